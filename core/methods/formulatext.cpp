// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formulatext.h"

#include <cmath>

namespace pixelplumb {

namespace {

constexpr qsizetype longestTerm = 16;
/// Below, six digits after the point would say too little.
constexpr double smallestDecimal = 0.001;
constexpr int shownDigits = 6;

/// By long division: a double does not hold large numbers whole.
QString shortenedFraction(const Quantity &fraction)
{
    const Int128 magnitude = absolute(fraction.numerator());
    Int128 remainder = magnitude % fraction.denominator();
    QString text = toText(magnitude / fraction.denominator()) + u'.';
    for (int place = 0; place < shownDigits; ++place) {
        remainder *= 10;
        text += QChar(char16_t(u'0' + int(remainder / fraction.denominator())));
        remainder %= fraction.denominator();
    }
    return fraction.numerator() < 0 ? u'-' + text : text;
}

QString shortened(const Quantity &quantity)
{
    const double value = quantity.toDouble();
    if (std::abs(value) < smallestDecimal)
        return QString::number(value, 'e', shownDigits) + u'…';
    return (quantity.isRational() ? shortenedFraction(quantity) : toDecimal(quantity, shownDigits))
        + u'…';
}

} // namespace

QString term(const Quantity &quantity)
{
    QString text = toText(quantity);
    if (text.size() > longestTerm && !quantity.isInteger())
        text = shortened(quantity);
    return text.startsWith(u'-') ? text.replace(0, 1, u'−') : text;
}

QString operand(const Quantity &quantity)
{
    const QString text = term(quantity);
    return text.contains(u' ') || text.startsWith(u'−') || text.contains(u'/') ? u'(' + text + u')'
                                                                               : text;
}

Quantity pixels(Lattice units) { return Quantity::rational(units, unitsPerPixel); }

QString divisorChange(VariantSet variants)
{
    QString change;
    if (variants.contains(Variant::DivisorMinusOne))
        change += QStringLiteral(" − 1");
    if (variants.contains(Variant::DivisorPlusOne))
        change += QStringLiteral(" + 1");
    return change;
}

QString pointText(const LatticePoint &point)
{
    return QStringLiteral("(%1, %2)").arg(term(pixels(point.x)), term(pixels(point.y)));
}

} // namespace pixelplumb
