// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/console.h"
#include "app/cli/output.h"
#include "core/grade/picture.h"

#include <QImage>
#include <QStringList>

namespace pixelplumb::cli {

/// The picture of an input: a file, or stdin for "-". Nothing is covered yet where it has colours.
Result<Picture> readPicture(const QString &path);

/// An input by its name on the command line.
struct SizedInput {
    QString path;
    QSize size; ///< px
};
/// Says so and gives the exit code where two inputs that are to be compared differ in size.
std::optional<ExitCode> refusalOfSizes(const SizedInput &one, const SizedInput &other);

/// Formats without loss, by their names' ends, so that each pixel can be read back: "png", …
const QStringList &pictureFormats();

/// The format that a path's end asks for. Standard output and names without an end, such as
/// /dev/stdout, get the first of the formats. `option` is what the error names: "-o".
Result<QString> pictureFormatOf(const QString &path, const QString &option);

std::optional<InputError> writePicture(const QImage &picture, Output &output,
                                       const QString &format);

} // namespace pixelplumb::cli
