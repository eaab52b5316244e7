// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"

#include <QStringList>

#include <span>

/// A student's program, tests/data/student/trianglewalk.py, right or with mistakes, run as a
/// process: it was written from the text of the assignment, without any code of ours.
namespace pixelplumb {

/// What the program walks along; rows from the greatest y, as row-walk does, or from the least.
enum class WalkLines { Columns, Rows, RowsFromBelow };
/// What it computes in.
enum class WalkNumbers { Fraction, Double };

/// The program with a mistake, and the defect that should be found.
struct MistakenProgram {
    QString method; ///< "column-scan" or "row-walk"
    QString id; ///< of the defect
    WalkLines lines = WalkLines::Columns;
    QStringList mistakes; ///< as mistakes.txt names them
    QString group; ///< of similar programs
};

/// Every mistake of mistakes.txt, by columns and by rows.
std::vector<MistakenProgram> mistakenPrograms();

/// What the program with these mistakes draws of scenes of triangles; fails the test and returns
/// nothing where it does not run.
std::vector<Picture> studentPictures(std::span<const Scene> scenes, WalkLines lines,
                                     const QStringList &mistakes,
                                     WalkNumbers numbers = WalkNumbers::Fraction);

} // namespace pixelplumb
