// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QImage>

namespace pixelplumb::cli {

/// Every pixel a square of so many, as --scale asks; an error where that is larger than a frame may
/// be.
Result<QImage> enlarged(const QImage &picture, std::int64_t scale);

} // namespace pixelplumb::cli
