// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"
#include "core/grade/try/writtentrace.h"

#include <optional>

namespace pixelplumb {

/// What a student's program printed of a scene: a picture, or lines of a trace; lines of pixels
/// also make a picture.
struct StudentOutput {
    std::optional<Picture> picture; ///< of the frame's size, with its covered pixels set
    std::optional<ProgramTrace> trace; ///< present where it prints lines, or names triangles

    bool hasLines() const { return trace && trace->kinds.hasAny(); }
};

/// Whether the output begins like lines of a trace.
bool looksLikeTrace(const QByteArray &output);

/// Whether it is a picture that is refused only for its size.
bool isOfOtherSize(const QByteArray &output, const FrameSpec &frame);

/// Reads untrusted output, or a file handed in, which `name` names: PNG, PPM, PGM, PBM, BMP, a
/// raster of # and ., or lines. A picture whose size is not the frame's is refused by its header,
/// before memory is allocated for it.
Result<StudentOutput> readStudentOutput(const QByteArray &output, const Scene &scene,
                                        const QString &name = u"the output"_s);

} // namespace pixelplumb
