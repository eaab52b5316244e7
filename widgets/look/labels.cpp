// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/labels.h"

#include <algorithm>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype fewLetters = 3; ///< with an ellipsis, so few letters say less than without

} // namespace

ElidedLabel::ElidedLabel(QWidget *parent)
    : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void ElidedLabel::setWholeText(const QString &text)
{
    setText(text);
    setToolTip(text);
}

QString ElidedLabel::shownText() const
{
    return fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
}

void ElidedLabel::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    painter.drawText(contentsRect(), int(alignment()), shownText());
}

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
    const QString whole = toolTip().isEmpty() ? currentText() : toolTip() + u": "_s + currentText();
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
