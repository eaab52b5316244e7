// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/elidingbox.h"

#include <QHelpEvent>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QToolTip>

namespace pixelplumb {

namespace {

constexpr qsizetype fewLetters = 3; ///< with an ellipsis, so few letters say less than without

} // namespace

QString ElidingBox::shownText() const
{
    QStyleOptionComboBox option;
    initStyleOption(&option);
    const QRect room
        = style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    // Styles start the text one pixel inside the field.
    const QString text = currentIndex() < 0 ? placeholderText() : currentText();
    const int width = room.width() - 2;
    const QString elided = fontMetrics().elidedText(text, Qt::ElideMiddle, width);
    if (elided == text || elided.size() > fewLetters)
        return elided;
    qsizetype letters = 1;
    while (letters < text.size()
           && fontMetrics().horizontalAdvance(text.left(letters + 1)) <= width)
        ++letters;
    return text.left(letters);
}

bool ElidingBox::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip || shownText() == currentText())
        return QComboBox::event(event);
    const QString whole
        = toolTip().isEmpty() ? currentText() : toolTip() + QStringLiteral(": ") + currentText();
    QToolTip::showText(static_cast<QHelpEvent *>(event)->globalPos(), whole, this);
    return true;
}

void ElidingBox::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    option.currentText = shownText();
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

} // namespace pixelplumb
