// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/resultsfolder.h"

#include "core/grade/filekind.h"
#include "core/grade/pictures/picture.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/inputrecord.h"

#include <QDir>
#include <QFile>
#include <QUuid>

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>

namespace pixelplumb {

/// A name in an open folder; the folder is not open where it does not exist.
struct ResultsFolder::Place {
    Descriptor folder;
    QByteArray name;
    QString path;

    /// The mode of the entry itself, without following links; none where there is none.
    std::optional<mode_t> mode() const
    {
        struct stat status = {};
        if (fstatat(folder.number(), name.constData(), &status, AT_SYMLINK_NOFOLLOW) != 0)
            return std::nullopt;
        return status.st_mode;
    }
    /// Why the entry with this name is not ours to read or replace.
    std::optional<InputError> objection() const
    {
        const std::optional<mode_t> found = mode();
        if (!found || S_ISREG(*found))
            return std::nullopt;
        return InputError{path, u"is "_s + fileKindOf(*found),
                          u"a file that grading wrote, or none"_s};
    }
    InputError error(const QString &what) const
    {
        return {path, what + qt_error_string(errno), {}};
    }
};

namespace {

constexpr int folderFlags = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
// Reduced by the user's umask.
constexpr mode_t everybody = 0777;
constexpr mode_t readAndWrite = 0666;
const QString cannotBeWritten = u"cannot be written: "_s;

/// Writes all content and flushes it to the disk.
bool fill(int descriptor, const QByteArray &content)
{
    for (qsizetype written = 0; written < content.size();) {
        const ssize_t more = ::write(descriptor, content.constData() + written,
                                     std::size_t(content.size() - written));
        if (more < 0 && errno != EINTR)
            return false;
        written += std::max<ssize_t>(more, 0);
    }
    return fsync(descriptor) == 0;
}

/// Gives a file of O_TMPFILE a name in a folder.
bool giveName(int file, int folder, const QByteArray &name)
{
    const QByteArray path = "/proc/self/fd/" + QByteArray::number(file);
    return linkat(AT_FDCWD, path.constData(), folder, name.constData(), AT_SYMLINK_FOLLOW) == 0;
}

} // namespace

const QStringList &ResultsFolder::folders()
{
    static const QStringList names = {u"grades"_s, u"pictures"_s, u"gradescope"_s};
    return names;
}

QString ResultsFolder::pathOf(const QString &file) const { return QDir(m_path).filePath(file); }

/// An error where the folder inside is missing, or is no folder.
Result<ResultsFolder::Place> ResultsFolder::placeOf(const QString &file) const
{
    const QString folder = file.section(u'/', 0, -2);
    Place place{Descriptor(::open(QFile::encodeName(m_path).constData(), folderFlags)),
                QFile::encodeName(file.section(u'/', -1)), pathOf(file)};
    if (place.folder.isOpen() && !folder.isEmpty())
        place.folder
            = Descriptor(openat(place.folder.number(), QFile::encodeName(folder).constData(),
                                folderFlags | O_NOFOLLOW));
    if (!place.folder.isOpen())
        return InputError{folder.isEmpty() ? m_path : pathOf(folder),
                          u"cannot be read: "_s + qt_error_string(errno),
                          u"a folder, and no link to one"_s};
    return place;
}

Result<Descriptor> ResultsFolder::openLockFile() const
{
    const auto place = placeOf(lockFile);
    if (!place)
        return place.error();
    if (auto objection = place->objection())
        return *objection;
    Descriptor file(openat(place->folder.number(), place->name.constData(),
                           O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, readAndWrite));
    if (!file.isOpen())
        return place->error(cannotBeWritten);
    return file;
}

std::optional<InputError> ResultsFolder::makeFolders() const
{
    for (const QString &name : folders()) {
        const auto place = placeOf(name);
        if (!place)
            return place.error();
        if (mkdirat(place->folder.number(), place->name.constData(), everybody) == 0)
            continue;
        if (errno != EEXIST)
            return place->error(u"cannot be made: "_s);
        if (const std::optional<mode_t> found = place->mode(); found && !S_ISDIR(*found))
            return InputError{place->path,
                              S_ISREG(*found) ? u"is a file"_s : u"is "_s + fileKindOf(*found),
                              u"a folder of the results"_s};
    }
    return std::nullopt;
}

bool ResultsFolder::has(const QString &file) const
{
    const auto place = placeOf(file);
    return place && place->mode();
}

Result<QByteArray> ResultsFolder::read(const QString &file) const
{
    const auto place = placeOf(file);
    if (!place)
        return place.error();
    if (auto objection = place->objection())
        return *objection;
    const Descriptor content(openat(place->folder.number(), place->name.constData(),
                                    O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    QFile device;
    if (!content.isOpen()
        || !device.open(content.number(), QIODevice::ReadOnly | QIODevice::Unbuffered))
        return place->error(u"cannot be read: "_s);
    // Not recorded: a grade that is read may be replaced by a newer one.
    if (auto refusal = refusalToRead(content.number()))
        return *refusal;
    return readDevice(place->path, device, largestPictureFile);
}

std::optional<InputError> ResultsFolder::write(const QString &file, const QByteArray &content) const
{
    const auto place = placeOf(file);
    if (!place)
        return place.error();
    if (auto objection = place->objection())
        return objection;
    if (auto refusal = refusalToWrite(place->path))
        return refusal;
    const int folder = place->folder.number();
    const QByteArray whole
        = place->name + '.' + QUuid::createUuid().toByteArray(QUuid::Id128).left(8);
    // Without a name nothing half-written is left of a process that is ended here; some disks have
    // no such files.
    const Descriptor nameless(openat(folder, ".", O_WRONLY | O_TMPFILE | O_CLOEXEC, readAndWrite));
    bool isWhole = nameless.isOpen() && fill(nameless.number(), content)
        && giveName(nameless.number(), folder, whole);
    if (!isWhole) {
        const Descriptor named(openat(folder, whole.constData(),
                                      O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, readAndWrite));
        isWhole = named.isOpen() && fill(named.number(), content);
    }
    if (isWhole && renameat(folder, whole.constData(), folder, place->name.constData()) == 0)
        return std::nullopt;
    const InputError error = place->error(cannotBeWritten);
    unlinkat(folder, whole.constData(), 0);
    return error;
}

void ResultsFolder::remove(const QString &file) const
{
    if (const auto place = placeOf(file); place && !isInput(place->path))
        unlinkat(place->folder.number(), place->name.constData(), 0);
}

QStringList ResultsFolder::filesIn(const QString &folder) const
{
    const auto place = placeOf(folder + u'/');
    return place ? QDir(pathOf(folder)).entryList(QDir::Files | QDir::NoSymLinks) : QStringList();
}

} // namespace pixelplumb
