// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/walklisting.h"

namespace pixelplumb {

namespace {

using enum Moment;

const QString longEdge = "₀₂", shortEdge = "_ij";

} // namespace

void WalkListing::add(int depth, const QString &text, const std::vector<Moment> &moments, LineOf of)
{
    m_code.push_back({.depth = depth, .text = text, .moments = moments, .of = of});
}

void WalkListing::addVaried(int depth, const QString &text, const std::vector<Moment> &moments,
                            const std::vector<VariedLine> &varied, LineOf of)
{
    add(depth, text, moments, of);
    m_code.back().varied = varied;
}

/// What the last line says under the rules that are not closed.
template <class Text>
void WalkListing::addRules(const Text &text)
{
    for (const FillRule rule : {FillRule::HalfOpenColumn, FillRule::TopLeft, FillRule::Open})
        for (const FrameOrigin origin : {FrameOrigin::BottomLeft, FrameOrigin::TopLeft})
            m_code.back().ruled.push_back({rule, text(rule, origin), origin});
}

Pseudocode WalkListing::written()
{
    for (PseudocodeLine &line : m_code) {
        line.text = m_names.filled(line.text);
        for (VariedLine &varied : line.varied)
            varied.text = m_names.filled(varied.text);
        for (RuledLine &ruled : line.ruled)
            ruled.text = m_names.filled(ruled.text);
    }
    return std::move(m_code);
}

void WalkListing::nameSortedVerticesByLetters()
{
    const auto named = [](QString &text) {
        constexpr std::array<QChar, 3> letters = {u'l', u'm', u'r'};
        for (const SortedEdge edge : sortedEdges) {
            const auto &ends = sortedEdgeEnds[std::size_t(edge)];
            text.replace(subscriptOf(edge), u"_%1%2"_s.arg(letters[ends[0]]).arg(letters[ends[1]]));
        }
        for (std::size_t vertex = 0; vertex < 3; ++vertex)
            text.replace(vertexDigits[vertex], u"_%1"_s.arg(letters[vertex]));
    };
    for (PseudocodeLine &line : m_code) {
        named(line.text);
        for (RuledLine &ruled : line.ruled)
            named(ruled.text);
    }
}

void WalkListing::addSorting()
{
    const QString sorted = isRow()
        ? u"sort the vertices by y, the largest first, those of equal y by x: P₀, P₁, P₂"_s
        : u"sort the vertices by x, those of equal x by y: P₀, P₁, P₂"_s;
    addVaried(0, sorted, {SetUp},
              {{VariantSet().with(Variant::UnsortedColours),
                sorted + u"; R, G, B stay in the order given"_s}});
}

void WalkListing::addSlopes()
{
    const VariantSet minus = VariantSet().with(Variant::DivisorMinusOne),
                     plus = VariantSet().with(Variant::DivisorPlusOne);
    const auto text = [this](const QString &change, const QString &less) {
        return slope(change, less)
            + (!carriesColours()                     ? QString()
                   : m_values == WalkValues::Colours ? u"; δR_ij, δG_ij and δB_ij likewise"_s
                                                     : u"; δ of each carried value likewise"_s);
    };
    addVaried(0, text({}, {}), {SetUp},
              {{minus, text(" − 1", " − 1")},
               {plus, text(" + 1", {})},
               {VariantSet{minus.bits | plus.bits}, text({}, {})}});
}

QString WalkListing::slope(const QString &change, const QString &less) const
{
    const QString width = isRow() ? u"y_i − y_j"_s : u"x_j − x_i"_s;
    const QString exists = isRow() ? u"y_j < y_i"_s : u"x_i < x_j"_s;
    return u"for each edge L_ij of L₀₁, L₁₂, L₀₂: m_ij ← ({a}_j − {a}_i)/(%1) if %2, else 0"_s.arg(
        width + change, exists + less);
}

void WalkListing::addRejection() { add(0, "if no sample is to be drawn: done", {Rejected}); }

/// "⌈x₀⌉ to ⌊x₂⌋": the spans that the rule takes. Rows go from the largest y down.
QString WalkListing::spans(FillRule rule, FrameOrigin origin) const
{
    const bool isTopDown = isRow() && origin == FrameOrigin::TopLeft && rule == FillRule::TopLeft;
    const bool ownsFirst = rule != FillRule::Open && !isTopDown;
    const bool ownsLast = rule == FillRule::Closed || isTopDown;
    if (isRow())
        return (ownsFirst ? u"⌊y₀⌋"_s : u"⌈y₀⌉ − 1"_s) + u" down to "_s
            + (ownsLast ? u"⌈y₂⌉"_s : u"⌊y₂⌋ + 1"_s);
    return (ownsFirst ? u"⌈x₀⌉"_s : u"⌊x₀⌋ + 1"_s) + u" to "_s
        + (ownsLast ? u"⌊x₂⌋"_s : u"⌈x₂⌉ − 1"_s);
}

void WalkListing::addSpans(int depth)
{
    const auto text = [this](FillRule rule, FrameOrigin origin) {
        return u"for each {span} {c} of the frame from %1:"_s.arg(spans(rule, origin));
    };
    add(depth, text(FillRule::Closed, FrameOrigin::BottomLeft), everySpan);
    addRules(text);
    addBounds(depth + 1);
    addOrder(depth + 1);
}

/// How far the span is from a vertex, which is 0 or i.
QString WalkListing::way(const QString &vertex) const
{
    return (isRow() ? u"({c}%1 − {c})"_s : u"({c} − {c}%1)"_s).arg(vertex);
}

QString WalkListing::alike() const
{
    if (!carriesColours())
        return {};
    return m_values == WalkValues::Colours ? u"; R, G and B likewise"_s
                                           : u"; each carried value likewise"_s;
}

QString WalkListing::fromVertex(const QString &edge, const QString &vertex,
                                const QString &way) const
{
    return u"{a}%1 ← {a}%2 + %3·m%1"_s.arg(edge, vertex, way) + alike();
}

QString WalkListing::added(const QString &edge) const
{
    return u"else: {a}%1 ← {a}%1 + m%1"_s.arg(edge) + alike();
}

void WalkListing::addBounds(int depth)
{
    const QString chosen
        = isRow() ? u"L_ij ← L₀₁ if y > y₁, else L₁₂"_s : u"L_ij ← L₀₁ if x < x₁, else L₁₂"_s;
    const QString first = "₀", either = "_i";
    if (isDirect()) {
        add(depth, fromVertex(longEdge, first, way(first)), everySpan);
        add(depth, chosen, everySpan, LineOf::Area);
        add(depth, fromVertex(shortEdge, either, way(either)), everySpan, LineOf::Area);
        return;
    }
    addBeginning(depth, "the first: ", longEdge, first, {Begin}, LineOf::EveryPrimitive);
    add(depth, added(longEdge), {TakeOver, Span});
    add(depth, chosen, everySpan, LineOf::Area);
    addBeginning(depth, "where it begins: ", shortEdge, either, {Begin, TakeOver}, LineOf::Area);
    add(depth, added(shortEdge), {Span}, LineOf::Area);
}

/// Adds the line for an edge's first span; without a pre-step it starts as if its vertex were on a
/// span.
void WalkListing::addBeginning(int depth, const QString &where, const QString &edge,
                               const QString &vertex, const std::vector<Moment> &moments, LineOf of)
{
    const QString whole = isRow() ? u"(⌊y%1⌋ − y)"_s : u"(x − ⌈x%1⌉)"_s;
    addVaried(depth, where + fromVertex(edge, vertex, way(vertex)), moments,
              {{VariantSet().with(Variant::NoEdgePreStep),
                where + fromVertex(edge, vertex, whole.arg(vertex))}},
              of);
}

QString WalkListing::ordered(const QString &condition) const
{
    return u"{a}_{lo}, {a}_{hi} ← {a}_ij, {a}₀₂ if %1, else {a}₀₂, {a}_ij"_s.arg(condition)
        + alike();
}

/// Top-left looks at the edges of a column, so that their slopes are told apart, too. At P₀, where
/// the bounds are equal, the slopes tell which edge is the lower one.
QString WalkListing::orderedWithSlopes() const
{
    return u"y_B, y_T, m_B, m_T ← y_ij, y₀₂, m_ij, m₀₂ if %1, else y₀₂, y_ij, m₀₂, m_ij"_s.arg(
               m_values == WalkValues::Carried ? u"S > 0"_s
                                               : u"y_ij < y₀₂, or y_ij = y₀₂ and m_ij < m₀₂"_s)
        + alike() + u" — by exact y and m"_s;
}

QString WalkListing::areaRemark() const
{
    return u" — %1, twice the signed area, is above 0 where L₀₂ is the {upper} edge"_s.arg(
        areaName());
}

QString WalkListing::orderedByArea() const
{
    return ordered(areaName() + u" > 0"_s) + areaRemark();
}

/// Only the closed rule draws where rounding or a variant takes the edges past each other.
void WalkListing::addOrder(int depth)
{
    const bool isByArea = isExact() && m_values == WalkValues::Carried;
    // A column's lower edge is L_ij where A > 0; rounded bounds of equal {a} differ in colour.
    const QString byArea = areaName() + u" > 0"_s;
    const QString compared = isDirect() ? u"{a}_ij ≤ {a}₀₂"_s
        : isByArea                      ? byArea
        : isExact()                     ? u"{a}_ij < {a}₀₂"_s
                    : u"{a}_ij < {a}₀₂, or {a}_ij = {a}₀₂ and "_s + byArea;
    const QString area = areaRemark();
    const QString remark = isByArea ? area
        : isExact()                 ? u" — by exact {a}"_s
        : isDirect()                ? QString()
                                    : area;
    add(depth, ordered(compared) + remark, everySpan, LineOf::Area);
    addRules([&](FillRule rule, FrameOrigin) {
        if (isExact() && !isRow() && rule == FillRule::TopLeft)
            return orderedWithSlopes();
        return isExact() ? ordered(compared) + remark : orderedByArea();
    });
    add(depth, u"{a}_{lo}, {a}_{hi} ← {a}₀, {a}₂ if {c}₀ = {c}₂, else {a}₀₂, {a}₀₂"_s + alike(),
        everySpan, LineOf::Segment);
    if (!isDirect())
        return;
    add(depth, u"β_B, β_T ← β_ij, β₀₂ if %1, else β₀₂, β_ij"_s.arg(compared), everySpan,
        LineOf::Area);
    add(depth, "β_B, β_T ← β₀₂, β₀₂", everySpan, LineOf::Segment);
}

void WalkListing::addSamples(int depth)
{
    const auto text = [this](FillRule rule, FrameOrigin origin) {
        return u"for each {across} {a} of the frame from %1:%2"_s.arg(
            samples(rule, origin),
            isExact() ? u" — by exact bounds in every arithmetic"_s : QString());
    };
    add(depth, text(FillRule::Closed, FrameOrigin::BottomLeft), {First, Next});
    addRules(text);
}

/// "⌈y_B⌉ to ⌊y_T⌋": the samples that the rule takes, each bound moved by its bias. Displaced to
/// the right, a sample on a falling edge lies above it, on a rising one below; on a level one the
/// smaller displacement decides, down on the screen.
QString WalkListing::samples(FillRule rule, FrameOrigin origin) const
{
    if (rule == FillRule::TopLeft && !isRow())
        return u"⌈y_B⌉ if m_B %1 0, else ⌊y_B⌋ + 1 to ⌊y_T⌋ if m_T %2 0, else ⌈y_T⌉ − 1"_s
            .arg(origin == FrameOrigin::TopLeft ? QChar(u'≤') : QChar(u'<'))
            .arg(origin == FrameOrigin::TopLeft ? QChar(u'>') : QChar(u'≥'));
    const Interval interval = columnIntervals(rule).rows;
    return m_names.coveredSample(SpanBound::Lower, interval) + u" to "_s
        + m_names.coveredSample(SpanBound::Upper, interval);
}

} // namespace pixelplumb
