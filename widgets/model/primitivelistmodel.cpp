// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/primitivelistmodel.h"

#include "core/scan/choicenames.h"
#include "core/scene/appearancenames.h"
#include "core/scene/fileorder.h"
#include "core/scene/scenefile.h"
#include "core/scene/text/colourtext.h"
#include "core/scene/text/coordinatetext.h"
#include "widgets/look/colourbutton.h"
#include "widgets/look/corewords.h"

#include <QGuiApplication>

#include <algorithm>
#include <limits>
#include <span>

namespace pixelplumb {

namespace {

/// The internal id of a primitive's row; a vertex's is its primitive's row + 1, so that 0 is free.
constexpr quintptr ofPrimitive = 0;
constexpr int ofSolid = std::numeric_limits<int>::min(); ///< in place of a primitive's number

int rowOf(const QModelIndex &vertex) { return int(vertex.internalId()) - 1; }

bool haveOneColour(std::span<const Vertex> vertices)
{
    return std::ranges::all_of(
        vertices, [&](const Vertex &vertex) { return vertex.colour == vertices[0].colour; });
}

QVariant colourData(std::span<const Vertex> vertices, int role)
{
    const Colour &first = vertices.front().colour;
    const bool isOne = haveOneColour(vertices);
    if (role == Qt::DecorationRole && isOne)
        return swatch(first, QGuiApplication::palette());
    if (role != Qt::DisplayRole && role != Qt::EditRole)
        return {};
    if (isOne)
        return colourText(first);
    return role == Qt::EditRole ? QString() : PrimitiveListModel::tr("several");
}

} // namespace

PrimitiveListModel::PrimitiveListModel(SceneDocument *document, QObject *parent)
    : QAbstractItemModel(parent)
    , m_document(document)
    , m_rows(rowsOfScene())
{
    connect(document, &SceneDocument::sceneChanged, this, &PrimitiveListModel::followScene);
}

std::vector<PrimitiveListModel::Row> PrimitiveListModel::rowsOfScene() const
{
    const Scene &scene = m_document->scene();
    std::vector<Row> rows;
    rows.reserve(std::size_t(m_document->primitiveCount() + m_document->hiddenCount()));
    const auto appendHidden = [&](std::size_t index) { rows.push_back({-1 - int(index), 0}); };
    visitTriangles(
        scene,
        [&](std::size_t index, const TriangleAttributes *) {
            rows.push_back({int(index), 3});
        },
        appendHidden);
    for (std::size_t i = 0; i < scene.solids.size(); ++i)
        rows.push_back({ofSolid, 0, i});
    visitShapes(
        scene,
        [&](std::size_t index) {
            rows.push_back(
                {int(scene.triangles.size() + index), int(scene.shapes[index].vertices.size())});
        },
        appendHidden);
    return rows;
}

/// Keeps the rows while only their contents change, so that a drag neither collapses nor scrolls
/// them.
void PrimitiveListModel::followScene()
{
    std::vector<Row> rows = rowsOfScene();
    if (rows != m_rows) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    } else if (!m_rows.empty()) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnEnd - 1)); // and the rows below
    }
}

bool PrimitiveListModel::isPrimitive(const QModelIndex &index) const
{
    return index.isValid() && index.internalId() == ofPrimitive;
}

std::optional<VertexRef> PrimitiveListModel::refAt(const QModelIndex &index) const
{
    const bool isWhole = isPrimitive(index);
    const int row = isWhole ? index.row() : rowOf(index);
    const int primitive = m_rows[std::size_t(row)].primitive;
    if (primitive < 0)
        return std::nullopt;
    return VertexRef{primitive, isWhole ? 0 : index.row()};
}

std::optional<int> PrimitiveListModel::hiddenAt(const QModelIndex &index) const
{
    const int primitive = isPrimitive(index) ? m_rows[std::size_t(index.row())].primitive : 0;
    return primitive < 0 && primitive != ofSolid ? std::optional(-1 - primitive) : std::nullopt;
}

std::optional<std::size_t> PrimitiveListModel::solidAt(const QModelIndex &index) const
{
    return isPrimitive(index) ? m_rows[std::size_t(index.row())].solid : std::nullopt;
}

QModelIndex PrimitiveListModel::indexOfPrimitive(int primitive) const
{
    // Hidden primitives before it shift its row.
    for (int row = primitive; row < int(m_rows.size()); ++row) {
        if (m_rows[std::size_t(row)].primitive == primitive)
            return index(row, Name);
    }
    return {};
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
    return createIndex(rowOf(index), Name, ofPrimitive);
}

int PrimitiveListModel::rowCount(const QModelIndex &parent) const
{
    if (!parent.isValid())
        return int(m_rows.size());
    const bool hasRows = isPrimitive(parent) && parent.column() == Name;
    return hasRows ? m_rows[std::size_t(parent.row())].vertexCount : 0;
}

int PrimitiveListModel::columnCount(const QModelIndex &) const { return columnEnd; }

Qt::ItemFlags PrimitiveListModel::flags(const QModelIndex &index) const
{
    if (!index.isValid())
        return {};
    const bool isCoordinate = index.column() == X || index.column() == Y;
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.column() == ColourText && refAt(index))
        return flags | Qt::ItemIsEditable;
    if (!isPrimitive(index))
        return isCoordinate ? flags | Qt::ItemIsEditable : flags;
    return index.column() == Name ? flags | Qt::ItemIsUserCheckable : flags;
}

