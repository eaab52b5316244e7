// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/scenedocument.h"

#include <QPointF>

namespace pixelplumb {

class Canvas;
class CanvasView;
class Playhead;

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
    PlaceVertexGesture(const CanvasView &view, SceneDocument &document)
        : m_view(view)
        , m_document(document)
    {
    }
    void moveTo(const QPointF &) override { }
    void releaseAt(const QPointF &position) override;

private:
    const CanvasView &m_view;
    SceneDocument &m_document;
};

/// Moves a vertex with the pointer, as far from it as it was at the press. A press that does not
/// move selects it and nothing else.
class MoveVertexGesture final : public CanvasGesture {
public:
    MoveVertexGesture(const CanvasView &view, SceneDocument &document, const VertexRef &ref,
                      const QPointF &press);
    void moveTo(const QPointF &position) override;
    void cancel() override;
    Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }

private:
    const CanvasView &m_view;
    SceneDocument &m_document;
    VertexRef m_ref;
    QPointF m_press;
    LatticePoint m_start;
    int m_drag;
    bool m_moving = false;
};

/// Moves the off-screen point with the pointer.
class MoveOffScreenPointGesture final : public CanvasGesture {
public:
    MoveOffScreenPointGesture(const CanvasView &view, SceneDocument &document,
                              const QPointF &press);
    void moveTo(const QPointF &position) override;
    void cancel() override;
    Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }

private:
    const CanvasView &m_view;
    SceneDocument &m_document;
    QPointF m_press;
    LatticePoint m_start;
    int m_drag;
    bool m_moving = false;
};

/// Picks the pixel under the pointer, as long as the button is held.
class PickPixelGesture final : public CanvasGesture {
public:
    PickPixelGesture(const CanvasView &view, Playhead &playhead)
        : m_view(view)
        , m_playhead(playhead)
    {
    }
    void moveTo(const QPointF &position) override;
    Qt::CursorShape cursor() const override { return Qt::ArrowCursor; }

private:
    const CanvasView &m_view;
    Playhead &m_playhead;
};

class MoveViewGesture final : public CanvasGesture {
public:
    MoveViewGesture(CanvasView &view, const QPointF &press);
    void moveTo(const QPointF &position) override;
    Qt::CursorShape cursor() const override { return Qt::ClosedHandCursor; }

private:
    CanvasView &m_view;
    QPoint m_device;
};

/// Moves time along the column ruler: to a column of the triangle in hand, or of the one whose
/// columns are nearest.
class SeekColumnGesture final : public CanvasGesture {
public:
    SeekColumnGesture(const CanvasView &view, Playhead &playhead)
        : m_view(view)
        , m_playhead(playhead)
    {
    }
    void moveTo(const QPointF &position) override;
    Qt::CursorShape cursor() const override { return Qt::PointingHandCursor; }

private:
    const CanvasView &m_view;
    Playhead &m_playhead;
};

} // namespace pixelplumb
