// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "tests/support/window/windowsteps.h"
#include "widgets/canvas/overdrawoverlay.h"
#include "widgets/files/svgexport.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/studies/accuracy/precisionpanel.h"
#include "widgets/studies/accuracy/precisionplot.h"
#include "widgets/studies/compare/comparepane.h"
#include "widgets/studies/compare/comparepanel.h"
#include "widgets/studies/compare/compareview.h"

#include <QClipboard>
#include <QLabel>
#include <QTest>
#include <qcustomplot.h>

namespace tst_predictstudies {

using namespace pixelplumb;

namespace {

/// On the default scene's triangle, before and after the middle column, in a row that the row walk
/// has already drawn halfway through its run.
constexpr QPoint past(26, 30);
constexpr QPoint ahead(34, 30);

/// The colour that a view shows in the middle of a pixel's cell.
QRgb shownAt(CompareView *view, const QPoint &pixel)
{
    const QImage grabbed = view->grab().toImage();
    return grabbed.pixel((view->positionOf(pixel) * grabbed.devicePixelRatio()).toPoint());
}

} // namespace

/// While a student predicts a run, studies of the whole run show only its past.
class TestPredictStudies : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }
    void cleanup() { m_window.reset(); }

    void comparedPicturesShowThePixelsThatAreDecided_data()
    {
        QTest::addColumn<QString>("method"); // empty: the truth
        QTest::newRow("the truth") << QString();
        QTest::newRow("another way") << QStringLiteral("row-walk");
    }
    void comparedPicturesShowThePixelsThatAreDecided()
    {
        QFETCH(QString, method);
        openCompare(QStringLiteral("default.json"), method);
        const QRgb background = packed(scene().frame.background);
        CompareView *view = m_panel->panes()[1]->view();
        playhead().pick({0, 0});

        QVERIFY(shownAt(view, past) != background);
        QCOMPARE(shownAt(view, ahead), background);
        playhead().seek(playhead().end());
        QVERIFY(shownAt(view, ahead) != background);
    }

    void theTruthOfStepsIsSeenAsFarAsTheyHaveCome_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("lines") << QStringLiteral("lines.json");
        QTest::newRow("circles") << QStringLiteral("circles.json");
    }
    void theTruthOfStepsIsSeenAsFarAsTheyHaveCome()
    {
        QFETCH(QString, file);
        openCompare(file, QString());
        const QRgb background = packed(scene().frame.background);
        CompareView *view = m_panel->panes()[1]->view();
        const TracedScene &traced = *playhead().traced();
        const PixelChanges &changes = traced.trace->changes();
        int seen = 0;
        int hidden = 0;
        for (std::size_t sample = 0; sample < traced.trace->sampleCount(); ++sample) {
            const PixelChange &change = changes[sample];
            const QPoint pixel(change.x, change.y);
            if (traced.differences.at(pixel.x(), pixel.y()) != Difference::None)
                continue;
            const bool isDone = traced.trace->indexOfSample(sample) < playhead().position();
            seen += int(isDone && shownAt(view, pixel) != background);
            hidden += int(!isDone && shownAt(view, pixel) == background);
        }
        QVERIFY2(seen > 20, qPrintable(QString::number(seen)));
        QVERIFY2(hidden > 20, qPrintable(QString::number(hidden)));
    }

    void theAgreementMapTellsOfThePixelsThatAreDecided()
    {
        openCompare(QStringLiteral("default.json"), QString());
        auto *map = named<AgreementView>(*m_panel, "agreementMap");
        const QRgb nothing = map->palette().color(QPalette::Base).rgb();
        playhead().pick({0, 0});

        QVERIFY(shownAt(map, past) != nothing);
        QCOMPARE(shownAt(map, ahead), nothing);
        togglePredict();
        QVERIFY(shownAt(map, ahead) != nothing);
    }

    void countsAndReasonsOfAComparisonWait()
    {
        openCompare(QStringLiteral("ties-at-tenths.json"), QString());
        const AgreementMap &agreement = m_panel->contest()->agreement;
        const QPoint wrong = lastDiffering(agreement);
        const auto *reason = named<QLabel>(*m_panel, "compareReason");
        playhead().pick(wrong);

        QCOMPARE(reason->text(), QStringLiteral("What lies ahead is hidden while Predict asks."));
        for (const QLabel *label : m_panel->findChildren<QLabel *>())
            QVERIFY2(!label->text().contains(QStringLiteral(": %1").arg(agreement.differing())),
                     qPrintable(label->text()));
        playhead().seek(playhead().end());
        playhead().pick(wrong);
        QVERIFY2(reason->text().contains(QStringLiteral("1 of 2 agree")),
                 qPrintable(reason->text()));
        // If nothing lies ahead, nothing is hidden.
        const auto tells = [this](const char *words) {
            return std::ranges::any_of(m_panel->findChildren<QLabel *>(), [words](QLabel *label) {
                return label->text().contains(QString::fromLatin1(words));
            });
        };
        QVERIFY(tells("shown finished"));
        QVERIFY(!tells("Predict hides"));
        playhead().seekToSpan(3);
        QVERIFY(!tells("shown finished"));
        QVERIFY(tells("Predict hides"));
    }

    void errorsAreThoseOfTheColumnsThatAreEntered()
    {
        openPredict(QStringLiteral("ties-at-tenths.json"));
        auto *panel = named<PrecisionPanel>(*m_window, "precision");
        action(*m_window, "precisionDockToggle")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!panel->errors().empty() && !panel->isRunning(), 20000);
        const auto *plot = panel->plot()->findChild<QCustomPlot *>();
        const auto last = [plot] {
            double largest = -1;
            for (int i = 0; i < plot->graphCount(); ++i)
                largest = std::max(
                    largest, plot->graph(i)->data()->at(plot->graph(i)->dataCount() - 1)->key);
            return largest;
        };
        const QCPRange range = plot->xAxis->range();
        for (const std::size_t span : {2, 9}) {
            playhead().seekToSpan(span);
            QCOMPARE(last(), double(*playhead().currentColumnX()));
            QCOMPARE(plot->xAxis->range().upper, range.upper); // nothing jumps
        }
        playhead().seek(0);
        QCOMPARE(plot->graphCount(), 0);
        QCOMPARE(named<QLabel>(*panel, "precisionSummary")->text(),
                 QStringLiteral("What lies ahead is hidden while Predict asks."));
        togglePredict();
        QVERIFY(last() > double(playhead().traced()->trace->placeOf(9).coordinate));
    }

    void overdrawIsNotTold()
    {
        openPredict(QStringLiteral("default.json"));
        action(*m_window, "showOverdraw")->trigger();
        auto *overlay = named<OverdrawOverlay>(*m_window, "overdrawMap");
        QCOMPARE(overlay->summary(), QStringLiteral("Overdraw is hidden while Predict asks"));
        const QImage hidden = overlay->grab().toImage();
        togglePredict();
        QVERIFY(!overlay->summary().contains(QStringLiteral("hidden")));
        QVERIFY(overlay->grab().toImage() != hidden);
    }

    void theCopyOfAPixelEndsAtTheCurrentStep()
    {
        openPredict(QStringLiteral("default.json"));
        const auto copied = [this](const QPoint &pixel) {
            playhead().pick(pixel);
            action(*m_window, "copyPixel")->trigger();
            return QGuiApplication::clipboard()->text();
        };
        QVERIFY(copied(past).contains(QStringLiteral("triangle 0: ")));
        QVERIFY(!copied(ahead).contains(QStringLiteral("triangle 0")));
        togglePredict();
        QVERIFY(copied(ahead).contains(QStringLiteral("triangle 0: ")));
    }

    void theFigureOfTheMomentHasNeitherTruthNorLayersOfWhatIsAhead()
    {
        openPredict(QStringLiteral("default.json"));
        DisplayOptions &options = *m_window->parts().options;
        const auto figure = [&] { return svgFigure(playhead(), options); };
        const QByteArray plain = figure();
        options.setTruthShown(true);
        QCOMPARE(figure(), plain);
        options.setTruthShown(false);
        options.setLayers({QStringLiteral("isolines-red")});
        QVERIFY(figure().contains("levels are still ahead"));
        const qsizetype paths = figure().count("<path");
        togglePredict();
        QVERIFY(!figure().contains("levels are still ahead"));
        QVERIFY(figure().count("<path") > paths);
    }

