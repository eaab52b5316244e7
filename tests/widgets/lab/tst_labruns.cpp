// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/labrequest.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/lab/accuracylab.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

#include <QtTest>
#include <QtWidgets>

namespace tst_labruns {

using namespace pixelplumb;

namespace {

constexpr int longest = 60'000; // ms

} // namespace

/// Runs of the lab in the window that are cancelled, repeated or made to wait.
class TestLabRuns : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_settings.clear();
        m_window = openedWindow(u"ties-at-tenths.json"_s);
        action(*m_window, "accuracyLabDockToggle")->trigger();
        m_lab = named<AccuracyLab>(*m_window, "accuracyLab");
        m_lab->setRequest(smallRequest());
        QCoreApplication::processEvents();
    }
    void cleanup() { m_window.reset(); }

    void aRunTellsItsProgressAndKeepsWhatItHasWhenItIsCancelled()
    {
        StudySettings request = smallRequest();
        request.rounds = 100'000;
        m_lab->setRequest(request);
        QSignalSpy spy(m_lab, &AccuracyLab::resultsChanged);
        click("labRun");
        QTRY_VERIFY_WITH_TIMEOUT(m_lab->results() && m_lab->results()->rounds > 0, longest);
        const int shown = m_lab->results()->rounds;
        const auto *progress = named<QProgressBar>(*m_lab, "labProgress");
        QTRY_VERIFY_WITH_TIMEOUT(progress->format().startsWith("measuring: "), longest);
        QVERIFY2(progress->format().endsWith(" left"), qPrintable(progress->format()));
        QVERIFY(progress->maximum() > 0);

        click("labCancel");

        QTRY_VERIFY(!m_lab->isRunning());
        const Study &study = *m_lab->results();
        QVERIFY(study.rounds >= shown);
        for (const LabRow &row : study.rows) {
            if (row.family == u"own-scene"_s)
                QVERIFY(row.cost && row.cost->rounds >= shown);
        }
        QVERIFY(!m_lab->results()->isComplete);
        QVERIFY(m_lab->results()->rows.front().accuracy);
        QVERIFY(m_lab->results()->rows.front().cost);
        QVERIFY(button("labRun")->isEnabled());
        const auto kept = spy.size();
        QTest::qWait(300);
        QCOMPARE(spy.size(), kept); // the ended run reports nothing more
    }

    void aRunThatIsCancelledBeforeItsFirstTimesLeavesTheResultsBefore()
    {
        runToItsEnd();
        const SharedResults before = m_lab->results();
        StudySettings request = smallRequest();
        request.families.clear(); // all families: judging them takes a while
        m_lab->setRequest(request);
        QSignalSpy notices(m_lab, &AccuracyLab::notice);

        click("labRun");
        QVERIFY(m_lab->isRunning());
        QVERIFY(named<QLabel>(*m_lab, "labWarnings")->isVisible());
        QVERIFY(named<QLabel>(*m_lab, "labWarnings")->text().contains("the previous run"));
        click("labCancel");

        QTRY_VERIFY_WITH_TIMEOUT(!m_lab->isRunning(), longest);
        QCOMPARE(m_lab->results(), before);
        QCOMPARE(notices.size(), 1);
        QVERIFY(notices.front().front().toString().contains("the earlier results stay"));
    }

    void aSceneThatIsNotAsItsFileSaysHasNoCommand()
    {
        runToItsEnd();
        const auto *conditions = named<QLabel>(*m_lab, "labConditions");
        QVERIFY2(conditions->text().contains("ties-at-tenths.json"),
                 qPrintable(conditions->text()));
        QVERIFY(conditions->text().contains("pixelplumb-cli lab "));
        ScanSettings settings = m_window->parts().document->scene().settings;
        settings.fillRule = FillRule::HalfOpenColumn;
        m_window->parts().document->setSettings(settings);
        QSignalSpy complaints(m_lab, &AccuracyLab::complaint);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->parts().playhead->traced(), longest);

        runToItsEnd();

        QVERIFY(conditions->text().contains("(save the scene to get its command)"));
        named<QAction>(*m_lab, "labCopyCommand")->trigger();
        QCOMPARE(complaints.size(), 1);
    }

private:
    QPushButton *button(const char *name) { return named<QPushButton>(*m_lab, name); }
    void click(const char *name) { QTest::mouseClick(button(name), Qt::LeftButton); }
    void runToItsEnd()
    {
        const SharedResults before = m_lab->results();
        click("labRun");
        QTRY_VERIFY_WITH_TIMEOUT(m_lab->results() != before && !m_lab->isRunning(), longest);
        QCoreApplication::processEvents();
    }

    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
    AccuracyLab *m_lab = nullptr;
};

PIXELPLUMB_TEST(TestLabRuns)

} // namespace tst_labruns

#include "tst_labruns.moc"
