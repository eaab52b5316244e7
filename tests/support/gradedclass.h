// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/gradefile.h"
#include "tests/support/openwindow.h"
#include "widgets/studies/gradetablemodel.h"

#include <QImage>
#include <QTemporaryDir>

class QAbstractItemView;

/// What the tests of the dock Grading share: a class whose submissions are graded, and the window
/// with its grades.
namespace pixelplumb {

class Gradebook;

/// ms: with sanitizers, on a machine that does other work as well, grades are read in ten seconds.
inline constexpr int longestWait = 60'000;

/// A triangle small enough to be diagnosed at once.
Scene smallScene();
QImage drawn(const Scene &scene);

/// Three students: right, and two who truncate.
class Classroom {
public:
    Classroom();

    QString assignmentFile() const { return m_folder.filePath("assignment.json"); }
    QString submissions() const { return m_folder.filePath("submissions"); }
    QString results() const { return m_folder.filePath("results"); }

private:
    void submit(const QString &name, const QImage &picture) const;

    QTemporaryDir m_folder;
};

/// What grading the class writes; graded once for all tests.
void bringResults(const Classroom &classroom);
/// What the assistant said of a student, as the results' folder has it.
GradeReview keptReview(const Classroom &classroom, std::size_t student);

/// The window with the dock in front.
std::unique_ptr<MainWindow> windowWithDock();
/// With the class's grades, its table in focus.
std::unique_ptr<MainWindow> windowWithGrades(const Classroom &classroom);

Gradebook &book(const MainWindow &window);
QAbstractItemView *table(const MainWindow &window);
QString cell(const MainWindow &window, int row, GradeTableModel::Column column);
/// In the table.
void press(const MainWindow &window, Qt::Key key);

} // namespace pixelplumb
