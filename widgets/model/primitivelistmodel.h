// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/scenedocument.h"

#include <QAbstractItemModel>

namespace pixelplumb {

/// The document's triangles and shapes in drawing order, each with a box that shows or hides it,
/// and below each its vertices in the file's order with their coordinates, which can be edited, and
/// their colours. Hidden ones stand in their places, which no hiding changes, without a number and
/// without vertices. Solids stand between triangles and shapes; their own triangles are none of the
/// document's.
class PrimitiveListModel : public QAbstractItemModel {
    Q_OBJECT

public:
    /// Name: the kind and the number that the whole program gives to what is drawn; Place: in the
    /// file's order, from 1, the hidden ones counted.
    enum Column { Name, Place, X, Y, ColourText, columnEnd };

    explicit PrimitiveListModel(SceneDocument *document, QObject *parent = nullptr);

    /// The vertex of a row; of a primitive's row its first; none of a hidden one's, nor of a
    /// solid's. Any column.
    std::optional<VertexRef> refAt(const QModelIndex &index) const;
    /// The index among the hidden ones of a hidden primitive's row.
    std::optional<int> hiddenAt(const QModelIndex &index) const;
    std::optional<std::size_t> solidAt(const QModelIndex &index) const; ///< its index
    bool isPrimitive(const QModelIndex &index) const; ///< or a solid
    QModelIndex indexOf(const VertexRef &ref) const;
    QModelIndex indexOfPrimitive(int primitive) const;

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &index) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    /// A coordinate as text: "26", "26.5" or "53/2"; or whether a primitive is checked, and shown.
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        int primitive = 0; ///< of a hidden one: −1 − its index among the hidden
        int vertexCount = 0; ///< that can be edited
        std::optional<std::size_t> solid = {}; ///< and no primitive

        friend bool operator==(const Row &, const Row &) = default;
    };

    void followScene();
    std::vector<Row> rowsOfScene() const;
    QVariant solidData(int column, int role, std::size_t index) const;
    QVariant hiddenData(int column, int role, const HiddenPrimitive &hidden) const;

    SceneDocument *m_document;
    std::vector<Row> m_rows; ///< of the primitives
};

} // namespace pixelplumb
