// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/primitivelistmodel.h"

#include "core/scene/colourtext.h"
#include "core/scene/coordinatetext.h"
#include "widgets/look/colourbutton.h"

#include <QGuiApplication>

#include <algorithm>

namespace pixelplumb {

namespace {

/// Of a primitive's row; a vertex's row has its primitive's number and one more, so that 0 is free.
constexpr quintptr ofPrimitive = 0;

int primitiveOf(const QModelIndex &vertex) { return int(vertex.internalId()) - 1; }

bool haveOneColour(const std::vector<Vertex> &vertices)
{
    return std::ranges::all_of(
        vertices, [&](const Vertex &vertex) { return vertex.colour == vertices[0].colour; });
}

} // namespace

PrimitiveListModel::PrimitiveListModel(SceneDocument *document, QObject *parent)
    : QAbstractItemModel(parent)
    , m_document(document)
    , m_rows(rowsOfScene())
{
    connect(document, &SceneDocument::sceneChanged, this, &PrimitiveListModel::followScene);
}

std::vector<int> PrimitiveListModel::rowsOfScene() const
{
    std::vector<int> rows(std::size_t(m_document->primitiveCount()), 3);
    const Scene &scene = m_document->scene();
    for (std::size_t shape = 0; shape < scene.shapes.size(); ++shape)
        rows[scene.triangles.size() + shape] = int(scene.shapes[shape].vertices.size());
    return rows;
}

/// Rows stay while only what is in them changes, so that a drag neither closes nor scrolls them.
void PrimitiveListModel::followScene()
{
    std::vector<int> rows = rowsOfScene();
    if (rows != m_rows) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    } else if (!m_rows.empty()) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnEnd - 1)); // and in what is below
    }
}

bool PrimitiveListModel::isPrimitive(const QModelIndex &index) const
{
    return index.isValid() && index.internalId() == ofPrimitive;
}

VertexRef PrimitiveListModel::refAt(const QModelIndex &index) const
{
    return isPrimitive(index) ? VertexRef{index.row(), 0}
                              : VertexRef{primitiveOf(index), index.row()};
}

QModelIndex PrimitiveListModel::indexOfPrimitive(int primitive) const
{
    return index(primitive, Name);
}

QModelIndex PrimitiveListModel::indexOf(const VertexRef &ref) const
{
    return index(ref.vertex, Name, indexOfPrimitive(ref.primitive));
}

QModelIndex PrimitiveListModel::index(int row, int column, const QModelIndex &parent) const
{
    if (row < 0 || row >= rowCount(parent) || column < 0 || column >= columnEnd)
        return {};
    return createIndex(row, column, parent.isValid() ? quintptr(parent.row()) + 1 : ofPrimitive);
}

QModelIndex PrimitiveListModel::parent(const QModelIndex &index) const
{
    if (!index.isValid() || isPrimitive(index))
        return {};
    return createIndex(primitiveOf(index), Name, ofPrimitive);
}

int PrimitiveListModel::rowCount(const QModelIndex &parent) const
{
    if (!parent.isValid())
        return int(m_rows.size());
    const bool hasRows = isPrimitive(parent) && parent.column() == Name;
    return hasRows ? m_rows[std::size_t(parent.row())] : 0;
}

int PrimitiveListModel::columnCount(const QModelIndex &) const { return columnEnd; }

Qt::ItemFlags PrimitiveListModel::flags(const QModelIndex &index) const
{
    if (!index.isValid())
        return {};
    const bool isCoordinate = index.column() == X || index.column() == Y;
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return !isPrimitive(index) && isCoordinate ? flags | Qt::ItemIsEditable : flags;
}

QVariant PrimitiveListModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const VertexRef ref = refAt(index);
    const std::optional<Vertex> vertex = m_document->vertexAt(ref);
    if (!vertex)
        return {};
    const bool isWhole = isPrimitive(index);
    const bool isColour = index.column() == ColourText;
    const bool isMixed
        = isWhole && isColour && !haveOneColour(m_document->verticesOf(ref.primitive));
    if (role == Qt::TextAlignmentRole && (index.column() == X || index.column() == Y))
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::DecorationRole && isColour && !isMixed)
        return swatch(vertex->colour, QGuiApplication::palette());
    if (role != Qt::DisplayRole && role != Qt::EditRole)
        return {};
    switch (Column(index.column())) {
    case Name:
        return isWhole ? QStringLiteral("%1 %2")
                             .arg(nameOf(m_document->kindOf(ref.primitive)))
                             .arg(ref.primitive)
                       : tr("vertex %1").arg(ref.vertex);
    case X:
        return isWhole ? QString() : coordinateText(vertex->position.x);
    case Y:
        return isWhole ? QString() : coordinateText(vertex->position.y);
    case ColourText:
        return isMixed ? tr("several") : colourText(vertex->colour);
    case columnEnd:
        break;
    }
    return {};
}

bool PrimitiveListModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::EditRole || !flags(index).testFlag(Qt::ItemIsEditable))
        return false;
    const Result<SnappedNumber> number = parseCoordinate(value.toString());
    const VertexRef ref = refAt(index);
    const std::optional<Vertex> vertex = m_document->vertexAt(ref);
    if (!number || !vertex)
        return false;
    LatticePoint position = vertex->position;
    (index.column() == X ? position.x : position.y) = number->units;
    m_document->moveVertex(ref, position, m_document->newDrag());
    return true;
}

QVariant PrimitiveListModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    const std::array titles{tr("primitive"), tr("x, px"), tr("y, px"), tr("colour")};
    return section >= 0 && section < columnEnd ? titles[std::size_t(section)] : QVariant();
}

} // namespace pixelplumb
