// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/scan/scansettings.h"
#include "core/scan/tests/edgetestform.h"

#include <QString>

namespace pixelplumb {

/// The letters of the slides, by form: E₀ from P₀ and P₁; f_bc and α from a, b and c; u, v and w
/// from A, B and C.
class EdgeTestNames {
public:
    explicit EdgeTestNames(const EdgeTestForm &form)
        : m_form(form)
    {
    }

    const EdgeTestForm &form() const { return m_form; }

    /// The suffix of a vertex's coordinates and levels: "₀", "_a"; in files "_0", "_a".
    QString vertex(std::size_t vertex) const;
    QString vertexId(std::size_t vertex) const;
    QString vertexLetter(std::size_t vertex) const; ///< "P₀", "a"
    /// The vertex in a sentence: "P₀"; with its letter "a = P₀".
    QString vertexName(std::size_t vertex) const;
    /// The weight of the vertex that faces a line: "α".
    QString weight(std::size_t line) const;

    /// A text with {l} replaced by the line, {from}, {to} and {opp} by its vertices, {letter} by
    /// the letter of {opp}, {w} by the weight and {value} by its value; in sentences {edge} by the
    /// edge's name, "P₀P₁" or "bc", and {facing} by that of the vertex that faces it.
    QString filled(QString text, std::size_t line) const;
    QString filledId(QString text, std::size_t line) const;

    /// The line's equation at a point, its placeholders such as {l} not yet filled in.
    QString lineAt(const QString &x, const QString &y) const;
    /// The value of a line of the set-up at a point; placeholders as in lineAt(). Cramer's rule has
    /// no coefficients for it: its own counts from C, or from the edge's first end if C is not an
    /// end of it.
    QString valueAt(std::size_t line, const QString &x, const QString &y) const;
    /// "a₀, b₀, c₀" of "%₀": a text for each coefficient of the form, % its letter.
    QString coefficients(const QString &each) const;
    /// Their values, from the ends of the edge; placeholders as in lineAt().
    QString coefficientsText() const;
    /// When a sample exactly on a line is inside, under a rule to which not all lines are alike.
    QString tieCondition(FillRule rule, FrameOrigin origin) const;
    /// The same in words, as the remark of a line.
    static QString tieRemark(FillRule rule);
    /// Above 0 where a value of a line has the sign that it has at the facing vertex: f_a·a_bc.
    /// Edge equations are positive there, and under Cramer's rule D is the opposite of each value.
    QString towardsFacing(const QString &value) const;
    QString weightFormula(std::size_t line) const;
    /// % stands for the channel's letter.
    QString levelFormula() const;
    /// "if u ≥ 0 and v ≥ 0 and u + v ≤ 1:". Of u, v and w the third test is on the sum.
    QString cramerText(FillRule rule) const;

private:
    EdgeTestForm m_form;
};

} // namespace pixelplumb
