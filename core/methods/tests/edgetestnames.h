// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
    /// How the numbers of the edges are found.
    QString linesText() const;
    QString weightFormula(std::size_t line) const;
    /// % stands for the channel's letter.
    QString levelFormula() const;
    /// What gives the triangle a sample exactly on a line; placeholders as in lineAt().
    QString tieText(FillRule rule) const;
    /// "if u ≥ 0 and v ≥ 0 and u + v ≤ 1:". Of u, v and w the third test is on the sum.
    QString cramerText(FillRule rule) const;

private:
    EdgeTestForm m_form;
};

} // namespace pixelplumb
