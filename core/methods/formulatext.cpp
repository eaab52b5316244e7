// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formulatext.h"

#include <cmath>

namespace pixelplumb {

namespace {

constexpr qsizetype longestTerm = 16;
/// Below, six digits after the point would say too little.
constexpr double smallestDecimal = 0.001;
constexpr int shownDigits = 6;

QString shortened(const Quantity &quantity)
{
    if (!quantity.isFinite())
        return toText(quantity);
    const double value = quantity.toDouble();
    if (std::abs(value) < smallestDecimal)
        return QString::number(value, 'e', shownDigits) + u'…';
    const auto [digits, isCut] = cutDecimal(quantity, shownDigits);
    return isCut ? digits + u'…' : digits;
}

} // namespace

QString term(const Quantity &quantity)
{
    QString text = toText(quantity);
    if (text.size() > longestTerm && !quantity.isInteger())
        text = shortened(quantity);
    return text.replace(u'-', u'−'); // in an exponent too
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
