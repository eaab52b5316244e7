// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/window/showntexts.h"

#include <QtWidgets>

namespace pixelplumb {

namespace {

void appendCells(QList<ShownText> &texts, const QAbstractItemView &view, const QModelIndex &parent)
{
    const QAbstractItemModel &model = *view.model();
    for (int row = 0; row < model.rowCount(parent); ++row) {
        for (int column = 0; column < model.columnCount(parent); ++column) {
            const QModelIndex cell = model.index(row, column, parent);
            texts += {view.objectName() + " cell", cell.data().toString()};
            if (column == 0)
                appendCells(texts, view, cell);
        }
    }
}

} // namespace

void appendTexts(QList<ShownText> &texts, const QMenu &menu)
{
    texts += {menu.objectName() + " title", menu.title()};
    for (const QAction *each : menu.actions()) {
        texts += {each->objectName(), each->text()};
        if (each->toolTip() != QAction(each->text()).toolTip())
            texts += {each->objectName() + " tip", each->toolTip()};
        if (each->menu())
            appendTexts(texts, *each->menu());
    }
}

QList<ShownText> shownTexts(const QWidget &whole)
{
    QList<ShownText> texts{{whole.objectName() + " title", whole.windowTitle()}};
    for (const auto *dock : whole.findChildren<QDockWidget *>())
        texts += {dock->objectName() + " title", dock->windowTitle()};
    for (const auto *button : whole.findChildren<QAbstractButton *>()) {
        // Qt's own buttons have Qt's texts.
        if (qobject_cast<const QDialogButtonBox *>(button->parentWidget()))
            continue;
        texts += {button->objectName(), button->text()};
        texts += {button->objectName() + " tip", button->toolTip()};
    }
    for (const auto *box : whole.findChildren<QGroupBox *>())
        texts += {box->objectName(), box->title()};
    for (const auto *label : whole.findChildren<QLabel *>())
        texts += {label->objectName(), label->text()};
    for (const auto *box : whole.findChildren<QComboBox *>()) {
        for (int i = 0; i < box->count(); ++i)
            texts += {box->objectName(), box->itemText(i)};
    }
    for (const auto *bar : whole.findChildren<QTabBar *>()) {
        for (int i = 0; i < bar->count(); ++i)
            texts += {bar->objectName(), bar->tabText(i)};
    }
    for (const auto *header : whole.findChildren<QHeaderView *>()) {
        for (int i = 0; header->orientation() == Qt::Horizontal && i < header->count(); ++i)
            texts += {header->parentWidget()->objectName() + " header",
                      header->model()->headerData(i, Qt::Horizontal).toString()};
    }
    return texts;
}

QList<ShownText> shownContents(const QWidget &whole)
{
    QList<ShownText> texts;
    for (const auto *view : whole.findChildren<QAbstractItemView *>()) {
        if (view->model() && !qobject_cast<const QHeaderView *>(view))
            appendCells(texts, *view, {});
    }
    for (const auto *edit : whole.findChildren<QTextEdit *>())
        texts += {edit->objectName(), edit->toPlainText()};
    for (const auto *edit : whole.findChildren<QPlainTextEdit *>())
        texts += {edit->objectName(), edit->toPlainText()};
    return texts;
}

} // namespace pixelplumb
