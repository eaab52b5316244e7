// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/scenedocument.h"

#include <QtWidgets>

namespace pixelplumb {

class PrimitiveListModel;
class PrimitiveForms;
class PrimitivesTree;

/// The scene's primitives as a list (objectName "primitives"). Its selection and the canvas's
/// follow each other. Primitives can be moved in the drawing order, recoloured, hidden, shown and
/// deleted (by the buttons or a right click), and their coordinates typed in place. Everything is
/// an edit that can be undone.
class PrimitivesPanel : public QWidget {
    Q_OBJECT

public:
    explicit PrimitivesPanel(SceneDocument *document, QWidget *parent = nullptr);

    /// Gives the deletion keys of the canvas's action to the list: in focus, it deletes its current
    /// row.
    void takeKeysOf(const QAction *deletion);

    QSize sizeHint() const override { return {384, 480}; }

private:
    void addActions(QHBoxLayout *row);
    void fitColumns();
    void hideOrShow();
    void chooseRow(const QModelIndex &index);
    void followSelection();
    void followReset();
    void update();
    void remove();
    void moveBy(int places);
    void chooseColour();
    void chooseSolidColour(std::size_t index);
    /// The vertex of the current row; none without a row.
    std::optional<VertexRef> currentRef() const;

    SceneDocument *m_document;
    PrimitiveListModel *m_model;
    PrimitivesTree *m_tree;
    QLabel *m_summary;
    QMenu *m_menu = nullptr;
    QAction *m_up = nullptr;
    QAction *m_down = nullptr;
    QAction *m_colour = nullptr;
    QAction *m_form = nullptr;
    PrimitiveForms *m_forms = nullptr;
    QAction *m_hide = nullptr;
    QAction *m_remove = nullptr;
    int m_lastRow = -1; ///< of the current primitive, before the list was rebuilt
    bool m_following = false; ///< the list follows the document, not the other way round
};

} // namespace pixelplumb
