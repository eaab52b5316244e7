// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/studentprogram.h"

#include "core/scene/files/filepath.h"
#include "core/scene/files/inputrecord.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>
#include <stdexcept>

namespace pixelplumb {

namespace {

/// Whether a folder holds files of more than one program: the user's own folder, those of the
/// system, their parents, and what everybody may write to.
bool isShared(const QString &folder)
{
    if (QFileInfo(folder).permission(QFile::WriteOther))
        return true;
    const QDir home(QDir::home().canonicalPath()); // it may be a link
    const QStringList shared = {home.path(),
                                home.filePath(u".local"_s),
                                home.filePath(u".config"_s),
                                home.filePath(u".cache"_s),
                                QDir::tempPath(),
                                u"/tmp"_s,
                                u"/var/tmp"_s,
                                u"/run"_s,
                                u"/etc"_s,
                                u"/dev"_s,
                                u"/proc"_s,
                                u"/sys"_s,
                                u"/home"_s,
                                u"/root"_s,
                                u"/mnt"_s,
                                u"/media"_s};
    const QString beginning = folder.endsWith(u'/') ? folder : folder + u'/';
    return std::ranges::any_of(shared, [&](const QString &each) {
        return (QDir::cleanPath(each) + u'/').startsWith(beginning);
    });
}

/// Resolves links and .. in its folder; its own name stays, since programs look at it.
QString wholePath(const QFileInfo &file)
{
    return file.isDir() ? file.canonicalFilePath()
                        : QDir(file.path()).canonicalPath() + u'/' + file.fileName();
}

/// Whether it is the folder of executables in an installation of its own; pyenv and similar tools
/// call it shims. What such programs need is next to it.
bool isOfInstallation(const QString &folder)
{
    const QString name = QFileInfo(folder).fileName();
    const QDir above(QFileInfo(folder).path());
    const bool hasLibraries
        = above.exists(u"lib"_s) || above.exists(u"lib64"_s) || above.exists(u"libexec"_s);
    return (name == u"bin"_s || name == u"shims"_s) && hasLibraries && !isShared(above.path());
}

void show(const QString &path, ShownFiles shown, QStringList &files)
{
    const QFileInfo file(path);
    if (!file.isFile() && !file.isDir())
        return;
    QString folder = file.isDir() ? path : file.path();
    const bool isInstalled = isOfInstallation(folder);
    if (isInstalled)
        folder = QFileInfo(folder).path();
    const bool isAlone = (shown == ShownFiles::Alone && !isInstalled) || isShared(folder);
    if (!isAlone || file.isFile())
        files += isAlone ? path : folder;
}

} // namespace

QString scriptInterpreter()
{
    const QString found = QStandardPaths::findExecutable(u"python3"_s);
    if (found.isEmpty())
        throw std::runtime_error("there is no python3 to run its program");
    return found;
}

Result<StudentProgram> studentProgramOf(const QStringList &words, ShownFiles shown)
{
    const QString name = words.value(0);
    const QFileInfo file(filePath(name));
    StudentProgram student{
        file.isFile() ? wholePath(file) : QStandardPaths::findExecutable(name), words.mid(1), {}};
    if (name.isEmpty() || student.path.isEmpty())
        return InputError{name, u"there is no such program"_s, {}};
    if (!QFileInfo(student.path).isExecutable())
        return InputError{name, u"it is no program: its file is not executable"_s, {}};
    QStringList files = {student.path};
    for (QString &argument : student.arguments) {
        if (const QFileInfo named(filePath(argument)); named.exists()) {
            argument = wholePath(named);
            // What a submission's link leads to may be anybody's: the assistant's own solution.
            if (named.isSymLink()
                && QFileInfo(named.canonicalFilePath()).path() != QFileInfo(argument).path())
                return InputError{named.filePath(), u"is a link that leads out of its folder"_s,
                                  u"the file itself"_s};
            files += argument;
        }
    }
    for (const QString &word : QStringList{student.path} + student.arguments) {
        if (auto refusal = noteInput(word))
            return *refusal;
    }
    for (const QString &each : files) {
        show(each, shown, student.shown);
        show(QFileInfo(each).canonicalFilePath(), shown, student.shown); // if it is a link
    }
    student.shown.removeDuplicates();
    for (const QString &each : student.shown) {
        if (!QFileInfo(each).isDir())
            continue;
        if (auto refusal = noteInputFolder(each))
            return *refusal;
    }
    return student;
}

} // namespace pixelplumb
