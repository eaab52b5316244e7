// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measure/spread.h"
#include "core/number/jobprogress.h"
#include "core/scene/scene.h"

#include <memory>
#include <optional>

namespace pixelplumb {

/// The time that a scene's own method needs for its triangles, by the plain kernel on one thread:
/// the number of the lab's family own-scene.
struct SceneCost {
    std::int64_t pixels = 0; ///< that the timed triangles write, counted each time
    Spread perPixel; ///< ns
    int rounds = 0;

    /// "plain kernel 1.10 ns a pixel"
    QString text() const;
    /// Which kernel is meant, and rounds, median, spread and pixels, in two lines.
    QString details() const;

    friend bool operator==(const SceneCost &, const SceneCost &) = default;
};

/// Takes about a fifth of a second. None if the method draws no triangles of the scene, if a draw
/// takes too long, or if the listener ended it.
std::optional<SceneCost> costOf(const std::shared_ptr<const Scene> &scene,
                                const ProgressListener &listener = {});

} // namespace pixelplumb
