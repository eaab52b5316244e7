// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/differencemap.h"

#include <QString>

namespace pixelplumb {

/// "none", "missing", "extra", "colour".
QString nameOf(Difference difference);

} // namespace pixelplumb
