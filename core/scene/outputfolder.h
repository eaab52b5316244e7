// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <optional>

namespace pixelplumb {

/// Why files cannot be written to a folder, which is made if need be; none where they can.
std::optional<InputError> refusalOfFolder(const QString &folder);

/// Whether one of two folders lies in the other, or is it, by whatever links; one that is not there
/// yet is taken as it will be made.
bool lieInEachOther(const QString &one, const QString &other);

} // namespace pixelplumb
