// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/viewmapping.h"

#include <QObject>

namespace pixelplumb {

/// Where several views of one frame look: they share the zoom and the sample in their middles, so
/// that what is under one pointer position is the same pixel in all.
class CompareLink : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void setFrame(const FrameSpec &frame);
    const FrameSpec &frame() const { return m_frame; }
    bool isFitted() const { return m_place == Place::Fitted; }

    /// For a view of that size.
    ViewMapping mappingFor(const QSizeF &size, double devicePixelRatio,
                           const QPointF &fraction) const;

public slots:
    /// The whole frame in each view.
    void fit();
    /// One step larger or smaller; the point under `anchor` of a view stays there.
    void zoomIn(const pixelplumb::ViewMapping &from, const QRectF &view, const QPointF &anchor);
    /// A frame that is seen whole gets no smaller.
    void zoomOut(const pixelplumb::ViewMapping &from, const QRectF &view, const QPointF &anchor);
    void moveBy(const pixelplumb::ViewMapping &from, const QRectF &view,
                const QPoint &devicePixels);
    /// Brings a pixel towards the middle, at a zoom at which it can be seen by itself; a frame that
    /// the view has room for is seen whole.
    void lookAt(const QPoint &pixel);

signals:
    void changed();

private:
    enum class Place {
        Fitted,
        LookedAt, ///< a pixel in the middle, or the whole frame
        Free, ///< as a person has moved it
    };

    void take(const ViewMapping &mapping, const QRectF &view);

    FrameSpec m_frame;
    Place m_place = Place::Fitted;
    ViewZoom m_zoom;
    QPointF m_centre; ///< in px of sample coordinates; meaningful when not fitted
};

} // namespace pixelplumb
