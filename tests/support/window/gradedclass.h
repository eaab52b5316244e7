// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/gradefile.h"
#include "tests/support/window/openwindow.h"
#include "widgets/studies/grade/gradetable.h"

#include <QImage>
#include <QTemporaryDir>

class QAbstractItemView;

/// Shared helpers of the Grading dock's tests: a class whose submissions are graded, and the window
/// that shows its grades.
namespace pixelplumb {

class Gradebook;

/// ms: with sanitizers on a busy machine, reading the grades takes ten seconds.
inline constexpr int longestWait = 60'000;

/// A triangle small enough to be diagnosed instantly.
Scene smallScene();
QImage drawn(const Scene &scene);

/// Three students: one is right, two truncate.
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

/// Copies the results of grading the class to results(); the grading itself runs once for all
/// tests.
void bringResults(const Classroom &classroom);
/// The assistant's review of a student, as stored in the results folder.
GradeReview keptReview(const Classroom &classroom, std::size_t student);

/// The window with the dock in front.
std::unique_ptr<MainWindow> windowWithDock();
/// The window with the class's grades open and the table in focus.
std::unique_ptr<MainWindow> windowWithGrades(const Classroom &classroom);

Gradebook &book(const MainWindow &window);
QAbstractItemView *table(const MainWindow &window);
QString cell(const MainWindow &window, int row, int column);
/// Presses a key in the grades table.
void press(const MainWindow &window, Qt::Key key);

} // namespace pixelplumb
