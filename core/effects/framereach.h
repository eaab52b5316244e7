// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/attributes.h"
#include "core/geometry/shape.h"
#include "core/scan/edgeteststate.h"
#include "core/scan/scansettings.h"

namespace pixelplumb {

/// What of the frame a triangle may touch, from above and without scanning it.

/// Where triangles are drawn: who owns a sample on an edge, and which samples a pixel has. What is
/// asked of their geometry is asked of these.
struct SampledFrame {
    FrameView frame;
    FillRule rule = FillRule::Closed;
    Antialiasing antialiasing = Antialiasing::None;
    /// Whether triangles are drawn at their own samples and no others. Bounds that are rounded, and
    /// variants, may draw others.
    bool isExact = true;

    /// A triangle without area has a segment, which is drawn at the pixels' own samples.
    Antialiasing antialiasingOf(const Triangle &triangle) const
    {
        return doubledArea(triangle) == 0 ? Antialiasing::None : antialiasing;
    }
};

SampledFrame sampledFrame(const FrameView &frame, const ScanSettings &settings,
                          Antialiasing antialiasing);

/// The pixels of the frame within the triangle's bounding box; where pixels have more than one
/// sample, those whose closed square meets the box. None of a triangle that is not drawn: one
/// without area where the rule does not paint it, and one that lies between the samples.
/// `horizon`: the w of the vertices where areas end at the horizon of its plane, else zeros.
SampleBox reachOf(const Triangle &triangle, const SampledFrame &where,
                  const std::array<Attribute, 3> &horizon = {});
/// How many of them it may cover: no more than its reach, and no more than A + P/2 + 1 of any
/// convex figure of area A and perimeter P (Nosarzewska 1948). Where pixels have more than one
/// sample that figure is the triangle widened by half a pixel's square on every side.
std::int64_t mostPixelsOf(const Triangle &triangle, const SampleBox &reach,
                          Antialiasing antialiasing);
/// How many pixels of the frame a line or curve one pixel wide may touch: of a line no more than
/// the same says of its segment widened by one pixel on every side; of a curve all of them.
std::int64_t mostPixelsOf(const Shape &stroke, const FrameView &frame);
/// Through how many of them an edge may pass.
std::int64_t mostEdgePixelsOf(const Triangle &triangle, const SampledFrame &where);

/// Whether an edge of a triangle that has an area meets a pixel of the frame: with 4 or 16 samples
/// its closed square, where areas are covered so that some of the square lies to each side. Exact.
bool hasEdgePixels(const Triangle &triangle, const SampledFrame &where);
/// Whether it is drawn so, or would be without antialiasing: between the samples of its pixels, on
/// their own. Where no triangle is, antialiasing changes nothing.
bool isDrawnEitherWay(const Triangle &triangle, const SampledFrame &where);
/// Whether a line or curve one pixel wide covers a part of the frame and its border meets a pixel
/// so. Of a curve the joints of its pieces count, too.
bool hasEdgePixels(const Shape &stroke, const SampledFrame &where);

} // namespace pixelplumb
