// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/primitiverejection.h"

#include <QString>

namespace pixelplumb {

/// Why a primitive draws nothing, and where that is seen, in a sentence or two.
QString rejectionText(const Rejection &rejection);

} // namespace pixelplumb
