// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study.h"

namespace pixelplumb {

/// How much of a family is drawn in each timed draw, about.
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

/// What everyone draws of a family. The family outlives it.
struct TimedFamily {
    const LabFamily *family = nullptr;
    std::vector<TimedPicture> pictures; ///< each with triangles
    StudyFamily described;

    bool isTimed() const { return described.timedPixels > 0; }
};

/// The first triangles, until they are enough, and at least a few of them. Large pictures of a
/// family that has many are left out.
TimedFamily timedPartOf(const LabFamily &family, const TimedLimits &limits);

} // namespace pixelplumb
