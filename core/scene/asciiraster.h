// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/coveragemask.h"
#include "core/scene/text/result.h"

#include <QStringView>

namespace pixelplumb {

/// A picture as text, top line first: `#` covered, `.` not; every line ends with a line feed. Meant
/// for the clipboard, tests and mails.
QString asciiRaster(const CoverageMask &coverage);

/// Whether a file or an output is meant as a raster: its first line begins with # or a full stop,
/// and consists mostly of these.
bool looksLikeRaster(const QByteArray &content);

/// Reads a raster; the frame's lower left is (0, 0). The last line feed may be missing, and Windows
/// line ends are allowed. Ragged lines and other characters are errors.
Result<CoverageMask> parseAsciiRaster(QStringView text);

} // namespace pixelplumb
