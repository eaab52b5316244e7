// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framemap.h"
#include "core/number/jobprogress.h"
#include "core/scene/scene.h"

#include <QPoint>

#include <optional>
#include <vector>

namespace pixelplumb {

/// What is painted of a frame, whatever its colour, by the scene's method and in truth.
struct MotionFrame {
    std::int64_t drawn = 0; ///< pixels
    std::int64_t truth = 0;
    std::int64_t toggled = 0; ///< that came or went since the frame before; of the first, none
    std::int64_t truthToggled = 0;

    friend bool operator==(const MotionFrame &, const MotionFrame &) = default;
};

/// How often a pixel comes or goes in the whole motion.
struct PixelToggles {
    std::int32_t drawn = 0;
    std::int32_t truth = 0;
};

/// A motion frame by frame: what flickers beyond what moves (Scan Conversion slides, "Triangle
/// Rasterization Issues: Moving Slivers").
struct MotionStudy {
    std::vector<MotionFrame> frames;
    FrameMap<PixelToggles> toggles;

    /// The sum over all frames of the pixels that come or go.
    std::int64_t toggled() const;
    std::int64_t truthToggled() const;
};

/// The pixels of a picture, from its top left corner, that came or went between a frame and the one
/// before, as the study counts them; none of the first frame. At most a million are named.
std::vector<QPoint> toggledPixels(const Scene &scene, int frame);

/// Of a scene that moves and that its method can draw; none where the listener, who hears how many
/// frames are drawn, ended it.
std::optional<MotionStudy> studyMotion(const Scene &scene, const ProgressListener &listener = {});

} // namespace pixelplumb
