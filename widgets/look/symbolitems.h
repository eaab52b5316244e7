// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QStyledItemDelegate>

namespace pixelplumb {

/// Draws an item's text with subscripts (see SymbolText), cut off where it does not fit.
class SymbolDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
};

/// A combo box whose texts have subscripts, the current one and those of its list.
class SymbolBox : public QComboBox {
    Q_OBJECT

public:
    explicit SymbolBox(QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;
};

} // namespace pixelplumb
