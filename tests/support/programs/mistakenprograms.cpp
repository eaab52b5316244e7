// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programs/mistakenprograms.h"

#include "core/scene/scenefile.h"
#include "tests/support/sourcetree.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace pixelplumb {

namespace {

/// A mistake as mistakes.txt writes it: its kind with its ids, and what is replaced by what.
struct Mistake {
    QStringList head;
    std::vector<std::pair<QString, QString>> replacements;
};

const std::vector<Mistake> &allMistakes()
{
    static const std::vector<Mistake> mistakes = [] {
        std::vector<Mistake> all;
        const QString text = textInTree(QStringLiteral("tests/data/student/mistakes.txt"));
        for (QString line : text.mid(text.indexOf(QStringLiteral("\n\n"))).split(u'\n')) {
            if (line.trimmed().isEmpty())
                continue;
            if (!line.startsWith(u' ')) {
                all.push_back({line.split(u' '), {}});
                continue;
            }
            const QStringList sides = line.replace(QStringLiteral("\\n"), QStringLiteral("\n"))
                                          .split(QStringLiteral(" => "));
            all.back().replacements.emplace_back(sides.front().mid(4), sides.back());
        }
        return all;
    }();
    return mistakes;
}

/// The program with the mistakes; empty if one is unknown or its line is not in the program once.
QByteArray programWith(const QStringList &mistakes)
{
    QString program = textInTree(QStringLiteral("tests/data/student/trianglewalk.py"));
    for (const QString &id : mistakes) {
        const auto mistake = std::ranges::find_if(
            allMistakes(), [&](const Mistake &each) { return each.head[1] == id; });
        if (mistake == allMistakes().end())
            return {};
        for (const auto &[right, wrong] : mistake->replacements) {
            if (program.count(right) != 1)
                return {};
            program.replace(right, wrong);
        }
    }
    return program.toUtf8();
}

bool write(const QString &path, const QByteArray &content)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(content) == content.size();
}

} // namespace

std::vector<MistakenProgram> mistakenPrograms()
{
    std::vector<MistakenProgram> programs;
    for (const Mistake &mistake : allMistakes()) {
        const QString kind = mistake.head[0];
        const QString id = mistake.head[1];
        const auto add = [&](WalkLines lines, const QString &found) {
            const bool isColumns = lines == WalkLines::Columns;
            const QString method
                = isColumns ? QStringLiteral("column-scan") : QStringLiteral("row-walk");
            programs.push_back({method,
                                found,
                                lines,
                                {id},
                                QStringLiteral("%1, %2 %3").arg(method, kind).arg(int(lines))});
        };
        if (kind == QStringLiteral("choice"))
            continue;
        add(WalkLines::Columns, id);
        if (kind != QStringLiteral("columns"))
            add(WalkLines::Rows, mistake.head.back());
        const QString fromBelow = id + QStringLiteral("-from-below");
        if (kind == QStringLiteral("edges") || kind == QStringLiteral("ordered"))
            add(WalkLines::RowsFromBelow, fromBelow);
        else if (kind == QStringLiteral("ends"))
            add(WalkLines::RowsFromBelow, id);
    }
    return programs;
}

std::vector<Picture> studentPictures(std::span<const Scene> scenes, WalkLines lines,
                                     const QStringList &mistakes, WalkNumbers numbers)
{
    const QByteArray program = programWith(mistakes);
    const QTemporaryDir folder;
    QStringList arguments
        = {folder.filePath(QStringLiteral("program.py")),
           numbers == WalkNumbers::Double ? QStringLiteral("double") : QStringLiteral("fraction"),
           QStringList{QStringLiteral("columns"), QStringLiteral("rows"),
                       QStringLiteral("rows-from-below")}[int(lines)]};
    bool isThere = !program.isEmpty() && write(arguments.front(), program);
    for (const Scene &scene : scenes) {
        arguments += folder.filePath(QStringLiteral("%1.json").arg(arguments.size()));
        isThere = isThere && write(arguments.back(), writeScene(scene, folder.path()));
    }
    QProcess process;
    process.start(QStringLiteral("python3"), arguments);
    isThere = isThere && process.waitForFinished(60000) && process.exitCode() == 0;
    std::vector<Picture> pictures;
    for (std::size_t i = 0; i < scenes.size() && isThere; ++i) {
        QFile file(arguments[qsizetype(i) + 3] + QStringLiteral(".ppm"));
        const auto picture = file.open(QIODevice::ReadOnly)
            ? parsePicture(file.readAll(), file.fileName())
            : Result<Picture>(InputError{});
        isThere = bool(picture);
        if (isThere) {
            pictures.push_back(*picture);
            coverAllBut(scenes[i].frame.background, pictures.back());
        }
    }
    if (!isThere) {
        QTest::qFail(qPrintable(mistakes.join(u' ') + u' ' + process.readAllStandardError()),
                     __FILE__, __LINE__);
        return {};
    }
    return pictures;
}

} // namespace pixelplumb
