// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/gradefile.h"
#include "core/grade/class/gradefolder.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/gradedclass.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/labels.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/studentpicture.h"
#include "widgets/studies/grade/gradebook.h"
#include "widgets/studies/grade/gradedialog.h"
#include "widgets/studies/grade/gradetable.h"
#include "widgets/studies/grade/gradingpanel.h"

#include <QtTest>
#include <QtWidgets>

#include <array>

namespace tst_gradingdock {

using namespace pixelplumb;

/// The assistant's bench, used as an assistant does.
class TestGradingDock : public QObject {
    Q_OBJECT

private slots:
    void aFolderIsGradedBesideTheWindow()
    {
        const Classroom classroom;
        const auto window = windowWithDock();
        QTimer::singleShot(0, window.get(), [&classroom, &window] {
            auto *dialog = named<GradeDialog>(*window, "gradeDialog");
            QVERIFY(dialog);
            named<QLineEdit>(*dialog, "gradeSubmissions")->setText(classroom.submissions());
            named<QLineEdit>(*dialog, "gradeAssignment")->setText(classroom.assignmentFile());
            named<QLineEdit>(*dialog, "gradeResults")->setText(classroom.results());
            auto *leeway = named<QComboBox>(*dialog, "gradeLeeway");
            leeway->setCurrentIndex(leeway->findData(int(Leeway::Edges)));
            QVERIFY(leeway->toolTip().contains("exactly on an edge"));
            QTest::keyClick(dialog, Qt::Key_Return);
        });

        QTest::mouseClick(named<QToolButton>(*window, "gradingGrade"), Qt::LeftButton);

        QVERIFY(book(*window).job().isRunning());
        QTRY_COMPARE_WITH_TIMEOUT(table(*window)->model()->rowCount(), 3, longestWait);
        QCOMPARE(cell(*window, 0, GradeColumn::Name), "ada");
        QCOMPARE(cell(*window, 0, GradeColumn::Verdict), "right");
        QCOMPARE(cell(*window, 1, GradeColumn::Name), "bob");
        QCOMPARE(cell(*window, 1, GradeColumn::Verdict), "wrong");
        QVERIFY2(cell(*window, 1, GradeColumn::Cause).contains("rounding-truncate"),
                 qPrintable(cell(*window, 1, GradeColumn::Cause)));
        QCOMPARE(cell(*window, 1, GradeColumn::Points), "3 / 5");
        QVERIFY(QFile::exists(classroom.results() + "/results.json"));
        QCOMPARE(book(*window).report().assignment.margin.leeway, Leeway::Edges);
    }

    void withoutAnAssignmentTheWindowsSceneIsTheOnlyTask()
    {
        const Classroom classroom;
        const auto window = windowWithDock();
        const Scene scene = window->parts().document->scene();
        QTimer::singleShot(0, window.get(), [&classroom, &window] {
            auto *dialog = named<GradeDialog>(*window, "gradeDialog");
            named<QLineEdit>(*dialog, "gradeSubmissions")->setText(classroom.submissions());
            named<QLineEdit>(*dialog, "gradeResults")->setText(classroom.results());
            QTest::keyClick(dialog, Qt::Key_Return); // refused: nothing says what is asked
            named<QCheckBox>(*dialog, "gradeByScene")->setChecked(true);
            QTest::keyClick(dialog, Qt::Key_Return);
        });

        QTest::mouseClick(named<QToolButton>(*window, "gradingGrade"), Qt::LeftButton);

        QTRY_COMPARE_WITH_TIMEOUT(table(*window)->model()->rowCount(), 3, longestWait);
        const Assignment &assignment = book(*window).report().assignment;
        QCOMPARE(assignment.scenes.size(), std::size_t(1));
        QCOMPARE(assignment.scenes[0].name, u"task"_s);
        QVERIFY(assignment.scenes[0].scene == scene);
        QCOMPARE(assignment.points(), 5.0);
        QVERIFY(QFile::exists(classroom.results() + "/assignment.json"));
    }

