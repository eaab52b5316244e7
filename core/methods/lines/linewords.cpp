// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/lines/linewords.h"

#include "core/methods/words/formulatext.h"

namespace pixelplumb {

namespace {

QString pixelText(const LinePlace &place)
{
    const QString pixel = u"the pixel (%1, %2)"_s.arg(place.x()).arg(place.y());
    return place.isInFrame ? pixel : pixel + u", outside the frame"_s;
}

/// Where the line is, not rounded, and the pixel that it rounds to.
QString roundingSentence(const QString &what, const LinePlace &place, const Quantity &ordinate)
{
    const bool isSteep = place.axis == LineAxis::Y;
    return u"On the %1 %2 %3 is at %4 = %5, which rounds to %6."_s
        .arg(isSteep ? u"row"_s : u"column"_s)
        .arg(place.along)
        .arg(what)
        .arg(isSteep ? u"x"_s : u"y"_s, term(ordinate), pixelText(place));
}

QString signText(const Quantity &decision)
{
    if (decision.numerator() == 0)
        return u"0, a tie"_s;
    return term(decision) + (decision.numerator() < 0 ? u" < 0"_s : u" > 0"_s);
}

/// "2Δy·x_k − 2Δx·y_k + c = 6·20 − 20·41 + 702 = ", as on the slide; empty if there is no c.
QString wholeDecision(const DecisionState &state)
{
    if (state.constant.isNone())
        return {};
    const QChar sign = state.falls() ? u'+' : u'−';
    const auto terms = [sign](const QString &perColumn, const QString &x, const QString &perRow,
                              const QString &y, const QString &constant) {
        return u"%1·%2 %3 %4·%5 + %6 = "_s.arg(perColumn, x, sign, perRow, y, constant);
    };
    return terms("2Δy", "x_k", "2Δx", "y_k", "c")
        + terms(operand(state.perColumn), operand(Quantity::integer(state.place.along - 1)),
                operand(state.perRow), operand(Quantity::integer(state.acrossBefore())),
                operand(state.constant));
}

/// "p_k = 2 > 0: step diagonally to the pixel (3, 2); Δp = 2Δy − 2Δx = −14."
QString decisionSentence(const DecisionState &state)
{
    if (!state.isLedByDecision() && state.nextDecision.isNone())
        return u"The line is one pixel, %1: there is nothing to decide."_s.arg(
            pixelText(state.place));
    if (!state.isLedByDecision()) {
        const QString next
            = u"p_k₊₁ = %1 decides about the next one."_s.arg(signText(state.nextDecision));
        return !state.ordinate.isNone()
            ? roundingSentence("the line", state.place, state.ordinate) + u' ' + next
            : u"The line starts at %1 without a decision; "_s.arg(pixelText(state.place)) + next;
    }
    const bool isSteep = state.place.axis == LineAxis::Y;
    const QString stay = isSteep ? u"stay in the column, at"_s : u"stay in the row, at"_s;
    return u"p_k = %1: %2 %3; Δp = %4 = %5."_s.arg(
        wholeDecision(state) + signText(state.decision),
        state.movesAcross ? u"step diagonally to"_s : stay, pixelText(state.place),
        state.movesAcross ? u"2Δy − 2Δx"_s : u"2Δy"_s, term(state.increment));
}

QString pairText(const Quantity &first, const Quantity &second)
{
    return u"(%1, %2)"_s.arg(term(first), term(second));
}

/// The ends as the method stores them. For a steep line the pairs are exchanged, and so are the
/// letters that the slides use.
QString endsSentence(LineAxis axis, const QString &letters, const std::array<Quantity, 2> &start,
                     const std::array<Quantity, 2> &end)
{
    const auto named
        = [&](QChar digit) { return u"(%1%3, %2%3)"_s.arg(letters[0]).arg(letters[1]).arg(digit); };
    if (axis == LineAxis::X)
        return u"The left end is stored first: %1 = %2, %3 = %4."_s.arg(
            named(u'₀'), pairText(start[0], start[1]), named(u'₁'), pairText(end[0], end[1]));
    return u"The line is steep, |Δy| ≥ |Δx|: x and y are exchanged, and it is walked "
           "along y. The end of smaller y, %1, is stored first: %2 = %3, %4 = %5."_s.arg(
               pairText(start[1], start[0]), named(u'₀'), pairText(start[0], start[1]), named(u'₁'),
               pairText(end[0], end[1]));
}

std::array<Quantity, 2> coordinatesOf(const Vertex &vertex)
{
    return {pixels(vertex.position.x), pixels(vertex.position.y)};
}

} // namespace

void tellLine(StepWords &words, const SlopeInterceptSetUpState &state)
{
    words.sentence
        = endsSentence(LineAxis::X, "xy", coordinatesOf(state.start), coordinatesOf(state.end));
}

void tellLine(StepWords &words, const DdaSetUpState &state)
{
    words.sentence
        = endsSentence(state.axis, "uv", coordinatesOf(state.start), coordinatesOf(state.end));
}

void tellLine(StepWords &words, const ParametricLineSetUpState &state)
{
    words.sentence = u"t goes from 0 to 1/%1 in steps of 1/%2: one pixel of the "
                     "longer side, or less, for each step of P(t)."_s.arg(state.pace)
                         .arg(state.steps);
    if (state.pace > 1)
        words.sentence
            += u" P(%1t) goes %1 times as far, so that there are gaps."_s.arg(state.pace);
    else
        words.sentence.replace(u"1/1 "_s, u"1 "_s);
}

void tellLine(StepWords &words, const DecisionSetUpState &state)
{
    words.sentence
        = endsSentence(state.axis, "xy", {state.startX, state.startY}, {state.endX, state.endY});
}

void tellLine(StepWords &words, const SlopeInterceptState &state)
{
    words.sentence = u"On the column %1 the line is at y = %2; (int)(y + ½) makes it %3."_s.arg(
        QString::number(state.place.along), term(state.ordinate), pixelText(state.place));
}

void tellLine(StepWords &words, const DdaState &state)
{
    words.sentence = roundingSentence("the walk", state.place, state.ordinate);
}

void tellLine(StepWords &words, const ParametricLineState &state)
{
    words.sentence = u"At t = %1 the line is at (%2, %3), which rounds to %4."_s.arg(
        term(state.t), term(state.x), term(state.y), pixelText(state.place));
}

void tellLine(StepWords &words, const DecisionState &state)
{
    if (!state.isLedByDecision())
        words.moment = Moment::Begin;
    else
        words.moment = state.movesAcross ? Moment::Cross : Moment::Stay;
    words.sentence = decisionSentence(state);
}

} // namespace pixelplumb
