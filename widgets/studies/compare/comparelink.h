// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/viewmapping.h"

#include <QObject>

namespace pixelplumb {

/// The shared view of several pictures of one frame: one zoom and one centre sample, so that the
/// same pointer position shows the same pixel in all.
class CompareLink : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void setFrame(const FrameSpec &frame);
    const FrameSpec &frame() const { return m_frame; }

    /// The mapping for a view of that size.
    ViewMapping mappingFor(const QSizeF &size, double devicePixelRatio,
                           const QPointF &fraction) const;

public slots:
    /// Shows the whole frame in each view.
    void fit();
    /// Zooms in one step; the point under `anchor` of a view stays there.
    void zoomIn(const pixelplumb::ViewMapping &from, const QRectF &view, const QPointF &anchor);
    /// Zooms out one step, but no farther than the whole frame.
    void zoomOut(const pixelplumb::ViewMapping &from, const QRectF &view, const QPointF &anchor);
    void moveBy(const pixelplumb::ViewMapping &from, const QRectF &view,
                const QPoint &devicePixels);
    /// Brings a pixel towards the middle, at a zoom at which single pixels are visible; a frame
    /// that fits into the view is shown whole.
    void lookAt(const QPoint &pixel);

signals:
    void changed();

private:
    enum class Place {
        Fitted,
        LookedAt, ///< a pixel in the middle, or the whole frame
        Free, ///< moved by a person
    };

    void take(const ViewMapping &mapping, const QRectF &view);

    FrameSpec m_frame;
    Place m_place = Place::Fitted;
    ViewZoom m_zoom;
    QPointF m_centre; ///< in px of sample coordinates; meaningful when not fitted
};

} // namespace pixelplumb
