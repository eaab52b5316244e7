// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/columnscanexplanation.h"
#include "core/methods/formulatext.h"
#include "core/methods/sortedtriangle.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The column in hand with the one before it, if that was on the same triangle.
struct ColumnPair {
    ColumnRecord current;
    std::optional<ColumnRecord> previous;
};

/// How a number of an edge came about: started at the edge's first vertex, or stepped by a rate.
FormulaLine edgeLine(const QString &symbol, const Quantity &used,
                     const std::optional<Quantity> &previous, const Quantity &rate,
                     const QString &rateSymbol, const QString &startSymbol, const Quantity &start,
                     const Quantity &preStep)
{
    FormulaLine line;
    line.used = used;
    if (previous) {
        line.symbols = QStringLiteral("%1 ← %1 + %2").arg(symbol, rateSymbol);
        line.substituted = QStringLiteral("%1 + %2").arg(term(*previous), operand(rate));
    } else if (preStep == Quantity::integer(0)) {
        line.symbols = QStringLiteral("%1 ← %2").arg(symbol, startSymbol);
        line.substituted = term(start);
    } else {
        line.symbols
            = QStringLiteral("%1 ← %2 + (x − x_start)·%3").arg(symbol, startSymbol, rateSymbol);
        line.substituted
            = QStringLiteral("%1 + %2·%3").arg(term(start), operand(preStep), operand(rate));
    }
    return line;
}

/// The numbers of one bound of the column: y, then R, G, B on it.
void appendEdge(Explanation &explanation, const SortedTriangle &triangle, const ColumnPair &columns,
                const std::optional<oracle::ExactColumn> &exact, FormulaSubject bound)
{
    const bool lower = bound == FormulaSubject::LowerEdge;
    const ColumnRecord &column = columns.current;
    const SortedEdge edge
        = lower ? triangle.lowerEdge(column.half()) : triangle.upperEdge(column.half());
    const auto index = std::size_t(edge);
    // A vertical edge, and the upper bound of a vertical segment, stay at a vertex.
    const bool segmentTop = triangle.setUp().zeroArea && !lower
        && triangle.start(edge).position.x == triangle.end(edge).position.x;
    const Vertex &from = segmentTop ? triangle.end(edge) : triangle.start(edge);
    const QString fromIndex = subscripts[edgeEnds[index][segmentTop ? 1 : 0]];
    const bool steps = columns.previous
        && (columns.previous->half() == column.half() || edge == SortedEdge::L02);
    const Quantity preStep = from.position.x == triangle.end(edge).position.x
        ? Quantity::integer(0)
        : Quantity::rational(Int128(column.x()) * unitsPerPixel - from.position.x, unitsPerPixel);
    const QString suffix = lower ? QStringLiteral("_B") : QStringLiteral("_T");

    const auto earlier
        = [&](const Quantity &quantity) { return steps ? std::optional(quantity) : std::nullopt; };
    const ColumnRecord none;
    const ColumnRecord &previous = columns.previous ? *columns.previous : none;
    FormulaLine line = edgeLine(u'y' + suffix, lower ? column.yBottom() : column.yTop(),
                                earlier(lower ? previous.yBottom() : previous.yTop()),
                                triangle.slope(edge), QStringLiteral("m%1").arg(edgeIndices[index]),
                                u'y' + fromIndex, pixels(from.position.y), preStep);
    line.subject = bound;
    if (exact)
        line.exact = lower ? exact->yBottom : exact->yTop;
    explanation.lines.push_back(line);

    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto levelOf = [&](const ColumnRecord &record) {
            return lower ? record.colourBottom(channel) : record.colourTop(channel);
        };
        FormulaLine level = edgeLine(
            channelLetters[channel] + suffix, levelOf(column), earlier(levelOf(previous)),
            triangle.colourRate(edge, channel),
            QStringLiteral("rate of %1 on %2").arg(channelLetters[channel]).arg(edgeNames[index]),
            channelLetters[channel] + fromIndex, Quantity::integer(from.colour.channels[channel]),
            preStep);
        level.subject = channelSubjects[channel];
        if (exact)
            level.exact = lower ? exact->colourBottom[channel] : exact->colourTop[channel];
        explanation.lines.push_back(level);
    }
}

