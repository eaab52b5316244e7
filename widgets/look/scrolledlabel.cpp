// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/scrolledlabel.h"

#include <QLabel>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr int leastLines = 2;

} // namespace

ScrolledLabel::ScrolledLabel(const QString &name, const QString &accessibleName, QWidget *parent)
    : QScrollArea(parent)
    , m_label(new QLabel)
{
    m_label->setObjectName(name);
    m_label->setAccessibleName(accessibleName);
    m_label->setWordWrap(true);
    m_label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidgetResizable(true);
    setAccessibleName(accessibleName);
    setWidget(m_label);
}

void ScrolledLabel::setText(const QString &text)
{
    m_label->setText(text);
    fit();
}

void ScrolledLabel::resizeEvent(QResizeEvent *event)
{
    QScrollArea::resizeEvent(event);
    fit();
}

void ScrolledLabel::fit()
{
    const int needed = m_label->heightForWidth(viewport()->width());
    setMinimumHeight(std::min(needed, leastLines * fontMetrics().lineSpacing()));
    setMaximumHeight(needed);
}

} // namespace pixelplumb
