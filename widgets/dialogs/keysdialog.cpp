// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/keysdialog.h"

#include "widgets/dialogs/keyfield.h"
#include "widgets/look/menuaction.h"
#include "widgets/look/namedwidget.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTreeWidget>

#include <algorithm>
#include <array>

namespace pixelplumb {

namespace {

constexpr const char *defaultsProperty = "defaultKeys";
constexpr int keyColumn = 1;

/// Keys that the canvas and the fields have without a menu.
constexpr std::array ownKeys
    = {Qt::Key_Left,      Qt::Key_Right,  Qt::Key_Up,          Qt::Key_Down,
       Qt::Key_Return,    Qt::Key_Enter,  Qt::Key_Escape,      Qt::Key_Tab,
       Qt::Key_Backspace, Qt::Key_Insert, Qt::Key_BracketLeft, Qt::Key_BracketRight,
       Qt::Key_Home,      Qt::Key_End,    Qt::Key_PageUp,      Qt::Key_PageDown,
       Qt::Key_C,         Qt::Key_Plus,   Qt::Key_Minus,       Qt::Key_Equal,
       Qt::Key_0};

bool isOwnKey(const QKeySequence &key)
{
    const bool isPlain = (key[0].keyboardModifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    return isPlain && std::ranges::find(ownKeys, key[0].key()) != ownKeys.end();
}

QString settingOf(const QAction &action) { return QStringLiteral("keys/") + action.objectName(); }

QString textOf(const QList<QKeySequence> &keys)
{
    return QKeySequence::listToString(keys, QKeySequence::PortableText);
}

/// An empty text has no key; Qt would read an empty one.
QList<QKeySequence> keysIn(const QString &text)
{
    return text.isEmpty() ? QList<QKeySequence>()
                          : QKeySequence::listFromString(text, QKeySequence::PortableText);
}

QList<QKeySequence> defaultsOf(const QAction &action)
{
    return keysIn(action.property(defaultsProperty).toString());
}

QString shownKeys(const QAction &action)
{
    return QKeySequence::listToString(action.shortcuts(), QKeySequence::NativeText);
}

} // namespace

void restoreKeys(const QList<QMenu *> &menus)
{
    const QSettings settings;
    for (const QMenu *menu : menus) {
        for (QAction *action : actionsIn(*menu)) {
            action->setProperty(defaultsProperty, textOf(action->shortcuts()));
            const QVariant chosen = settings.value(settingOf(*action));
            if (!action->objectName().isEmpty() && chosen.isValid())
                changeKeys(action, keysIn(chosen.toString()));
        }
    }
}

KeysDialog::KeysDialog(const QList<QMenu *> &menus, QWidget *parent)
    : QDialog(parent)
    , m_rows(named(new QTreeWidget(this), "keysRows", tr("Actions and their keys")))
    , m_key(named(new KeyField(this), "keysField",
                  tr("Press the key that the action in hand shall have")))
    , m_message(new QLabel(this))
{
    setObjectName(QStringLiteral("keysDialog"));
    setWindowTitle(tr("Change keys"));
    auto *filter
        = named(new QLineEdit(this), "keysFilter", tr("Show the actions with these words"));
    filter->setPlaceholderText(tr("find an action or a key"));
    filter->setClearButtonEnabled(true);
    m_rows->setRootIsDecorated(false);
    m_rows->setUniformRowHeights(true);
    m_rows->setHeaderLabels({tr("action"), tr("key")});
    m_rows->header()->resizeSection(0, 336);
    fill(menus);
    m_message->setObjectName(QStringLiteral("keysMessage"));
    m_message->setWordWrap(true);
    m_message->setMinimumHeight(2 * m_message->fontMetrics().lineSpacing());
    auto *none = namedButton("keysNone", tr("No key"), tr("The action has no key"), this);
    auto *byDefault
        = namedButton("keysDefault", tr("Default"), tr("The key that the action had first"), this);
    auto *all = namedButton("keysAllDefaults", tr("All defaults"),
                            tr("Every action has the key that it had first"), this);
    auto *row = new QHBoxLayout;
    row->addWidget(m_key, 1);
    row->addWidget(none);
    row->addWidget(byDefault);
    row->addWidget(all);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(8);
    layout->addWidget(filter);
    layout->addWidget(m_rows, 1);
    layout->addLayout(row);
    layout->addWidget(m_message);
    layout->addWidget(buttons);
    resize(600, 560); // on the lowest screen, too

    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(filter, &QLineEdit::textChanged, this, &KeysDialog::showOnly);
    connect(m_rows, &QTreeWidget::currentItemChanged, this, &KeysDialog::showRow);
    connect(m_key, &KeyField::editingFinished, this, &KeysDialog::takeKey);
    connect(none, &QAbstractButton::clicked, this, [this] { offerKeys({}); });
    connect(byDefault, &QAbstractButton::clicked, this,
            [this] { offerKeys(defaultsOf(*actionInHand())); });
    connect(all, &QAbstractButton::clicked, this, [this] {
        for (QAction *action : std::as_const(m_actions))
            giveKeys(action, defaultsOf(*action));
        m_message->setText(tr("Every action has the key that it had first."));
    });
    connect(m_rows, &QTreeWidget::currentItemChanged, this,
            [this, none, byDefault](const QTreeWidgetItem *current) {
                m_key->setEnabled(current);
                none->setEnabled(current);
                byDefault->setEnabled(current);
            });
    m_rows->setCurrentItem(m_rows->topLevelItem(0));
}

void KeysDialog::fill(const QList<QMenu *> &menus)
{
    for (const QMenu *menu : menus) {
        for (QAction *action : actionsIn(*menu)) {
            if (action->objectName().isEmpty())
                continue;
            m_actions += action;
            new QTreeWidgetItem(
                m_rows,
                {tr("%1 ▸ %2").arg(withoutMnemonic(menu->title()), listedText(*action)),
                 shownKeys(*action)});
        }
    }
}

QAction *KeysDialog::actionInHand() const
{
    const int row = m_rows->indexOfTopLevelItem(m_rows->currentItem());
    return row >= 0 ? m_actions[row] : nullptr;
}

void KeysDialog::showRow(QTreeWidgetItem *row)
{
    m_message->clear();
    m_key->setKeySequence(row ? actionInHand()->shortcut() : QKeySequence());
}

void KeysDialog::showOnly(const QString &words)
{
    QTreeWidgetItem *firstShown = nullptr;
    for (int i = m_rows->topLevelItemCount() - 1; i >= 0; --i) {
        QTreeWidgetItem *row = m_rows->topLevelItem(i);
        row->setHidden(!row->text(0).contains(words, Qt::CaseInsensitive)
                       && !row->text(keyColumn).contains(words, Qt::CaseInsensitive));
        firstShown = row->isHidden() ? firstShown : row;
    }
    // Only what is seen is in hand.
    if (const QTreeWidgetItem *row = m_rows->currentItem(); !row || row->isHidden())
        m_rows->setCurrentItem(firstShown);
}

void KeysDialog::takeKey()
{
    const QKeySequence key = m_key->keySequence();
    const QAction *action = actionInHand();
    if (!action || key == action->shortcut())
        return;
    if (!isOwnKey(key))
        return offerKeys({key});
    m_key->setKeySequence(action->shortcut());
    m_message->setText(tr("%1 is a key of the canvas and of the fields themselves: take another.")
                           .arg(key.toString(QKeySequence::NativeText)));
}

void KeysDialog::offerKeys(const QList<QKeySequence> &keys)
{
    QAction *action = actionInHand();
    for (const QAction *other : std::as_const(m_actions)) {
        for (const QKeySequence &key : keys) {
            if (other == action || !other->shortcuts().contains(key))
                continue;
            m_key->setKeySequence(action->shortcut());
            m_message->setText(
                tr("%1 is the key of “%2”: take another, or take that one's key "
                   "away first.")
                    .arg(key.toString(QKeySequence::NativeText), listedText(*other)));
            return;
        }
    }
    giveKeys(action, keys);
}

void KeysDialog::giveKeys(QAction *action, const QList<QKeySequence> &keys)
{
    changeKeys(action, keys);
    QSettings settings;
    if (keys == defaultsOf(*action))
        settings.remove(settingOf(*action));
    else
        settings.setValue(settingOf(*action), textOf(keys));
    m_rows->topLevelItem(int(m_actions.indexOf(action)))->setText(keyColumn, shownKeys(*action));
    if (action == actionInHand())
        m_key->setKeySequence(action->shortcut());
    m_message->setText(
        keys.isEmpty() ? tr("“%1” has no key.").arg(listedText(*action))
                       : tr("“%1” has the key %2.").arg(listedText(*action), shownKeys(*action)));
}

} // namespace pixelplumb
