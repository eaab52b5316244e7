// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "tests/support/window/windowsteps.h"
#include "widgets/canvas/overdrawoverlay.h"
#include "widgets/files/svgexport.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"

#include <QClipboard>
#include <QTest>

namespace tst_predictstudies {

using namespace pixelplumb;

namespace {

/// On the default scene's triangle, before and after the middle column, in a row that the row walk
/// has already drawn halfway through its run.
constexpr QPoint past(26, 30);
constexpr QPoint ahead(34, 30);

} // namespace

/// While a student predicts a run, copies and overlays of the whole run show only its past.
class TestPredictStudies : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }
    void cleanup() { m_window.reset(); }

    void overdrawIsNotTold()
    {
        openPredict(u"default.json"_s);
        action(*m_window, "showOverdraw")->trigger();
        auto *overlay = named<OverdrawOverlay>(*m_window, "overdrawMap");
        QCOMPARE(overlay->summary(), u"Overdraw is hidden while Predict asks"_s);
        const QImage hidden = overlay->grab().toImage();
        togglePredict();
        QVERIFY(!overlay->summary().contains(u"hidden"_s));
        QVERIFY(overlay->grab().toImage() != hidden);
    }

    void theCopyOfAPixelEndsAtTheCurrentStep()
    {
        openPredict(u"default.json"_s);
        const auto copied = [this](const QPoint &pixel) {
            playhead().pick(pixel);
            action(*m_window, "copyPixel")->trigger();
            return QGuiApplication::clipboard()->text();
        };
        QVERIFY(copied(past).contains(u"triangle 0: "_s));
        QVERIFY(!copied(ahead).contains(u"triangle 0"_s));
        togglePredict();
        QVERIFY(copied(ahead).contains(u"triangle 0: "_s));
    }

    void theFigureOfTheMomentHasNeitherTruthNorLayersOfWhatIsAhead()
    {
        openPredict(u"default.json"_s);
        DisplayOptions &options = *m_window->parts().options;
        const auto figure = [&] { return svgFigure(playhead(), options); };
        const QByteArray plain = figure();
        options.setTruthShown(true);
        QCOMPARE(figure(), plain);
        options.setTruthShown(false);
        options.setLayers({u"isolines-red"_s});
        QVERIFY(figure().contains("levels are still ahead"));
        const qsizetype paths = figure().count("<path");
        togglePredict();
        QVERIFY(!figure().contains("levels are still ahead"));
        QVERIFY(figure().count("<path") > paths);
    }

private:
    Playhead &playhead() { return *m_window->parts().playhead; }
    /// Opens a scene at a middle column, with Predict visible.
    void openPredict(const QString &file)
    {
        m_window = openedWindow(file);
        QVERIFY(waitForRun(*m_window));
        playhead().seekToSpan(playhead().traced()->trace->spanCount() / 2);
        togglePredict();
        QTRY_VERIFY(playhead().isAheadHidden());
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
};

PIXELPLUMB_TEST(TestPredictStudies)

} // namespace tst_predictstudies

#include "tst_predictstudies.moc"
