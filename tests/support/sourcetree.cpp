// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/sourcetree.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>

namespace pixelplumb {

using namespace Qt::StringLiterals;

QString resource(const QString &path) { return QStringLiteral(PIXELPLUMB_RESOURCES) + path; }

QString testData(const QString &name) { return resource(u"/../tests/data/"_s) + name; }

QString inTree(const QString &path) { return QDir::cleanPath(resource(u"/../"_s + path)); }

QString textInTree(const QString &path)
{
    QFile file(inTree(path));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList filesBelow(const QString &folder, const QStringList &patterns)
{
    const QDir root(inTree({}));
    QDirIterator files(inTree(folder), patterns, QDir::Files, QDirIterator::Subdirectories);
    QStringList paths;
    while (files.hasNext())
        paths.append(root.relativeFilePath(files.next()));
    paths.sort();
    return paths;
}

QStringList documents()
{
    return QStringList{u"README.md"_s} + filesBelow(u"resources"_s, {u"*.md"_s});
}

} // namespace pixelplumb
