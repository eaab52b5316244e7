// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/gradereport.h"
#include "core/grade/class/submissionfolder.h"
#include "core/grade/hunt/invariants.h"

#include <stop_token>

namespace pixelplumb {

/// What a submission offers for a scene: a picture of the frame's size, or why there is none.
struct Delivery {
    QString file; ///< the picture file in the submission, escaped
    QString fault; ///< empty: there is a picture
    std::optional<PictureLack> lack; ///< the kind of fault
    std::optional<Picture> picture;
    std::optional<GradedRun> run; ///< the run of the program that drew it
    bool hasWaited = false; ///< the clock ended it
    bool exceededTotalCpuTime = false; ///< … for the computing time of all its processes
    QString trace; ///< see GradedScene
    std::optional<QString> note; ///< see GradedScene
    /// Of the program, where they are asked for; none: it broke none and did not draw all
    /// triangles.
    std::optional<std::vector<Invariant>> brokenInvariants;
};

/// For each scene of the assignment: the first of SCENE.png, .ppm, .bmp, .txt; with only one scene,
/// the only picture, whatever its name; or what the submission's program draws, where the
/// assignment allows programs and there is one.
std::vector<Delivery> deliveriesOf(const SubmissionEntry &entry, const Assignment &assignment,
                                   const std::stop_token &stop = {});

} // namespace pixelplumb
