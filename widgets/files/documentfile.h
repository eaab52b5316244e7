// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"
#include "core/scene/scene.h"

#include <optional>

namespace pixelplumb {

/// Writes the current scene to its own file, from which it was read.
std::optional<InputError> writeDocument(const QString &path, const Scene &scene);

} // namespace pixelplumb
