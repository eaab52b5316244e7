// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/windowparts.h"

#include <QtWidgets>

namespace pixelplumb {

struct Layer;

/// Scenes as files, and everything that is exported.
class FileMenu : public QMenu {
    Q_OBJECT

public:
    FileMenu(const WindowParts &parts, QWidget *window);

signals:
    void examplesRequested();

private:
    void addExports(const WindowParts &parts);
};

/// The figures of the course texts that can be laid over the frame. A layer with nothing to show
/// for the current scene and method is grey and says why.
class LayersMenu : public QMenu {
    Q_OBJECT

public:
    LayersMenu(const WindowParts &parts, QWidget *window);

private:
    void addLayer(const Layer &layer, const WindowParts &parts);
};

/// The menu of moves in time, with their keys.
class StepMenu : public QMenu {
    Q_OBJECT

public:
    StepMenu(const WindowParts &parts, QWidget *window);
};

/// The manual; the key sheet, made from the menu bar's menus; What's This; the About box.
class HelpMenu : public QMenu {
    Q_OBJECT

public:
    explicit HelpMenu(QMenuBar *bar);

    /// All menus of the bar.
    QList<QMenu *> menus() const;

private:
    void showManual();
    void showKeys();
    void showAbout();

    QMenuBar *m_bar;
};

} // namespace pixelplumb
