// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/messagebar.h"

#include "core/grade/showntext.h"
#include "core/scene/text/shortened.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"

#include <algorithm>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr int sideMargin = 16;
constexpr int widest = 720; ///< longer lines are hard to read
constexpr int besideMargin = 8;
constexpr int leastBeside = 160; ///< width of a note beside a picture
constexpr double linesBelow = 2.5; ///< kept free: a ruler stands at the lower border

} // namespace

MessageBar::MessageBar(QWidget *covered)
    : QFrame(covered)
    , m_glyph(new QLabel(this))
    , m_text(new QLabel(this))
{
    named(this, "messageBar", tr("Message"));
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    setMouseTracking(true); // clicks outside the button go to the widget below
    setBackgroundRole(QPalette::ToolTipBase);
    setForegroundRole(QPalette::ToolTipText);
    m_glyph->setObjectName(u"messageKind"_s);
    named(m_text, "messageText", tr("No message"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setForegroundRole(QPalette::ToolTipText);
    for (QLabel *label : {m_glyph, m_text})
        label->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_glyph->setFont(bold(font()));

    auto *close = named(new QToolButton(this), "closeMessage");
    close->setText(tr("Close"));
    close->setAccessibleName(tr("Close the message"));
    close->setAutoRaise(true);
    close->setCursor(Qt::ArrowCursor);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);

    auto *row = withParts(new QHBoxLayout(this), {m_glyph, {m_text, 1}, close}, 8);
    row->setContentsMargins(16, 4, 8, 4);
    hide();
    covered->installEventFilter(this);
}

bool MessageBar::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize && !isHidden())
        QMetaObject::invokeMethod(this, &MessageBar::place, Qt::QueuedConnection); // after it
    if (!m_isFresh && isNextChoice(*watched, *event))
        hide();
    return QFrame::eventFilter(watched, event);
}

/// Whether an event is the person's next action. Shift and other modifiers alone are not. A click
/// on the bar goes through to the widget below; its release hides the bar.
bool MessageBar::isNextChoice(const QObject &watched, const QEvent &event) const
{
    if (!watched.isWidgetType() || !isVisible())
        return false;
    if (event.type() == QEvent::MouseButtonRelease)
        return &watched == this;
    if (event.type() == QEvent::MouseButtonPress) {
        const auto *pressed = static_cast<const QWidget *>(&watched);
        const QPoint place = static_cast<const QMouseEvent &>(event).position().toPoint();
        const bool isThroughBar = pressed == parentWidget() && geometry().contains(place);
        return pressed != this && !isAncestorOf(pressed) && !isThroughBar;
    }
    if (event.type() != QEvent::KeyPress && event.type() != QEvent::ShortcutOverride)
        return false;
    const int key = static_cast<const QKeyEvent &>(event).key();
    return key < Qt::Key_Shift || key > Qt::Key_ScrollLock;
}

void MessageBar::showEvent(QShowEvent *event)
{
    QFrame::showEvent(event);
    qApp->installEventFilter(this);
}

void MessageBar::hideEvent(QHideEvent *event)
{
    QFrame::hideEvent(event);
    qApp->removeEventFilter(this);
}

void MessageBar::place()
{
    static_cast<QBoxLayout *>(layout())->setDirection(m_picture ? QBoxLayout::TopToBottom
                                                                : QBoxLayout::LeftToRight);
    if (m_picture)
        placeBeside(m_picture());
    else
        placeBelow();
    raise();
}

/// As wide as the text needs, and as high as that width requires.
QSize MessageBar::sizeWithin(int limit) const
{
    const QMargins margins = layout()->contentsMargins();
    const int others = m_picture ? 0 : sizeHint().width() - m_text->sizeHint().width();
    const int asked = others + m_text->fontMetrics().size(0, m_text->text()).width()
        + margins.left() + margins.right() + besideMargin; // Qt breaks a line that just fits
    const int width = std::min(asked, limit);
    const int frame = 2 * frameWidth();
    return {
        width,
        frame
            + std::max(layout()->heightForWidth(width - frame), layout()->minimumSize().height())};
}

void MessageBar::placeBelow()
{
    const QSize room = parentWidget()->size();
    const QSize size = sizeWithin(std::min(widest, room.width() - 2 * sideMargin));
    const int bottom = room.height() - int(linesBelow * fontMetrics().lineSpacing());
    setGeometry({{(room.width() - size.width()) / 2, std::max(0, bottom - size.height())}, size});
}

void MessageBar::placeBeside(const QRect &picture)
{
    const int room = parentWidget()->width();
    const int strip = room - picture.right() - 2 * besideMargin; // at either side, without rulers
    const bool isFree = strip >= leastBeside;
    const QSize size = sizeWithin(isFree ? strip : std::max(leastBeside, room * 2 / 5));
    const int left = isFree ? picture.left() - besideMargin - size.width()
                            : room - besideMargin - size.width();
    setGeometry({{left, besideMargin}, size});
}

QString MessageBar::text() const { return m_text->text(); }

void MessageBar::tell(const QString &text)
{
    m_picture = {};
    show(Kind::Information, text);
}

void MessageBar::complain(const QString &text)
{
    m_picture = {};
    show(Kind::Error, text);
}

void MessageBar::tellBeside(const std::function<QRect()> &picture, const QString &text)
{
    m_picture = picture;
    show(Kind::Information, text);
}

void MessageBar::show(Kind kind, const QString &text)
{
    const bool isError = kind == Kind::Error;
    QPalette colours;
    colours.setColor(QPalette::WindowText,
                     isError ? signColour(Sign::Breakpoint, palette())
                             : signColour(Sign::CurrentColumn, palette()));
    m_glyph->setPalette(colours);
    m_glyph->setText(isError ? tr("Error") : tr("Note"));
    constexpr qsizetype longestMessage = 2000; // characters
    const QString shown = escapedLines(shortened(text, longestMessage));
    m_text->setText(shown);
    m_text->setAccessibleName(shown);
    setAccessibleDescription(shown);
    place();
    setVisible(true);
    // The key that caused it may still propagate to parents of the focused widget.
    m_isFresh = true;
    QTimer::singleShot(0, this, [this] { m_isFresh = false; });
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

} // namespace pixelplumb
