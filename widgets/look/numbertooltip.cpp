// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/numbertooltip.h"

#include "widgets/look/numberformat.h"
#include "widgets/look/symboltext.h"

#include <QCoreApplication>
#include <QStringList>

namespace pixelplumb {

namespace {

struct NumberToolTip {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::NumberToolTip)
};

void appendDecimal(QStringList &lines, const Quantity &quantity, Arithmetic arithmetic)
{
    if (const QString decimal = decimalBeside(quantity, arithmetic); !decimal.isEmpty())
        lines.append(decimal);
}

} // namespace

QString withoutMarkup(QString symbols) { return symbols.remove(u'_'); }

QString numberToolTip(const NumberDescription &number)
{
    QStringList lines(number.toolTip);
    if (!number.formula.isEmpty())
        lines.append(number.formula);
    if (!number.unit.isEmpty())
        lines.append(NumberToolTip::tr("unit: %1").arg(number.unit));
    return toolTipHtml(lines);
}

QString numberToolTip(const NumberDescription &number, const Quantity &used, const Quantity &exact,
                      Arithmetic arithmetic)
{
    QStringList lines(number.title + QStringLiteral(" = ") + displayText(used, arithmetic)
                      + (number.unit.isEmpty() ? QString() : u' ' + number.unit));
    appendDecimal(lines, used, arithmetic);
    if (!exact.isNone()) {
        lines.append(NumberToolTip::tr("exact %1").arg(displayText(exact)));
        appendDecimal(lines, exact, Arithmetic::Exact);
        lines.append(NumberToolTip::tr("error %1").arg(displayError(used, exact)));
    }
    lines.append(number.toolTip);
    if (!number.formula.isEmpty())
        lines.append(number.formula);
    return toolTipHtml(lines);
}

} // namespace pixelplumb
