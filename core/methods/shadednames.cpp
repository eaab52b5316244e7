// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/interpolationnames.h"
#include "core/methods/shadednumbers.h"
#include "core/number/wideinteger.h"

namespace pixelplumb {

const QString &shadedName(Channel channel)
{
    static const PerChannel<QString> names = {
        QStringLiteral("R"),   QStringLiteral("G"),   QStringLiteral("B"),   QStringLiteral("A"),
        QStringLiteral("z"),   QStringLiteral("q"),   QStringLiteral("u"),   QStringLiteral("v"),
        QStringLiteral("N_x"), QStringLiteral("N_y"), QStringLiteral("N_z"), QStringLiteral("p_x"),
        QStringLiteral("p_y"), QStringLiteral("p_z")};
    return names[indexOf(channel)];
}

QString linearName(Channel channel, const EffectSet &effects)
{
    const QString &name = shadedName(channel);
    return effects.perspective && followsPerspective(channel)
        ? withSubscript(name, QStringLiteral("w"))
        : name;
}

Quantity quotientOf(const BigInteger &numerator, const BigInteger &denominator)
{
    static const BigInteger limit = BigInteger(1) << 126;
    const BigInteger divisor = gcd(numerator, denominator);
    const BigInteger above = divisor == 0 ? numerator : BigInteger(numerator / divisor);
    const BigInteger below = divisor == 0 ? denominator : BigInteger(denominator / divisor);
    if (abs(above) < limit && below < limit)
        return Quantity::rational(Int128(above), Int128(below));
    return Quantity::of(boost::multiprecision::cpp_rational(above, below).convert_to<double>());
}

} // namespace pixelplumb
