// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/window/mainwindow.h"

#include <QAction>

/// What the tests of the window and of its docks share: a window on the screen, and its parts by
/// the names that are promised to programs.
namespace pixelplumb {

struct Scene;

/// The window as a person sees it first: active, the canvas in focus, the default scene half drawn.
std::unique_ptr<MainWindow> openedWindow();
/// The same with another scene, or with a file from resources/scenes.
std::unique_ptr<MainWindow> openedWindow(const Scene &scene);
std::unique_ptr<MainWindow> openedWindow(const QString &sceneFile);

/// A window of the default scene, active, as it would open at a size, whatever other runs have
/// kept.
std::unique_ptr<MainWindow> windowOf(const QSize &size);
/// Waits until what windows have put off is done: docks get their places one after another.
void settle();

/// The part of this name; null where there is none.
template <class Part>
Part *named(const QObject &whole, const char *name)
{
    return whole.findChild<Part *>(QLatin1String(name));
}
QAction *action(const MainWindow &window, const char *name);

/// A left click in the middle of a pixel's cell on the canvas.
void clickPixel(const MainWindow &window, const QPoint &pixel);

/// The rows "light" and "dark" of a test whose column is "palette".
void addPalettes();
/// The window's picture; saved as NAME-ROW.png in the folder PIXELPLUMB_GRABS where that is set.
QImage grabbed(MainWindow &window, const QString &name);

/// Why a part cannot be read as it is drawn: its ground, the most frequent colour, is not that of
/// the application's palette, or hardly a pixel has a contrast of 4.5 to it. Empty where it can.
QString readingFault(const QWidget &part);

} // namespace pixelplumb
