// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace pixelplumb {

/// Where a PBM, PGM or PPM file is broken or ends early, in its header or after it, or where its
/// levels in text (P1 … P3) exceed the greatest one or stop being numbers: "line 4: no level from 0
/// to 255". Empty for a sound file and for other formats. Its decoder would accept the levels in
/// text up to there.
QString pnmFault(const QByteArray &content);

/// A PBM in text (P1) with a space after each bit, as its decoder wants them; the format allows
/// bits without. Any other content as it is.
QByteArray withSpacedBits(const QByteArray &content);

} // namespace pixelplumb