QVariant PrimitiveListModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == Qt::TextAlignmentRole && index.column() >= Place && index.column() <= Y)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::DisplayRole && index.column() == Place)
        return isPrimitive(index) ? QString::number(index.row() + 1) : QString();
    if (const std::optional<std::size_t> solid = solidAt(index))
        return solidData(index.column(), role, *solid);
    if (const std::optional<int> hidden = hiddenAt(index))
        return hiddenData(index.column(), role, m_document->scene().hidden[std::size_t(*hidden)]);
    const VertexRef ref = *refAt(index);
    const std::optional<Vertex> vertex = m_document->vertexAt(ref);
    if (!vertex)
        return {};
    const bool isWhole = isPrimitive(index);
    if (role == Qt::CheckStateRole && isWhole && index.column() == Name)
        return Qt::Checked;
    if (index.column() == ColourText)
        return isWhole ? colourData(m_document->verticesOf(ref.primitive), role)
                       : colourData(std::span(&*vertex, 1), role);
    if (role != Qt::DisplayRole && role != Qt::EditRole)
        return {};
    switch (Column(index.column())) {
    case Name:
        return isWhole ? u"%1 %2"_s.arg(coreWord(nameOf(m_document->kindOf(ref.primitive))),
                                        QString::number(ref.primitive))
                       : tr("vertex %1").arg(ref.vertex);
    case X:
        return isWhole ? QString() : coordinateText(vertex->position.x);
    case Y:
        return isWhole ? QString() : coordinateText(vertex->position.y);
    case Place: // handled above
    case ColourText:
    case columnEnd:
        break;
    }
    return {};
}

QVariant PrimitiveListModel::solidData(int column, int role, std::size_t index) const
{
    const Solid &solid = m_document->scene().solids[index];
    if (role == Qt::ForegroundRole && solid.isHidden)
        return QGuiApplication::palette().brush(QPalette::PlaceholderText);
    if (role == Qt::CheckStateRole && column == Name)
        return solid.isHidden ? Qt::Unchecked : Qt::Checked;
    if (role != Qt::DisplayRole || column != Name)
        return {};
    const QString kind = coreWord(nameOf(solid.kind));
    return solid.isHidden ? tr("%1, hidden").arg(kind)
                          : tr("%1, solid %2").arg(kind, QString::number(index));
}

QVariant PrimitiveListModel::hiddenData(int column, int role, const HiddenPrimitive &hidden) const
{
    const std::span<const Vertex> vertices = hidden.vertices();
    if (role == Qt::ForegroundRole)
        return QGuiApplication::palette().brush(QPalette::PlaceholderText);
    if (role == Qt::CheckStateRole && column == Name)
        return Qt::Unchecked;
    if (column == ColourText)
        return colourData(vertices, role);
    if (role != Qt::DisplayRole)
        return {};
    if (column == Name)
        return tr("%1, hidden").arg(coreWord(nameOf(hidden.kind())));
    const LatticePoint &first = vertices.front().position; // tells them apart
    return coordinateText(column == X ? first.x : first.y);
}

bool PrimitiveListModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role == Qt::CheckStateRole && isPrimitive(index) && index.column() == Name) {
        const std::optional<int> hidden = hiddenAt(index);
        if (const std::optional<std::size_t> solid = solidAt(index))
            m_document->setSolidShown(*solid, value == Qt::Checked);
        else if (hidden && value == Qt::Checked)
            m_document->showHidden(*hidden);
        else if (!hidden && value == Qt::Unchecked)
            m_document->hidePrimitive(refAt(index)->primitive);
        return true;
    }
    if (role != Qt::EditRole || !flags(index).testFlag(Qt::ItemIsEditable))
        return false;
    if (index.column() == ColourText) {
        const Result<Colour> colour = opaqueColour(value.toString());
        if (colour && isPrimitive(index))
            m_document->setPrimitiveColour(refAt(index)->primitive, *colour);
        else if (colour)
            m_document->setVertexColour(*refAt(index), *colour);
        return colour.isOk();
    }
    const Result<SnappedNumber> number = parseCoordinate(value.toString());
    const VertexRef ref = *refAt(index);
    const std::optional<Vertex> vertex = m_document->vertexAt(ref);
    if (!number || !vertex)
        return false;
    LatticePoint position = vertex->position;
    (index.column() == X ? position.x : position.y) = number->units;
    m_document->moveVertex(ref, position, m_document->newDrag());
    if (number->isDisplaced()) {
        const QString place = tr("vertex %1, %2")
                                  .arg(ref.vertex)
                                  .arg(index.column() == X ? QChar(u'x') : QChar(u'y'));
        emit m_document->notice(SnapReport{place, value.toString(), *number}.message());
    }
    return true;
}

QVariant PrimitiveListModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= columnEnd)
        return {};
    if (role == Qt::ToolTipRole && section == Name)
        return tr(
            "The number used in all other places: counted from 0, among the drawn primitives");
    if (role == Qt::ToolTipRole && section == Place)
        return tr(
            "The place in the drawing order, hidden ones counted, from 1; hiding changes none");
    const std::array titles{tr("primitive"), tr("place"), tr("x, px"), tr("y, px"), tr("colour")};
    return role == Qt::DisplayRole ? titles[std::size_t(section)] : QVariant();
}

} // namespace pixelplumb
