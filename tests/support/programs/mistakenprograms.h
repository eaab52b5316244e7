// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"

#include <QStringList>

#include <span>

/// Students' programs, in tests/data/student: texts in Python, written from the course texts
/// without any code of ours, and run as processes; each right or with mistakes, which replace its
/// lines.
namespace pixelplumb {

/// A mistake of a program: its kind, the ids that follow it, and what is replaced by what.
struct ProgramMistake {
    QString kind;
    QStringList ids;
    std::vector<std::pair<QString, QString>> replacements;
};

/// The mistakes of a program, as the text beside it lists them: "bresenham".
std::vector<ProgramMistake> mistakesOf(const QString &program);

/// What the program draws of the scenes, with these mistakes and arguments; fails the test and
/// returns nothing where it does not run.
std::vector<Picture> drawnByStudent(const QString &program, const QStringList &arguments,
                                    const QStringList &mistakes, std::span<const Scene> scenes);

/// What trianglewalk.py walks along; rows from the greatest y, as row-walk does, or from the least.
enum class WalkLines { Columns, Rows, RowsFromBelow };
/// What it computes in.
enum class WalkNumbers { Fraction, Double };

/// The program trianglewalk.py with a mistake, and the defect that should be found.
struct MistakenProgram {
    QString method; ///< "column-scan" or "row-walk"
    QString id; ///< of the defect
    WalkLines lines = WalkLines::Columns;
    QStringList mistakes;
    QString group; ///< of similar programs
};

/// It with each of its mistakes, by columns and by rows.
std::vector<MistakenProgram> mistakenPrograms();

std::vector<Picture> studentPictures(std::span<const Scene> scenes, WalkLines lines,
                                     const QStringList &mistakes,
                                     WalkNumbers numbers = WalkNumbers::Fraction);

} // namespace pixelplumb
