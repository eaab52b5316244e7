// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/scenedocument.h"

#include <QAbstractItemModel>

namespace pixelplumb {

/// The document's triangles and shapes in drawing order, each with a check box to show or hide it,
/// and below each its vertices in file order with their coordinates and colours, all editable.
/// Hidden primitives keep their places, but have no numbers and no vertices. Solids come between
/// triangles and shapes; a solid's triangles do not count among the document's.
class PrimitiveListModel : public QAbstractItemModel {
    Q_OBJECT

public:
    /// Name: the kind, and the number of what is drawn, as everywhere in the program; Place: in
    /// file order, from 1, hidden ones included.
    enum Column { Name, Place, X, Y, ColourText, columnEnd };

    explicit PrimitiveListModel(SceneDocument *document, QObject *parent = nullptr);

    /// The vertex of a row, in any column; the first vertex for a primitive's row; none for a
    /// hidden primitive or a solid.
    std::optional<VertexRef> refAt(const QModelIndex &index) const;
    /// The index of a hidden primitive's row among the hidden ones.
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
    /// Sets a coordinate from text: "26", "26.5" or "53/2"; a colour, of all vertices in the row of
    /// a primitive: "#a06f30"; or whether a primitive is checked and shown.
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        int primitive = 0; ///< for a hidden one: −1 − its index among the hidden
        int vertexCount = 0; ///< editable ones
        std::optional<std::size_t> solid = {}; ///< then not a primitive

        friend bool operator==(const Row &, const Row &) = default;
    };

    void followScene();
    std::vector<Row> rowsOfScene() const;
    QVariant solidData(int column, int role, std::size_t index) const;
    QVariant hiddenData(int column, int role, const HiddenPrimitive &hidden) const;

    SceneDocument *m_document;
    std::vector<Row> m_rows; ///< one per primitive or solid
};

} // namespace pixelplumb
