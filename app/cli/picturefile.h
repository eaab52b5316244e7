// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
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

/// The format that a path's end asks for. Standard output, devices and pipes, whose names do not
/// say it, get the first of the formats. `option` is what the error names: "-o".
Result<QString> pictureFormatOf(const QString &option, const QString &path);
/// The same of an option of the command line, "output"; the first format where it is not set.
Result<QString> pictureFormatOf(const CommandLine &line, const QString &option);

std::optional<InputError> writePicture(const QImage &picture, Output &output,
                                       const QString &format);

} // namespace pixelplumb::cli
