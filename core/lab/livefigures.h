// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measure/spread.h"
#include "core/number/jobprogress.h"
#include "core/runs/tracedscene.h"

#include <memory>
#include <optional>

namespace pixelplumb {

/// What the current scene costs and gets wrong with its own method and arithmetic.
struct LiveFigures {
    std::int64_t pixels = 0; ///< of the true picture
    std::optional<std::int64_t> wrongPixels; ///< of the finished picture; none: not known
    bool isProved = false; ///< that no pixel is wrong
    /// Pixels that the timed triangles write, counted each time; 0 if none is timed.
    std::int64_t timedPixels = 0;
    /// ns per such pixel, by the method's plain kernel on one thread: the number of the lab's
    /// family own-scene. None if nothing is drawn or draws take too long.
    std::optional<Spread> perPixel;
    int rounds = 0;

    /// "When finished: all pixels correct", "When finished: 68 px wrong, truth 1320 px"
    QString text() const;
    /// "plain kernel 1.10 ns a pixel"; empty where nothing was timed.
    QString timeText() const;
    /// text() with its reason and, if something was timed, with kernel, time, rounds and spread, in
    /// several lines.
    QString details() const;

    friend bool operator==(const LiveFigures &, const LiveFigures &) = default;
};

/// None if the listener ended it. Takes about a fifth of a second for small scenes; for large ones
/// the truth is their exact twin (see ScenePicture).
std::optional<LiveFigures> liveFiguresOf(const std::shared_ptr<const Scene> &scene,
                                         const ProgressListener &listener = {});
/// The live figures of a complete run. If the scene has no exact twin, the run provides the truth,
/// and what is missing if the method refuses a primitive.
std::optional<LiveFigures> liveFiguresOf(const std::shared_ptr<const TracedScene> &traced,
                                         const ProgressListener &listener = {});

} // namespace pixelplumb
