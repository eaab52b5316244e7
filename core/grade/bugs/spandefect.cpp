// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/spandefect.h"

#include "core/grade/bugs/edgetestdefect.h"
#include "core/grade/bugs/walkdefect.h"
#include "core/grade/scan/keptsamples.h"
#include "core/grade/scan/programwalk.h"
#include "core/runs/scenerun.h"

#include <algorithm>
#include <iterator>

namespace pixelplumb {

namespace {

struct SpanDefect {
    const char *id;
    const char *forStudent;
    const char *forAssistant; ///< %1 is a column or row, %2 the coordinate that its samples share
    KeepsSample keeps;
};

constexpr const char *endsQuestion = "From which to which sample does a span go?";
constexpr const char *spansQuestion
    = "From which to which %1 does a triangle go? What if a vertex lies on one, or between two?";
constexpr const char *halvesQuestion = "What happens where one edge ends and the next begins?";
constexpr const char *alongQuestion
    = "What happens to a triangle that has an edge along a %1, which has no slope?";

const std::vector<SpanDefect> &omissions()
{
    using T = SpanGeometry;
    using S = RunSample;
    static const std::vector<SpanDefect> rows = {
        {"last-sample-missing", endsQuestion, "Each %1's last sample is left out: < in place of ≤.",
         [](const T &, const S &s) { return s.place != s.last; }},
        {"first-sample-missing", endsQuestion, "Each %1's first sample is left out.",
         [](const T &, const S &s) { return s.place != s.first; }},
        {"last-span-missing", spansQuestion,
         "The %1 ⌊%2⌋ of the vertex with the greatest %2 is left out: < ⌊%2⌋ in place of ≤.",
         [](const T &t, const S &s) { return s.span != floorPixel(t.x2); }},
        {"first-span-missing", spansQuestion,
         "The %1 ⌈%2⌉ of the vertex with the least %2 is left out: > ⌈%2⌉ in place of ≥.",
         [](const T &t, const S &s) { return s.span != ceilPixel(t.x0); }},
        {"open-at-last-vertex", spansQuestion,
         "A %1 through the vertex with the greatest %2 is left out: < %2 in place of ≤.",
         [](const T &t, const S &s) { return !isAt(s, t.x2); }},
        {"open-at-first-vertex", spansQuestion,
         "A %1 through the vertex with the least %2 is left out: > %2 in place of ≥.",
         [](const T &t, const S &s) { return !isAt(s, t.x0); }},
        {"middle-span-missing", halvesQuestion,
         "The %1 ⌈%2⌉ of the middle vertex is in neither half.",
         [](const T &t, const S &s) { return s.span != ceilPixel(t.x1); }},
        {"middle-floor-span-missing", halvesQuestion,
         "The %1 ⌊%2⌋ of the middle vertex is in neither half.",
         [](const T &t, const S &s) { return s.span != floorPixel(t.x1); }},
        {"open-at-middle-vertex", halvesQuestion,
         "A %1 through the middle vertex is in neither half: < %2 in the one, > %2 in the other.",
         [](const T &t, const S &s) { return !isAt(s, t.x1); }},
        {"middle-span-truncated", halvesQuestion,
         "Where the middle vertex lies between two, the %1 ⌊%2⌋ is in neither half: < ⌊%2⌋ in the "
         "one, from ⌈%2⌉ in the other.",
         [](const T &t, const S &s) { return s.span != floorPixel(t.x1) || isAt(s, t.x1); }},
        {"first-half-missing", halvesQuestion,
         "The half with the lesser %2 is not drawn; a %1 through the middle vertex is.",
         [](const T &t, const S &s) { return s.span >= ceilPixel(t.x1); }},
        {"second-half-missing", halvesQuestion,
         "The half with the greater %2 is not drawn, nor a %1 through the middle vertex.",
         [](const T &t, const S &s) { return s.span < ceilPixel(t.x1); }},
        {"first-half-and-middle-missing", halvesQuestion,
         "The half with the lesser %2 is not drawn, nor a %1 through the middle vertex.",
         [](const T &t, const S &s) { return s.span > floorPixel(t.x1); }},
        {"second-half-behind-middle-missing", halvesQuestion,
         "The half with the greater %2 is not drawn; a %1 through the middle vertex is.",
         [](const T &t, const S &s) { return s.span <= floorPixel(t.x1); }},
        {"first-edge-along-lost", alongQuestion,
         "Nothing is drawn of a triangle two vertices of which have its least %2: it is given up "
         "where an edge has no slope.",
         [](const T &t, const S &) { return t.x0 != t.x1; }},
        {"last-edge-along-lost", alongQuestion,
         "Nothing is drawn of a triangle two vertices of which have its greatest %2: it is given "
         "up where an edge has no slope.",
         [](const T &t, const S &) { return t.x1 != t.x2; }},
        {"edge-along-lost", alongQuestion,
         "Nothing is drawn of a triangle two vertices of which have one %2: it is given up where "
         "an edge has no slope.",
         [](const T &t, const S &) { return t.x0 != t.x1 && t.x1 != t.x2; }},
        {"last-edge-along-missing", alongQuestion,
         "Where two vertices of a triangle have its greatest %2, the %1 through them is left out: "
         "the half that would be this %1 alone is not drawn.",
         [](const T &t, const S &s) { return t.x1 != t.x2 || !isAt(s, t.x2); }},
        {"outline-alone", "What lies between the first and the last sample of a %1?",
         "Of each %1 only the first and the last sample are drawn.",
         [](const T &, const S &s) { return s.place == s.first || s.place == s.last; }},
    };
    return rows;
}

/// A walk by rows may begin at either end.
const SpanDefect &omissionAtLeastRow()
{
    using T = SpanGeometry;
    using S = RunSample;
    static const SpanDefect row
        = {"first-edge-along-missing", alongQuestion,
           "Where two vertices of a triangle have its least %2, the %1 through them is left out: "
           "the half that would be this %1 alone is not drawn.",
           [](const T &t, const S &s) { return t.x0 != t.x1 || !isAt(s, t.x0); }};
    return row;
}

/// Going down, ⌈y₁⌉ corresponds to ⌊x₁⌋ from left to right.
const SpanDefect &omissionFromAbove()
{
    using T = SpanGeometry;
    using S = RunSample;
    static const SpanDefect row
        = {"middle-span-truncated-from-above", halvesQuestion,
           "Where the middle vertex lies between two, the %1 ⌈%2⌉ is in neither half: > ⌈%2⌉ in "
           "the one, from ⌊%2⌋ down in the other.",
           [](const T &t, const S &s) { return s.span != ceilPixel(t.x1) || isAt(s, t.x1); }};
    return row;
}

/// Mistakes in samples exactly on a bound: they are owned where the rule in force does not own
/// them, or the reverse.
void appendSamplesOnBounds(std::vector<Defect> &defects, const Scene &scene, SpanAxis axis)
{
    const BoundaryRule rule = boundaryRuleOf(scene);
    const Interval samples
        = (axis == SpanAxis::Row ? rowIntervals(rule) : columnIntervals(rule.rule)).rows;
    const auto add = [&](const QString &id, const char *what, const ScanBugs &bugs, bool isOwned) {
        const auto words
            = isOwned ? u"%1 is left out: < in place of ≤."_s : u"%1 is drawn: ≤ in place of <."_s;
        defects.push_back(redrawnDefect((isOwned ? u"open-at-"_s : u"closed-at-"_s) + id,
                                        u"Does a sample that lies on an edge belong to a %1?"_s,
                                        words.arg(QString::fromUtf8(what)), redrawingBy(bugs),
                                        axis));
    };
    constexpr auto otherwise = EndRounding::OnBoundOtherwise;
    add(u"lower-bound"_s, "A sample on the lower bound of a %1", {.first = otherwise},
        ownsFirst(samples));
    add(u"upper-bound"_s, "A sample on the upper bound of a %1", {.last = otherwise},
        ownsLast(samples));
    if (ownsFirst(samples) == ownsLast(samples))
        add(u"bounds"_s, "A sample on either bound of a %1",
            {.first = otherwise, .last = otherwise}, ownsFirst(samples));
}

/// Whether two vertices of a triangle share a span: programs may sort them in different ways.
bool hasEdgeAlong(const Scene &scene, SpanAxis axis)
{
    const auto spanOf = [axis](const Vertex &vertex) {
        return axis == SpanAxis::Row ? vertex.position.y : vertex.position.x;
    };
    return std::ranges::any_of(scene.triangles, [&](const Triangle &triangle) {
        const auto &[a, b, c] = triangle.vertices;
        return spanOf(a) == spanOf(b) || spanOf(b) == spanOf(c) || spanOf(c) == spanOf(a);
    });
}

} // namespace

std::vector<Defect> spanDefectsFor(const Scene &scene)
{
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    if (!canBeRedrawn(scene))
        return {};
    const SpanAxis axis = method.spanAxis;
    const bool walksEdges = method.walksEdges();
    std::vector<Defect> defects;
    if (walksEdges && hasEdgeAlong(scene, axis))
        defects = flatEdgeChoicesFor(axis);
    if (walksEdges) {
        std::ranges::move(walkDefectsFor(axis), std::back_inserter(defects));
        appendSamplesOnBounds(defects, scene, axis);
    }
    if (walksEdges && leavesShort(scene))
        defects.push_back(redrawnDefect(
            u"interpolation-in-16-bits"_s, u"How large do your numbers get, and what holds them?"_s,
            u"An edge's %3 is computed in whole numbers, %3₀ + (%3₁ − %3₀)·(%2 − "
            "%2₀)/(%2₁ − %2₀), and the product is kept in 16 bits: beyond ±32,767 "
            "it wraps, and the edges of large triangles jump."_s,
            redrawingBy(
                {.edgePlaces = Truncation::TowardZero, .edgeStoring = Storing::AddedOfShorts}),
            axis));
    const auto add = [&](const SpanDefect &row) {
        defects.push_back(redrawnDefect(
            QString::fromLatin1(row.id), QString::fromUtf8(row.forStudent),
            QString::fromUtf8(row.forAssistant), redrawingThatKeeps(row.keeps), axis));
    };
    if (axis == SpanAxis::Free) {
        defects = edgeTestDefectsFor(scene);
        std::ranges::move(boxDefects(), std::back_inserter(defects));
    } else {
        std::ranges::for_each(omissions(), add);
    }
    if (axis == SpanAxis::Row) {
        add(omissionFromAbove());
        add(omissionAtLeastRow());
    }
    const auto unchanged = [](TriangleRuns &) {};
    defects.push_back(redrawnDefect(
        u"parity"_s, u"What happens to a pixel that two triangles paint?"_s,
        u"Pixels are toggled, not painted: what two triangles paint is background again."_s,
        {unchanged, LevelOverflow::Clamps, Repainting::Toggles}, axis));
    return defects;
}

} // namespace pixelplumb
