// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study.h"

#include <memory>

namespace pixelplumb {

/// What the lab shows: a study, finished or not.
using SharedResults = std::shared_ptr<const Study>;

} // namespace pixelplumb
