// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/columnscanexplanation.h"
#include "core/methods/formulatext.h"
#include "core/methods/rejectiontext.h"
#include "core/methods/sortedtriangle.h"

#include <algorithm>

namespace pixelplumb {

namespace {

void appendSlope(Explanation &explanation, const SortedTriangle &triangle, SortedEdge edge)
{
    const auto index = std::size_t(edge);
    const Vertex &a = triangle.start(edge);
    const Vertex &b = triangle.end(edge);
    const QString from = subscripts[edgeEnds[index][0]];
    const QString to = subscripts[edgeEnds[index][1]];
    const Lattice width = b.position.x - a.position.x;
    FormulaLine line;
    line.symbols
        = QStringLiteral("m%1 = (y%3 − y%2)/(x%3 − x%2)").arg(edgeIndices[index], from, to);
    if (width == 0) {
        line.substituted
            = QStringLiteral("%1 is vertical: no slope, no division").arg(edgeNames[index]);
        explanation.lines.push_back(line);
        return;
    }
    line.substituted = QStringLiteral("(%1 − %2)/(%3 − %4)")
                           .arg(term(pixels(b.position.y)), operand(pixels(a.position.y)),
                                term(pixels(b.position.x)), operand(pixels(a.position.x)));
    line.used = triangle.slope(edge);
    line.exact = Quantity::rational(b.position.y - a.position.y, width);
    explanation.lines.push_back(line);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const int rise = b.colour.channels[channel] - a.colour.channels[channel];
        FormulaLine rate;
        rate.subject = channelSubjects[channel];
        rate.symbols = QStringLiteral("rate of %1 on %2 = (%1%4 − %1%3)/(x%4 − x%3)")
                           .arg(channelLetters[channel])
                           .arg(edgeNames[index], from, to);
        rate.substituted = QStringLiteral("(%1 − %2)/%3")
                               .arg(b.colour.channels[channel])
                               .arg(a.colour.channels[channel])
                               .arg(operand(pixels(width)));
        rate.used = triangle.colourRate(edge, channel);
        rate.exact = Quantity::rational(Int128(rise) * unitsPerPixel, width);
        explanation.lines.push_back(rate);
    }
}

} // namespace

Explanation explainSetUp(const TracedScene &traced, std::size_t index)
{
    const SortedTriangle triangle(traced, index);
    const SetUpRecord &setUp = triangle.setUp();
    Explanation explanation;
    explanation.heading = QStringLiteral("Triangle %1: set-up").arg(index);
    explanation.sentence
        = QStringLiteral("Sorted by x: P₀ = %1, P₁ = %2, P₂ = %3.")
              .arg(pointText(triangle[0].position), pointText(triangle[1].position),
                   pointText(triangle[2].position));
    if (setUp.rejection) {
        explanation.sentence += u' ' + rejectionText(*setUp.rejection);
        return explanation;
    }
    if (setUp.zeroArea) {
        explanation.sentence
            += QStringLiteral(" It has no area: the closed rule paints the samples on "
                              "its segment, coloured along L₀₂.");
        appendSlope(explanation, triangle, SortedEdge::L02);
        return explanation;
    }
    explanation.sentence += setUp.longEdge == LongEdge::Above
        ? QStringLiteral(" L₀₂ is above: L₀₁ and L₁₂ give y_B, L₀₂ gives y_T.")
        : QStringLiteral(" L₀₂ is below: L₀₂ gives y_B, L₀₁ and L₁₂ give y_T.");
    if (triangle[0].position.x == triangle[1].position.x)
        explanation.sentence += QStringLiteral(" x₀ = x₁: the first half is skipped.");
    for (const SortedEdge edge : {SortedEdge::L01, SortedEdge::L12, SortedEdge::L02})
        appendSlope(explanation, triangle, edge);
    return explanation;
}

} // namespace pixelplumb
