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
        QCOMPARE(kindOfFile(resource(QStringLiteral("/glossary.md"))), FileKind::Other);
        QVERIFY(readSceneFile(assignment())
                    .error()
                    .message()
                    .contains(QStringLiteral("this is an assignment")));
    }

    void anAssignmentThatIsOpenedIsOfferedToGrading()
    {
        const auto window = openedWindow();
        QVERIFY(!window->openScene(assignment()));
        QTRY_VERIFY(window->findChild<QMessageBox *>(QStringLiteral("assignmentMet")));
        auto *box = named<QMessageBox>(*window, "assignmentMet");
        QVERIFY(box->text().contains(QStringLiteral("column-scan.json")));
        QString offered;
        QTimer::singleShot(0, window.get(), [&] {
            auto *dialog = named<GradeDialog>(*window, "gradeDialog");
            offered = dialog->assignment();
            dialog->reject();
        });

        QTest::mouseClick(box->defaultButton(), Qt::LeftButton);
        QTRY_COMPARE(offered, assignment());
    }

    void aSceneByWhichToGradeIsOfferedToBeOpened()
    {
        const auto window = openedWindow();
        action(*window, "gradingDockToggle")->trigger();
        QTimer::singleShot(0, window.get(), [&] {
            auto *dialog = named<GradeDialog>(*window, "gradeDialog");
            dialog->setPaths(m_settings.folder(), scene(), m_settings.folder() + "/results");
            dialog->accept();
        });
        QTest::mouseClick(named<QAbstractButton>(*window, "gradingGrade"), Qt::LeftButton);
        QTRY_VERIFY(window->findChild<QMessageBox *>(QStringLiteral("sceneMet")));

        QTest::mouseClick(named<QMessageBox>(*window, "sceneMet")->defaultButton(), Qt::LeftButton);
        QTRY_COMPARE(window->parts().files->path(), scene());
    }

private:
    static QString assignment()
    {
        return resource(QStringLiteral("/assignments/column-scan.json"));
    }
    static QString scene() { return resource(QStringLiteral("/scenes/lines.json")); }

    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestMixedUpFiles)

} // namespace tst_mixedupfiles

#include "tst_mixedupfiles.moc"
