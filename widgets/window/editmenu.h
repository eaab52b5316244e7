// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <QMenu>

#include <optional>

namespace pixelplumb {

/// Edits of the scene, and the clipboard.
class EditMenu : public QMenu {
    Q_OBJECT

public:
    EditMenu(const WindowParts &parts, QWidget *window);

    /// The functions of a left click on the canvas; one of them is checked.
    const QList<QAction *> &tools() const { return m_tools; }
    const QAction *deletion() const { return m_deletion; } ///< deletes the selected primitive

private:
    void addTools();
    void addUndo();
    void addClipboard();
    void addVertices(QWidget *window);
    void addFrameAndSnap(QWidget *window);
    void chooseColourOfSelected(QWidget *window);
    void chooseNextColour(QWidget *window);
    void deleteSelected();
    /// The index of the triangle whose vertex is selected.
    std::optional<int> currentTriangle() const;
    void editSelected(QWidget *window);

    WindowParts m_parts;
    QList<QAction *> m_tools;
    const QAction *m_deletion = nullptr;
};

} // namespace pixelplumb
