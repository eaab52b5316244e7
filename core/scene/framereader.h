// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/scene/jsonreader.h"

namespace pixelplumb {

/// The frame but for its off-screen point, which the whole scene's numbers are read with. Errors
/// stay with the reader: a side or an area that is too large, an unknown origin or centre.
FrameSpec readFrame(JsonReader &json, const JsonNode &node);

} // namespace pixelplumb