    void theDialogSaysWhatItAsksForAndWhereMoreIsTold()
    {
        const auto window = windowWithDock();
        QString page;
        QTimer::singleShot(0, window.get(), [&window, &page] {
            auto *dialog = named<GradeDialog>(*window, "gradeDialog");
            auto *words = named<QLabel>(*dialog, "gradeWords");
            QVERIFY(words->text().contains("for each student"));
            emit words->linkActivated(u"assignment-file.md"_s);
            page = named<QListWidget>(*dialog, "manualPages")->currentItem()->text();
            named<QDialog>(*dialog, "manual")->reject();
            dialog->reject();
        });
        QTest::mouseClick(named<QToolButton>(*window, "gradingGrade"), Qt::LeftButton);
        QCOMPARE(page, "Assignments");
    }

    void aFolderOfResultsOpensInGradingHoweverItComes_data()
    {
        QTest::addColumn<bool>("isDropped");
        QTest::newRow("on the command line, before the window is shown") << false;
        QTest::newRow("dropped on the window") << true;
    }
    void aFolderOfResultsOpensInGradingHoweverItComes()
    {
        QFETCH(bool, isDropped);
        const Classroom classroom;
        bringResults(classroom);
        const auto window = std::make_unique<MainWindow>();
        window->openDefaultScene();
        if (!isDropped)
            window->openResults(classroom.results());
        window->show();
        QVERIFY(QTest::qWaitForWindowExposed(window.get()));

        if (isDropped)
            dropFile(*window, classroom.results());

        QTRY_COMPARE_WITH_TIMEOUT(table(*window)->model()->rowCount(), 3, longestWait);
        QTRY_VERIFY_WITH_TIMEOUT(
            !named<QDockWidget>(*window, "gradingDock")->visibleRegion().isEmpty(), longestWait);
        QVERIFY(!named<QWidget>(*window, "messageBar")->isVisible());
        QTRY_COMPARE_WITH_TIMEOUT(window->focusWidget(), table(*window), longestWait);
        QTRY_COMPARE_WITH_TIMEOUT(window->parts().student->name(), "ada · small", longestWait);
    }

    void whatRanInNoSandboxIsTold()
    {
        const Classroom classroom;
        bringResults(classroom);
        const auto window = windowWithDock();
        book(*window).open(classroom.results());
        QTRY_COMPARE_WITH_TIMEOUT(table(*window)->model()->rowCount(), 3, longestWait);
        const auto *told = named<ElidedLabel>(*window, "gradingConfinement");
        QVERIFY(!told->isVisible());

        GradedSubmission ran = book(*window).report().submissions.front();
        ran.scenes.front().run
            = GradedRun{u"finished"_s, u"it finished"_s, {}, u"there is no bwrap"_s};
        QFile file(submissionFileOf(classroom.results(), ran.id));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(writeGradedSubmission(ran, writeAssignment(book(*window).report().assignment)));
        file.close();
        book(*window).open(classroom.results());

        QTRY_VERIFY_WITH_TIMEOUT(told->isVisible(), longestWait);
        QVERIFY2(told->text().contains("there is no bwrap"), qPrintable(told->text()));
        QVERIFY(told->toolTip() == told->text());
    }

    void whatHoldsNoGradesIsToldAsSuch()
    {
        const auto window = openedWindow();
        const QTemporaryDir empty;
        window->openResults(empty.path());
        QTRY_VERIFY_WITH_TIMEOUT(named<QWidget>(*window, "messageBar")->isVisible(), longestWait);
        const QString told = named<QLabel>(*window, "messageText")->text();
        for (const QString &part :
             {u"No grades: "_s, empty.path(), u"holds no results"_s, u"expected"_s})
            QVERIFY2(told.contains(part), qPrintable(told));
    }

