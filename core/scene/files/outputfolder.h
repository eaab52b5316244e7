// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/text/result.h"

#include <optional>

namespace pixelplumb {

/// Why files cannot be written to a folder, which is made if need be; none where they can.
std::optional<InputError> refusalOfFolder(const QString &folder);

/// Whether two folders are the same or one lies in the other, through any links; a folder that does
/// not exist yet counts as it will be made.
bool lieInEachOther(const QString &one, const QString &other);

} // namespace pixelplumb
