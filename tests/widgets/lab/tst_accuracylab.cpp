// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/labfile.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/labrequest.h"
#include "tests/support/madestudy.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/lab/accuracylab.h"
#include "widgets/lab/labfiles.h"
#include "widgets/lab/labtable.h"
#include "widgets/lab/paretoplot.h"

#include <QtTest>
#include <QtWidgets>

namespace tst_accuracylab {

using namespace pixelplumb;

namespace {

constexpr int longest = 60'000; // ms

} // namespace

/// The lab in the window, driven by clicks.
class TestAccuracyLab : public QObject {
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

    void saysAtFirstWhatTheButtonDoes()
    {
        QVERIFY(m_lab->isVisible());
        QVERIFY(!m_lab->results());
        const auto *invitation = named<QLabel>(*m_lab, "labInvitation");
        QVERIFY(invitation->isVisible());
        QVERIFY(invitation->text().contains(u"(about "_s));
        QVERIFY(invitation->text().endsWith(u" s)."_s));
        QVERIFY(!named<QTabWidget>(*m_lab, "labTabs")->isVisible());

        named<QComboBox>(*m_lab, "labExtent")->setCurrentIndex(1);
        QVERIFY(invitation->text().contains(u"every method in every arithmetic"_s));
    }

    void aRunFillsTheChartsAndCanBeDoneAgain()
    {
        for (int run = 0; run < 2; ++run) {
            click("labRun");
            QVERIFY(m_lab->isRunning());
            QVERIFY(!button("labRun")->isEnabled());
            QVERIFY(named<QProgressBar>(*m_lab, "labProgress")->isVisible());
            QTRY_VERIFY_WITH_TIMEOUT(!m_lab->isRunning(), longest);

            const Study &results = *m_lab->results();
            QVERIFY(results.isComplete);
            QCOMPARE(results.rows.size(), std::size_t(2));
            QVERIFY(!named<QProgressBar>(*m_lab, "labProgress")->isVisible());
            QVERIFY(button("labRun")->isEnabled());
            QCOMPARE(named<LabTable>(*m_lab, "labTable")->model()->rowCount(), 2);
            QVERIFY(named<ParetoPlot>(*m_lab, "labPareto")->positionOf(u"column-scan:float32"_s));
            QVERIFY(
                named<QLabel>(*m_lab, "labConditions")->text().contains(u"pixelplumb-cli lab"_s));
        }
    }

    void aRowOfTheTableIsTheDotOfTheChart()
    {
        runToItsEnd();
        auto *table = named<LabTable>(*m_lab, "labTable");
        named<QTabWidget>(*m_lab, "labTabs")->setCurrentIndex(1);
        QCoreApplication::processEvents();

        QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                          table->visualRect(table->model()->index(1, 0)).center());

        const QString chosen = table->selected();
        QVERIFY(!chosen.isEmpty());
        QCOMPARE(table->currentIndex().row(), 1);
        QCOMPARE(named<QComboBox>(*m_lab, "labMissContender")->currentData().toString(), chosen);
        auto *pareto = named<ParetoPlot>(*m_lab, "labPareto");
        QCOMPARE(pareto->selected(), chosen);

        named<QTabWidget>(*m_lab, "labTabs")->setCurrentIndex(0);
        pareto->setFocus();
        QTest::keyClick(pareto, Qt::Key_Left);
        QTest::keyClick(pareto, Qt::Key_Left);
        const QString cheapest = pareto->selected();
        QCOMPARE(table->selected(), cheapest);
        QTest::keyClick(pareto, Qt::Key_Right);
        QVERIFY(table->selected() != cheapest);
        QCOMPARE(table->selected(), pareto->selected());
        QVERIFY(pareto->accessibleDescription().contains(u"ns a pixel"_s));
    }

