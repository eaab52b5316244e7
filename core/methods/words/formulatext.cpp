// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/words/formulatext.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr qsizetype longestTerm = 16;
/// Below this, six digits after the point would say too little.
constexpr double smallestDecimal = 0.001;

QString shortened(const Quantity &quantity, int places)
{
    if (!quantity.isFinite())
        return toText(quantity);
    const double value = quantity.toDouble();
    if (std::abs(value) < smallestDecimal)
        return QString::number(value, 'e', places) + u'…';
    const auto [digits, isCut] = cutDecimal(quantity, places);
    return isCut ? digits + u'…' : digits;
}

} // namespace

QString term(const Quantity &quantity, int places)
{
    QString text = toText(quantity);
    if (text.size() > longestTerm + places - usualPlaces && !quantity.isInteger())
        text = shortened(quantity, places);
    return withMinus(text);
}

QString operand(const Quantity &quantity, int places)
{
    const QString text = term(quantity, places);
    return text.contains(u' ') || text.startsWith(u'−') || text.contains(u'/') ? u'(' + text + u')'
                                                                               : text;
}

int placesOfOperands(const Quantity &result)
{
    constexpr int mostPlaces = 17; // no double near a pixel has more
    if (!result.isFinite() || result.isInteger())
        return usualPlaces;
    const QString digits = cutDecimal(result, mostPlaces).digits;
    const qsizetype first = digits.indexOf(u'.') + 1;
    qsizetype end = first;
    while (end < digits.size() && digits[end] == digits[first]
           && (digits[end] == u'0' || digits[end] == u'9'))
        ++end;
    return std::clamp(int(end - first) + 3, usualPlaces, mostPlaces);
}

Quantity pixels(Lattice units) { return Quantity::rational(units, unitsPerPixel); }

QString divisorChange(VariantSet variants)
{
    QString change;
    if (variants.contains(Variant::DivisorMinusOne))
        change += u" − 1"_s;
    if (variants.contains(Variant::DivisorPlusOne))
        change += u" + 1"_s;
    return change;
}

QString differenceText(Lattice to, Lattice from)
{
    return u"(%1 − %2)"_s.arg(operand(pixels(to)), operand(pixels(from)));
}

QString sampleNumbersText(std::uint16_t samples, int count)
{
    QStringList numbers;
    for (int k = 0; k < count; ++k) {
        if ((samples >> k & 1) != 0)
            numbers.append(QString::number(k + 1));
    }
    return numbers.size() == count
        ? u"all"_s
        : u"%1 (number %2)"_s.arg(numbers.size()).arg(numbers.join(u", "_s));
}

QString pointText(const LatticePoint &point)
{
    return u"(%1, %2)"_s.arg(term(pixels(point.x)), term(pixels(point.y)));
}

} // namespace pixelplumb
