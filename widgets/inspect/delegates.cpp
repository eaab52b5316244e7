// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/inspect/delegates.h"

#include "core/scene/text/coordinatetext.h"
#include "widgets/look/colourbutton.h"
#include "widgets/look/parts.h"
#include "widgets/look/signs.h"
#include "widgets/model/pixelhistorymodel.h"
#include "widgets/model/primitivelistmodel.h"
#include "widgets/model/scenedocument.h"

#include <QtWidgets>

namespace pixelplumb {

namespace {

/// Accepts input that cannot be read yet, since it may become readable; on Enter the error is
/// reported.
template <class Parse>
class CellValidator final : public QValidator {
public:
    CellValidator(const Parse &parse, SceneDocument *document, QObject *parent)
        : QValidator(parent)
        , m_parse(parse)
        , m_document(document)
    {
    }

    State validate(QString &text, int &) const override
    {
        return m_parse(text) ? Acceptable : Intermediate;
    }

    void fixup(QString &text) const override
    {
        if (const auto read = m_parse(text); !read)
            emit m_document->refused(read.error().message());
    }

private:
    Parse m_parse;
    SceneDocument *m_document;
};

constexpr int swatchWidth = 16;
constexpr int cellGap = 4;
constexpr int partGap = 12;
constexpr int linePadding = 4;
constexpr float writeAheadFade = 0.42F;

bool isAttempt(const QModelIndex &index) { return !index.parent().isValid(); }

/// Draws words and colours from left to right on one line.
class LinePainter {
public:
    LinePainter(QPainter &painter, const QStyleOptionViewItem &item)
        : m_painter(painter)
        , m_item(item)
        , m_left(item.rect.left() + cellGap)
    {
    }

    void drawText(const QString &text)
    {
        const int width = m_item.fontMetrics.horizontalAdvance(text);
        m_painter.drawText(QRect(m_left, m_item.rect.top(), width, m_item.rect.height()),
                           Qt::AlignVCenter, text);
        m_left += width;
    }

    void drawColour(const QColor &colour)
    {
        const int side = m_item.fontMetrics.ascent();
        const QRect swatch(m_left, m_item.rect.center().y() - side / 2, swatchWidth, side);
        m_painter.fillRect(swatch, m_item.palette.color(QPalette::Mid));
        m_painter.fillRect(swatch.adjusted(1, 1, -1, -1), colour);
        m_left += swatchWidth + cellGap;
        drawText(colour.name());
    }

    void skip(int width) { m_left += width; }

private:
    QPainter &m_painter;
    const QStyleOptionViewItem &m_item;
    int m_left;
};

void drawAttempt(LinePainter &line, const QModelIndex &index)
{
    line.drawText(index.siblingAtColumn(PixelHistoryModel::WhatColumn).data().toString());
    const QModelIndex used = index.siblingAtColumn(PixelHistoryModel::UsedColumn);
    const QVariant after = used.data(PixelHistoryModel::AfterColourRole);
    line.skip(partGap);
    if (after.isValid()) {
        line.drawColour(used.data(PixelHistoryModel::BeforeColourRole).value<QColor>());
        line.drawText(u" → "_s);
        line.drawColour(after.value<QColor>());
    } else {
        line.drawText(used.data().toString());
    }
    for (const int column : {PixelHistoryModel::ByteColumn, PixelHistoryModel::ExactColumn}) {
        line.skip(partGap);
        line.drawText(index.siblingAtColumn(column).data().toString());
    }
}

} // namespace

VertexDelegate::VertexDelegate(SceneDocument *document, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_document(document)
{
}

QWidget *VertexDelegate::createEditor(QWidget *parent, const QStyleOptionViewItem &,
                                      const QModelIndex &index) const
{
    const bool isColour = index.column() == PrimitiveListModel::ColourText;
    auto *field = named(new QLineEdit(parent), isColour ? "colourField" : "coordinateField",
                        index.model()->headerData(index.column(), Qt::Horizontal).toString());
    if (isColour)
        field->setValidator(new CellValidator(
            [](const QString &text) { return opaqueColour(text); }, m_document, field));
    else
        field->setValidator(new CellValidator(
            [](const QString &text) { return parseCoordinate(text); }, m_document, field));
    field->setFrame(false);
    return field;
}

QString PixelHistoryDelegate::displayText(const QVariant &value, const QLocale &) const
{
    // A thin space between digits and a fraction's small digits is not noticed in plain text.
    return value.toString().replace(QChar(0x2009), QChar(0x00a0));
}

QSize PixelHistoryDelegate::sizeHint(const QStyleOptionViewItem &option,
                                     const QModelIndex &index) const
{
    const QSize size = QStyledItemDelegate::sizeHint(option, index);
    const int height = option.fontMetrics.height() + linePadding;
    // An attempt spans all columns, so it needs no width in any.
    return {isAttempt(index) ? 0 : size.width() + partGap, height};
}

void PixelHistoryDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                                 const QModelIndex &index) const
{
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    if (index.data(PixelHistoryModel::IsAheadRole).toBool())
        item.palette.setColor(QPalette::Text,
                              blended(item.palette.color(QPalette::Text),
                                      item.palette.color(QPalette::Base), writeAheadFade));
    const QStyle *style = item.widget ? item.widget->style() : QApplication::style();
    if (!isAttempt(index)) {
        style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
        return;
    }
    item.text.clear();
    style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
    painter->save();
    painter->setFont(item.font);
    painter->setClipRect(item.rect);
    const bool isSelected = item.state.testFlag(QStyle::State_Selected);
    painter->setPen(item.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text));
    LinePainter line(*painter, item);
    drawAttempt(line, index);
    painter->restore();
}

} // namespace pixelplumb
