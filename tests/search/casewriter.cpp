// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/search/casewriter.h"

#include "core/oracle/oracle.h"
#include "tests/search/canvaspicture.h"

#include <map>

namespace pixelplumb::search {

namespace {

constexpr std::array<std::pair<FillRule, const char *>, 3> ruleNames
    = {{{FillRule::Closed, "closed"},
        {FillRule::HalfOpenColumn, "half_open_column"},
        {FillRule::TopLeft, "top_left"}}};

constexpr std::size_t largestPointCount = 6;

// JSON text with our own key order and with short arrays on one line.

QString quoted(const QString &text) { return u'"' + text + u'"'; }
QString quoted(const char *text) { return quoted(QString::fromUtf8(text)); }
QString array(const QStringList &elements)
{
    return u'[' + elements.join(QStringLiteral(", ")) + u']';
}
template <class Range>
QString numbers(const Range &values)
{
    QStringList texts;
    for (const auto &value : values)
        texts.append(QString::number(qint64(value)));
    return array(texts);
}
QString member(const char *key, const QString &value) { return quoted(key) + ": " + value; }
QString object(const QStringList &members)
{
    return u'{' + members.join(QStringLiteral(", ")) + u'}';
}

/// In units of 1/scale px.
QString position(const LatticePoint &point, Lattice scale)
{
    const Lattice unit = unitsPerPixel / scale;
    return numbers(std::array{point.x / unit, point.y / unit});
}

QString corners(const Triangle &triangle, Lattice scale)
{
    QStringList texts;
    for (const Vertex &vertex : triangle.vertices)
        texts.append(position(vertex.position, scale));
    return array(texts);
}

QString colours(const Triangle &triangle)
{
    QStringList texts;
    for (const Vertex &vertex : triangle.vertices)
        texts.append(numbers(vertex.colour.channels));
    return array(texts);
}

/// "vertices" and "triangles", each vertex once.
QStringList meshMembers(const HardCase &hardCase, Lattice scale)
{
    std::map<LatticePoint, int> indices;
    QStringList vertices;
    QStringList triangles;
    for (const Triangle &triangle : hardCase.triangles) {
        std::array<int, 3> of = {};
        for (std::size_t i = 0; i < 3; ++i) {
            const LatticePoint &point = triangle.vertices[i].position;
            const auto [entry, isNew] = indices.try_emplace(point, int(indices.size()));
            if (isNew)
                vertices.append(position(point, scale));
            of[i] = entry->second;
        }
        triangles.append(numbers(of));
    }
    return {member("vertices", array(vertices)), member("triangles", array(triangles))};
}

QString factsText(const ExpectedFacts &facts)
{
    QStringList members;
    if (facts.pixelCount)
        members.append(member("count", QString::number(*facts.pixelCount)));
    if (!facts.spanHash.isEmpty())
        members.append(member("span_sha", quoted(QString::fromLatin1(facts.spanHash))));
    if (facts.channelSums)
        members.append(member("sum8", numbers(*facts.channelSums)));
    if (!facts.frameCounts.empty())
        members.append(member("counts", numbers(facts.frameCounts)));
    if (facts.toggles)
        members.append(member("toggles", QString::number(*facts.toggles)));
    if (facts.distinctPictures)
        members.append(member("distinct_pictures", QString::number(*facts.distinctPictures)));
    if (members.isEmpty()) { // a mesh, even one that covers nothing
        QStringList entries;
        std::int64_t covered = 0;
        for (const auto &[times, count] : facts.histogram) {
            entries.append(quoted(QString::number(times)) + ": " + QString::number(count));
            covered += count;
        }
        members
            = {member("covered", QString::number(covered)), member("histogram", object(entries))};
    }
    return object(members);
}

/// Under the top-left rule a case's y points down, the oracle's up.
bool isCovered(const Triangle &triangle, FillRule rule, std::int64_t x, std::int64_t y)
{
    if (rule != FillRule::TopLeft)
        return oracle::covers(triangle, rule, x, y);
    Triangle mirrored = triangle;
    for (Vertex &vertex : mirrored.vertices)
        vertex.position.y = -vertex.position.y;
    return oracle::covers(mirrored, rule, x, -y);
}

QString pointText(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    QStringList covered;
    for (const auto &[rule, name] : ruleNames)
        covered.append(member(name, isCovered(triangle, rule, x, y) ? "true" : "false"));
    QStringList exact;
    std::array<std::int64_t, 3> rounded = {};
    const std::array<Quantity, 3> levels = oracle::colourAt(triangle, x, y);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Int128 numerator = levels[channel].numerator();
        const Int128 denominator = levels[channel].denominator();
        exact.append(quoted(denominator == 1 ? toText(numerator)
                                             : toText(numerator) + u'/' + toText(denominator)));
        rounded[channel]
            = std::int64_t(floorDivide<Int128>(2 * numerator + denominator, 2 * denominator));
    }
    return object({member("x", QString::number(x)), member("y", QString::number(y)),
                   member("in", object(covered)), member("rgb", array(exact)),
                   member("rgb8", numbers(rounded))});
}

/// The first pixels that are wrong in the arithmetic for which the case was found.
QString pointsText(const Find &find)
{
    const Triangle &triangle = find.hardCase.triangles.front();
    CanvasPicture drawn(find.hardCase.canvas);
    drawn.drawByScan(triangle, {find.recipe->arithmetic, find.recipe->rule, ByteRounding::Nearest});
    CanvasPicture truth(find.hardCase.canvas);
    truth.drawTruly(triangle, find.recipe->rule);
    QStringList points;
    const FrameSpec &canvas = find.hardCase.canvas;
    for (std::size_t i = 0; i < drawn.pixels().size(); ++i) {
        if (drawn.pixels()[i] == truth.pixels()[i])
            continue;
        points.append("\n    "
                      + pointText(triangle, canvas.firstColumn + std::int64_t(i) % canvas.width,
                                  canvas.firstRow + std::int64_t(i) / canvas.width));
        if (std::size_t(points.size()) == largestPointCount)
            break;
    }
    return array(points);
}

QString failingArithmetics(const HardCase &hardCase)
{
    QStringList names;
    for (const Arithmetic arithmetic : allArithmetics) {
        bool fails = false;
        for (const FillRule rule : {FillRule::Closed, FillRule::HalfOpenColumn})
            fails = fails || !measure(hardCase, {arithmetic, rule, ByteRounding::Nearest}).isNone();
        const std::string_view name = nameOf(arithmetic);
        if (fails)
            names.append(
                quoted("column scan in " + QString::fromUtf8(name.data(), qsizetype(name.size()))));
    }
    return array(names);
}

QString caseText(const Find &find)
{
    const HardCase &hardCase = find.hardCase;
    const Lattice scale = find.recipe->scale;
    QStringList lines
        = {member("id", quoted(hardCase.id)), member("family", quoted(find.recipe->family))};
    switch (hardCase.kind) {
    case HardCaseKind::Triangle:
        lines.append(member("kind", quoted("triangle")));
        break;
    case HardCaseKind::Mesh:
        lines.append(member("kind", quoted("mesh")));
        break;
    case HardCaseKind::Sequence:
        lines.append(member("kind", quoted("sequence")));
        break;
    case HardCaseKind::Translation:
    case HardCaseKind::Invalid:
    case HardCaseKind::Line:
    case HardCaseKind::Circle:
    case HardCaseKind::Polygon:
    case HardCaseKind::Attributes:
    case HardCaseKind::Effects:
        lines.append(member("kind", quoted("translation")));
        break;
    }
    lines.append(member("scale", QString::number(scale)));
    if (hardCase.kind == HardCaseKind::Mesh) {
        lines += meshMembers(hardCase, scale);
    } else if (hardCase.kind == HardCaseKind::Sequence) {
        QStringList frames;
        for (const Triangle &triangle : hardCase.triangles)
            frames.append(corners(triangle, scale));
        lines.append(member("frames", array(frames)));
    } else {
        lines.append(member("vertices", corners(hardCase.triangles.front(), scale)));
    }
    if (hardCase.kind != HardCaseKind::Mesh)
        lines.append(member("colours", colours(hardCase.triangles.front())));
    if (hardCase.kind == HardCaseKind::Translation) {
        QStringList offsets;
        for (const auto &offset : hardCase.offsets)
            offsets.append(numbers(offset));
        lines.append(member("offsets_px", array(offsets)));
    }
    const FrameSpec &canvas = hardCase.canvas;
    lines.append(member("canvas", numbers(std::array{canvas.width, canvas.height})));
    lines.append(member("origin", numbers(std::array{canvas.firstColumn, canvas.firstRow})));
    lines.append(member("stresses", quoted(find.recipe->reason)));
    lines.append(member("fails_in", failingArithmetics(hardCase)));
    QStringList expected;
    for (const auto &[rule, name] : ruleNames)
        expected.append("\n    " + member(name, factsText(hardCase.facts.at(rule))));
    lines.append(member("expected", object(expected)));
    if (hardCase.kind == HardCaseKind::Triangle && doubledArea(hardCase.triangles.front()) != 0)
        lines.append(member("points", pointsText(find)));
    return "  {\n   " + lines.join(QStringLiteral(",\n   ")) + "\n  }";
}

} // namespace

