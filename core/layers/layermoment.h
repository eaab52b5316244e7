// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/affineimage.h"
#include "core/runs/ahead.h"
#include "core/runs/tracedscene.h"
#include "core/scan/tests/edgeteststate.h"
#include "core/trace/namednumbers.h"

#include <QPoint>
#include <QPointF>
#include <QRectF>

#include <array>

namespace pixelplumb {

/// Which part of a run is viewed.
struct LayerView {
    const TracedScene *traced = nullptr;
    std::size_t position = 0; ///< in the trace: this many steps are done
    SampleBox seen; ///< the pixels in view
    double cell = 1; ///< a pixel's side as it is painted, logical px
    std::optional<std::size_t> primitive; ///< none: the current one
    std::optional<QPoint> picked; ///< the pixel that layers describe; none: the step's
    std::optional<AffineImage> image; ///< none: the default one
    Ahead ahead = Ahead::Shown;
};

/// A view for one layer: its primitive is one that the layer has something to say about.
struct LayerMoment {
    const LayerView &view;
    std::size_t primitive = 0;

    const ScanTrace &trace() const { return *view.traced->trace; }
    const Primitives &primitives() const { return view.traced->primitives; }
    const Triangle &triangle() const { return primitives().triangles[primitive]; }
    const Shape &shape() const { return primitives().shape(primitive); }
    const FrameSpec &frame() const { return view.traced->scene.frame; }
    /// The pixels in view that lie in the frame.
    SampleBox seen() const { return intersection(view.seen, samplesOf(windowOf(frame()))); }
    /// The area of those pixels, px.
    QRectF seenArea() const;
    /// P₀, P₁, P₂ of the triangle, as the run names them.
    std::array<LatticePoint, 3> corners() const;
    /// a, b, c of p = αa + βb + γc: in the scene's order, whatever the method sorts.
    std::array<LatticePoint, 3> weightedCorners() const;
    /// "b = P2": one of these, and its name in the run.
    QString weightedCornerName(std::size_t vertex, const QString &suffix = {}) const;
    /// The primitive's current span, or its last one; none if none is entered yet.
    std::optional<std::size_t> currentSpan() const;
    bool hasDone(std::size_t step) const { return step < view.position; }
    /// Whether some of the primitive's steps lie ahead and are hidden.
    bool hidesSteps() const;
    /// A coordinate as the scene gives it, px: "27 1/2".
    QString inScene(Lattice sample) const;
};

/// Where a lattice point is, px.
QPointF placeOf(const LatticePoint &point);

} // namespace pixelplumb
