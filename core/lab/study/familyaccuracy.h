// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/study.h"

namespace pixelplumb {

/// How much of a family is examined more closely than by its pictures.
struct AccuracyOptions {
    /// For one contender: the samples of the triangles' boxes, or of the whole frame for each
    /// triangle if its method visits all of it. The same on every machine.
    std::int64_t mostSamples = 200'000'000;
    double hangSeconds = 20; ///< of processor time: a contender that takes longer hangs
    std::int64_t probedPixels = 60'000; ///< whose levels are compared before they are bytes
    std::int64_t movedPixels = 300'000; ///< of boxes drawn in other orders and places
    std::int64_t countedPixels = 20'000; ///< whose operations are counted
};

/// The result of a contender on a family's pictures.
struct FamilyVerdict {
    LabOutcome outcome = LabOutcome::Pending;
    QString remark;
    ScanSettings settings;
    std::optional<AccuracyFigures> accuracy;
    std::optional<LabMiss> firstMiss;
    std::optional<OperationCounts> operations;
    double nanoseconds = 0; ///< of processor time that the drawing took
};

/// The settings under which a contender takes part; none if it supports no rule that fits, or is a
/// peer and the family needs more than whole pixels inside the frame.
std::optional<ScanSettings> settingsFor(const LabContender &contender, const LabFamily &family);

/// Judges the contenders one after another or, if the true pictures take much memory, batch by
/// batch of triangles. Reports each verdict as soon as it is known. False if the listener ended it.
bool judgeFamily(const LabFamily &family, const std::vector<LabContender> &contenders,
                 const AccuracyOptions &options,
                 const std::function<void(std::size_t contender, const FamilyVerdict &)> &tell,
                 const ProgressListener &listener);

} // namespace pixelplumb
