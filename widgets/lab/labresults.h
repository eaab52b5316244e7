// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/sizestudy.h"
#include "core/lab/study.h"

#include <memory>

namespace pixelplumb {

/// What the lab shows: a study, finished or not, and how times and errors grow.
struct LabResults {
    Study study;
    std::vector<SizeCurve> sizes;
    std::vector<DriftCurve> drift;
};

using SharedResults = std::shared_ptr<const LabResults>;

} // namespace pixelplumb
