// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/geometry/colour.h"
#include "core/grade/pictures/picture.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/outputfile.h"
#include "core/scene/text/result.h"

#include <QFile>
#include <QImage>
#include <QRgb>
#include <QStringList>

namespace pixelplumb::cli {

/// Reads a file, or stdin for "-", up to `most` bytes. Commands read all their input files with it.
/// It refuses a file to which standard output is appended (`trace s.json >> s.json`), since every
/// command may write there; nothing is written before that.
QByteArray readInput(const QString &path, qint64 most = largestFile);

/// The folder in which an input's relative references are looked up: its own; empty, the current
/// one, for "-".
QString folderOf(const QString &path);

/// Whether a path stands for standard output: "-", or what leads to the file, pipe or terminal that
/// it goes to, such as /dev/stdout and links to it.
bool isStandardOutput(const QString &path);

/// Where a result is written while it is made: standard output, or a file that is no input and
/// appears whole or not at all.
class Output {
public:
    explicit Output(const QString &path);

    void open();
    QIODevice &device();
    /// Makes the file permanent; without this call an existing file stays as it was.
    void finish();

    /// Why it cannot be written: what the device says, else `otherwise`.
    InputError error(const QString &otherwise = {}) const;

private:
    QFile m_standardOutput;
    std::optional<OutputFile> m_file; ///< none: standard output
};

/// Refuses standard output for what a command writes in addition to its printed report.
void refuseStandardOutput(const QString &path, const QString &expected);

/// Where the results of several inputs are written, in their order. A single result goes to
/// `output` itself. Where `output` is a folder ("out/", or an existing one), which is made if need
/// be, each result gets its input's name in it with the ending `suffix` ("png"). Refused are
/// several inputs without a folder, two that would get the same name, and standard input, which has
/// no name.
QStringList outputPaths(const QString &output, const QStringList &inputs, const QString &suffix);

/// Reads the picture of an input: a file, or stdin for "-". In a picture with colours no pixel is
/// covered yet.
Picture readPicture(const QString &path);

/// An input by its name on the command line.
struct SizedInput {
    QString path;
    QSize size; ///< px
};
/// Reports two inputs whose sizes differ though they are to be compared, and ends the command.
void refuseOtherSizes(const SizedInput &one, const SizedInput &other);

/// The lossless formats, from which each pixel can be read back, by their file endings: "png", …
const QStringList &pictureFormats();

/// The format that a path's ending asks for. Standard output, devices and pipes have no ending and
/// get the first format. `option` is what a refusal names: "-o".
QString pictureFormatOf(const QString &option, const QString &path);
/// The format for the path in a command-line option ("output"); the first format where it is not
/// set.
QString pictureFormatOf(const CommandLine &line, const QString &option);

void writePicture(const QImage &picture, Output &output, const QString &format);

/// Makes every pixel a square of `scale` pixels a side, as --scale asks; refuses a result that
/// exceeds the largest frame.
QImage enlarged(const QImage &picture, std::int64_t scale);

/// A grey between three quarters white and white, against which every mark stands out.
inline QRgb faint(const Colour &colour)
{
    const int grey = 191 + qGray(colour.red(), colour.green(), colour.blue()) / 4;
    return qRgb(grey, grey, grey);
}

} // namespace pixelplumb::cli
