// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "app/cli/output.h"
#include "core/grade/picture.h"

#include <QImage>
#include <QStringList>

namespace pixelplumb::cli {

/// Reads the picture of an input: a file, or stdin for "-". In a picture with colours no pixel is
/// covered yet.
Result<Picture> readPicture(const QString &path);

/// An input by its name on the command line.
struct SizedInput {
    QString path;
    QSize size; ///< px
};
/// Reports two inputs whose sizes differ though they are to be compared, and returns the exit code;
/// none where they match.
std::optional<ExitCode> refusalOfSizes(const SizedInput &one, const SizedInput &other);

/// The lossless formats, from which each pixel can be read back, by their file endings: "png", …
const QStringList &pictureFormats();

/// The format that a path's ending asks for. Standard output, devices and pipes have no ending and
/// get the first format. `option` is what the error names: "-o".
Result<QString> pictureFormatOf(const QString &option, const QString &path);
/// The format for the path in a command-line option ("output"); the first format where it is not
/// set.
Result<QString> pictureFormatOf(const CommandLine &line, const QString &option);

std::optional<InputError> writePicture(const QImage &picture, Output &output,
                                       const QString &format);

} // namespace pixelplumb::cli
