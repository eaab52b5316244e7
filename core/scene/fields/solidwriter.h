// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/solid.h"

#include <QByteArray>

namespace pixelplumb {

/// A solid as one line of a scene file in the folder, which readScene() reads back as the same
/// solid.
QByteArray primitiveText(const Solid &solid, const std::vector<Material> &materials,
                         const QString &folder);

} // namespace pixelplumb
