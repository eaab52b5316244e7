// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"
#include "core/grade/writtentrace.h"

#include <optional>

namespace pixelplumb {

/// What a student's program printed of a scene: a picture, or lines of a trace; lines of pixels
/// make a picture, too.
struct StudentOutput {
    std::optional<Picture> picture; ///< of the frame's size; what is covered is filled in
    std::optional<ProgramTrace> trace; ///< there where it prints lines, or names triangles

    bool hasLines() const { return trace && trace->kinds.hasAny(); }
};

/// Whether it begins as lines of a trace do.
bool looksLikeTrace(const QByteArray &output);

/// Whether it is a picture that is refused for its size alone.
bool isOfOtherSize(const QByteArray &output, const FrameSpec &frame);

/// Output that nobody trusts, or a file that was handed in, by its name: PNG, PPM, PGM, PBM, BMP, a
/// raster of # and ., or lines. A picture of another size than the frame's is refused by its
/// header, before there is room made for it.
Result<StudentOutput> readStudentOutput(const QByteArray &output, const Scene &scene,
                                        const QString &name = QStringLiteral("the output"));

} // namespace pixelplumb