QByteArray casesText(std::span<const Find> finds)
{
    std::map<QString, int> families;
    QStringList cases;
    for (const Find &find : finds) {
        ++families[QString::fromLatin1(find.recipe->family)];
        cases.append(caseText(find));
    }
    QStringList counts;
    for (const auto &[family, count] : families)
        counts.append("\n  " + quoted(family) + ": " + QString::number(count));
    const QString conventions = object(
        {"\n  " + member("sample", quoted("pixel (x,y) is sampled at (x,y)")),
         "\n  " + member("vertices", quoted("integers in units of 1/scale px")),
         "\n  "
             + member("rules",
                      object({member("closed", quoted("inside or on")),
                              member("half_open_column", quoted("sample displaced by (+e^2,+e)")),
                              member("top_left", quoted("sample displaced by (+e,+e^2)"))})),
         "\n  " + member("rounding", quoted("floor(v+1/2)")),
         "\n  "
             + member("span_sha",
                      quoted("first 16 hex digits of sha256 over \\\"x lo hi\\\\n\\\" for each "
                             "non-empty column, ascending, clipped to the canvas window")),
         "\n  " + member("sum8", quoted("sum over covered pixels of the rounded 8-bit channels")),
         "\n  " + member("origin", quoted("lower corner of the canvas window in pixels"))});
    const QString text = "{\n " + member("version", QString::number(1)) + ",\n "
        + member("conventions", conventions) + ",\n " + member("families", object(counts)) + ",\n "
        + member("cases", "[\n" + cases.join(QStringLiteral(",\n")) + "\n ]") + "\n}\n";
    return text.toUtf8();
}

} // namespace pixelplumb::search
