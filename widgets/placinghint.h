// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

#include <QString>

namespace pixelplumb {

enum class FrameContent { Empty, Drawn };

/// What the next click on the canvas does: said while a primitive is under way, and in an empty
/// frame.
QString placingHint(PrimitiveKind kind, std::size_t pendingVertices, FrameContent content);

} // namespace pixelplumb
