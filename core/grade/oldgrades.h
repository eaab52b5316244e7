// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/assignment.h"

namespace pixelplumb {

/// The text of a submission's grade, of whatever age: where it was written when the first pixel
/// that differs was told in the picture's lines, from the top, with that pixel in frame
/// coordinates. Every other text is left as it is.
QByteArray inFrameCoordinates(const QByteArray &grade, const Assignment &assignment);

} // namespace pixelplumb
