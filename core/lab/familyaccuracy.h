// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study.h"

namespace pixelplumb {

/// How much of a family is looked at more closely than by its pictures.
struct AccuracyOptions {
    /// Of one contender's work: the samples of the triangles' boxes, or of the whole frame for each
    /// triangle where its method looks at all of it. The same on every machine.
    std::int64_t mostSamples = 200'000'000;
    double hangSeconds = 20; ///< of processor time: what takes longer hangs
    std::int64_t probedPixels = 60'000; ///< of which levels are compared before they are bytes
    std::int64_t movedPixels = 300'000; ///< of boxes drawn in other orders and elsewhere
    std::int64_t countedPixels = 20'000; ///< of which operations are counted
};

/// What a contender's pictures of a family came to.
struct FamilyVerdict {
    LabOutcome outcome = LabOutcome::Pending;
    QString remark;
    ScanSettings settings;
    std::optional<AccuracyFigures> accuracy;
    std::optional<LabMiss> firstMiss;
    std::optional<OperationCounts> operations;
    double nanoseconds = 0; ///< of processor time that the drawing took
};

/// The settings under which a contender takes part; none where it keeps no rule that fits, or is a
/// peer, and those take whole pixels inside the frame alone.
std::optional<ScanSettings> settingsFor(const LabContender &contender, const LabFamily &family);

/// Judges the contenders one after the other, or, where the true pictures take much memory, some
/// triangles after the others. Tells of each verdict as soon as it stands. False where the listener
/// ended it.
bool judgeFamily(const LabFamily &family, const std::vector<LabContender> &contenders,
                 const AccuracyOptions &options,
                 const std::function<void(std::size_t contender, const FamilyVerdict &)> &tell,
                 const ProgressListener &listener);

} // namespace pixelplumb
