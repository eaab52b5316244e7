// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace pixelplumb {

/// How many bytes a BMP file's pixels lack: "a BMP that ends early, 12 of 9216 bytes of pixels are
/// missing"; empty of a whole one and of what is no BMP. Its decoder takes such a file and leaves
/// the last lines to what stood in memory.
QString bmpFault(const QByteArray &content);

} // namespace pixelplumb
