// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/edgewalknames.h"

#include "core/methods/words/formulatext.h"

#include <algorithm>

namespace pixelplumb {

QString subscriptOf(SortedEdge edge, const std::array<std::size_t, 3> &digitOf)
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    const auto [first, last] = std::minmax(digitOf[ends[0]], digitOf[ends[1]]);
    return QString(vertexDigits[first]) + vertexDigits[last];
}

QString nameOf(SortedEdge edge) { return u'L' + subscriptOf(edge); }

QString EdgeWalkNames::filled(QString text) const
{
    const auto put = [&](const char *name, const QString &inColumn, const QString &inRow) {
        text.replace(QLatin1String(name), isRow() ? inRow : inColumn);
    };
    put("{a}", "y", "x");
    put("{c}", "x", "y");
    put("{lo}", "B", "L");
    put("{hi}", "T", "R");
    put("{span}", "column", "row");
    put("{across}", "row", "column");
    put("{half}", "half", "trapezoid");
    // y may point either way on the screen, x points to the right.
    put("{lower}", "smaller-y", "left");
    put("{upper}", "larger-y", "right");
    return text;
}

NumberDescription EdgeWalkNames::filled(NumberDescription description) const
{
    for (QString *text : {&description.id, &description.title, &description.unit,
                          &description.toolTip, &description.formula, &description.startFormula})
        *text = filled(*text);
    if (isRow() && description.subject == NumberSubject::LowerEdge)
        description.subject = NumberSubject::LeftEdge;
    if (isRow() && description.subject == NumberSubject::UpperEdge)
        description.subject = NumberSubject::RightEdge;
    return description;
}

QString EdgeWalkNames::way(std::size_t corner, VariantSet variants) const
{
    // Rows are walked from the largest y on, columns from the smallest x.
    if (variants.contains(Variant::NoEdgePreStep))
        return (isRow() ? u"(⌊y%1⌋ − y)"_s : u"(x − ⌈x%1⌉)"_s).arg(vertexDigits[corner]);
    return (isRow() ? u"(y%1 − y)"_s : u"(x − x%1)"_s).arg(vertexDigits[corner]);
}

QString EdgeWalkNames::way(std::size_t from, std::size_t to) const
{
    const QString pattern = isRow() ? u"(y%1 − y%2)"_s : u"(x%2 − x%1)"_s;
    return pattern.arg(vertexDigits[from]).arg(vertexDigits[to]);
}

QString EdgeWalkNames::divisor(SortedEdge edge, VariantSet variants) const
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    return way(ends[0], ends[1]).chopped(1) + divisorChange(variants) + u')';
}

bool EdgeWalkNames::isTooShort(const std::array<Vertex, 3> &corners, SortedEdge edge,
                               VariantSet variants) const
{
    const auto &ends = sortedEdgeEnds[std::size_t(edge)];
    return variants.contains(Variant::DivisorMinusOne)
        && across(corners[ends[1]]) - across(corners[ends[0]]) <= unitsPerPixel;
}

QString EdgeWalkNames::heading(const EdgeWalkSpanState &state) const
{
    const QString place
        = isRow() ? u"Row %1"_s.arg(-state.column.x) : u"Column %1"_s.arg(state.column.x);
    if (!state.start.hasPlane)
        return place;
    return place
        + filled(state.column.half == ColumnHalf::First ? u", first {half}"_s
                                                        : u", second {half}"_s);
}

QString EdgeWalkNames::coveredSample(SpanBound bound, Interval covered) const
{
    if (bound == SpanBound::Lower)
        return biased(filled(ownsFirst(covered) ? u"⌈{a}_{lo}⌉"_s : u"⌊{a}_{lo}⌋ + 1"_s));
    return biased(filled(ownsLast(covered) ? u"⌊{a}_{hi}⌋"_s : u"⌈{a}_{hi}⌉ − 1"_s));
}

QString EdgeWalkNames::biased(QString rounding) const
{
    if (m_form.walk == WalkForm::Accumulated)
        return rounding;
    const QString bound = rounding.contains(filled("_{lo}")) ? filled("β_{lo}") : filled("β_{hi}");
    return rounding.replace(u'⌉', u" − %1⌉"_s.arg(bound)).replace(u'⌋', u" + %1⌋"_s.arg(bound));
}

QString EdgeWalkNames::exchanged(const QString &title) const
{
    const QString lower = filled("{lo}");
    const QString upper = filled("{hi}");
    return title.chopped(1) + (title.endsWith(lower) ? upper : lower);
}

QString EdgeWalkNames::boundFormula(const EdgeWalkSpanState &state, SpanBound bound,
                                    const QString &title, const QString &value,
                                    const QString &rate) const
{
    const SortedEdge edge = bound == SpanBound::Lower ? state.lower : state.upper;
    const QString slope = rate + subscriptOf(edge, state.digits);
    // L₀₂ goes on through the middle vertex; a short edge does not.
    const bool goesOn = m_form.walk == WalkForm::Accumulated && !state.isFirst
        && (edge == SortedEdge::L02 || !state.beginsHalf);
    if (goesOn)
        return u"%1 ← %2′ + %3"_s.arg(title, state.isCrossed ? exchanged(title) : title, slope);
    const bool isAlong = hasNoSlope(state.corners, edge);
    // A segment along the span lies in a single span, from P0 to P2.
    const bool isSegmentsEnd = !state.start.hasPlane && isAlong && bound == SpanBound::Upper;
    const std::size_t from = isSegmentsEnd ? 2 : sortedEdgeEnds[std::size_t(edge)][0];
    const QString start = value + vertexDigits[state.digits[from]];
    const VariantSet variants = state.start.hasPlane ? state.settings.variants : VariantSet{};
    const Lattice vertex = across(state.corners[from]);
    const Lattice first
        = variants.contains(Variant::NoEdgePreStep) ? ceilPixel(vertex) * unitsPerPixel : vertex;
    if (isAlong || state.column.x * unitsPerPixel == first)
        return u"%1 ← %2"_s.arg(title, start);
    return u"%1 ← %2 + %3·%4"_s.arg(title, start, way(state.digits[from], variants), slope);
}

QString planeSlope(QChar axis, const QString &doubledArea)
{
    return u'('
        + (axis == u'x' ? u"(%₁ − %₀)·(y₂ − y₀) − (%₂ − %₀)·(y₁ − y₀)"_s
                        : u"(%₂ − %₀)·(x₁ − x₀) − (%₁ − %₀)·(x₂ − x₀)"_s)
        + u")/"_s + doubledArea;
}

QString doubledAreaText() { return u"(x₁ − x₀)·(y₂ − y₀) − (x₂ − x₀)·(y₁ − y₀)"_s; }

QString colourBiasTitle() { return u"β_C"_s; }

} // namespace pixelplumb
