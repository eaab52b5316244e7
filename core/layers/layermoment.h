// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/affineimage.h"
#include "core/runs/ahead.h"
#include "core/runs/tracedscene.h"
#include "core/scan/edgeteststate.h"

#include <QPoint>
#include <QPointF>
#include <QRectF>

#include <array>

namespace pixelplumb {

/// What of a run is looked at.
struct LayerView {
    const TracedScene *traced = nullptr;
    std::size_t position = 0; ///< of the trace: so many steps are done
    SampleBox seen; ///< the pixels in view
    double cell = 1; ///< a pixel's side as it is painted, logical px
    std::optional<std::size_t> primitive; ///< none: the one in hand
    std::optional<QPoint> picked; ///< the pixel of which layers tell; none: that of the step
    std::optional<AffineImage> image; ///< none: one that is worth a look
    Ahead ahead = Ahead::Shown;
};

/// The same for one layer: its primitive is one of which the layer has something to say.
struct LayerMoment {
    const LayerView &view;
    std::size_t primitive = 0;

    const ScanTrace &trace() const { return *view.traced->trace; }
    const Primitives &primitives() const { return view.traced->primitives; }
    const Triangle &triangle() const { return primitives().triangles[primitive]; }
    const Shape &shape() const { return primitives().shape(primitive); }
    const FrameSpec &frame() const { return view.traced->scene.frame; }
    /// The pixels in view that the frame has.
    SampleBox seen() const { return intersection(view.seen, samplesOf(windowOf(frame()))); }
    /// What those pixels cover, px.
    QRectF seenArea() const;
    /// P₀, P₁, P₂ of the triangle, as the run names them.
    std::array<LatticePoint, 3> corners() const;
    /// a, b, c of p = αa + βb + γc: in the order of the scene, whatever the method sorts.
    std::array<LatticePoint, 3> weightedCorners() const;
    /// "b = P2": one of these, and which it is to the run.
    QString weightedCornerName(std::size_t vertex, const QString &suffix = {}) const;
    /// The span of the primitive that is in hand, or its last one; none where none is entered yet.
    std::optional<std::size_t> spanInHand() const;
    bool hasDone(std::size_t step) const { return step < view.position; }
    /// Whether some of the primitive's steps are ahead, and hidden.
    bool hidesSteps() const;
    /// A coordinate as the scene gives it, px: "27 1/2".
    QString inScene(Lattice sample) const;
};

/// Where a lattice point is, px.
QPointF placeOf(const LatticePoint &point);

/// The numbers of a record by their ids (NumberDescription::id).
class NamedNumbers {
public:
    /// Both must outlive it.
    NamedNumbers(const std::vector<NumberDescription> &descriptions,
                 const std::vector<Quantity> &cells)
        : m_descriptions(descriptions)
        , m_cells(cells)
    {
    }

    /// None where the record has no such number.
    Quantity operator[](const QString &id) const;

private:
    const std::vector<NumberDescription> &m_descriptions;
    const std::vector<Quantity> &m_cells;
};

} // namespace pixelplumb
