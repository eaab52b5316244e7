// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace pixelplumb {

/// Where a PBM, PGM or PPM file is broken or ends early, in its header or behind it, or where its
/// levels in text (P1 … P3) go beyond its greatest one or stop being numbers: "line 4: no level
/// from 0 to 255". Empty of one that is right and of what is none. Its decoder would take what is
/// left of levels in text.
QString pnmFault(const QByteArray &content);

} // namespace pixelplumb
