// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/files.h"

#include "core/frame/framespec.h"
#include "core/scene/files/filepath.h"
#include "core/scene/files/inputrecord.h"
#include "core/scene/files/outputfolder.h"

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImageWriter>

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>

namespace pixelplumb::cli {

namespace {

/// Where several may write, since nothing is kept.
bool isNullDevice(const struct stat &file)
{
    struct stat null = {};
    return S_ISCHR(file.st_mode) && stat("/dev/null", &null) == 0 && file.st_rdev == null.st_rdev;
}

} // namespace

QByteArray readInput(const QString &path, qint64 most)
{
    if (path.isEmpty())
        refuse({u"“”"_s, u"names no file"_s, u"the name of one, or - for standard input"_s});
    if (path != u"-"_s)
        return required(readFile(path, most));
    const QString place = u"standard input"_s;
    refuseIf(noteStandardInput());
    QFile input;
    if (!input.open(stdin, QIODevice::ReadOnly))
        refuse({place, input.errorString(), {}});
    return required(readDevice(place, input, most));
}

QString folderOf(const QString &path)
{
    return path == u"-"_s ? QString() : QFileInfo(filePath(path)).absolutePath();
}

bool isStandardOutput(const QString &path)
{
    if (path == u"-"_s)
        return true;
    struct stat named = {};
    struct stat printed = {};
    return stat(QFile::encodeName(path).constData(), &named) == 0
        && fstat(STDOUT_FILENO, &printed) == 0 && named.st_dev == printed.st_dev
        && named.st_ino == printed.st_ino && !isNullDevice(named);
}

Output::Output(const QString &path)
{
    if (!isStandardOutput(path))
        m_file.emplace(path);
}

void Output::open()
{
    refuseIf(m_file ? m_file->open() : refusalToPrint());
    if (!m_file && !m_standardOutput.open(fileno(stdout), QIODevice::WriteOnly))
        refuse(error());
}

QIODevice &Output::device()
{
    if (m_file)
        return m_file->device();
    return m_standardOutput;
}

void Output::finish()
{
    if (m_file)
        return refuseIf(m_file->finish());
    if (m_standardOutput.error() != QFileDevice::NoError || !m_standardOutput.flush())
        refuse(error());
}

InputError Output::error(const QString &otherwise) const
{
    if (m_file)
        return m_file->error(otherwise);
    return writingError(u"standard output"_s, m_standardOutput, otherwise);
}

void refuseStandardOutput(const QString &path, const QString &expected)
{
    if (isStandardOutput(path))
        refuse({u"-o "_s + path, u"standard output has the report"_s, expected});
}

QStringList outputPaths(const QString &output, const QStringList &inputs, const QString &suffix)
{
    const bool isPrinted = isStandardOutput(output);
    const bool isFolder
        = !isPrinted && (output.endsWith(u'/') || QFileInfo(filePath(output)).isDir());
    if (!isFolder && inputs.size() == 1)
        return QStringList(output);
    if (isPrinted)
        refuse({u"%1 scenes"_s.arg(inputs.size()), u"standard output is one"_s,
                u"a folder to write to, -o DIR/"_s});
    if (!isFolder)
        refuse({u"-o "_s + output, u"is one file for %1 scenes"_s.arg(inputs.size()),
                u"a folder, such as %1/"_s.arg(QFileInfo(output).baseName())});
    QStringList paths;
    for (const QString &input : inputs) {
        if (input == u"-"_s)
            refuse({u"-o "_s + output, u"standard input has no name in a folder"_s,
                    u"a scene file, or a file to write to"_s});
        const QString path
            = QDir(filePath(output)).filePath(QFileInfo(input).completeBaseName() + u'.') + suffix;
        if (const qsizetype other = paths.indexOf(path); other >= 0)
            refuse({input,
                    u"its output would be %2, and so would that of %1"_s.arg(inputs[other], path),
                    u"scenes of different names"_s});
        paths.append(path);
    }
    // Checked last: no folder is made for a refused path.
    refuseIf(refusalOfFolder(output));
    return paths;
}

Picture readPicture(const QString &path)
{
    return required(parsePicture(readInput(path, largestPictureFile), path));
}

void refuseOtherSizes(const SizedInput &one, const SizedInput &other)
{
    if (one.size == other.size)
        return;
    sayLine(u"%1 has %2 × %3 pixels%7, %4 has %5 × %6%8"_s.arg(
        one.path, QString::number(one.size.width()), QString::number(one.size.height()), other.path,
        QString::number(other.size.width()), QString::number(other.size.height()),
        sizeHint(one.size, other.size),
        one.size == other.size.transposed() ? QString() : sizeHint(other.size, one.size)));
    throw Ended{ExitCode::SizesDiffer};
}

const QStringList &pictureFormats()
{
    static const QStringList formats = {u"png"_s, u"bmp"_s, u"ppm"_s};
    return formats;
}

QString pictureFormatOf(const QString &option, const QString &path)
{
    const QFileInfo file(filePath(path));
    const bool isStream = path == u"-"_s || path.startsWith(u"/dev/"_s)
        || (file.exists() && !file.isFile() && !file.isDir());
    QString format = file.suffix().toLower();
    if (pictureFormats().contains(format))
        return format;
    if (isStream)
        return pictureFormats().front();
    refuse({option + u' ' + path,
            format.isEmpty() ? u"the name does not say which kind of picture"_s
                             : u"unknown kind of picture"_s,
            u"a name that ends in ."_s + pictureFormats().join(u", ."_s)});
}

QString pictureFormatOf(const CommandLine &line, const QString &option)
{
    return line.isSet(option) ? pictureFormatOf(u"-o"_s, line.value(option))
                              : pictureFormats().front();
}

void writePicture(const QImage &picture, Output &output, const QString &format)
{
    output.open();
    // libpng would print its own error if it wrote to the file directly.
    QBuffer encoded;
    QImageWriter writer(&encoded, format.toLatin1());
    if (!writer.write(picture))
        refuse(output.error(writer.errorString()));
    if (output.device().write(encoded.data()) != encoded.size())
        refuse(output.error());
    output.finish();
}

QImage enlarged(const QImage &picture, std::int64_t scale)
{
    const std::int64_t pixels = picture.width() * scale * picture.height() * scale;
    if (pixels > largestFrameArea)
        refuse({u"--scale"_s,
                u"%1 × %2 pixels, %3 times as many each way"_s.arg(picture.width())
                    .arg(picture.height())
                    .arg(scale),
                u"at most %1 pixels"_s.arg(largestFrameArea)});
    return scale == 1 ? picture : picture.scaled(picture.size() * int(scale));
}

} // namespace pixelplumb::cli
