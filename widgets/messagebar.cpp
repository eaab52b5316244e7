// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messagebar.h"

#include "widgets/signs.h"

#include <QAccessible>
#include <QBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace pixelplumb {

MessageBar::MessageBar(QWidget *parent)
    : QFrame(parent)
    , m_glyph(new QLabel(this))
    , m_text(new QLabel(this))
{
    setObjectName(QStringLiteral("messageBar"));
    setAccessibleName(tr("Message"));
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    setForegroundRole(QPalette::ToolTipText);
    m_text->setObjectName(QStringLiteral("messageText"));
    m_text->setAccessibleName(tr("No message"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_text->setForegroundRole(QPalette::ToolTipText);
    QFont bold = font();
    bold.setBold(true);
    m_glyph->setFont(bold);

    auto *close = new QToolButton(this);
    close->setObjectName(QStringLiteral("closeMessage"));
    close->setText(tr("Close"));
    close->setAccessibleName(tr("Close the message"));
    close->setAutoRaise(true);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);

    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(16, 4, 8, 4);
    row->setSpacing(8);
    row->addWidget(m_glyph);
    row->addWidget(m_text, 1);
    row->addWidget(close);
    hide();
}

QString MessageBar::text() const { return m_text->text(); }

void MessageBar::tell(const QString &text) { show(Kind::Information, text); }

void MessageBar::complain(const QString &text) { show(Kind::Error, text); }

void MessageBar::show(Kind kind, const QString &text)
{
    const bool isError = kind == Kind::Error;
    QPalette colours;
    colours.setColor(QPalette::WindowText,
                     isError ? signColour(Sign::Breakpoint, palette())
                             : signColour(Sign::ColumnInHand, palette()));
    m_glyph->setPalette(colours);
    m_glyph->setText(isError ? tr("Error") : tr("Note"));
    m_text->setText(text);
    m_text->setAccessibleName(text);
    setAccessibleDescription(text);
    setVisible(true);
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

} // namespace pixelplumb