/// Δ and the start of each channel in the column.
void appendRamp(Explanation &explanation, const TracedScene &traced, const ColumnRecord &column,
                const std::optional<oracle::ExactColumn> &exact)
{
    const Triangle &triangle = traced.primitives.triangles[column.span().primitive];
    const bool isSegment = doubledArea(triangle) == 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const QChar name = channelLetters[channel];
        FormulaLine rate;
        rate.subject = channelSubjects[channel];
        rate.symbols = QStringLiteral("Δ%1 = (%1_T − %1_B)/(y_T − y_B)").arg(name);
        if (column.yTop() != column.yBottom())
            rate.substituted
                = QStringLiteral("(%1 − %2)/(%3 − %4)")
                      .arg(term(column.colourTop(channel)), operand(column.colourBottom(channel)),
                           term(column.yTop()), operand(column.yBottom()));
        else if (traced.scene.settings.arithmetic == Arithmetic::Exact && !isSegment)
            rate.substituted = QStringLiteral("0/0 here; the plane's, as in every column");
        else
            rate.substituted = QStringLiteral("y_T = y_B: nothing to share out");
        rate.used = column.colourRate(channel);
        if (exact)
            rate.exact = exact->colourRate[channel];
        explanation.lines.push_back(rate);

        if (column.span().drawnSamples() == 0)
            continue;
        FormulaLine start;
        start.subject = channelSubjects[channel];
        const bool clipped = column.span().firstDrawn != column.span().firstSample;
        start.symbols = clipped ? QStringLiteral("%1 = %1_B + (y_frame − y_B)·Δ%1").arg(name)
                                : QStringLiteral("%1 = %1_B + (⌈y_B⌉ − y_B)·Δ%1").arg(name);
        start.substituted
            = QStringLiteral("%1 + (%2 − %3)·%4")
                  .arg(term(column.colourBottom(channel)),
                       term(Quantity::integer(column.span().firstDrawn)), operand(column.yBottom()),
                       operand(column.colourRate(channel)));
        start.used = column.firstColour(channel);
        start.exact = oracle::colourAt(triangle, column.x(), column.span().firstDrawn)[channel];
        explanation.lines.push_back(start);
    }
}

void appendSpan(Explanation &explanation, const ColumnRecord &column,
                const std::optional<oracle::ExactColumn> &exact, FillRule rule)
{
    FormulaLine first;
    first.subject = FormulaSubject::LowerEdge;
    first.symbols = QStringLiteral("first row = ⌈y_B⌉");
    first.substituted = QStringLiteral("⌈%1⌉").arg(term(column.yBottom()));
    first.used = Quantity::integer(column.span().firstSample);
    FormulaLine last;
    last.subject = FormulaSubject::UpperEdge;
    last.symbols = rule == FillRule::Closed ? QStringLiteral("last row = ⌊y_T⌋")
                                            : QStringLiteral("last row = ⌈y_T⌉ − 1");
    last.substituted
        = (rule == FillRule::Closed ? QStringLiteral("⌊%1⌋") : QStringLiteral("⌈%1⌉ − 1"))
              .arg(term(column.yTop()));
    last.used = Quantity::integer(column.span().endSample - 1);
    if (exact) {
        first.exact = Quantity::integer(exact->firstRow);
        last.exact = Quantity::integer(exact->endRow - 1);
    }
    explanation.lines.push_back(first);
    explanation.lines.push_back(last);
}

QString halfText(ColumnHalf half)
{
    return half == ColumnHalf::First ? QStringLiteral("first half") : QStringLiteral("second half");
}

} // namespace

Explanation explainColumn(const TracedScene &traced, const TraceStep &step)
{
    const ScanTrace &trace = *traced.trace;
    const SortedTriangle triangle(traced, step.primitive);
    ColumnPair columns{ColumnRecord(trace.span(step.span)), std::nullopt};
    if (step.span > trace.firstSpanOf(step.primitive))
        columns.previous = ColumnRecord(trace.span(step.span - 1));
    const ColumnRecord &column = columns.current;
    const FillRule rule = traced.scene.settings.fillRule;
    const std::optional<oracle::ExactColumn> exact
        = oracle::columnAt(traced.primitives.triangles[step.primitive], rule, column.x());

    Explanation explanation;
    explanation.heading
        = QStringLiteral("Column %1, %2").arg(column.x()).arg(halfText(column.half()));
    explanation.isHalfChange = column.half() == ColumnHalf::Second
        && (!columns.previous || columns.previous->half() == ColumnHalf::First);
    if (explanation.isHalfChange)
        explanation.sentence = columns.previous
            ? QStringLiteral("At x₁ the scan stops tracking L₀₁ and starts L₁₂ at P₁. ")
            : QStringLiteral("The scan starts in the second half, between L₁₂ and L₀₂. ");
    if (column.span().drawnSamples() > 0)
        explanation.sentence += QStringLiteral("y_B = %1 and y_T = %2 cover the rows %3 to %4.")
                                    .arg(term(column.yBottom()), term(column.yTop()))
                                    .arg(column.span().firstDrawn)
                                    .arg(column.span().endDrawn - 1);
    else
        explanation.sentence
            += QStringLiteral("No sample of the frame lies between y_B = %1 and y_T = %2.")
                   .arg(term(column.yBottom()), term(column.yTop()));
    appendEdge(explanation, triangle, columns, exact, FormulaSubject::LowerEdge);
    appendEdge(explanation, triangle, columns, exact, FormulaSubject::UpperEdge);
    appendSpan(explanation, column, exact, rule);
    appendRamp(explanation, traced, column, exact);
    return explanation;
}

} // namespace pixelplumb
