// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/togglestyle.h"

#include "widgets/look/blend.h"

#include <QPainter>
#include <QStyleOption>

namespace pixelplumb {

namespace {

constexpr float tintShare = 0.7F; // of the window in a tint of the highlight: texts stay readable
constexpr double cornerRadius = 3;

} // namespace

ToggleStyle::ToggleStyle()
    : QProxyStyle(QStringLiteral("Fusion"))
{
}

void ToggleStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option,
                                QPainter *painter, const QWidget *widget) const
{
    if (element != PE_PanelButtonTool || !option->state.testFlag(State_On)) {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        return;
    }
    const QPalette &palette = option->palette;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(palette.color(QPalette::Link));
    painter->setBrush(
        blended(palette.color(QPalette::Highlight), palette.color(QPalette::Window), tintShare));
    painter->drawRoundedRect(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5), cornerRadius,
                             cornerRadius);
    painter->restore();
}

} // namespace pixelplumb
