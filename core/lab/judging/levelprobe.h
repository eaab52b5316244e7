// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/judging/labfigures.h"

#include <vector>

namespace pixelplumb {

/// What became of levels before they were bytes.
struct LevelTally {
    std::vector<float> magnitudes; ///< of the errors that are numbers, levels
    double squares = 0;
    double largest = 0;
    LabShare notANumber;
    LabShare infinite;
    LabShare clamped;

    void add(double error);
    /// None where nothing was added. Sorts the magnitudes.
    std::optional<LevelErrors> errors();
};

/// Traces a triangle that has area by the method's plain kernel and compares its numbers, before
/// they are rounded to bytes, with the exact plane, wherever the truth's picture is painted too.
/// False if the method draws no triangles.
bool probeLevels(const Method &method, const ScanSettings &settings, const Triangle &triangle,
                 FrameView frame, const FrameView &truth, LevelTally &tally);

} // namespace pixelplumb
