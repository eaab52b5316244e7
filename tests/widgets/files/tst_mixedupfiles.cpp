// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/assignment.h"
#include "core/scene/scenefile.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/files/scenefiles.h"
#include "widgets/studies/grade/gradedialog.h"

#include <QTest>
#include <QtWidgets>

namespace tst_mixedupfiles {

using namespace pixelplumb;

/// An assignment where a scene is expected, and a scene where an assignment is.
class TestMixedUpFiles : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void aFileSaysWhatItIs()
    {
        QCOMPARE(kindOfFile(assignment()), FileKind::Assignment);
        QCOMPARE(kindOfFile(scene()), FileKind::Scene);
        QCOMPARE(kindOfFile(resource(u"/glossary.md"_s)), FileKind::Other);
        QVERIFY(readSceneFile(assignment()).error().message().contains(u"this is an assignment"_s));
    }

    void anAssignmentThatIsOpenedIsOfferedToGrading()
    {
        const auto window = openedWindow();
        QVERIFY(!window->openScene(assignment()));
        QTRY_VERIFY(window->findChild<QMessageBox *>(u"assignmentMet"_s));
        auto *box = named<QMessageBox>(*window, "assignmentMet");
        QVERIFY(box->text().contains(u"column-scan.json"_s));
        QString offered;
        QTimer::singleShot(0, window.get(), [&] {
            auto *dialog = named<GradeDialog>(*window, "gradeDialog");
            offered = dialog->assignment();
            dialog->reject();
        });

        QTest::mouseClick(box->defaultButton(), Qt::LeftButton);
        QTRY_COMPARE(offered, assignment());
    }

    void aSceneByWhichToGradeIsOfferedToBeOpenedOrTheOnlyTask_data()
    {
        QTest::addColumn<QString>("offer");
        QTest::newRow("opened") << u"Open the scene"_s;
        QTest::newRow("the only task") << u"Grade by this scene"_s;
    }
    void aSceneByWhichToGradeIsOfferedToBeOpenedOrTheOnlyTask()
    {
        QFETCH(QString, offer);
        const QString submissions = m_settings.folder() + "/submissions";
        QVERIFY(QDir().mkpath(submissions));
        QVERIFY(QImage(4, 4, QImage::Format_RGB32).save(submissions + "/ann.png"));
        const auto window = openedWindow();
        action(*window, "gradingDockToggle")->trigger();
        QTimer::singleShot(0, window.get(), [&] {
            auto *dialog = named<GradeDialog>(*window, "gradeDialog");
            dialog->setPaths(submissions, scene(), m_settings.folder() + "/results");
            dialog->accept();
        });
        QTest::mouseClick(named<QAbstractButton>(*window, "gradingGrade"), Qt::LeftButton);
        QTRY_VERIFY(window->findChild<QMessageBox *>(u"sceneMet"_s));

        for (QAbstractButton *button : named<QMessageBox>(*window, "sceneMet")->buttons()) {
            if (button->text().remove(u'&') == offer)
                QTest::mouseClick(button, Qt::LeftButton);
        }
        if (offer.startsWith(u"Open"_s)) {
            QTRY_COMPARE(window->parts().files->path(), scene());
            return;
        }
        const QString made = m_settings.folder() + "/results/assignment.json";
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(made), 60000);
        QTRY_VERIFY(readAssignmentFile(made));
        const auto assignment = readAssignmentFile(made);
        QCOMPARE(assignment->points(), 5.0);
        QVERIFY(assignment->scenes.front().scene == readSceneFile(scene())->scene);
    }

private:
    static QString assignment() { return resource(u"/assignments/column-scan.json"_s); }
    static QString scene() { return resource(u"/scenes/lines.json"_s); }

    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestMixedUpFiles)

} // namespace tst_mixedupfiles

#include "tst_mixedupfiles.moc"
