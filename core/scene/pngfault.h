// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace pixelplumb {

/// Where a PNG file is broken: "a PNG that ends early, in IDAT at byte 41"; empty of a whole one
/// and of what is no PNG. Its decoder writes such things to standard error itself, without the
/// file's name, so that it is not asked. Of chunks that a decoder may leave out nothing is said
/// (ISO/IEC 15948, 5.3 and 5.4).
QString pngFault(const QByteArray &content);

} // namespace pixelplumb
