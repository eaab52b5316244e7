// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/study.h"

namespace pixelplumb {

/// About how much of a family each timed draw draws.
struct TimedLimits {
    std::int64_t pixels = 400'000;
    std::int64_t boxPixels = 2'500'000; ///< in the boxes of the triangles
};

/// The first triangles of a picture.
struct TimedPicture {
    const LabPicture *picture = nullptr;
    std::size_t triangles = 0;

    std::span<const Triangle> first() const
    {
        return std::span(picture->triangles).first(triangles);
    }
};

/// The part of a family that every contender draws. The family must outlive it.
struct TimedFamily {
    const LabFamily *family = nullptr;
    std::vector<TimedPicture> pictures; ///< each with triangles
    StudyFamily described;

    bool isTimed() const { return described.timedPixels > 0; }
};

/// The first triangles until the limits are reached, but at least a few. Large pictures of a family
/// that has many are left out.
TimedFamily timedPartOf(const LabFamily &family, const TimedLimits &limits);

} // namespace pixelplumb
