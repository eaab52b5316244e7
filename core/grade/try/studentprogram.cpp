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
                                home.filePath(QStringLiteral(".local")),
                                home.filePath(QStringLiteral(".config")),
                                home.filePath(QStringLiteral(".cache")),
                                QDir::tempPath(),
                                QStringLiteral("/tmp"),
                                QStringLiteral("/var/tmp"),
                                QStringLiteral("/run"),
                                QStringLiteral("/etc"),
                                QStringLiteral("/dev"),
                                QStringLiteral("/proc"),
                                QStringLiteral("/sys"),
                                QStringLiteral("/home"),
                                QStringLiteral("/root"),
                                QStringLiteral("/mnt"),
                                QStringLiteral("/media")};
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
    const bool hasLibraries = above.exists(QStringLiteral("lib"))
        || above.exists(QStringLiteral("lib64")) || above.exists(QStringLiteral("libexec"));
    return (name == QStringLiteral("bin") || name == QStringLiteral("shims")) && hasLibraries
        && !isShared(above.path());
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
    const QString found = QStandardPaths::findExecutable(QStringLiteral("python3"));
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
        return InputError{name, QStringLiteral("there is no such program"), {}};
    if (!QFileInfo(student.path).isExecutable())
        return InputError{name, QStringLiteral("it is no program: its file is not executable"), {}};
    QStringList files = {student.path};
    for (QString &argument : student.arguments) {
        if (const QFileInfo named(filePath(argument)); named.exists()) {
            argument = wholePath(named);
            // What a submission's link leads to may be anybody's: the assistant's own solution.
            if (named.isSymLink()
                && QFileInfo(named.canonicalFilePath()).path() != QFileInfo(argument).path())
                return InputError{named.filePath(),
                                  QStringLiteral("is a link that leads out of its folder"),
                                  QStringLiteral("the file itself")};
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
