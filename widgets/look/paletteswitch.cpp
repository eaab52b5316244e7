// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/paletteswitch.h"

#include <QSettings>

namespace pixelplumb {

namespace {

constexpr auto paletteKey = "palette";

} // namespace

PaletteSwitch::PaletteSwitch(QObject *parent)
    : QObject(parent)
    , m_choice(stored())
{
    applyAppearance(m_choice);
}

PaletteChoice PaletteSwitch::stored()
{
    const QString name = QSettings().value(QLatin1String(paletteKey)).toString();
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
    QSettings().setValue(QLatin1String(paletteKey), nameOf(choice));
    setForThisRun(choice);
}

} // namespace pixelplumb
