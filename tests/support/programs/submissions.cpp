// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programs/submissions.h"

#include "tests/support/sourcetree.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>

#include <algorithm>

namespace pixelplumb {

Assignment exampleAssignment()
{
    const auto assignment = readAssignmentFile(resource(u"/assignments/column-scan.json"_s));
    return assignment ? *assignment : Assignment();
}

std::vector<Defect> defectsOf(const Assignment &assignment)
{
    std::vector<Defect> defects = defectsFor(assignment.scenes.front().scene);
    std::erase_if(defects, [](const Defect &defect) { return defect.standsAlone; });
    return defects;
}

bool writeTo(const QString &path, const QByteArray &content)
{
    QFile file(path);
    return QDir().mkpath(QFileInfo(path).path()) && file.open(QIODevice::WriteOnly)
        && file.write(content) == content.size();
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QMap<QString, QByteArray> filesIn(const QString &folder)
{
    QMap<QString, QByteArray> files;
    QDirIterator each(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (each.hasNext()) {
        const QString path = each.next();
        files.insert(QDir(folder).relativeFilePath(path), contentOf(path));
    }
    return files;
}

bool deliver(const QString &folder, const Assignment &assignment,
             const std::vector<Defect> &defects)
{
    return QDir().mkpath(folder)
        && std::ranges::all_of(assignment.scenes, [&](const AssignedScene &each) {
               return imageOf(pictureWith(each.scene, defects))
                   .save(u"%1/%2.png"_s.arg(folder, each.name));
           });
}

} // namespace pixelplumb
