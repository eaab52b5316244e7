// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/formulatext.h"

namespace pixelplumb {

QString term(const Quantity &quantity)
{
    const QString text = toText(quantity);
    return text.size() <= 16 ? text : toDecimal(quantity, 6) + u'…';
}

QString operand(const Quantity &quantity)
{
    const QString text = term(quantity);
    return text.contains(u' ') || text.startsWith(u'-') || text.contains(u'/') ? u'(' + text + u')'
                                                                               : text;
}

Quantity pixels(Lattice units) { return Quantity::rational(units, unitsPerPixel); }

QString pointText(const LatticePoint &point)
{
    return QStringLiteral("(%1, %2)").arg(term(pixels(point.x)), term(pixels(point.y)));
}

} // namespace pixelplumb
