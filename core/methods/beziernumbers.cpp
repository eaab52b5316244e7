// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/beziernumbers.h"

#include <bit>
#include <cmath>

namespace pixelplumb {

namespace {

using Group = NumberGroup;

/// What of 128 bits a fraction uses, so that errors can still be counted from it.
constexpr int exactBits = 120;
/// What of a numerator a double can tell.
constexpr int doubleBits = 62;

NumberDescription bezierNumber(const char *id, const QString &title, const char *unit,
                               const QString &toolTip, Group group = Group::Span)
{
    return {.id = QString::fromUtf8(id),
            .title = title,
            .unit = QString::fromUtf8(unit),
            .toolTip = toolTip,
            .formula = {},
            .group = group};
}

/// One coordinate of a control point, if the piece has that many.
void appendCoordinate(NumberTable<BezierStep> &table, std::size_t control, QChar axis,
                      BezierControls BezierPiece::*coordinates)
{
    table.push_back({{.id = QStringLiteral("%1_%2").arg(axis).arg(control),
                      .title = QString(axis) + QChar(char16_t(0x2080 + control)),
                      .unit = QStringLiteral("px"),
                      .toolTip = QStringLiteral("%1 of control point P%2.").arg(axis).arg(control),
                      .formula = {},
                      .group = Group::Span},
                     [=](const BezierStep &step) {
                         const BezierPiece &piece = step.piece;
                         constexpr int unitBits = std::countr_zero(std::uint64_t(unitsPerPixel));
                         return control < piece.count
                             ? dyadic((piece.*coordinates)[control],
                                      unitBits + piece.degree() * piece.depth)
                             : Quantity();
                     }});
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
    const int excess = std::max(0, int(msb(size)) - doubleBits);
    size >>= excess;
    const double rounded = std::ldexp(double(size.convert_to<std::int64_t>()), excess - power);
    return Quantity::of(isNegative ? -rounded : rounded);
}

const NumberTable<BezierSetUp> &bezierSetUpNumbers()
{
    static const NumberTable<BezierSetUp> numbers
        = {{bezierNumber("degree", QStringLiteral("n"), "",
                         QStringLiteral("The degree: 2 quadratic, 3 cubic.")),
            [](const BezierSetUp &setUp) { return Quantity::integer(Int128(setUp.count) - 1); }},
           {bezierNumber(
                "deepest", QStringLiteral("depth_max"), "",
                QStringLiteral("After so many halvings the two borders that a piece still meets "
                               "are met at one point: numerics.md, 3.6.")),
            [](const BezierSetUp &setUp) { return Quantity::integer(setUp.deepest); }}};
    return numbers;
}

const NumberTable<BezierStep> &bezierNumbers()
{
    static const auto numbers = [] {
        NumberTable<BezierStep> table = {
            {bezierNumber("i", QStringLiteral("i"), "",
                          QStringLiteral("The piece's number, from 0 for the whole curve."),
                          Group::Position),
             [](const BezierStep &step) { return Quantity::integer(step.number); }},
            {bezierNumber("depth", QStringLiteral("depth"), "",
                          QStringLiteral("How often the curve was halved to get this piece.")),
             [](const BezierStep &step) { return Quantity::integer(step.piece.depth); }},
            {bezierNumber("t_from", QStringLiteral("t_from"), "",
                          QStringLiteral("The parameter at which the piece begins.")),
             [](const BezierStep &step) { return dyadic(step.piece.part, step.piece.depth); }},
            {bezierNumber("t_to", QStringLiteral("t_to"), "",
                          QStringLiteral("The parameter at which it ends.")),
             [](const BezierStep &step) { return dyadic(step.piece.part + 1, step.piece.depth); }},
            {bezierNumber(
                 "decided", QStringLiteral("decided"), "",
                 QStringLiteral("1: it has no pixels but those of its ends (and of a corner "
                                "that it passes); 0: halved."),
                 Group::Decision),
             [](const BezierStep &step) {
                 return Quantity::integer(step.verdict == BezierVerdict::Undecided ? 0 : 1);
             }}};
        for (std::size_t control = 0; control < 4; ++control) {
            appendCoordinate(table, control, u'x', &BezierPiece::x);
            appendCoordinate(table, control, u'y', &BezierPiece::y);
        }
        return table;
    }();
    return numbers;
}

} // namespace pixelplumb
