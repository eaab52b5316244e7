// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/attributes.h"
#include "core/geometry/shape.h"
#include "core/scan/scansettings.h"
#include "core/scan/tests/edgeteststate.h"

namespace pixelplumb {

/// Upper bounds for the part of the frame that a triangle may touch, without scanning it.

/// The frame that triangles are drawn in, with the owner of a sample on an edge and the samples of
/// a pixel: what all questions about their geometry depend on.
struct SampledFrame {
    FrameView frame;
    FillRule rule = FillRule::Closed;
    Antialiasing antialiasing = Antialiasing::None;
    /// Whether triangles are drawn exactly at their own samples. Rounded bounds and variants may
    /// draw others.
    bool isExact = true;

    /// None for a triangle without area: its segment is drawn at the pixels' own samples.
    Antialiasing antialiasingOf(const Triangle &triangle) const
    {
        return doubledArea(triangle) == 0 ? Antialiasing::None : antialiasing;
    }
};

SampledFrame sampledFrame(const FrameView &frame, const ScanSettings &settings,
                          Antialiasing antialiasing);

/// The pixels of the frame within the triangle's bounding box; where pixels have more than one
/// sample, those whose closed square meets the box. Empty for a triangle that is not drawn: one
/// without area that the rule does not paint, or one between the samples. `horizon`: the w of the
/// vertices where areas end at the horizon of the triangle's plane, else zeros.
SampleBox reachOf(const Triangle &triangle, const SampledFrame &where,
                  const std::array<Attribute, 3> &horizon = {});
/// An upper bound for the pixels of its reach that the triangle covers: all of the reach, or A +
/// P/2 + 1, which bounds any convex figure of area A and perimeter P (Nosarzewska 1948). Where
/// pixels have more than one sample, the figure is the triangle widened by half a pixel's square on
/// every side.
std::int64_t mostPixelsOf(const Triangle &triangle, const SampleBox &reach,
                          Antialiasing antialiasing);
/// An upper bound for the pixels of the frame that a line or curve one pixel wide touches: for a
/// line by the same formula, of its segment widened by one pixel on every side; for a curve all
/// pixels.
std::int64_t mostPixelsOf(const Shape &stroke, const FrameView &frame);
/// An upper bound for the pixels of the frame that its edges pass through.
std::int64_t mostEdgePixelsOf(const Triangle &triangle, const SampledFrame &where);

/// Whether an edge of a triangle with area meets a pixel of the frame: with 4 or 16 samples its
/// closed square; with area antialiasing so that some of the square lies to each side. Exact.
bool hasEdgePixels(const Triangle &triangle, const SampledFrame &where);
/// Whether the triangle is drawn with these samples, or would be with the pixels' own alone. If no
/// triangle is, antialiasing changes nothing.
bool isDrawnEitherWay(const Triangle &triangle, const SampledFrame &where);
/// Whether a line or curve one pixel wide covers a part of the frame and its border meets a pixel
/// in that way. In a curve the joints between its pieces count as border, too.
bool hasEdgePixels(const Shape &stroke, const SampledFrame &where);

} // namespace pixelplumb
