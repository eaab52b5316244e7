// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace pixelplumb {

/// Whether a word of a face is "1", "1/2", "1//3" or "1/2/3", with minus signs or without, of at
/// most nine digits each: tinyobjloader takes the digits that it finds for the number, and lets it
/// overflow.
bool isCorner(QByteArrayView word);

/// A Wavefront OBJ file's text without a byte order mark, remarks and the ends of lines that go on;
/// with as many lines, so that faults are found at their numbers.
QByteArray withoutRemarks(const QByteArray &text);

} // namespace pixelplumb
