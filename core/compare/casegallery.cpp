// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/casegallery.h"

#include "core/check/effectcase.h"
#include "core/runs/contender.h"

#include <QHash>

#include <algorithm>

namespace pixelplumb {

namespace {

struct Reason {
    const char *name;
    const char *sentences;
};

/// Why each family goes wrong. Sources for the texts: resources/numerics.md, 1.1 to 3.4.
constexpr std::array familyReasons = {
    Reason{"sliver",
           "The triangle is thinner than a pixel, so a bound that is off by a little less than "
           "its thickness already gains or loses a sample. The colour increments divide by that "
           "thickness, which rounding can change by any factor."},
    Reason{"near-vertical",
           "A steep edge rises by many rows per column, so the slope multiplies any error in the "
           "column's place. A fixed-point slope runs out of integer bits; a floating-point "
           "slope runs out of fractional bits."},
    Reason{"vertical",
           "A vertical edge has no slope: Δy/Δx divides by zero. A method must give that column "
           "to one of its halves without using the quotient."},
    Reason{"degenerate",
           "The three vertices lie on one line or in one point, so the area that divides the "
           "weights and colour increments is zero. The closed rule still draws the segment; all "
           "other rules draw nothing."},
    Reason{"subpixel",
           "The triangle is smaller than the distance between two samples and usually covers "
           "none. Rounding its vertices or bounds to whole pixels draws pixels that it does not "
           "cover."},
    Reason{"tie",
           "Samples lie exactly on an edge, so the exact bound is an integer, and any error, "
           "however small, decides the pixel. The sign of the error counts, not its size: more "
           "digits make it smaller but not zero."},
    Reason{"shared-edge",
           "Two triangles meet in an edge, and each sample on it must belong to exactly one of "
           "them. That needs a fill rule, and the same rounded numbers from both sides; "
           "otherwise pixels are left out or drawn twice."},
    Reason{"t-junction",
           "A vertex lies on another triangle's edge, which the two neighbours split into halves. "
           "If the vertex was rounded to the lattice, the crack is real and must be shown; if "
           "it lies exactly on the edge, a crack comes from rounded slopes and is an error."},
    Reason{"temporal",
           "From frame to frame the triangle moves by less than a pixel, so few samples should "
           "change. An error that varies with the position makes other pixels flicker, too."},
    Reason{"translation",
           "Moving the triangle by whole pixels must move the picture and change nothing else. "
           "Floating-point numbers lose fractional bits as coordinates grow, so the same "
           "triangle is rounded differently at each place."},
    Reason{"huge",
           "Coordinates are so large that their products overflow integers, or that neighbouring "
           "floating-point numbers are almost a pixel apart. The frame shows only a small part "
           "of the triangle, but the error has accumulated all the way there."},
    Reason{"far",
           "Far from the origin a floating-point coordinate has few fractional bits left. Where "
           "two such products are subtracted, their leading digits cancel and mostly the "
           "rounding error remains."},
    Reason{"wide",
           "The edge is long, and every column adds a rounding error. The error grows in "
           "proportion to the number of columns, because neighbouring additions round to the "
           "same side."},
    Reason{"drift",
           "Each column adds a rounded slope to a rounded sum, and neighbouring additions round "
           "to the same side. The error grows with the number of columns until the bound passes "
           "a sample. A slope below half a unit in the last place does not change the sum at "
           "all."},
    Reason{"zero-division",
           "At a tip y_B and y_T are equal, so the colour increment is 0/0. Without a guard it "
           "becomes NaN, which a cast often turns into the smallest integer."},
    Reason{"tip",
           "At a tip y_B and y_T are equal or nearly so, and the colour increment divides by "
           "their difference. Rounding can change that small difference by any factor, and with "
           "it the colour."},
    Reason{"colour",
           "A level lies close to the limit between two bytes, or at 0 or 255. There a rounding "
           "error far below one level changes the byte or makes it wrap around."},
    Reason{"clamp",
           "The rounded bounds lie slightly outside the triangle, so the colours there leave the "
           "range of the vertices' colours. A level below 0 or above 255 must be clamped, or "
           "the byte wraps around."},
    Reason{"wrap",
           "The numbers exceed the largest value of the fixed-point word. It silently wraps "
           "around, and the run continues from the other end of the range."},
    Reason{"negative",
           "In C, C++ and many other languages, casts and integer divisions round towards zero, "
           "which is upward for negative numbers. Use a true floor and a true ceiling."},
    Reason{"order",
           "The same triangle is given with its vertices in another order, or two of its sort "
           "keys are equal. A method that starts from the first vertex given then rounds "
           "differently."},
    Reason{"invalid",
           "The numbers are unusual: infinite, too large for any integer, NaN, or smaller than "
           "the smallest normal float. Casting the large ones and NaN to an integer is "
           "undefined. A processor that flushes the small ones to zero draws a sample that lies "
           "outside."},
    Reason{"line",
           "At each step along its longer axis a line has exactly one pixel, the nearest one. "
           "Accumulated steps drift; a tie between two pixels needs a rule that gives the same "
           "pixel when the line is reversed; and stepping along the shorter axis leaves gaps."},
    Reason{"circle",
           "Each step along the arc has one nearest pixel, but where the arc runs half-way "
           "between two rows or columns of samples, both are almost equally near. The fast "
           "methods rely on symmetry and whole numbers: a centre between pixels breaks the "
           "first, a fractional radius the second."},
    Reason{"polygon",
           "All edges, not just three, decide whether a sample is inside. If a vertex touches "
           "another edge, contours cross or run round twice, or an edge passes through samples, "
           "rounding makes one edge count too often or not at all."},
    Reason{"far-mesh",
           "The triangles share edges far from the origin, where floating-point coordinates have "
           "few fractional bits left. Each triangle rounds the shared edge in its own way, so "
           "pixels along it are left out or drawn twice."},
    Reason{"sliver-motion",
           "A triangle thinner than a pixel slides by less than a pixel, so single samples come "
           "and go with its exact position. Rounding errors in that position show as flicker."},
    Reason{"interpolation",
           "The vertices carry more than colour: depth, texture coordinates and normals. All of "
           "them divide by the same area. Where a value is large and changes little, rounding "
           "loses the change first."},
    Reason{"perspective",
           "Each interpolated value is divided by the interpolated 1/w, and both are rounded. "
           "Where w spans many powers of two, or the triangle is thinner than a pixel, few "
           "correct digits are left in either."},
    Reason{"texture",
           "A texture coordinate lies exactly on the border between two texels, so the smallest "
           "error reads the wrong one. Below 0 and above 1 the texture is repeated or its "
           "border is extended; a cast that rounds towards zero then finds the wrong texel."},
    Reason{"depth",
           "Two depths are equal or differ in their last bit, so rounding decides which surface "
           "is seen. In a depth buffer with few bits many different depths become equal, and "
           "the surfaces show through each other."},
    Reason{"blending",
           "Transparency reveals pixels that are drawn twice on a shared edge, and gaps. Fill "
           "rules, clipping and the rounding of alpha all show, if only by one level."},
    Reason{"antialiasing",
           "A pixel is the sum of many parts: of samples that are each tested separately, or of "
           "covered areas. An edge through a sample or along a pixel's border, and an area of a "
           "few millionths, must still be counted correctly."},
    Reason{"effects",
           "Depth, perspective, texture and alpha are each rounded before the byte is written. "
           "Here one of them lies exactly on a rounding limit."},
    Reason{"frame",
           "The triangle touches or crosses the border of the frame. If the bounds are off by "
           "one, pixels outside the frame are read or written, or the last row is lost."},
    Reason{"reference",
           "These cases come from other projects' tests and bug reports, and their correct pixels "
           "are known. There, a fill rule was broken or a number overflowed."},
};

/// For single cases with more to explain than their family.
constexpr std::array caseReasons = {
    Reason{"tie_tenths",
           "Every tenth column has a sample exactly on each edge, where any error, however small, "
           "decides: a y_B that is too high or a y_T that is too low loses the pixel. The "
           "errors of float64 are a hundred million times smaller than those of float32, but at "
           "127 of these samples they lose the pixel, those of float32 at 64: the sign of the "
           "error decides, not its size."},
    Reason{"power_of_two_hides_error",
           "The width is a power of two, so the slope has a short binary fraction and every "
           "addition is exact. A test that uses only such widths sees no rounding error at all."},
    Reason{"t_junction_rounded",
           "The middle of the long edge is not on the lattice; rounding it to the lattice opens a "
           "real crack. Exact arithmetic must show the crack: a test that demands no gap here "
           "is wrong."},
};

template <std::size_t Count>
QString sentencesOf(const std::array<Reason, Count> &reasons, const QString &name)
{
    const auto found = std::ranges::find_if(
        reasons, [&name](const Reason &reason) { return name == QLatin1String(reason.name); });
    return found != reasons.end() ? QString::fromUtf8(found->sentences) : QString();
}

QString nameOf(HardCaseKind kind)
{
    switch (kind) {
    case HardCaseKind::Mesh:
        return u"shared-edge"_s;
    case HardCaseKind::Sequence:
        return u"temporal"_s;
    case HardCaseKind::Translation:
        return u"translation"_s;
    case HardCaseKind::Line:
        return u"line"_s;
    case HardCaseKind::Circle:
        return u"circle"_s;
    case HardCaseKind::Polygon:
        return u"polygon"_s;
    case HardCaseKind::Attributes:
        return u"interpolation"_s;
    case HardCaseKind::Effects:
        return u"effects"_s;
    case HardCaseKind::Triangle:
    case HardCaseKind::Invalid:
        break;
    }
    return u"triangle"_s;
}

} // namespace

QString whyOf(const QString &family)
{
    const QString sentences = sentencesOf(familyReasons, family);
    return sentences.isEmpty() ? u"A number that decides a pixel lies so close to its limit that "
                                 "rounding takes it to the other side. Open the case at the "
                                 "first pixel that differs to see which number."_s
                               : sentences;
}

Result<std::vector<GalleryCase>> readGallery(const QByteArray &text)
{
    const Result<std::vector<HardCase>> cases = readHardCases(text);
    if (!cases)
        return cases.error();
    const JsonReader json(text);
    QHash<QString, JsonNode> remarks;
    for (const JsonNode &each : json.root()["cases"].elements())
        remarks.insert(each["id"].toString(), each);

    std::vector<GalleryCase> gallery;
    for (const HardCase &hardCase : *cases) {
        if (hardCase.triangles.empty() && hardCase.shapes.empty())
            continue;
        const JsonNode remark = remarks.value(hardCase.id);
        GalleryCase entry;
        entry.hardCase = hardCase;
        const JsonNode family = remark["family"];
        entry.family = family.isString() ? family.toString() : nameOf(hardCase.kind);
        for (const JsonNode &each : remark["fails_in"].elements())
            entry.failsIn.append(each.toString());
        entry.note = remark["note"].toString();
        entry.why = sentencesOf(caseReasons, hardCase.id);
        if (entry.why.isEmpty())
            entry.why = whyOf(entry.family);
        gallery.push_back(std::move(entry));
    }
    return gallery;
}

Scene sceneOf(const HardCase &hardCase, const Method &method, const ScanSettings &settings)
{
    Scene scene;
    scene.frame = hardCase.canvas;
    scene.triangles = hardCase.triangles;
    scene.shapes = hardCase.shapes;
    scene.attributes = hardCase.attributes;
    scene.appearance = hardCase.appearance;
    if (hardCase.kind == HardCaseKind::Sequence) {
        const LatticePoint from = scene.triangles.front().vertices[0].position;
        const LatticePoint to = scene.triangles.back().vertices[0].position;
        scene.motion = Motion{{to.x - from.x, to.y - from.y}, int(scene.triangles.size())};
        scene.triangles.resize(1);
    }
    const bool isShape = scene.triangles.empty();
    const bool isDrawn
        = isShape ? method.draws(scene.shapes.front()) : method.draws(PrimitiveKind::Triangle);
    const Method &able
        = isShape ? firstMethodFor(scene.shapes.front()) : firstMethodFor(PrimitiveKind::Triangle);
    Contender contender = contenderFor(isDrawn ? method : able, settings);
    if (hardCase.kind == HardCaseKind::Effects
        && !effectRefusal(contender.settings, *contender.method).isEmpty()) {
        contender = contenderFor(able, settings);
        contender.settings.arithmetic = Arithmetic::Exact;
    }
    scene.method = contender.method->id.toStdString();
    scene.settings = contender.settings;
    return scene;
}

} // namespace pixelplumb
