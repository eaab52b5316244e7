// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/scenedocument.h"

#include <QtGui>

namespace pixelplumb {

class Canvas;
class CanvasMouse;
class CanvasView;
class Playhead;
struct CanvasSources;

/// Keys on the canvas: all that the mouse does, and a look at the truth while Shift is held.
class CanvasKeys {
public:
    CanvasKeys(Canvas &canvas, CanvasView &view, CanvasMouse &mouse, const CanvasSources &sources);

    /// False for keys that mean nothing here.
    bool press(QKeyEvent *event);
    bool release(QKeyEvent *event);
    void endPeek() { setPeek(Peek::Off); } ///< Shift means something else
    void endDrag() { m_drag.reset(); }

    bool isPeeking() const { return m_peek == Peek::On; }
    bool isMovingVertex() const { return m_drag.has_value(); }
    /// The vertex that Enter would place, in the scene's coordinates.
    std::optional<LatticePoint> candidate() const;

private:
    enum class Peek { Off, Waiting, On };

    bool handleArrow(QKeyEvent *event);
    bool handleEditingKey(QKeyEvent *event);
    bool handleViewKey(QKeyEvent *event);
    void placeAtPickedPixel();
    void cycleSelection(int step);
    void cancelCurrent();
    void moveSelectedBy(const QPoint &steps);
    void moveChosenCornerBy(const LatticePoint &way);
    void setPeek(Peek peek);

    Canvas &m_canvas;
    CanvasView &m_view;
    CanvasMouse &m_mouse;
    const CanvasSources &m_sources;
    SceneDocument &m_document;
    Playhead &m_playhead;
    std::optional<int> m_drag; ///< number of the current run of Ctrl+arrows
    Peek m_peek = Peek::Off;
    QTimer m_peekTimer;
};

} // namespace pixelplumb
