// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/colour.h"

#include <QRgb>

namespace pixelplumb::cli {

/// A grey between three quarters white and white, against which every mark stands out.
inline QRgb faint(const Colour &colour)
{
    const int grey = 191 + qGray(colour.red(), colour.green(), colour.blue()) / 4;
    return qRgb(grey, grey, grey);
}

} // namespace pixelplumb::cli
