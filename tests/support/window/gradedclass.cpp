// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/window/gradedclass.h"

#include "core/runs/tracedscene.h"
#include "widgets/studies/grade/gradebook.h"
#include "widgets/studies/grade/gradingpanel.h"

#include <QTest>
#include <QtWidgets>

namespace pixelplumb {

Scene smallScene()
{
    Scene scene;
    scene.frame.width = 12;
    scene.frame.height = 9;
    scene.triangles.push_back({{{{latticePixel(1, 1), {{255, 0, 0}}},
                                 {latticePixel(10, 2), {{0, 255, 0}}},
                                 {latticePixel(4, 8), {{0, 0, 255}}}}}});
    return scene;
}

QImage drawn(const Scene &scene)
{
    const FrameBuffer frame(scene.frame);
    drawScene(scene, frame);
    return frame.image().copy();
}

Classroom::Classroom()
{
    Assignment assignment;
    assignment.name = u"Triangles"_s;
    assignment.scenes.push_back({u"small"_s, smallScene()});
    QFile file(assignmentFile());
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(writeAssignment(assignment));
    Scene wrong = smallScene();
    wrong.settings.rounding = ByteRounding::Truncate;
    submit("ada", drawn(smallScene()));
    submit("bob", drawn(wrong));
    submit("cyd", drawn(wrong));
}

void Classroom::submit(const QString &name, const QImage &picture) const
{
    const QString folder = submissions() + u'/' + name;
    QVERIFY(QDir().mkpath(folder) && picture.save(folder + "/small.png"));
}

void bringResults(const Classroom &classroom)
{
    static const QTemporaryDir graded;
    const QString results = graded.filePath("results");
    if (!QFile::exists(results)) {
        const auto assignment = readAssignmentFile(classroom.assignmentFile());
        QVERIFY(assignment.isOk());
        QVERIFY(
            gradeFolder({classroom.submissions(), results, QCoreApplication::applicationVersion()},
                        *assignment)
                .isOk());
    }
    QDirIterator files(results, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString copy = classroom.results() + files.next().mid(results.size());
        QVERIFY(QDir().mkpath(QFileInfo(copy).path()) && QFile::copy(files.filePath(), copy));
    }
}

Gradebook &book(const MainWindow &window)
{
    return *named<GradingPanel>(window, "grading")->book();
}

QAbstractItemView *table(const MainWindow &window)
{
    return named<QAbstractItemView>(window, "gradingTable");
}

QString cell(const MainWindow &window, int row, int column)
{
    return table(window)->model()->index(row, column).data().toString();
}

std::unique_ptr<MainWindow> windowWithDock()
{
    auto window = openedWindow();
    window->resize(1366, 768);
    action(*window, "gradingDockToggle")->trigger();
    return window;
}

std::unique_ptr<MainWindow> windowWithGrades(const Classroom &classroom)
{
    bringResults(classroom);
    auto window = windowWithDock();
    book(*window).open(classroom.results());
    if (!QTest::qWaitFor([&] { return !book(*window).results().isEmpty(); }, longestWait))
        QTest::qFail("no grades are opened", __FILE__, __LINE__);
    table(*window)->setFocus();
    return window;
}

GradeReview keptReview(const Classroom &classroom, std::size_t student)
{
    const auto kept = readGrades(classroom.results());
    return kept ? kept->submissions[student].review : GradeReview();
}

void press(const MainWindow &window, Qt::Key key) { QTest::keyClick(table(window), key); }

} // namespace pixelplumb
