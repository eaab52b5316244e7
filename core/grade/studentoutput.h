// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"
#include "core/grade/writtentrace.h"

#include <optional>
#include <vector>

namespace pixelplumb {

/// What a student's program printed of a scene: a picture, or lines of a trace; lines of pixels
/// make a picture, too.
struct StudentOutput {
    std::optional<Picture> picture; ///< of the frame's size; what is covered is filled in
    std::vector<WrittenLine> lines;
};

/// Output that nobody trusts: PNG, PPM, PGM, PBM, BMP, a raster of # and ., or lines. A picture of
/// another size than the frame's is refused by its header, before there is room made for it.
Result<StudentOutput> readStudentOutput(const QByteArray &output, const Scene &scene);

} // namespace pixelplumb
