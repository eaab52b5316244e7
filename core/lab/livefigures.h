// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measure/spread.h"
#include "core/number/jobprogress.h"
#include "core/runs/tracedscene.h"

#include <memory>
#include <optional>

namespace pixelplumb {

/// What the scene in hand costs and gets wrong by its own method and arithmetic.
struct LiveFigures {
    std::int64_t pixels = 0; ///< of the true picture
    std::optional<std::int64_t> wrongPixels; ///< of the finished picture; none: not known
    bool isProved = false; ///< that there are none
    /// That the timed triangles write, each as often as it is written; 0 where none is timed.
    std::int64_t timedPixels = 0;
    /// ns of each of these, by the method's plain kernel on one thread: the number of the lab's
    /// family own-scene. None of nothing and of draws that take too long.
    std::optional<Spread> perPixel;
    int rounds = 0;

    /// "When finished: all pixels correct", "When finished: 68 px wrong, truth 1320 px"
    QString text() const;
    /// "plain kernel 1.10 ns a pixel"; empty where nothing was timed.
    QString timeText() const;
    /// The first with why it is so and, where something was timed, with kernel, time, rounds and
    /// spread, some lines.
    QString details() const;

    friend bool operator==(const LiveFigures &, const LiveFigures &) = default;
};

/// None where the listener ended it. Takes about a fifth of a second of small scenes; of large
/// ones the truth is their exact twin (see ScenePicture).
std::optional<LiveFigures> liveFiguresOf(const std::shared_ptr<const Scene> &scene,
                                         const ProgressListener &listener = {});
/// The same of a run that is whole. Where the scene has no exact twin, the run knows the truth, and
/// what is missing where the method refuses a primitive.
std::optional<LiveFigures> liveFiguresOf(const std::shared_ptr<const TracedScene> &traced,
                                         const ProgressListener &listener = {});

} // namespace pixelplumb
