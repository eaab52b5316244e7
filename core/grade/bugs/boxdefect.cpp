// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/edgetestdefect.h"
#include "core/grade/scan/keptsamples.h"

#include <algorithm>
#include <map>

namespace pixelplumb {

namespace {

constexpr const char *edgesQuestion = "Are all three edges tested alike?";
constexpr const char *boxQuestion
    = "Which samples of the bounding box are tested, and which are inside?";

/// Draws all of the box.
void fillBox(TriangleRuns &triangle)
{
    if (doubledArea(triangle.triangle) == 0) // has no plane of colours
        return;
    const SampleBox &box = triangle.visited;
    triangle.runs.clear();
    for (std::int64_t row = std::max(box.firstY, triangle.firstSpan);
         row < std::min(box.endY, triangle.endSpan); ++row)
        triangle.runs.push_back({row, box.firstX, box.endX});
}

/// Draws what lies outside in the box, and not what lies inside, of a triangle whose vertices turn
/// so: its doubled area has this sign.
void invert(TriangleRuns &triangle, int turn)
{
    const Triangle asGiven = exchanged(triangle.triangle);
    const Int128 area = doubledArea(asGiven);
    if (turn > 0 ? area <= 0 : area >= 0)
        return;
    std::map<std::int64_t, std::vector<SampleRun>> inside; // by row
    for (const SampleRun &run : triangle.runs)
        inside[run.span].push_back(run);
    fillBox(triangle);
    std::vector<SampleRun> outside;
    for (const SampleRun &row : triangle.runs) {
        std::int64_t next = row.first;
        for (const SampleRun &run : inside[row.span]) {
            if (run.first > next)
                outside.push_back({row.span, next, run.first});
            next = std::max(next, run.end);
        }
        if (next < row.end)
            outside.push_back({row.span, next, row.end});
    }
    triangle.runs = std::move(outside);
}

/// Whether a sample lies in the box of the edge from that vertex to the next.
bool isInBoxOf(std::size_t vertex, const SpanGeometry &of, const RunSample &sample)
{
    Triangle edge = of.triangle;
    edge.vertices[(vertex + 2) % 3] = edge.vertices[vertex];
    const SampleBox box = boundingBoxOf(exchanged(edge));
    return sample.span >= box.firstY && sample.span < box.endY && sample.place >= box.firstX
        && sample.place < box.endX;
}

/// Whether a sample lies exactly on the line of that edge.
bool isOn(std::size_t vertex, const SpanGeometry &of, const RunSample &sample)
{
    const auto &vertices = of.triangle.vertices;
    return doubledArea(vertices[vertex].position, vertices[(vertex + 1) % 3].position,
                       latticePixel(sample.span, sample.place))
        == 0;
}

QString vertexText(std::size_t vertex) { return QString::number(vertex % 3); }

} // namespace

std::vector<Defect> boxDefects()
{
    std::vector<Defect> defects;
    const auto add = [&](const QString &id, const char *forStudent, const QString &forAssistant,
                         const Redrawing &redrawing) {
        defects.push_back(redrawnBy(redrawing, {id, QString::fromUtf8(forStudent), forAssistant}));
    };
    const auto addOfBox
        = [&](const char *id, const char *forAssistant, const Redrawing &redrawing) {
              add(QString::fromLatin1(id), boxQuestion, QString::fromUtf8(forAssistant), redrawing);
          };
    const auto addThatKeeps
        = [&](const char *id, const char *forAssistant, const KeepsSample &keeps) {
              addOfBox(id, forAssistant, redrawingThatKeeps(keeps));
          };
    using T = SpanGeometry;
    using S = RunSample;
    const KeepsSample lastRow = [](const T &t, const S &s) { return s.span != t.box.endY - 1; };
    const KeepsSample lastColumn = [](const T &t, const S &s) { return s.place != t.box.endX - 1; };
    const KeepsSample firstRow = [](const T &t, const S &s) { return s.span != t.box.firstY; };
    const KeepsSample firstColumn = [](const T &t, const S &s) { return s.place != t.box.firstX; };
    addOfBox("box-filled", "The whole bounding box is drawn: no sample is tested.", {fillBox});
    constexpr const char *windingQuestion
        = "Are all triangles there, whichever way their vertices turn?";
    add(u"clockwise-inverted"_s, windingQuestion,
        u"Of triangles whose vertices turn clockwise, taking y upward, what lies outside in the "
        u"box "
        "is drawn, and what lies inside is not."_s,
        {[](TriangleRuns &triangle) { invert(triangle, -1); }});
    add(u"counter-clockwise-inverted"_s, windingQuestion,
        u"Of triangles whose vertices turn counter-clockwise, taking y upward, what lies outside "
        "in the box is drawn, and what lies inside is not."_s,
        {[](TriangleRuns &triangle) { invert(triangle, 1); }});
    addThatKeeps("box-last-row-missing", "The box' last row is left out: < in place of ≤.",
                 lastRow);
    addThatKeeps("box-last-column-missing", "The box' last column is left out: < in place of ≤.",
                 lastColumn);
    addThatKeeps("box-ends-missing",
                 "The box' last row and its last column are left out: < in place of ≤.",
                 [=](const T &t, const S &s) { return lastRow(t, s) && lastColumn(t, s); });
    addThatKeeps("box-open-at-greatest",
                 "Samples at x_max or y_max itself are left out: < in place of ≤.",
                 [](const T &t, const S &s) {
                     const LatticePoint greatest = boundingCornersOf(exchanged(t.triangle)).second;
                     return s.span < ceilPixel(greatest.y) && s.place < ceilPixel(greatest.x);
                 });
    addThatKeeps("box-first-row-missing", "The box' first row is left out.", firstRow);
    addThatKeeps("box-first-column-missing", "The box' first column is left out.", firstColumn);
    addThatKeeps("box-starts-missing", "The box' first row and its first column are left out.",
                 [=](const T &t, const S &s) { return firstRow(t, s) && firstColumn(t, s); });
    add(u"levels-wrap"_s, "What becomes of a level that no byte holds?",
        u"Levels beyond 0 … 255 wrap in a byte. That alone is no mistake."_s,
        {[](TriangleRuns &) {}, LevelOverflow::Wraps});
    defects.back().isRightAlone = true;
    Redrawing outward{[](TriangleRuns &) {}};
    outward.box = VisitedBox::Outward;
    addOfBox("box-outward",
             "The box is rounded outward, ⌊x_min⌋ … ⌈x_max⌉ and ⌊y_min⌋ … "
             "⌈y_max⌉: samples beside "
             "the triangle are tested, too. That alone is no mistake.",
             outward);
    defects.back().isRightAlone = true;
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const QString from = vertexText(edge);
        const QString to = vertexText(edge + 1);
        add(u"box-of-vertices-%1-and-%2"_s.arg(from, to), boxQuestion,
            u"The box is that of the vertices %1 and %2 alone."_s.arg(from, to),
            redrawingThatKeeps([edge](const T &t, const S &s) { return isInBoxOf(edge, t, s); }));
        add(u"strict-at-edge-%1"_s.arg(edge), edgesQuestion,
            u"The edge from vertex %1 to vertex %2 is tested by > in "
            "place of ≥, the "
            "others are not."_s.arg(from, to),
            redrawingThatKeeps([edge](const T &t, const S &s) { return !isOn(edge, t, s); }));
        defects.back().choice = QString::fromLatin1(ruleChoice);
        add(u"strict-but-at-edge-%1"_s.arg(edge), edgesQuestion,
            u"Two edges are tested by > in place of ≥, that from "
            "vertex %1 to vertex "
            "%2 is not."_s.arg(from, to),
            redrawingThatKeeps([edge](const T &t, const S &s) {
                return !isOn((edge + 1) % 3, t, s) && !isOn((edge + 2) % 3, t, s);
            }));
        defects.back().choice = QString::fromLatin1(ruleChoice);
    }
    return defects;
}

} // namespace pixelplumb
