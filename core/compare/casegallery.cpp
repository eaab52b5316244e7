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
           "The triangle is thinner than a pixel, so a bound that is off by a little less than its "
           "thickness already gains or loses a sample. Colour rates divide by that thickness, and "
           "what rounding leaves of it can be anything."},
    Reason{"near-vertical",
           "A steep edge rises by many rows a column, so the error of the column's place is "
           "multiplied by the slope. Fixed-point slopes run out of digits before the point, "
           "floating ones behind it."},
    Reason{"vertical",
           "A vertical edge has no slope: Δy/Δx divides by zero. A method has to give that column "
           "to one of its halves without ever using the quotient."},
    Reason{"degenerate",
           "The three vertices lie on one line or in one point, so the area by which weights and "
           "colour rates are divided is zero. The rules differ on what is left: closed paints the "
           "segment, all others nothing."},
    Reason{"subpixel",
           "The triangle is smaller than the distance of two samples and usually covers none. "
           "Rounding vertices or bounds to whole pixels invents pixels that are not there."},
    Reason{"tie",
           "Samples lie exactly on an edge, so the exact bound is an integer, and there any error, "
           "however small, decides. The sign of the error counts, not its size: more digits make "
           "it smaller, they do not make it zero."},
    Reason{"shared-edge",
           "Two triangles meet in an edge, and each sample on it must belong to exactly one of "
           "them. That needs a fill rule and the same rounded numbers from both sides; else there "
           "are holes or pixels drawn twice."},
    Reason{"t-junction",
           "A vertex lies on another triangle's edge, whose slope is not that of the two halves. "
           "Once rounded, the two do not meet: a crack opens that is real in the rounded vertices "
           "and must be shown, or one that only the arithmetic makes."},
    Reason{"temporal",
           "From frame to frame the triangle moves by less than a pixel, so few samples should "
           "change. An error that comes and goes with the place makes pixels flicker that never "
           "moved."},
    Reason{"translation",
           "A move by whole pixels must move the picture and nothing else. Floating-point numbers "
           "lose digits behind the point as coordinates grow, so the same triangle is rounded "
           "otherwise at each place."},
    Reason{"huge",
           "Coordinates are so large that their products leave the integer's width, or that the "
           "spacing of floating-point numbers nears a pixel. The window sees only a small part, "
           "and the whole error of the way there."},
    Reason{"far",
           "Far from the origin a floating-point coordinate has few digits left behind the point. "
           "Forms that subtract two such products keep mostly the error."},
    Reason{"wide",
           "The way is long, and every column adds its rounding. The error grows in a straight "
           "line with the number of columns, because nearby additions round to the same side."},
    Reason{"drift",
           "Each column adds a rounded slope to a rounded sum, and neighbouring additions round to "
           "the same side. The error grows with the number of columns until it passes a sample; "
           "where the slope is below half a unit in the last place, the sum stands still."},
    Reason{"zero-division",
           "At a tip y_B and y_T are equal, so the colour rate is 0/0. Without a guard that is not "
           "a number, and cast to an integer it is the smallest one there is."},
    Reason{"tip",
           "At a tip y_B and y_T are equal or nearly so, and the colour rate divides by their "
           "difference. What rounding leaves of the difference decides the colour."},
    Reason{"colour",
           "A level lies close to the limit between two bytes, or at 0 or 255. A rounding error "
           "far below one level then changes the byte, or wraps it around."},
    Reason{"clamp",
           "Levels are extrapolated a little beyond the vertices' own, because the bounds are off. "
           "Below 0 or above 255 the byte must be clamped, or it wraps around."},
    Reason{"wrap",
           "The numbers pass the largest that the fixed-point word can hold. It wraps without a "
           "word, and the run goes on from the other end."},
    Reason{"negative",
           "Casts and integer divisions of the language round towards zero, which is upward for "
           "negative numbers. Floors and ceilings must be true ones."},
    Reason{"order",
           "The same triangle is given with its vertices in another order, or with equal keys in "
           "the sort. A method that starts from its first vertex then rounds otherwise."},
    Reason{"invalid",
           "The numbers are no ordinary ones: beyond every integer, not a number, or smaller than "
           "the smallest normal float. Casts of them are undefined, and processors set to flush "
           "the small ones to zero draw a sample that is outside."},
    Reason{
        "line",
        "Along its longer axis a line has exactly one pixel a step, the nearest one. Accumulated "
        "steps drift, ties between two pixels need a rule that does not change when the line is "
        "reversed, and steps along the shorter axis leave gaps."},
    Reason{"circle",
           "Along its arc a circle has one nearest pixel a step, and where it runs level with the "
           "samples many of them are almost equally near. A centre or a radius off the pixels "
           "breaks the symmetry on which the fast methods rest."},
    Reason{"polygon",
           "Whether a sample is inside is decided by every edge, not by three. Vertices that touch "
           "other edges, contours that cross or are gone round twice, and edges on samples count "
           "once too often or not at all when one of them is rounded."},
    Reason{"far-mesh",
           "The triangles share their edges far from the origin, where floating-point coordinates "
           "have few digits left behind the point. Each rounds the shared edge for itself, and a "
           "row of holes or of pixels drawn twice opens along it."},
    Reason{"sliver-motion",
           "A triangle thinner than a pixel slides by less than one, so that single samples come "
           "and go with its exact place. What rounding adds to that place is seen as flicker."},
    Reason{"interpolation",
           "More than colour hangs on the vertices here: depth, texture coordinates, normals. Each "
           "of them divides by the same area, and levels that are large beside their change lose "
           "the change first."},
    Reason{"perspective",
           "What is carried along is divided by a sum of 1/w that itself is rounded. Where w spans "
           "many powers of two, or the triangle is thinner than a pixel, little of both remains."},
    Reason{"texture",
           "A texture coordinate lies exactly on the border of two texels, so the smallest error "
           "reads the other one. Beyond 0 and 1 the picture is repeated or its border goes on, and "
           "casts that round towards zero find the wrong one."},
    Reason{"depth",
           "Two depths are equal or differ in their last bit, so rounding decides who is seen. On "
           "few levels many depths are equal that were not, and surfaces fight."},
    Reason{"blending",
           "What is drawn twice on a shared edge is seen through glass, and what is drawn by "
           "nobody too. Fill rules, cuts and the rounding of alpha all show in one level."},
    Reason{"antialiasing",
           "Parts of pixels are added up, and each of many samples decides by itself. Edges on a "
           "sample or on a pixel's border, and parts of some millionths, must be counted right."},
    Reason{"effects",
           "Depth, perspective, texture and alpha each round on the way to the byte. One of them "
           "lies exactly on its limit here."},
    Reason{"frame",
           "The triangle touches or crosses the border of the frame. Bounds that are off by one "
           "there read or write beside it, or lose the last row."},
    Reason{"reference",
           "These come from other projects' tests and bug reports, and their pixels are known. "
           "What went wrong there is a rule that was not kept or a number that overflowed."},
};

/// For single cases with more to explain than their family.
constexpr std::array caseReasons = {
    Reason{"tie_tenths",
           "Every tenth column has a sample exactly on each edge, and there any error, however "
           "small, decides: y_B too high or y_T too low loses the pixel. float64 errs a hundred "
           "million times less than float32, but at 127 of these samples towards the losing side, "
           "float32 at 64: the sign of the error decides, not its size."},
    Reason{"power_of_two_hides_error",
           "The width is a power of two, so the slope has a short binary fraction and every "
           "addition is exact. A test that uses only such widths sees no rounding error at all."},
    Reason{"t_junction_rounded",
           "The middle of the long edge is not on the lattice, and its rounded place opens a real "
           "crack. Exact arithmetic must show it: a test that demands no gap here is wrong."},
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
    return sentences.isEmpty()
        ? u"A number that decides a pixel lies so close to its limit that rounding "
          "carries it across. Open it at the first pixel that differs to see which."_s
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
