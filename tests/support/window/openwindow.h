// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/signs.h"
#include "widgets/window/mainwindow.h"

#include <QAction>
#include <QMimeData>

/// Shared helpers of the window and dock tests: a window on the screen, and its parts by their
/// promised object names.
namespace pixelplumb {

using namespace Qt::StringLiterals;

struct Scene;

/// The window as a user first sees it: active, the canvas in focus, the default scene half drawn.
std::unique_ptr<MainWindow> openedWindow();
/// Like openedWindow(), but with another scene, or with a file from resources/scenes.
std::unique_ptr<MainWindow> openedWindow(const Scene &scene);
std::unique_ptr<MainWindow> openedWindow(const QString &sceneFile);

/// An active window with the default scene, in the layout for this size, whatever earlier runs have
/// stored.
std::unique_ptr<MainWindow> windowOf(const QSize &size);
/// Processes pending events: docks get their places one after another.
void settle();

/// Builds the window's panels that nobody has seen yet.
void buildPanelsOf(const QObject &window);
/// The child of this name, also in a panel that nobody has seen yet; null if there is none.
template <class Part>
Part *named(const QObject &whole, const char *name)
{
    if (Part *found = whole.findChild<Part *>(QLatin1String(name)))
        return found;
    buildPanelsOf(whole);
    return whole.findChild<Part *>(QLatin1String(name));
}
QAction *action(const MainWindow &window, const char *name);

/// A left click in the middle of a pixel's cell on the canvas.
void clickPixel(const MainWindow &window, const QPoint &pixel);

/// Whether a pixel's cell on the canvas shows the colour of a sign.
bool isMarked(const MainWindow &window, const QPoint &pixel, Sign sign);
/// Drops data, or a file, on the window, which must accept it.
void drop(MainWindow &window, const QMimeData &data);
void dropFile(MainWindow &window, const QString &path);

/// Adds the rows "light" and "dark" to a test; the column is "palette".
void addPalettes();
/// The window's picture; also saved as NAME-ROW.png if PIXELPLUMB_GRABS names a folder.
QImage grabbed(MainWindow &window, const QString &name);

/// Why a part is unreadable as drawn: its background (the most frequent colour) differs from the
/// application's palette, or too few pixels have a contrast of 4.5 to it. Empty if it is readable.
QString readingFault(const QWidget &part);

} // namespace pixelplumb
