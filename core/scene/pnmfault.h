// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace pixelplumb {

/// Where the levels of a PGM or PPM file in text (P2, P3) go beyond its greatest one, or stop being
/// numbers: "line 4: no level from 0 to 255". Empty of one that is right and of
/// what is none; its decoder would take what is left of them.
QString pnmFault(const QByteArray &content);

} // namespace pixelplumb
