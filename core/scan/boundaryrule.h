// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/scan/scansettings.h"

namespace pixelplumb {

/// A fill rule and what it depends on: which triangle owns a sample on an edge may depend on the
/// frame. A rule alone assumes a frame whose y points up and whose first pixel is (0, 0).
struct BoundaryRule {
    FillRule rule = FillRule::Closed;
    FrameOrigin origin = FrameOrigin::BottomLeft; ///< TopLeft displaces down on the screen
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

    /// The step of y that goes down on the screen.
    constexpr int down() const { return origin == FrameOrigin::TopLeft ? 1 : -1; }
};

} // namespace pixelplumb
