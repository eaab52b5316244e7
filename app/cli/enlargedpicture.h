// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QImage>

namespace pixelplumb::cli {

/// Makes every pixel a square of `scale` pixels a side, as --scale asks; an error where the result
/// exceeds the largest frame.
Result<QImage> enlarged(const QImage &picture, std::int64_t scale);

} // namespace pixelplumb::cli
