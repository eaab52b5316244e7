// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/scenedocument.h"

#include <QPointF>

namespace pixelplumb {

class Canvas;

/// What a press on the canvas began and a release ends.
class CanvasGesture {
public:
    virtual ~CanvasGesture() = default;
    virtual void moveTo(const QPointF &position) = 0;
    virtual void releaseAt(const QPointF &position) { moveTo(position); }
    /// Leaves everything as it was before the press.
    virtual void cancel() { }
    virtual Qt::CursorShape cursor() const { return Qt::CrossCursor; }
};

/// Places a vertex where the button is released, so that a hand that slips still chooses.
class PlaceVertexGesture final : public CanvasGesture {
public:
    PlaceVertexGesture(Canvas &canvas, SceneDocument &document)
        : m_canvas(canvas)
        , m_document(document)
    {
    }
    void moveTo(const QPointF &) override { }
    void releaseAt(const QPointF &position) override;

private:
    Canvas &m_canvas;
    SceneDocument &m_document;
};

/// Moves a vertex with the pointer, as far from it as it was at the press. A press that does not
/// move selects it and nothing else.
class MoveVertexGesture final : public CanvasGesture {
public:
    MoveVertexGesture(Canvas &canvas, SceneDocument &document, const VertexRef &ref,
                      const QPointF &press);
    void moveTo(const QPointF &position) override;
    void cancel() override;
    Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }

private:
    Canvas &m_canvas;
    SceneDocument &m_document;
    VertexRef m_ref;
    QPointF m_press;
    LatticePoint m_start;
    int m_drag;
    bool m_moving = false;
};

class MoveViewGesture final : public CanvasGesture {
public:
    MoveViewGesture(Canvas &canvas, const QPointF &press);
    void moveTo(const QPointF &position) override;
    Qt::CursorShape cursor() const override { return Qt::ClosedHandCursor; }

private:
    Canvas &m_canvas;
    QPoint m_device;
};

/// Moves time along the column ruler.
class SeekColumnGesture final : public CanvasGesture {
public:
    explicit SeekColumnGesture(Canvas &canvas)
        : m_canvas(canvas)
    {
    }
    void moveTo(const QPointF &position) override;
    Qt::CursorShape cursor() const override { return Qt::PointingHandCursor; }

private:
    Canvas &m_canvas;
};

} // namespace pixelplumb
