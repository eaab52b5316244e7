// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace pixelplumb {

/// Whether a word of a face is "1", "1/2", "1//3" or "1/2/3", each with an optional minus sign and
/// at most nine digits. tinyobjloader itself takes any leading digits for the number, and lets it
/// overflow.
bool isCorner(QByteArrayView word);

/// A Wavefront OBJ file's text without its byte order mark, comments and line continuations. It
/// keeps the number of lines, so that faults are reported at their lines.
QByteArray withoutRemarks(const QByteArray &text);

} // namespace pixelplumb
