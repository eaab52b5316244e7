// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curves/beziernumbers.h"

#include "core/methods/curves/curvenumbers.h"
#include "core/methods/words/placenumbers.h"

#include <QStringList>

#include <bit>

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// How many of 128 bits a fraction may use, so that errors can still be computed from it.
constexpr int exactBits = 120;

Quantity coordinateOf(const BezierPiece &piece, const BezierControls &coordinates,
                      std::size_t control)
{
    constexpr int unitBits = std::countr_zero(std::uint64_t(unitsPerPixel));
    return dyadic(coordinates[control], unitBits + piece.degree() * piece.depth);
}

/// Whether every control point of a piece can be shown as numbers.
bool hasCoordinates(const BezierPiece &piece)
{
    for (std::size_t control = 0; control < piece.count; ++control) {
        if (coordinateOf(piece, piece.x, control).isNone()
            || coordinateOf(piece, piece.y, control).isNone())
            return false;
    }
    return true;
}

/// An end of a piece: deep down in the curve a double does not hold it.
NumberDescription parameter(const char *id, const QString &toolTip)
{
    return comparedNumber(id, id, {}, toolTip, {}, Group::Span);
}

/// One coordinate of a control point, if the piece has that many.
void appendCoordinate(NumberTable<BezierStep> &table, std::size_t control, QChar axis,
                      BezierControls BezierPiece::*coordinates)
{
    table.push_back(
        {comparedNumber(
             u"%1_%2"_s.arg(axis).arg(control), QString(axis) + QChar(char16_t(0x2080 + control)),
             "px",
             u"%1 of control point P%2; none where it takes more than 120 bits."_s.arg(axis).arg(
                 control),
             {}, Group::Span),
         [=](const BezierStep &step) {
             const BezierPiece &piece = step.piece;
             return control < piece.count ? coordinateOf(piece, piece.*coordinates, control)
                                          : Quantity();
         }});
}

/// a or b of a control point, without the ½: "x₀ + y₀", "y₀ − x₀".
QString diagonalText(QChar coordinate, std::size_t control)
{
    const QChar digit(char16_t(0x2080 + control));
    return coordinate == u'a' ? u"x%1 + y%1"_s.arg(digit) : u"y%1 − x%1"_s.arg(digit);
}

/// "min(x₀ + y₀, x₁ + y₁, x₂ + y₂)": over the control points of a piece.
QString extremeText(const QString &function, QChar coordinate, std::size_t count)
{
    QStringList each;
    for (std::size_t control = 0; control < count; ++control)
        each.append(diagonalText(coordinate, control));
    return function + u'(' + each.join(u", "_s) + u')';
}

/// The squares, from the lowest to the highest, that a piece may meet along a or b: they decide it.
void appendSquares(NumberTable<BezierStep> &table, QChar coordinate,
                   const DiamondExtent &(BezierDiamonds::*extent)() const)
{
    const QString sum = coordinate == u'a' ? u"a = x + y + ½"_s : u"b = y − x + ½"_s;
    const auto append = [&](const char *end, const QString &which,
                            std::int64_t DiamondExtent::*square, const auto &formula) {
        const QString name = coordinate + QString::fromUtf8(end);
        table.push_back(
            {plainNumber(
                 name, name, {},
                 u"The %1 square that the piece may meet along %2; squares begin at "
                 "whole numbers, and every second one is the diamond of a pixel."_s.arg(which, sum),
                 {}, Group::Decision),
             [=](const BezierStep &step) {
                 return Quantity::integer((BezierDiamonds(step.piece).*extent)().*square);
             },
             [=](NumberDescription &number, const BezierStep &step) {
                 if (hasCoordinates(step.piece))
                     number.formula = name + u" = "_s + formula(step.piece.count);
             }});
    };
    append("_low", "first", &DiamondExtent::lowest, [=](std::size_t count) {
        return u"⌊%1 + ½⌋"_s.arg(extremeText("min", coordinate, count));
    });
    // A curve reaches its highest control point only at an end.
    append("_high", "last", &DiamondExtent::highest, [=](std::size_t count) {
        return u"max(⌊%1 + ½⌋, ⌊%2 + ½⌋, ⌈%3 + ½⌉ − 1)"_s.arg(
            diagonalText(coordinate, 0), diagonalText(coordinate, count - 1),
            extremeText("max", coordinate, count));
    });
}

} // namespace

Quantity dyadic(BigInteger numerator, int power)
{
    if (numerator == 0)
        return Quantity::integer(0);
    const bool isNegative = numerator < 0;
    BigInteger size = abs(numerator);
    const int common = std::min(int(lsb(size)), power);
    size >>= common;
    power -= common;
    if (power <= exactBits && int(msb(size)) < exactBits) {
        const auto whole = size.convert_to<Int128>();
        return Quantity::rational(isNegative ? -whole : whole, Int128(1) << power);
    }
    return {};
}

const NumberTable<BezierSetUp> &bezierSetUpNumbers()
{
    static const NumberTable<BezierSetUp> numbers
        = {{plainNumber("degree", "n", {}, "The degree: 2 quadratic, 3 cubic.", {}, Group::Span),
            [](const BezierSetUp &setUp) { return Quantity::integer(Int128(setUp.count) - 1); }},
           {plainNumber("deepest", "depth_max", {},
                        "After so many halvings the two borders that a piece still meets are met "
                        "at one point: numerics.md, 3.6.",
                        {}, Group::Span),
            [](const BezierSetUp &setUp) { return Quantity::integer(setUp.deepest); }}};
    return numbers;
}

const NumberTable<BezierStep> &bezierNumbers()
{
    static const auto numbers = [] {
        NumberTable<BezierStep> table = {
            {plainNumber("i", "i", {}, "The piece's number, from 0 for the whole curve."),
             [](const BezierStep &step) { return Quantity::integer(step.number); }},
            {plainNumber("depth", "depth", {}, "How often the curve was halved to get this piece.",
                         {}, Group::Span),
             [](const BezierStep &step) { return Quantity::integer(step.piece.depth); }},
            {parameter("t_from",
                       "The parameter at which the piece begins; none where it takes more than 120 "
                       "bits."),
             [](const BezierStep &step) { return dyadic(step.piece.part, step.piece.depth); }},
            {parameter("t_to", "The parameter at which it ends, likewise."),
             [](const BezierStep &step) { return dyadic(step.piece.part + 1, step.piece.depth); }},
            {plainNumber("decided", "decided", {},
                         "1: it has no pixels but those of its ends (and of a corner that it "
                         "passes); 0: halved.",
                         {}, Group::Decision),
             [](const BezierStep &step) {
                 return Quantity::integer(step.verdict == BezierVerdict::Undecided ? 0 : 1);
             }}};
        appendSquares(table, u'a', &BezierDiamonds::alongA);
        appendSquares(table, u'b', &BezierDiamonds::alongB);
        for (std::size_t control = 0; control < 4; ++control) {
            appendCoordinate(table, control, u'x', &BezierPiece::x);
            appendCoordinate(table, control, u'y', &BezierPiece::y);
        }
        return table;
    }();
    return numbers;
}

} // namespace pixelplumb
