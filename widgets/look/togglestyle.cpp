// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/togglestyle.h"

#include "widgets/look/blend.h"

#include <QPainter>
#include <QStyleOption>
#include <QToolButton>

namespace pixelplumb {

namespace {

constexpr float tintShare = 0.7F; // window colour in the highlight's tint: texts stay readable
constexpr double cornerRadius = 3;
constexpr float offShare = 0.5F; // window colour in an unchecked button's frame: at least 3:1

QColor frameOf(const QPalette &palette)
{
    return blended(palette.color(QPalette::WindowText), palette.color(QPalette::Window), offShare);
}

bool isToggle(const QWidget *widget)
{
    const auto *button = qobject_cast<const QToolButton *>(widget);
    return button && button->isCheckable();
}

void drawFrame(const QStyleOption &option, QPainter &painter, const QBrush &inside,
               const QColor &frame)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(frame);
    painter.setBrush(inside);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), cornerRadius,
                            cornerRadius);
    painter.restore();
}

} // namespace

ToggleStyle::ToggleStyle()
    : QProxyStyle(QStringLiteral("Fusion"))
{
}

void ToggleStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
                                     QPainter *painter, const QWidget *widget) const
{
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    // In a tool bar an unchecked button has no panel until it is hovered.
    if (control == CC_ToolButton && isToggle(widget) && !option->state.testFlag(State_On))
        drawFrame(*option, *painter, Qt::NoBrush, frameOf(option->palette));
}

void ToggleStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option,
                                QPainter *painter, const QWidget *widget) const
{
    if (element == PE_IndicatorCheckBox) {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        painter->save();
        painter->setPen(frameOf(option->palette));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5));
        painter->restore();
        return;
    }
    if (element != PE_PanelButtonTool || !option->state.testFlag(State_On)) {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        return;
    }
    const QPalette &palette = option->palette;
    drawFrame(
        *option, *painter,
        blended(palette.color(QPalette::Highlight), palette.color(QPalette::Window), tintShare),
        palette.color(QPalette::Link));
}

} // namespace pixelplumb
