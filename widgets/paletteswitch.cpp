// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/paletteswitch.h"

#include <QSettings>

namespace pixelplumb {

namespace {

constexpr auto key = "palette";

} // namespace

PaletteSwitch::PaletteSwitch(QObject *parent)
    : QObject(parent)
    , m_choice(stored())
{
    applyAppearance(m_choice);
}

PaletteChoice PaletteSwitch::stored()
{
    const QString name = QSettings().value(QLatin1String(key)).toString();
    return paletteNamed(name).value_or(PaletteChoice::System);
}

void PaletteSwitch::setForThisRun(PaletteChoice choice)
{
    m_choice = choice;
    applyAppearance(choice);
    emit changed();
}

void PaletteSwitch::choose(PaletteChoice choice)
{
    QSettings().setValue(QLatin1String(key), nameOf(choice));
    setForThisRun(choice);
}

} // namespace pixelplumb
