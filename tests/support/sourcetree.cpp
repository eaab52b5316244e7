// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/sourcetree.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>

namespace pixelplumb {

QString resource(const QString &path) { return QStringLiteral(PIXELPLUMB_RESOURCES) + path; }

QString testData(const QString &name) { return resource(QStringLiteral("/../tests/data/")) + name; }

QString inTree(const QString &path)
{
    return QDir::cleanPath(resource(QStringLiteral("/../") + path));
}

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
    return QStringList{QStringLiteral("README.md")}
    + filesBelow(QStringLiteral("resources"), {QStringLiteral("*.md")});
}

} // namespace pixelplumb