    void keysGoFromPictureToPicture_data() { addPalettes(); }
    void keysGoFromPictureToPicture()
    {
        QFETCH(QPalette, palette);
        const Classroom classroom;
        const auto window = windowWithGrades(classroom);
        QApplication::setPalette(palette);

        QTRY_COMPARE_WITH_TIMEOUT(window->parts().student->name(), "ada · small", longestWait);
        press(*window, Qt::Key_J);
        QTRY_COMPARE_WITH_TIMEOUT(window->parts().student->name(), "bob · small", longestWait);
        QTRY_VERIFY_WITH_TIMEOUT(window->parts().student->judgement(), longestWait);

        QCOMPARE(window->parts().document->scene().triangles, smallScene().triangles);
        QVERIFY(named<QDockWidget>(*window, "submissionDock")->isVisible());
        QCOMPARE(window->parts().playhead->pickedPixel(),
                 window->parts().student->judgement()->firstDifference());
        QVERIFY2(named<QLabel>(*window, "gradingSentences")->text().contains("byte"),
                 qPrintable(named<QLabel>(*window, "gradingSentences")->text()));
        QTest::qWait(50);
        grabbed(*window, "grading");
        for (const char *part : {"gradingTable", "gradingSentences"})
            QTRY_COMPARE(readingFault(*named<QWidget>(*window, part)), QString());
        press(*window, Qt::Key_K);
        QTRY_COMPARE_WITH_TIMEOUT(window->parts().student->name(), "ada · small", longestWait);
        QCOMPARE(table(*window)->currentIndex().row(), 0);
    }

    void theBenchIsUsableOnASmallScreen_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1024 × 640") << QSize(1016, 600);
        QTest::newRow("1366 × 768") << QSize(1358, 728);
    }
    void theBenchIsUsableOnASmallScreen()
    {
        QFETCH(QSize, size);
        const Classroom classroom;
        const auto window = windowWithGrades(classroom);
        window->resize(size);
        action(*window, "resetLayout")->trigger();
        book(*window).setComment(std::array{std::size_t(0), std::size_t(1)},
                                 "Round where you cut: half a level is lost on every channel.");
        QTRY_VERIFY_WITH_TIMEOUT(window->parts().student->judgement(), longestWait);
        press(*window, Qt::Key_J);
        QTRY_COMPARE_WITH_TIMEOUT(window->parts().student->name(), "bob · small", longestWait);
        QTRY_VERIFY_WITH_TIMEOUT(window->parts().student->judgement(), longestWait);
        QTest::qWait(100); // events move the docks into place

        grabbed(*window, "bench");
        QCOMPARE(window->size(), size);
        const auto seen = [&](const char *name) {
            return named<QWidget>(*window, name)->visibleRegion().boundingRect();
        };
        const int line = window->fontMetrics().lineSpacing();
        QVERIFY(seen("gradingTable").height() >= 4 * line);
        QVERIFY(seen("gradingTable").width() >= 20 * line);
        QCOMPARE(seen("gradingSentences"), named<QWidget>(*window, "gradingSentences")->rect());
        const auto *causes = named<QLabel>(*window, "gradingCauses");
        QCOMPARE(seen("gradingCauses").height(), causes->height());
        QVERIFY2(causes->text().startsWith(u"rounding-truncate"_s), qPrintable(causes->text()));
        QVERIFY(named<QLabel>(*window, "gradingDone")->text().startsWith("Levels are cut"));
        QVERIFY(seen("gradingDone").height() >= line);
        const auto *view = qobject_cast<QTableView *>(table(*window));
        QCOMPARE(view->horizontalScrollBar()->maximum(), 0);
        for (int column = 0; column < view->model()->columnCount(); ++column) {
            if (!view->isColumnHidden(column))
                QVERIFY2(view->columnWidth(column)
                             >= view->horizontalHeader()->sectionSizeHint(column),
                         qPrintable(QString::number(column)));
        }
        QVERIFY(view->columnWidth(GradeColumn::Verdict) > 0);
        QVERIFY(seen("gradingComment").height() >= 3 * line);
        QCOMPARE(seen("gradingComment"), named<QWidget>(*window, "gradingComment")->rect());
        QVERIFY(seen("submissionPicture").height() >= 6 * line);
        QCOMPARE(seen("submissionExpected").height(), seen("submissionPicture").height());
    }

