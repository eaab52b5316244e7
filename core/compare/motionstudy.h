// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framemap.h"
#include "core/number/jobprogress.h"
#include "core/scene/scene.h"

#include <QPoint>

#include <optional>
#include <vector>

namespace pixelplumb {

/// How much of a frame is painted, in any colour, by the scene's method and in the truth.
struct MotionFrame {
    std::int64_t drawn = 0; ///< pixels
    std::int64_t truth = 0;
    std::int64_t toggled = 0; ///< pixels that came or went since the frame before; 0 for the first
    std::int64_t truthToggled = 0;

    friend bool operator==(const MotionFrame &, const MotionFrame &) = default;
};

/// How often a pixel comes or goes during the whole motion.
struct PixelToggles {
    std::int32_t drawn = 0;
    std::int32_t truth = 0;
};

/// A motion frame by frame: flicker beyond what the motion itself causes (Scan Conversion slides,
/// "Triangle Rasterization Issues: Moving Slivers").
struct MotionStudy {
    std::vector<MotionFrame> frames;
    FrameMap<PixelToggles> toggles;

    /// The sum over all frames of the pixels that come or go.
    std::int64_t toggled() const;
    std::int64_t truthToggled() const;
};

/// The pixels, from the picture's top left corner, that came or went since the frame before, as the
/// study counts them; none for the first frame. At most a million are returned.
std::vector<QPoint> toggledPixels(const Scene &scene, int frame);

/// Studies a scene that moves and that its method can draw. The listener gets the number of frames
/// drawn; none if it ended the job.
std::optional<MotionStudy> studyMotion(const Scene &scene, const ProgressListener &listener = {});

} // namespace pixelplumb
