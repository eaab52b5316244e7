// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scanobserver.h"

#include <QString>

namespace pixelplumb {

/// Why a primitive draws nothing, in a sentence or two.
QString rejectionText(PrimitiveRejection rejection);

} // namespace pixelplumb
