// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/coveragemask.h"
#include "core/scene/result.h"
#include "core/scene/scene.h"
#include "core/trace/scantrace.h"

#include <QStringView>

namespace pixelplumb {

/// A picture as text, the top line first: `#` covered, `.` not. It travels by clipboard and stands
/// in tests and in mails; every line ends with a line feed.
QString asciiRaster(const CoverageMask &coverage);

/// The pixels that the scene's method writes, whatever their colours.
CoverageMask coverageOf(const Scene &scene);
/// Those that a recorded run has written at a position.
CoverageMask coverageAt(const ScanTrace &trace, const FrameSpec &spec, std::size_t position);

/// Whether a file or an output is meant as a raster: most of its first line, and how this begins,
/// is # and full stops.
bool looksLikeRaster(const QByteArray &content);

/// Reads a raster; its frame begins at (0, 0) in the lower left. The last line feed may be missing
/// and lines may end as on Windows. Ragged lines and other characters are errors.
Result<CoverageMask> parseAsciiRaster(QStringView text);

} // namespace pixelplumb
