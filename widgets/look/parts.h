// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

#include <initializer_list>

namespace pixelplumb {

inline QFont bold(QFont font)
{
    font.setBold(true);
    return font;
}

/// Names a widget or another object; a widget also in words.
template <class Part>
Part *named(Part *part, const char *name, const QString &inWords = {}, const QString &toolTip = {})
{
    part->setObjectName(QLatin1String(name));
    if constexpr (requires { part->setAccessibleName(inWords); })
        part->setAccessibleName(inWords);
    if constexpr (requires { part->setToolTip(toolTip); })
        part->setToolTip(toolTip);
    return part;
}

/// The name in words is the tool tip too.
template <class Widget>
Widget *explained(Widget *widget, const char *name, const QString &inWords)
{
    return named(widget, name, inWords, inWords);
}

/// A picture that looks the same in a selected row.
inline QIcon untinted(const QPixmap &picture)
{
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected);
    return icon;
}

inline QToolButton *namedButton(const char *name, const QString &text, const QString &inWords,
                                QWidget *parent)
{
    auto *button = explained(new QToolButton(parent), name, inWords);
    button->setText(text);
    return button;
}

inline QPushButton *pushButton(const char *name, const QString &text, const QString &toolTip,
                               QWidget *parent)
{
    return named(new QPushButton(text, parent), name, {}, toolTip);
}

/// A text that is broken into lines and can be selected.
inline QLabel *readingLabel(const char *name, const QString &inWords, QWidget *parent)
{
    auto *label = named(new QLabel(parent), name, inWords);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

/// An area without a frame in which its content, as wide as itself, is scrolled up and down.
inline QScrollArea *columnScroll(QWidget *parent)
{
    auto *area = new QScrollArea(parent);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return area;
}

/// Calls `act` at these events of the widget, after its layout and before the widget itself: when
/// it is shown, resized, or looks different. Not for events that a widget gets while it is
/// destroyed, such as being hidden.
template <class Act>
void onEvents(QWidget *widget, std::initializer_list<QEvent::Type> types, Act act)
{
    class Watch final : public QObject {
    public:
        Watch(QWidget *watched, std::vector<QEvent::Type> some, Act whatToDo)
            : QObject(watched)
            , m_types(std::move(some))
            , m_act(std::move(whatToDo))
        {
            watched->installEventFilter(this);
        }

    protected:
        bool eventFilter(QObject *, QEvent *event) override
        {
            if (std::ranges::find(m_types, event->type()) != m_types.end())
                m_act();
            return false;
        }

    private:
        std::vector<QEvent::Type> m_types;
        Act m_act;
    };
    new Watch(widget, types, std::move(act));
}

/// Empty room in a layout.
struct Room { };

/// A part of a row or column, and how it stretches.
struct LayoutPart {
    LayoutPart(QWidget *part, int share = 0) // NOLINT: a part is a part
        : widget(part)
        , stretch(share)
    {
    }
    LayoutPart(QLayout *part, int share = 0) // NOLINT
        : layout(part)
        , stretch(share)
    {
    }
    LayoutPart(Room) { } // NOLINT

    QWidget *widget = nullptr;
    QLayout *layout = nullptr;
    int stretch = 0;
};

/// Fills a row or column; -1: the style's own spacing and margin.
template <class Layout>
Layout *withParts(Layout *layout, std::initializer_list<LayoutPart> parts, int spacing = -1,
                  int margin = -1)
{
    layout->setSpacing(spacing);
    if (margin >= 0)
        layout->setContentsMargins(margin, margin, margin, margin);
    for (const LayoutPart &part : parts) {
        if (part.widget)
            layout->addWidget(part.widget, part.stretch);
        else if (part.layout)
            layout->addLayout(part.layout, part.stretch);
        else
            layout->addStretch();
    }
    return layout;
}

} // namespace pixelplumb
