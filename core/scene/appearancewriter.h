// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"

#include <QByteArray>
#include <QString>

namespace pixelplumb {

/// The lines of a scene file in the folder that say how its triangles look, without defaults;
/// readAppearance() reads them back.
QByteArray appearanceText(const Appearance &appearance, const QString &folder);

} // namespace pixelplumb
