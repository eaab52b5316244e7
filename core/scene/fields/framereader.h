// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/scene/text/jsonreader.h"

namespace pixelplumb {

/// Reads the frame without its off-screen point, which is read with the whole scene's numbers.
/// Errors stay with the reader: a side or an area that is too large, an unknown origin or centre.
FrameSpec readFrame(JsonReader &json, const JsonNode &node);

} // namespace pixelplumb
