// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace pixelplumb {

class SceneDocument;

/// The field in which a coordinate or a colour of a list is typed (objectNames "coordinateField"
/// and "colourField"). Invalid input is refused; the document tells why (SceneDocument::refused).
class VertexDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    VertexDelegate(SceneDocument *document, QObject *parent);

    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const override;

private:
    SceneDocument *m_document;
};

/// Draws an attempt across all columns, a write as two colours with an arrow between them, and
/// writes that have not happened yet dimmed.
class PixelHistoryDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QString displayText(const QVariant &value, const QLocale &locale) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
};

} // namespace pixelplumb