    void progressMovesNoTab_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("low panel") << QSize(1016, 600);
        QTest::newRow("high panel") << QSize(1440, 1100);
    }
    void progressMovesNoTab()
    {
        QFETCH(QSize, size);
        m_window->resize(size);
        runToItsEnd();
        QTest::qWait(50); // events move the docks into place
        const auto *tabs = named<QTabWidget>(*m_lab, "labTabs");
        const QRect place = tabs->geometry();
        StudySettings request = smallRequest();
        request.rounds = 100'000;
        m_lab->setRequest(request);

        click("labRun");
        QTest::qWait(50);
        QVERIFY(named<QProgressBar>(*m_lab, "labProgress")->isVisible());
        QCOMPARE(tabs->geometry(), place);

        click("labCancel");
        QTRY_VERIFY(!m_lab->isRunning());
        QTest::qWait(50);
        QCOMPARE(tabs->geometry(), place);
    }

    void resultsGoToAFileAndComeBack()
    {
        runToItsEnd();
        const Study study = *m_lab->results();
        const QString path = m_folder.filePath(u"lab.json"_s);
        QVERIFY(m_lab->files()->writeResults(path, study));
        QVERIFY(m_lab->files()->writeTable(m_folder.filePath(u"lab.csv"_s), study));

        QVERIFY(m_lab->openResults(path));

        QCOMPARE(writeStudy(*m_lab->results()), writeStudy(study));
        QSignalSpy complaints(m_lab, &AccuracyLab::complaint);
        QVERIFY(!m_lab->files()->writeTable(path, study)); // results that were read, not measured
        QVERIFY(complaints.takeFirst().constFirst().toString().contains("not written"));
        QVERIFY(!m_lab->openResults(m_folder.filePath(u"lab.csv"_s)));
        QVERIFY(complaints.takeFirst().constFirst().toString().contains("not opened"));
    }

    void chartsAreFiguresWithTheirOrigin_data() { addPalettes(); }
    void chartsAreFiguresWithTheirOrigin()
    {
        QFETCH(QPalette, palette);
        qApp->setPalette(palette);
        const auto results
            = madeResults({{"column-scan:float32", 2, 5000}, {"proved", 3, 0, true}});
        ParetoPlot plot;
        plot.resize(300, 200);
        plot.show(results, u"f"_s, *errorAxisNamed(u"wrong-pixels"_s));
        const QString svg = m_folder.filePath(u"chart.svg"_s);
        const QString png = m_folder.filePath(u"chart.png"_s);

        QVERIFY(m_lab->files()->writeChart(svg, plot, *results));
        QVERIFY(m_lab->files()->writeChart(png, plot, *results));

        const QString text = QString::fromUtf8(*readFile(svg));
        for (const char *part :
             {"Cost against error: Family f", "pixelplumb-cli lab --quick --seed 1", "a processor",
              "cost, ns a pixel", "0, proved"})
            QVERIFY2(text.contains(QLatin1String(part)), part);
        const QImage picture(png);
        QCOMPARE(picture.size(), QSize(1920, 1280));
        QCOMPARE(picture.pixelColor(2, 2), QColor(Qt::white)); // paper, whatever the window's
                                                               // palette
        QCOMPARE(plot.palette(), palette);
    }

    void fitsIntoASmallWindow()
    {
        m_window->resize(1016, 600);
        action(*m_window, "resetLayout")->trigger();
        runToItsEnd();
        QTest::qWait(50); // events move the docks into place

        QCOMPARE(m_window->size(), QSize(1016, 600));
        for (const char *name : {"labRun", "labTabs", "labConditions"})
            QVERIFY2(!named<QWidget>(*m_lab, name)->visibleRegion().isEmpty(), name);
        QVERIFY(named<ParetoPlot>(*m_lab, "labPareto")->height() >= 60);
    }

    void looksRightInBothPalettes_data() { addPalettes(); }
    void looksRightInBothPalettes()
    {
        QFETCH(QPalette, palette);
        qApp->setPalette(palette);
        runToItsEnd();

        grabbed(*m_window, u"lab"_s);
        QTRY_COMPARE(readingFault(*named<QWidget>(*m_lab, "labPareto")), QString());
    }

private:
    QPushButton *button(const char *name) { return named<QPushButton>(*m_lab, name); }
    void click(const char *name) { QTest::mouseClick(button(name), Qt::LeftButton); }
    void runToItsEnd()
    {
        click("labRun");
        QTRY_VERIFY_WITH_TIMEOUT(m_lab->results() && !m_lab->isRunning(), longest);
        QCoreApplication::processEvents();
    }

    IsolatedSettings m_settings;
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
    AccuracyLab *m_lab = nullptr;
};

PIXELPLUMB_TEST(TestAccuracyLab)

} // namespace tst_accuracylab

#include "tst_accuracylab.moc"
