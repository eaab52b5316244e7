// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/text/result.h"
#include "core/space/solid.h"

#include <optional>

namespace pixelplumb {

/// What is wrong with a solid's corners or its reach, without a place.
std::optional<InputError> faultOf(const Solid &solid);

} // namespace pixelplumb
