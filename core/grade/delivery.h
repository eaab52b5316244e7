// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/gradereport.h"
#include "core/grade/submissionfolder.h"

#include <stop_token>

namespace pixelplumb {

/// What a submission has of a scene: a picture of the frame's size, or why there is none.
struct Delivery {
    QString file; ///< the picture's in the submission, escaped
    QString fault; ///< empty: there is a picture
    std::optional<PictureLack> lack; ///< the same as a kind
    std::optional<Picture> picture;
    std::optional<GradedRun> run; ///< of the program that drew it
    bool hasWaited = false; ///< it was ended by the clock
    bool hasMultiplied = false; ///< … for what all its processes together had computed
    QString trace; ///< GradedScene's
    std::optional<QString> note; ///< GradedScene's
};

/// By scene of the assignment: of pictures SCENE.png, .ppm, .bmp, .txt the first; of one scene its
/// one picture, whatever its name; or what the submission's program draws, where the assignment
/// knows programs and there is one.
std::vector<Delivery> deliveriesOf(const SubmissionEntry &entry, const Assignment &assignment,
                                   const std::stop_token &stop = {});

} // namespace pixelplumb
