// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/affinewords.h"

#include "core/layers/cellnumber.h"
#include "core/number/widequantity.h"

namespace pixelplumb {

namespace {

/// How the numbers of a sentence are shown: if one of their fractions is longer than this, in
/// characters, all are rounded to this many places.
struct NumberStyle {
    qsizetype longestFraction;
    int places;
};
constexpr NumberStyle compared = {13, 6}; ///< weights and coefficients
constexpr NumberStyle beside = {9, 3}; ///< places and areas

Quantity quantityOf(const BigRational &number)
{
    return quotientOf(numerator(number), denominator(number));
}

/// "−3/7"; empty if it is longer than the style allows.
QString fractionOf(const BigRational &number, const NumberStyle &style)
{
    const Quantity quantity = quantityOf(number);
    if (!quantity.isRational())
        return {};
    QString fraction = toText(quantity.numerator());
    if (quantity.denominator() != 1)
        fraction += u'/' + toText(quantity.denominator());
    return fraction.size() <= style.longestFraction ? withMinus(fraction) : QString();
}

/// The numbers of one sentence, which are all exact or all rounded.
class ShownNumbers {
public:
    ShownNumbers(std::initializer_list<BigRational> numbers, const NumberStyle &style)
    {
        for (const BigRational &number : numbers)
            m_texts += fractionOf(number, style);
        m_isRounded = m_texts.contains(QString());
        if (!m_isRounded)
            return;
        m_texts.clear();
        for (const BigRational &number : numbers)
            m_texts += withMinus(toDecimal(quantityOf(number), style.places));
    }

    const QString &operator[](qsizetype i) const { return m_texts[i]; }
    /// "≈ " before a rounded number.
    QString mark() const { return m_isRounded ? u"≈ "_s : QString(); }
    /// Between a name and its number.
    QString equals() const { return m_isRounded ? u"≈"_s : u"="_s; }

private:
    QStringList m_texts;
    bool m_isRounded = false;
};

QChar signOf(const BigRational &number) { return number < 0 ? QChar(0x2212) : u'+'; }

} // namespace

QString pointText(const RationalPoint &point)
{
    const ShownNumbers numbers({point.x, point.y}, beside);
    return u"%1(%2, %3)"_s.arg(numbers.mark(), numbers[0], numbers[1]);
}

QStringList rowsText(const AffineMap &map)
{
    const ShownNumbers numbers(
        {map.xx, abs(map.xy), abs(map.shift.x), map.yx, abs(map.yy), abs(map.shift.y)}, compared);
    const QString row = "%1 %2 %3·x %4 %5·y %6 %7";
    return {row.arg(u"Affine map: x′"_s, numbers.equals(), numbers[0], signOf(map.xy), numbers[1],
                    signOf(map.shift.x), numbers[2]),
            row.arg(u"and y′"_s, numbers.equals(), numbers[3], signOf(map.yy), numbers[4],
                    signOf(map.shift.y), numbers[5])};
}

QString weightsText(const PointAreas &areas)
{
    const ShownNumbers numbers({areas.weight(0), areas.weight(1), areas.weight(2)}, compared);
    return u"α %1 %2, β %1 %3, γ %1 %4"_s.arg(numbers.equals(), numbers[0], numbers[1], numbers[2]);
}

QString areasText(const PointAreas &areas)
{
    const ShownNumbers numbers({areas.parts[0], areas.parts[1], areas.parts[2], areas.whole},
                               beside);
    return u"Doubled areas: %1%2, %3, %4 of %5"_s.arg(numbers.mark(), numbers[0], numbers[1],
                                                      numbers[2], numbers[3]);
}

QString areasChangeText(const AffineMap &map)
{
    const BigRational factor = map.determinant();
    const ShownNumbers number({factor}, compared);
    const QString same
        = u"The weights stay, all areas are multiplied by %1"_s.arg(number.mark() + number[0]);
    return factor < 0 ? same + u": the map mirrors"_s : same;
}

} // namespace pixelplumb
