// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curves/curvewords.h"

#include "core/methods/curves/beziernumbers.h"
#include "core/methods/words/formulatext.h"

#include <QStringList>

#include <algorithm>

namespace pixelplumb {

namespace {

QString pairText(std::int64_t x, std::int64_t y) { return u"(%1, %2)"_s.arg(x).arg(y); }

QString pixelText(const LatticePoint &pixel)
{
    return u"the pixel "_s + pairText(pixel.x, pixel.y);
}

/// Which side of the circle the midpoint is on, by the sign of F there.
QString midpointSignText(const Quantity &decision)
{
    if (decision.numerator() == 0)
        return u"0"_s;
    return term(decision) + (decision.numerator() < 0 ? u" < 0"_s : u" > 0"_s);
}

/// Which side of the curve the midpoint is on. A row stays with it outside only by the variant
/// StayAtZero.
QString sideText(const MidpointStep &step, const Quantity &decision)
{
    if (decision.numerator() > 0 && step.down == 0 && step.y > 0)
        return u"outside by ¼, which a whole number p = 0 hides from p ≤ 0"_s;
    if (decision.numerator() == 0)
        return u"on the curve"_s;
    return decision.numerator() < 0 ? u"inside"_s : u"outside"_s;
}

/// How Δp follows from the branch that was taken. Several rows at once have no short form.
QString incrementFormula(const MidpointStep &step)
{
    if (step.down > 1)
        return {};
    if (step.isScaled())
        return step.down == 0 ? u"2x_k + 1 = "_s : u"2x_k + 1 − 2y_k = "_s;
    const QString along = step.arc == 0 ? u"r_x"_s : u"r_y"_s;
    const QString across = step.arc == 0 ? u"r_y"_s : u"r_x"_s;
    const QString stays = across + u"²·(2x_k + 1)"_s;
    return step.down == 0 ? stays + u" = "_s : stays + u" − 2"_s + along + u"²·y_k = "_s;
}

/// On the steep arc of an ellipse x_k counts rows and y_k columns; a circle's step is mirrored into
/// both kinds of octants.
QString branchText(const MidpointStep &step)
{
    if (step.down == 0 && step.y == 0)
        return u"y_k stays 0, on the axis"_s;
    if (step.down == 0)
        return u"y_k stays %1"_s.arg(step.y);
    if (step.isScaled())
        return u"y_k goes %1 inwards, to %2"_s.arg(step.down).arg(step.y);
    const QString line = step.arc == 0 ? u"row"_s : u"column"_s;
    return step.down == 1
        ? u"y_k goes a %1 inwards, to %2"_s.arg(line).arg(step.y)
        : u"y_k goes %1 %2s inwards, to %3"_s.arg(step.down).arg(line).arg(step.y);
}

/// "a from 3 to 5": the squares that a piece may meet along a coordinate.
QString squaresText(QChar coordinate, const DiamondExtent &extent)
{
    return u"%1 from %2 to %3"_s.arg(coordinate).arg(extent.lowest).arg(extent.highest);
}

QString directionText(const DiamondExtent &extent)
{
    return extent.atLast > extent.atFirst ? u"grows"_s : u"falls"_s;
}

/// part / 2^depth. A halving takes a third of a digit, so this many tell a piece's ends apart.
QString parameterText(const BigInteger &part, int depth)
{
    const Quantity parameter = dyadic(part, depth);
    return parameter.isNone() ? u"%1/2^%2"_s.arg(QString::fromStdString(part.str())).arg(depth)
                              : term(parameter, std::max(usualPlaces, depth / 3 + 2));
}

/// What the curve does there, by the numbers that decide it.
QString verdictText(const BezierStep &step)
{
    const BezierDiamonds diamonds(step.piece);
    const DiamondExtent &a = diamonds.alongA();
    const DiamondExtent &b = diamonds.alongB();
    switch (step.verdict) {
    case BezierVerdict::Undecided:
        return u"may meet squares with %1 and %2, and so have pixels that its ends "
               "do not have: it is halved."_s.arg(squaresText(u'a', a), squaresText(u'b', b));
    case BezierVerdict::WithinSquare:
        return u"stays within one diamond, or between four: a in the square %1, b in %2."_s
            .arg(a.lowest)
            .arg(b.lowest);
    case BezierVerdict::AcrossBorder: {
        const bool isAlongA = a.passesOneBorder() && b.isClearOfBorders();
        return u"passes one side of one diamond: %1 only %2 from the square %3 to "
               "%4, and %5 stays within %6."_s
                   .arg(QString(isAlongA ? u'a' : u'b'), directionText(isAlongA ? a : b))
                   .arg((isAlongA ? a : b).atFirst)
                   .arg((isAlongA ? a : b).atLast)
                   .arg(QString(isAlongA ? u'b' : u'a'))
                   .arg((isAlongA ? b : a).lowest);
    }
    case BezierVerdict::ThroughCorner:
        return (a.runsAlongBorder() || b.runsAlongBorder()
                    ? u"runs along sides of diamonds and passes one corner: %1, %2."_s
                    : u"meets a side or a corner of diamonds at one point: %1, %2."_s)
            .arg(squaresText(u'a', a), squaresText(u'b', b));
    }
    return {};
}

/// The pixels of a decided piece, each once, in the curve's order.
QString pixelsText(const BezierStep &step)
{
    QStringList pixels;
    for (const auto &pixel : {step.from, step.corner, step.to}) {
        if (pixel && !pixels.contains(pixelText(*pixel)))
            pixels.append(pixelText(*pixel));
    }
    if (pixels.isEmpty())
        return u"No pixel is within ½ px of it."_s;
    return u"It has %1."_s.arg(pixels.join(u" and "_s));
}

} // namespace

void tellCurve(StepWords &words, const PointStep &step)
{
    words.sentence = step.isInFrame
        ? u"The point is nearest to %1, whose address is %2."_s.arg(pixelText({step.x, step.y}))
              .arg(step.address)
        : u"The point is nearest to %1, outside the frame: nothing is written."_s.arg(
            pixelText({step.x, step.y}));
}

void tellCurve(StepWords &words, const CircleExplicitState &step)
{
    const QString place
        = u"On the column %1 the curve is h from y_c to either side, "
          "as computed %2, which rounds to "_s.arg(QString::number(step.x), term(step.root));
    words.sentence = step.above == step.below
        ? place + u"the row %1."_s.arg(step.above)
        : place + u"the rows %1 and %2."_s.arg(step.above).arg(step.below);
}

void tellCurve(StepWords &words, const CircleParametricState &step)
{
    words.sentence = u"At θ = %1 the curve is at (%2, %3), which rounds to %4."_s.arg(
        term(step.angle), term(step.curveX), term(step.curveY), pixelText({step.x, step.y}));
}

void tellCurve(StepWords &words, const MidpointStep &step)
{
    const Quantity next = Quantity::rational(step.nextDecision, step.decisionUnit);
    if (!step.hasDecision) {
        words.moment = Moment::Begin;
        if (isOnePixel(step)) {
            words.sentence = "Both radii round to 0: the centre's pixel alone is written, and "
                             "there is nothing to decide.";
            return;
        }
        const QString counted = step.arc == 0 ? QString() : u", x_k in rows and y_k in columns"_s;
        words.sentence = u"The arc starts at (x_k, y_k) = %1 from the centre%2, without a "
                         "decision; p_k₊₁ = %3 decides about the next step."_s.arg(
                             pairText(step.x, step.y), counted, midpointSignText(next));
        return;
    }
    words.moment = step.down == 0 ? Moment::Stay : Moment::Cross;
    const Quantity decision = Quantity::rational(step.decision, step.decisionUnit);
    const Quantity increment
        = Quantity::rational(step.nextDecision - step.decision, step.decisionUnit);
    // No row lies inwards of the axis, wherever the midpoint is.
    const bool staysAnyway = step.down == 0 && step.y == 0 && decision.numerator() > 0;
    if (staysAnyway)
        words.moment = Moment::Cross;
    words.sentence = u"p_k = %1: the midpoint is %2, %3 %4; Δp = %5%6."_s.arg(
        midpointSignText(decision), sideText(step, decision), staysAnyway ? u"but"_s : u"so"_s,
        branchText(step), incrementFormula(step), term(increment));
}

void tellCurve(StepWords &words, const BezierStep &step)
{
    const BezierPiece &piece = step.piece;
    words.moment = step.verdict == BezierVerdict::Undecided ? Moment::Halve : Moment::Span;
    words.heading = QStringLiteral(QT_TRANSLATE_NOOP("core", "Piece %1")).arg(step.number);
    words.sentence = u"From t = %1 to t = %2 the curve %3"_s.arg(
        parameterText(piece.part, piece.depth), parameterText(piece.part + 1, piece.depth),
        verdictText(step));
    if (step.verdict != BezierVerdict::Undecided)
        words.sentence += u' ' + pixelsText(step);
}

} // namespace pixelplumb
