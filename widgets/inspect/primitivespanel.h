// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/scenedocument.h"

#include <QWidget>

class QAction;
class QHBoxLayout;
class QLabel;
class QMenu;

namespace pixelplumb {

class PrimitiveListModel;
class PrimitiveForms;
class PrimitivesTree;

/// The scene's primitives as a list (objectName "primitives"): chosen here they are chosen on the
/// canvas, and the other way round; they change places in the drawing order, take another colour,
/// are hidden and shown, go (by the buttons or by a right click), and their coordinates are typed
/// in place. Everything is an edit that can be undone.
class PrimitivesPanel : public QWidget {
    Q_OBJECT

public:
    explicit PrimitivesPanel(SceneDocument *document, QWidget *parent = nullptr);

    /// With the list in focus they delete what is in hand, as the action does on the canvas.
    void takeKeysOf(const QAction *deletion);

    QSize sizeHint() const override { return {384, 480}; }

protected:
    void resizeEvent(QResizeEvent *event) override;

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
    /// What the row in hand stands for; none without one.
    std::optional<VertexRef> refInHand() const;

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
    int m_lastRow = -1; ///< of the primitive that was in hand before the list was built anew
    bool m_following = false; ///< the list moves after the document, not the other way
};

} // namespace pixelplumb