    void acceptedStaysAccepted()
    {
        const Classroom classroom;
        const auto window = windowWithGrades(classroom);
        press(*window, Qt::Key_Up);
        press(*window, Qt::Key_A);

        QCOMPARE(cell(*window, 0, GradeColumn::State), "✓");
        const auto *model = table(*window)->model();
        QCOMPARE(model->index(0, GradeColumn::State).data(Qt::AccessibleTextRole), "accepted");
        named<QLineEdit>(*window, "gradingFilter")->setText("accepted");
        QCOMPARE(model->rowCount(), 1);
        named<QLineEdit>(*window, "gradingFilter")->clear();
        QTRY_VERIFY_WITH_TIMEOUT(keptReview(classroom, 0).isAccepted, longestWait);
        press(*window, Qt::Key_A);
        QCOMPARE(cell(*window, 0, GradeColumn::State), QString());
    }

    void aCommentIsKeptWhenTheRowIsLeftAndStandsInTheReports()
    {
        const Classroom classroom;
        const auto window = windowWithGrades(classroom);
        auto *comment = named<QPlainTextEdit>(*window, "gradingComment");
        press(*window, Qt::Key_K);
        press(*window, Qt::Key_C);
        QTRY_VERIFY_WITH_TIMEOUT(comment->hasFocus(), longestWait);
        QTest::keyClicks(comment, "well done");
        QTest::keyClick(comment, Qt::Key_Escape);
        QVERIFY(table(*window)->hasFocus());
        press(*window, Qt::Key_J);

        QCOMPARE(comment->toPlainText(), QString());
        QCOMPARE(cell(*window, 0, GradeColumn::Comment), "well done");
        QTRY_COMPARE_WITH_TIMEOUT(keptReview(classroom, 0).comment, "well done", longestWait);

        QTest::mouseClick(named<QToolButton>(*window, "gradingReports"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!book(*window).job().isRunning(), longestWait);
        QFile results(classroom.results() + "/results.json");
        QVERIFY(results.open(QIODevice::ReadOnly));
        QVERIFY(results.readAll().contains("well done"));
    }

    void pointsAreChangedWithAReasonAlone()
    {
        const Classroom classroom;
        {
            const auto window = windowWithGrades(classroom);
            press(*window, Qt::Key_K);
            press(*window, Qt::Key_J);
            auto *points = named<QLineEdit>(*window, "gradingPoints");
            auto *reason = named<QLineEdit>(*window, "gradingReason");
            QCOMPARE(points->placeholderText(), "3");
            points->setFocus();
            QTest::keyClicks(points, "4.5");
            QTest::keyClick(points, Qt::Key_Return);
            QCOMPARE(cell(*window, 1, GradeColumn::Points), "3 / 5");
            press(*window, Qt::Key_K); // without a reason they are not taken, which is said
            QVERIFY(named<QLabel>(*window, "messageText")->text().contains("4.5"));
            press(*window, Qt::Key_J);
            QCOMPARE(cell(*window, 1, GradeColumn::Points), "3 / 5");
            QCOMPARE(points->text(), "4.5"); // they wait for it
            points->setFocus();
            QTest::keyClick(points, Qt::Key_Return);
            QVERIFY(reason->hasFocus());
            QTest::keyClicks(reason, "explained by mail");
            QTest::keyClick(reason, Qt::Key_Return);
            QCOMPARE(cell(*window, 1, GradeColumn::Points), "4.5 / 5");
            press(*window, Qt::Key_K);
            QCOMPARE(points->text(), QString());
        }
        QCOMPARE(keptReview(classroom, 1).points, std::optional(4.5));
        QCOMPARE(keptReview(classroom, 1).reason, "explained by mail");
    }

    void aCommentThatIsBeingTypedOutlivesGradingAnewAndTheWindow()
    {
        const Classroom classroom;
        {
            const auto window = windowWithGrades(classroom);
            auto *comment = named<QPlainTextEdit>(*window, "gradingComment");
            press(*window, Qt::Key_K);
            comment->setPlainText("first");
            book(*window).grade(classroom.submissions(), classroom.assignmentFile(),
                                classroom.results());
            comment->setPlainText("second");
            QTRY_VERIFY_WITH_TIMEOUT(!book(*window).job().isRunning(), longestWait);
            QTRY_COMPARE_WITH_TIMEOUT(cell(*window, 0, GradeColumn::Comment), "second",
                                      longestWait);
            press(*window, Qt::Key_K);
            comment->setPlainText("third");
        }
        QCOMPARE(keptReview(classroom, 0).comment, "third");
    }

    void whatIsSaidLastIsWrittenLastEvenAtTheEnd()
    {
        const Classroom classroom;
        bringResults(classroom);
        {
            Gradebook gradebook;
            gradebook.open(classroom.results());
            QTRY_VERIFY_WITH_TIMEOUT(!gradebook.results().isEmpty(), longestWait);
            for (int i = 1; i <= 20; ++i)
                gradebook.setComment(std::array{std::size_t(0)}, QString::number(i));
        }
        QCOMPARE(keptReview(classroom, 0).comment, "20");
    }

    void whyThereIsNoPictureStandsInItsPlaceAtOnce()
    {
        const Classroom classroom;
        const auto window = windowWithGrades(classroom);
        press(*window, Qt::Key_K);
        QTRY_VERIFY_WITH_TIMEOUT(window->parts().student->judgement(), longestWait);

        emit named<GradingPanel>(*window, "grading")
            ->openRequested({smallScene(), {}, {}, "bob · small", "it is 20 × 20 pixels"});

        QVERIFY(!window->parts().student->judgement());
        QCOMPARE(named<QLabel>(*window, "submissionVerdict")->text(),
                 "No picture: it is 20 × 20 pixels.");
        press(*window, Qt::Key_J);
        QCOMPARE(window->parts().student->name(), "bob · small");
        QVERIFY(!window->parts().student->judgement());
        QTRY_VERIFY_WITH_TIMEOUT(window->parts().student->judgement(), longestWait);
    }

    void aCommentOfAStudentWhoIsNotThereNowStays()
    {
        const Classroom classroom;
        const auto window = windowWithGrades(classroom);
        GradeReport report = book(*window).report();
        report.submissions[2].review.comment = "see me";
        QVERIFY(!writeReviews(classroom.results(), report));
        report.submissions.pop_back();
        report.submissions[0].review.comment = "fine";
        QVERIFY(!writeReviews(classroom.results(), report));

        const auto kept = readGrades(classroom.results());
        QVERIFY(kept.isOk());
        QCOMPARE(kept->submissions[0].review.comment, "fine");
        QCOMPARE(kept->submissions[2].review.comment, "see me");
    }

    void oneCommentIsForTheWholeCause()
    {
        const Classroom classroom;
        const auto window = windowWithGrades(classroom);
        press(*window, Qt::Key_K);
        press(*window, Qt::Key_J);
        named<QPlainTextEdit>(*window, "gradingComment")->setPlainText("round, do not cut");

        QTest::mouseClick(named<QToolButton>(*window, "gradingCommentCluster"), Qt::LeftButton);

        QTRY_COMPARE_WITH_TIMEOUT(keptReview(classroom, 1).comment, "round, do not cut",
                                  longestWait);
        QCOMPARE(keptReview(classroom, 2).comment, "round, do not cut");
        QCOMPARE(keptReview(classroom, 0).comment, QString());
    }

    void theTableIsFiltered()
    {
        const Classroom classroom;
        const auto window = windowWithGrades(classroom);
        QTest::keyClicks(named<QLineEdit>(*window, "gradingFilter"), "truncate cyd");
        QCOMPARE(table(*window)->model()->rowCount(), 1);
        named<QLineEdit>(*window, "gradingFilter")->clear();
        named<QComboBox>(*window, "gradingClusters")->setCurrentIndex(1);
        QCOMPARE(table(*window)->model()->rowCount(), 2);
    }

    void theModelKeepsItsPromises()
    {
        const Classroom classroom;
        bringResults(classroom);
        Gradebook gradebook;
        GradeRows &model = *gradeRows(&gradebook, &gradebook);
        const QAbstractItemModelTester tester(&model);
        GradeFilter filter;
        filter.setSourceModel(&model);
        const QAbstractItemModelTester filterTester(&filter);
        gradebook.open(classroom.results());
        QTRY_COMPARE_WITH_TIMEOUT(filter.rowCount(), 3, longestWait);
        gradebook.setAccepted(0, true);
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestGradingDock)

} // namespace tst_gradingdock

#include "tst_gradingdock.moc"
