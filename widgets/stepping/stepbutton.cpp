// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/stepping/stepbutton.h"

#include <QAction>
#include <QStyleOptionToolButton>
#include <QStylePainter>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr int padding = 8;
constexpr int signSize = 12;
constexpr int iconGap = 6;

} // namespace

StepButton::StepButton(QAction *action, SignSide side, QWidget *parent)
    : QToolButton(parent)
    , m_side(side)
{
    setObjectName(action->objectName() + QStringLiteral("Button"));
    setDefaultAction(action);
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(QString(action->text()).remove(QLatin1Char('&')));
}

QSize StepButton::sizeHint() const
{
    int width = 2 * padding + signSize;
    if (m_side != SignSide::Alone) {
        int text = fontMetrics().horizontalAdvance(this->text());
        for (const QString &other : m_texts)
            text = std::max(text, fontMetrics().horizontalAdvance(other));
        width += iconGap + text;
    }
    return {width, QToolButton::sizeHint().height()};
}

void StepButton::keepRoomFor(const QStringList &texts)
{
    m_texts = texts;
    updateGeometry();
}

void StepButton::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    QStyleOptionToolButton option;
    initStyleOption(&option);
    const QString text = m_side == SignSide::Alone ? QString() : option.text;
    const QIcon sign = option.icon;
    option.text.clear();
    option.icon = {};
    painter.drawComplexControl(QStyle::CC_ToolButton, option);

    const int textWidth = text.isEmpty() ? 0 : iconGap + fontMetrics().horizontalAdvance(text);
    const int left = (width() - signSize - textWidth) / 2;
    const int signLeft = m_side == SignSide::AfterText ? left + textWidth : left;
    sign.paint(&painter, QRect(signLeft, (height() - signSize) / 2, signSize, signSize),
               Qt::AlignCenter, isEnabled() ? QIcon::Normal : QIcon::Disabled);
    const int textLeft = m_side == SignSide::AfterText ? left : left + signSize + iconGap;
    painter.drawItemText(QRect(textLeft, 0, width() - textLeft, height()),
                         Qt::AlignLeft | Qt::AlignVCenter, palette(), isEnabled(), text,
                         QPalette::ButtonText);
}

} // namespace pixelplumb
