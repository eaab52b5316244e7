// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace pixelplumb {

/// How many bytes of pixels a BMP file lacks: "a BMP that ends early, 12 of 9216 bytes of pixels
/// are missing"; empty for a whole BMP and for other files. Its decoder accepts such a file and
/// leaves in the last lines whatever the memory held.
QString bmpFault(const QByteArray &content);

} // namespace pixelplumb
