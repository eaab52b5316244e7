// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgewalkstate.h"
#include "core/methods/words/edgewalkform.h"
#include "core/trace/numberdescription.h"

#include <array>

namespace pixelplumb {

/// One of the two bounds of a span: B and T of a column, L and R of a row.
enum class SpanBound { Lower, Upper };

inline constexpr std::array<QChar, 3> vertexDigits = {u'₀', u'₁', u'₂'};

/// The two vertices of an edge, by SortedEdge.
inline constexpr std::array<std::array<std::size_t, 2>, 3> sortedEdgeEnds
    = {{{0, 1}, {1, 2}, {0, 2}}};

inline constexpr std::array sortedEdges = {SortedEdge::L01, SortedEdge::L12, SortedEdge::L02};

/// "₀₁"; the smaller digit first.
QString subscriptOf(SortedEdge edge, const std::array<std::size_t, 3> &digits = {0, 1, 2});
/// "L₀₁".
QString nameOf(SortedEdge edge);

/// The letters of an edge walk. In its texts {a} is the coordinate along the span and {c} the one
/// across the spans; {lo} and {hi} are the bounds; {span}, {half}, {lower} and {upper} are words.
class EdgeWalkNames {
public:
    explicit EdgeWalkNames(const EdgeWalkForm &form)
        : m_form(form)
    {
    }

    const EdgeWalkForm &form() const { return m_form; }
    bool isRow() const { return m_form.axis == SpanAxis::Row; }

    QString filled(QString text) const;
    NumberDescription filled(NumberDescription description) const;

    /// The distance from a vertex to the span in a formula, px: "(x − x₀)"; for an edge without
    /// pre-step from its first span on: "(x − ⌈x₀⌉)".
    QString way(std::size_t corner, VariantSet variants = {}) const;
    /// The distance between two vertices: "(x₁ − x₀)".
    QString way(std::size_t from, std::size_t to) const;
    /// What divides an edge's increments: "(x₁ − x₀)"; with a variant "(x₁ − x₀ − 1)".
    QString divisor(SortedEdge edge, VariantSet variants) const;

    /// The coordinate across the spans, turned as the scan turns it, lattice units.
    Lattice across(const Vertex &corner) const
    {
        return isRow() ? -corner.position.y : corner.position.x;
    }
    /// True where the edge lies along the spans and has no slope.
    bool hasNoSlope(const std::array<Vertex, 3> &corners, SortedEdge edge) const
    {
        const auto &ends = sortedEdgeEnds[std::size_t(edge)];
        return across(corners[ends[0]]) == across(corners[ends[1]]);
    }

    /// True where Δ − 1 leaves nothing to divide by: the edge stays at its first vertex.
    bool isTooShort(const std::array<Vertex, 3> &corners, SortedEdge edge,
                    VariantSet variants) const;

    /// "Column 27, second half", "Row 3, first trapezoid"; of a triangle without area "Column 27".
    QString heading(const EdgeWalkSpanState &state) const;
    /// The first or last covered sample of a span: "⌈y_B⌉", "⌈y_T⌉ − 1" where y_T is not covered,
    /// "⌈y_B − β_B⌉" in the direct form, which adds its bias first.
    QString coveredSample(SpanBound bound, Interval covered) const;

    /// Where a bound's position or colour comes from in this span: `title` is the number's title,
    /// `value` its letter at a vertex and `rate` the letter of its change ("y_B", "y", "m").
    QString boundFormula(const EdgeWalkSpanState &state, SpanBound bound, const QString &title,
                         const QString &value, const QString &rate) const;

private:
    /// A rounding with the direct form's bias.
    QString biased(QString rounding) const;
    /// The title of the same number at the other bound.
    QString exchanged(const QString &title) const;

    EdgeWalkForm m_form;
};

/// The change along x or y of the plane through the values % of the three vertices, over their
/// doubled area; and that area in the vertices' coordinates.
QString planeSlope(QChar axis, const QString &doubledArea);
QString doubledAreaText();
/// "β_C": what moves float64's levels before they are cut to bytes.
QString colourBiasTitle();

} // namespace pixelplumb
