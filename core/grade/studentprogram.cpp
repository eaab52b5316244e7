// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/studentprogram.h"

#include "core/scene/inputrecord.h"

#include <QFileInfo>
#include <QStandardPaths>

namespace pixelplumb {

Result<StudentProgram> studentProgramOf(const QStringList &words)
{
    const QString name = words.value(0);
    const QFileInfo file(name);
    StudentProgram student{file.isFile() ? file.absoluteFilePath()
                                         : QStandardPaths::findExecutable(name),
                           words.mid(1)};
    if (name.isEmpty() || student.path.isEmpty())
        return InputError{name, QStringLiteral("there is no such program"), {}};
    if (!QFileInfo(student.path).isExecutable())
        return InputError{name, QStringLiteral("it is no program: its file is not executable"), {}};
    for (QString &argument : student.arguments) {
        if (QFileInfo::exists(argument))
            argument = QFileInfo(argument).absoluteFilePath();
    }
    for (const QString &word : QStringList{student.path} + student.arguments) {
        if (auto refusal = noteInput(word))
            return *refusal;
    }
    return student;
}

} // namespace pixelplumb
