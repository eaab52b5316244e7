// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/outputpaths.h"

#include "core/scene/outputfolder.h"

#include <QDir>
#include <QFileInfo>

namespace pixelplumb::cli {

Result<QStringList> outputPaths(const QString &output, const QStringList &inputs,
                                const QString &suffix)
{
    const bool isStandardOutput = output == QStringLiteral("-");
    const bool isFolder = !isStandardOutput && (output.endsWith(u'/') || QFileInfo(output).isDir());
    if (!isFolder && inputs.size() == 1)
        return QStringList(output);
    if (isStandardOutput)
        return InputError{QStringLiteral("%1 scenes").arg(inputs.size()),
                          QStringLiteral("standard output is one"),
                          QStringLiteral("a folder to write to, -o DIR/")};
    if (!isFolder)
        return InputError{
            QStringLiteral("-o ") + output,
            QStringLiteral("is one file for %1 scenes").arg(inputs.size()),
            QStringLiteral("a folder, such as %1/").arg(QFileInfo(output).baseName())};
    QStringList paths;
    for (const QString &input : inputs) {
        if (input == QStringLiteral("-"))
            return InputError{QStringLiteral("-o ") + output,
                              QStringLiteral("standard input has no name in a folder"),
                              QStringLiteral("a scene file, or a file to write to")};
        const QString path
            = QDir(output).filePath(QFileInfo(input).completeBaseName() + u'.') + suffix;
        if (const qsizetype other = paths.indexOf(path); other >= 0)
            return InputError{input,
                              QStringLiteral("its picture would be %2, and so would that of %1")
                                  .arg(inputs[other], path),
                              QStringLiteral("scenes of different names")};
        paths.append(path);
    }
    // Checked last: no folder is made for a refused path.
    if (const auto refusal = refusalOfFolder(output))
        return *refusal;
    return paths;
}

} // namespace pixelplumb::cli
