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

/// The program with the mistakes; empty if one is unknown or its line is not in the program once.
QByteArray programWith(const QString &name, const QStringList &mistakes)
{
    QString program = textInTree(u"tests/data/student/%1.py"_s.arg(name));
    const std::vector<ProgramMistake> known = mistakesOf(name);
    for (const QString &id : mistakes) {
        const auto mistake = std::ranges::find_if(
            known, [&](const ProgramMistake &each) { return each.ids.front() == id; });
        if (mistake == known.end())
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

std::vector<ProgramMistake> mistakesOf(const QString &program)
{
    std::vector<ProgramMistake> mistakes;
    const QString text = textInTree(u"tests/data/student/%1.txt"_s.arg(program));
    for (QString line : text.mid(text.indexOf(u"\n\n"_s)).split(u'\n')) {
        if (line.trimmed().isEmpty())
            continue;
        if (!line.startsWith(u' ')) {
            QStringList ids = line.split(u' ');
            const QString kind = ids.takeFirst();
            mistakes.push_back({kind, ids, {}});
            continue;
        }
        const QStringList sides = line.replace(u"\\n"_s, u"\n"_s).split(u" => "_s);
        mistakes.back().replacements.emplace_back(sides.front().mid(4), sides.back());
    }
    return mistakes;
}

std::vector<Picture> drawnByStudent(const QString &program, const QStringList &arguments,
                                    const QStringList &mistakes, std::span<const Scene> scenes)
{
    const QByteArray text = programWith(program, mistakes);
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"program.py"_s);
    bool isThere = !text.isEmpty() && write(path, text);
    QStringList files;
    for (const Scene &scene : scenes) {
        files += folder.filePath(u"%1.json"_s.arg(files.size()));
        isThere = isThere && write(files.back(), writeScene(scene, folder.path()));
    }
    QProcess process;
    process.start(u"python3"_s, QStringList{path} + arguments + files);
    isThere = process.waitForFinished(60000) && process.exitCode() == 0 && isThere;
    std::vector<Picture> pictures;
    for (std::size_t i = 0; i < scenes.size() && isThere; ++i) {
        QFile file(files[qsizetype(i)] + u".ppm"_s);
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

std::vector<MistakenProgram> mistakenPrograms()
{
    std::vector<MistakenProgram> programs;
    for (const ProgramMistake &mistake : mistakesOf(u"trianglewalk"_s)) {
        const QString kind = mistake.kind;
        const QString id = mistake.ids.front();
        const auto add = [&](WalkLines lines, const QString &found) {
            const bool isColumns = lines == WalkLines::Columns;
            const QString method = isColumns ? u"column-scan"_s : u"row-walk"_s;
            programs.push_back(
                {method, found, lines, {id}, u"%1, %2 %3"_s.arg(method, kind).arg(int(lines))});
        };
        if (kind == u"choice"_s)
            continue;
        add(WalkLines::Columns, id);
        if (kind != u"columns"_s)
            add(WalkLines::Rows, mistake.ids.back());
        if (kind == u"edges"_s || kind == u"ordered"_s)
            add(WalkLines::RowsFromBelow, id + u"-from-below"_s);
        else if (kind == u"ends"_s)
            add(WalkLines::RowsFromBelow, id);
    }
    return programs;
}

std::vector<Picture> studentPictures(std::span<const Scene> scenes, WalkLines lines,
                                     const QStringList &mistakes, WalkNumbers numbers)
{
    const QStringList names = {u"columns"_s, u"rows"_s, u"rows-from-below"_s};
    return drawnByStudent(
        u"trianglewalk"_s,
        {numbers == WalkNumbers::Double ? u"double"_s : u"fraction"_s, names[int(lines)]}, mistakes,
        scenes);
}

} // namespace pixelplumb
