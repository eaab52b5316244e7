// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb {

/// Lets screen readers ask a Canvas for the pixel or vertex in hand, as its value. Harmless when
/// called again.
void installCanvasAccessible();

} // namespace pixelplumb
