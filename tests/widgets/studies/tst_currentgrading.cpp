// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/gradedclass.h"
#include "widgets/model/studentpicture.h"
#include "widgets/studies/grade/gradebook.h"

#include <QTest>
#include <QtWidgets>

namespace tst_currentgrading {

using namespace pixelplumb;

/// The selected row, the words about it and the picture shown belong to the same student.
class TestCurrentGrading : public QObject {
    Q_OBJECT

private slots:
    void aRowThatIsFilteredAwayIsNeitherCurrentNorShown_data()
    {
        QTest::addColumn<bool>("isByCause");
        QTest::newRow("by words") << false;
        QTest::newRow("by cause") << true;
    }
    void aRowThatIsFilteredAwayIsNeitherCurrentNorShown()
    {
        QFETCH(bool, isByCause);
        const Classroom classroom;
        const auto window = windowWithGrades(classroom);
        QTRY_VERIFY_WITH_TIMEOUT(window->parts().student->judgement(), longestWait);

        if (isByCause)
            named<QComboBox>(*window, "gradingClusters")->setCurrentIndex(1);
        else
            QTest::keyClicks(named<QLineEdit>(*window, "gradingFilter"), "bob");

        QVERIFY(!table(*window)->selectionModel()->hasSelection());
        QTRY_VERIFY_WITH_TIMEOUT(!window->parts().student->isThere(), longestWait);
        QCOMPARE(window->parts().student->name(), QString());
        QCOMPARE(named<QLabel>(*window, "gradingSentences")->text(), QString());
        press(*window, Qt::Key_A);
        QVERIFY(!book(*window).report().submissions[0].review.isAccepted);
        QVERIFY(!book(*window).report().submissions[1].review.isAccepted);
        press(*window, Qt::Key_J);
        QTRY_COMPARE_WITH_TIMEOUT(window->parts().student->name(), "bob · small", longestWait);
    }

    void theCurrentRowStaysSoWhileTheFilterKeepsIt()
    {
        const Classroom classroom;
        const auto window = windowWithGrades(classroom);
        press(*window, Qt::Key_J);
        QTRY_VERIFY_WITH_TIMEOUT(window->parts().student->judgement(), longestWait);
        const auto judged = window->parts().student->judgement();

        QTest::keyClicks(named<QLineEdit>(*window, "gradingFilter"), "bob");
        QCoreApplication::processEvents();

        QCOMPARE(table(*window)->selectionModel()->selectedRows().size(), 1);
        QCOMPARE(window->parts().student->judgement(), judged);
    }

    void everyWayToAnotherRowOpensItsPicture()
    {
        const Classroom classroom;
        const auto window = windowWithGrades(classroom);
        QTest::keyClick(table(*window), Qt::Key_End, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(window->parts().student->name(), "cyd · small", longestWait);
        QTest::keyClick(table(*window), Qt::Key_Home, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(window->parts().student->name(), "ada · small", longestWait);
        press(*window, Qt::Key_B); // the table searches for a name
        QTRY_COMPARE_WITH_TIMEOUT(window->parts().student->name(), "bob · small", longestWait);
        QTest::mouseClick(
            table(*window)->viewport(), Qt::LeftButton, {},
            table(*window)->visualRect(table(*window)->model()->index(0, 0)).center());
        QTRY_COMPARE_WITH_TIMEOUT(window->parts().student->name(), "ada · small", longestWait);
        for (const char *shown : {"bob · small", "cyd · small"}) {
            QTest::keyClick(window->focusWidget(), Qt::Key_J);
            QTRY_COMPARE_WITH_TIMEOUT(window->parts().student->name(), QString::fromUtf8(shown),
                                      longestWait);
            QTRY_VERIFY_WITH_TIMEOUT(window->parts().student->judgement(), longestWait);
            QCOMPARE(window->focusWidget(), table(*window)); // though a scene has come with it
        }
    }

    void noSubmissionIsCurrentWhileAnotherPictureIsShown()
    {
        const Classroom classroom;
        const auto window = windowWithGrades(classroom);
        press(*window, Qt::Key_K);
        QTRY_VERIFY_WITH_TIMEOUT(window->parts().student->judgement(), longestWait);

        window->parts().student->paste(drawn(smallScene()), "pasted");

        QTRY_COMPARE_WITH_TIMEOUT(window->parts().student->name(), "pasted", longestWait);
        QVERIFY(!table(*window)->selectionModel()->hasSelection());
        QCoreApplication::processEvents();
        QCOMPARE(window->parts().student->name(), "pasted");
        QVERIFY(!named<QToolButton>(*window, "gradingAccept")->isEnabled());
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestCurrentGrading)

} // namespace tst_currentgrading

#include "tst_currentgrading.moc"
