// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/scan/scansettings.h"

namespace pixelplumb {

/// A fill rule with what it looks at: who owns a sample on an edge may depend on the frame. A rule
/// by itself is that of a frame whose y points up and whose first pixel is (0, 0).
struct BoundaryRule {
    FillRule rule = FillRule::Closed;
    FrameOrigin origin = FrameOrigin::BottomLeft; ///< top-left displaces down as seen
    LatticePoint offScreenPoint = latticePixel(-1, -1); ///< sample coordinates

    constexpr BoundaryRule(FillRule ofRule)
        : rule(ofRule)
    {
    }
    constexpr BoundaryRule(FillRule ofRule, FrameOrigin ofFrame, const LatticePoint &ofPoint)
        : rule(ofRule)
        , origin(ofFrame)
        , offScreenPoint(ofPoint)
    {
    }
    BoundaryRule(const ScanSettings &settings, const FrameView &frame)
        : BoundaryRule(settings.fillRule, frame.origin, frame.offScreenPoint)
    {
    }

    /// The step of y that goes down as seen.
    constexpr int down() const { return origin == FrameOrigin::TopLeft ? 1 : -1; }
};

} // namespace pixelplumb
