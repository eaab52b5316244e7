// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/menuaction.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

constexpr const char *listedTextProperty = "listedText";

} // namespace

QList<QAction *> actionsIn(const QMenu &menu)
{
    QList<QAction *> all;
    for (QAction *action : menu.actions()) {
        if (action->menu())
            all += actionsIn(*action->menu());
        else if (!action->isSeparator())
            all += action;
    }
    return all;
}

QString withoutMnemonic(QString text)
{
    text.remove(QLatin1Char('&'));
    if (text.endsWith(QChar(0x2026))) // …
        text.chop(1);
    return text.trimmed(); // some languages separate it
}

QString listedText(const QAction &action)
{
    const QVariant fixed = action.property(listedTextProperty);
    return withoutMnemonic(fixed.isValid() ? fixed.toString() : action.text());
}

void setListedText(QAction *action, const QString &text)
{
    action->setProperty(listedTextProperty, text);
}

QString tipWithKey(const QString &tip, const QKeySequence &key)
{
    return key.isEmpty() ? tip : u"%1 (%2)"_s.arg(tip, key.toString(QKeySequence::NativeText));
}

void confineKeyTo(QWidget *widget, QAction *action)
{
    action->setShortcutContext(Qt::WidgetShortcut);
    widget->addAction(action);
}

} // namespace pixelplumb
