// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/canvas/canvas.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

#include <QEvent>

/// Shared helpers of the canvas tests.
namespace pixelplumb {

/// The design's first scene without its fraction.
Scene firstScene();

/// A canvas in its own window; every scene change is traced again, as in the real window.
struct CanvasBench {
    SceneDocument document;
    Playhead playhead;
    DisplayOptions options;
    Canvas canvas{&document, &playhead, &options};

    explicit CanvasBench(const Scene &scene = {});

    /// Widget positions: the middle of a pixel's cell, and the place of column x on the ruler.
    QPoint at(int x, int y) const { return canvas.positionOf(QPoint(x, y)).toPoint(); }
    QPoint onColumnRuler(int x) const
    {
        return {at(x, 0).x(), canvas.columnRuler().center().toPoint().y()};
    }
    LatticePoint vertex(int triangle, int index) const
    {
        return document.vertexAt({triangle, index})->position;
    }

    void click(int x, int y, Qt::MouseButton button = Qt::LeftButton);
    void send(QEvent::Type type, const QPoint &position, Qt::MouseButton button,
              Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = {});
    void drag(const QPoint &from, const QPoint &to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = {});
};

/// The colour shown in the middle of a pixel's cell.
QRgb shownAt(const QImage &grabbed, const Canvas &canvas, const QPoint &pixel);

} // namespace pixelplumb