private:
    Playhead &playhead() { return *m_window->parts().playhead; }
    const Scene &scene() { return m_window->parts().document->scene(); }
    static QPoint lastDiffering(const AgreementMap &agreement)
    {
        QPoint last;
        for (int x = 0; x < agreement.spec().width; ++x) {
            for (int y = 0; y < agreement.spec().height; ++y) {
                if (agreement.agreeingAt(x, y) < agreement.contenderCount())
                    last = {x, y};
            }
        }
        return last;
    }

    /// Opens a scene at a middle column, with Predict visible.
    void openPredict(const QString &file)
    {
        m_window = openedWindow(file);
        QVERIFY(waitForRun(*m_window));
        playhead().seekToSpan(playhead().traced()->trace->spanCount() / 2);
        togglePredict();
        QTRY_VERIFY(playhead().isAheadHidden());
    }
    /// Opens the current method in the first pane, and another one or the truth in the second.
    void openCompare(const QString &file, const QString &other)
    {
        openPredict(file);
        m_panel = named<ComparePanel>(*m_window, "compare");
        action(*m_window, "compareDockToggle")->trigger();
        m_panel->setContenders({{playhead().traced()->method, scene().settings},
                                {methodNamed(other), scene().settings}});
        QTRY_VERIFY_WITH_TIMEOUT(m_panel->contest() && !m_panel->isRunning()
                                     && m_panel->contest()->runs.size() == 2,
                                 20000);
        QCoreApplication::processEvents();
    }
    /// Toggles Predict in its workspace.
    void togglePredict()
    {
        action(*m_window, "stepWorkspace")->trigger();
        action(*m_window, "predictDockToggle")->trigger();
        action(*m_window, "workspaceBack")->trigger();
    }

    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
    ComparePanel *m_panel = nullptr;
};

PIXELPLUMB_TEST(TestPredictStudies)

} // namespace tst_predictstudies

#include "tst_predictstudies.moc"
