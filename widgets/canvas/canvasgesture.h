// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/affineimage.h"
#include "widgets/model/scenedocument.h"

#include <QPointF>

namespace pixelplumb {

class Canvas;
class CanvasView;
class Playhead;
struct CanvasSources;

/// What a press on the canvas begins and a release ends.
class CanvasGesture {
public:
    virtual ~CanvasGesture() = default;
    virtual void moveTo(const QPointF &position) = 0;
    virtual void releaseAt(const QPointF &position) { moveTo(position); }
    /// Leaves everything as it was before the press.
    virtual void cancel() { }
    virtual Qt::CursorShape cursor() const { return Qt::CrossCursor; }
};

/// Places a vertex where the button is released, so that the place can be corrected until then.
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

/// Moves a point with the pointer, keeping the offset it had at the press. A tremble during a click
/// moves nothing.
class MovePointGesture : public CanvasGesture {
public:
    void moveTo(const QPointF &position) final;
    Qt::CursorShape cursor() const final { return Qt::SizeAllCursor; }

protected:
    MovePointGesture(const CanvasView &view, const QPointF &press, const LatticePoint &start);
    /// `place` is not snapped yet.
    virtual void movePoint(const LatticePoint &place) = 0;

    const LatticePoint &start() const { return m_start; }
    bool hasMoved() const { return m_moving; }

private:
    const CanvasView &m_view;
    QPointF m_press;
    LatticePoint m_start;
    bool m_moving = false;
};

/// Moves a vertex. A click on it selects it; on one that is selected, or while vertices are
/// pending, it places the next vertex there, so that edges can be shared.
class MoveVertexGesture final : public MovePointGesture {
public:
    MoveVertexGesture(const CanvasView &view, SceneDocument &document, const VertexRef &ref,
                      const QPointF &press);
    void releaseAt(const QPointF &position) override;
    void cancel() override;

protected:
    void movePoint(const LatticePoint &place) override;

private:
    SceneDocument &m_document;
    VertexRef m_ref;
    int m_drag;
    bool m_wasSelected; ///< before the press
};

/// Moves the off-screen point.
class MoveOffScreenPointGesture final : public MovePointGesture {
public:
    MoveOffScreenPointGesture(const CanvasView &view, SceneDocument &document,
                              const QPointF &press);
    void cancel() override;

protected:
    void movePoint(const LatticePoint &place) override;

private:
    SceneDocument &m_document;
    int m_drag;
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

/// Seeks along the column ruler: to a column of the current triangle, or of the one whose columns
/// are nearest.
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

/// Moves a corner of the affine map's image; the scene stays as it is.
class MoveImageCornerGesture final : public MovePointGesture {
public:
    MoveImageCornerGesture(const CanvasView &view, const CanvasSources &sources, std::size_t corner,
                           const QPointF &press);
    void cancel() override;

protected:
    void movePoint(const LatticePoint &place) override;

private:
    const CanvasSources &m_sources;
    std::size_t m_corner;
    std::optional<AffineImage> m_before; ///< the requested image
    AffineImage m_image; ///< at the press
    int m_drag;
};

} // namespace pixelplumb
