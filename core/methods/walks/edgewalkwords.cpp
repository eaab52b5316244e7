// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/walks/edgewalkwords.h"

#include "core/methods/words/formulatext.h"

#include <QStringList>

namespace pixelplumb {

void EdgeWalkWords::tell(StepWords &words, const EdgeWalkSetUpState &state) const
{
    const ColumnSetUp<AnyArithmetic> &scan = state.walk.scan;
    QStringList points;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        // Between its extreme vertices a row walk sees no third one.
        if (scan.zeroArea && m_names.isRow() && corner == 1)
            continue;
        points.append(
            (scan.zeroArea && m_names.isRow()
                 ? u"P%1 = %2"_s.arg(vertexDigits[corner])
                 : u"P%1 = vertex %2 %3"_s.arg(vertexDigits[corner]).arg(scan.order[corner]))
                .arg(pointText(state.walk.corners[corner].position)));
    }
    QString sentence
        = (m_names.isRow() ? u"Sorted by y, the largest first: %1."_s : u"Sorted by x: %1."_s)
              .arg(points.join(u", "_s));
    if (scan.zeroArea) {
        words.sentence = sentence
            + u" It has no area: the closed rule paints the samples on its segment, "
              "coloured along L₀₂."_s;
        return;
    }
    const bool isAbove = scan.longEdge == LongEdge::Above;
    if (m_names.isRow())
        sentence += isAbove ? u" L₀₁ and L₁₂ give x_L, L₀₂ gives x_R."_s
                            : u" L₀₂ gives x_L, L₀₁ and L₁₂ give x_R."_s;
    else
        sentence += isAbove ? u" L₀₁ and L₁₂ give y_B, L₀₂ gives y_T."_s
                            : u" L₀₂ gives y_B, L₀₁ and L₁₂ give y_T."_s;
    if (m_names.hasNoSlope(state.walk.corners, SortedEdge::L01))
        sentence
            += m_names.filled(" {c}₀ = {c}₁: L₀₁ has no slope, and the first {half} is skipped.");
    else if (m_names.hasNoSlope(state.walk.corners, SortedEdge::L12))
        sentence += m_names.filled(
            " {c}₁ = {c}₂: L₁₂ has no slope, and the second {half} is one {span} at most.");
    words.sentence = sentence;
}

QString EdgeWalkWords::turnSentence(const EdgeWalkSpanState &state) const
{
    if (!state.start.hasPlane || !state.beginsHalf || state.column.half == ColumnHalf::First)
        return {};
    return m_names.filled(state.isFirst
                              ? u"The scan starts in the second {half}, between L₁₂ and L₀₂. "_s
                              : u"At {c}₁ the scan stops tracking L₀₁ and starts L₁₂ at P₁. "_s);
}

/// For a span without pixels: what its bounds have between them and, if only samples exactly on
/// them, that the rule does not take these.
QString EdgeWalkWords::emptySentence(const EdgeWalkSpanState &state) const
{
    const ColumnState<AnyArithmetic> &column = state.column;
    const QString lower = term(column.yBottom);
    const QString upper = term(column.yTop);
    QStringList left;
    if (column.firstRow >= column.endRow) {
        if (column.yBottom.isInteger() && !ownsFirst(state.start.covered))
            left.append(lower);
        if (column.yTop.isInteger() && !ownsLast(state.start.covered) && !left.contains(upper))
            left.append(upper);
    }
    if (left.isEmpty())
        return m_names
            .filled("Between {a}_{lo} = %1 and {a}_{hi} = %2 the fill rule takes no sample of the "
                    "frame.")
            .arg(lower, upper);
    const QString pattern = left.size() == 1
        ? u"{a}_{lo} = %1 and {a}_{hi} = %2 have just the {across} %3 between them, "
          "exactly on an edge, and the fill rule does not take it."_s
        : u"{a}_{lo} = %1 and {a}_{hi} = %2 have just the {across}s %3 between them, "
          "exactly on edges, and the fill rule takes neither."_s;
    return m_names.filled(pattern).arg(lower, upper, left.join(u" and "_s));
}

QString EdgeWalkWords::coverSentence(const EdgeWalkSpanState &state) const
{
    const QString lower = term(state.column.yBottom);
    const QString upper = term(state.column.yTop);
    const std::int64_t count = state.drawnSamples();
    if (count == 0)
        return emptySentence(state);
    const QString pattern = count == 1
        ? u"{a}_{lo} = %1 and {a}_{hi} = %2 cover the {across} %3."_s
        : u"{a}_{lo} = %1 and {a}_{hi} = %2 cover the {across}s %3 to %4."_s;
    const QString text = m_names.filled(pattern).arg(lower, upper).arg(state.column.firstDrawn);
    return count == 1 ? text : text.arg(state.column.endDrawn - 1);
}

/// What a variant skips in this span.
QString EdgeWalkWords::departureSentence(const EdgeWalkSpanState &state) const
{
    QString text;
    if (state.start.hasPlane && state.beginsHalf
        && state.settings.variants.contains(Variant::NoEdgePreStep))
        text += m_names.filled(" Without a pre-step, an edge that begins here has its vertex's "
                               "values, wherever between two {span}s the vertex lies.");
    if (!state.start.hasPreStep && !state.start.isPoint && state.drawnSamples() > 0)
        text += m_names
                    .filled(" Without a pre-step, the first {across} has the colours of {a}_{lo}: "
                            "(%1 − {a}_{lo})·Δ is left out.")
                    .arg(m_names.coveredSample(SpanBound::Lower, state.start.covered));
    return text;
}

void EdgeWalkWords::tell(StepWords &words, const EdgeWalkSpanState &state) const
{
    words.heading = m_names.heading(state);
    words.sentence = turnSentence(state) + coverSentence(state);
    if (state.start.isPoint && state.drawnSamples() > 0
        && m_names.form().rate == ColourRate::Bilinear)
        words.sentence += m_names.filled(
            " The bounds are equal, so there is no change to spread between them, and no Δ.");
    words.sentence += departureSentence(state);
    if (state.start.hasPlane && state.beginsHalf && !state.isFirst)
        words.moment = Moment::TakeOver;
    if (state.start.hasPlane && state.column.half == ColumnHalf::Second && state.beginsHalf)
        words.event = m_names.filled(state.isFirst ? u"the second {half} comes first: L₁₂ and L₀₂"_s
                                                   : u"{c}₁ reached: L₁₂ takes over from L₀₁"_s);
}

void EdgeWalkWords::tell(StepWords &words, const EdgeWalkSampleState &state) const
{
    if (state.isFirst)
        words.sentence
            = m_names.filled("The {span}'s first pixel takes the starting values of R, G and B.");
    else if (m_names.form().walk == WalkForm::Direct
             && (state.start.hasPlane || state.start.isVertical))
        words.sentence = "Each level is computed from P₀ anew.";
    else
        words.sentence = m_names.isRow() ? u"The next column: each level changes by its Δ."_s
                                         : u"The next row: each level changes by its Δ."_s;
}

} // namespace pixelplumb
