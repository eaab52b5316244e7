// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output.h"

#include <QImage>
#include <QStringList>

namespace pixelplumb::cli {

/// Formats without loss, by their names' ends, so that each pixel can be read back: "png", …
const QStringList &pictureFormats();

/// The format that a path's end asks for. Standard output and names without an end, such as
/// /dev/stdout, get the first of the formats. `option` is what the error names: "-o".
Result<QString> pictureFormatOf(const QString &path, const QString &option);

std::optional<InputError> writePicture(const QImage &picture, Output &output,
                                       const QString &format);

} // namespace pixelplumb::cli
