// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/delivery.h"
#include "core/grade/try/studentoutput.h"

namespace pixelplumb {

/// A submission's program and a scene that it is to draw.
struct AssignedRun {
    const SubmissionEntry &entry;
    const SubmittedFile &file;
    const Assignment &assignment;
    const AssignedScene &scene;
};

bool isScript(const SubmittedFile &file);

/// Runs the program; after scenes in which it waited or kept starting processes it has less time.
Delivery drawnBy(const AssignedRun &asked, const std::vector<Delivery> &before,
                 const std::stop_token &stop);

void refuse(Delivery &delivery, PictureLack lack, const QString &fault);
/// Takes a picture of the scene's size, or one made of a trace's lines.
void take(const QByteArray &content, const Result<StudentOutput> &output, const FrameSpec &frame,
          Delivery &delivery);

} // namespace pixelplumb
