// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/canvas/overdrawoverlay.h"
#include "widgets/model/playhead.h"
#include "widgets/studies/compare/comparelink.h"
#include "widgets/studies/compare/comparepane.h"
#include "widgets/studies/compare/comparepanel.h"
#include "widgets/studies/compare/compareview.h"
#include "widgets/window/windowdocks.h"

#include <QTest>
#include <QtWidgets>

namespace tst_comparepanel {

using namespace pixelplumb;

class TestComparePanel : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_settings.clear();
        m_window = openedWindow(u"ties-at-tenths.json"_s);
        m_panel = named<ComparePanel>(*m_window, "compare");
        m_playhead = m_window->parts().playhead;
    }
    void cleanup() { m_window.reset(); }

    void comparesTheCurrentMethodWithItsOtherNumbersAtFirst()
    {
        open();

        QCOMPARE(m_panel->panes().size(), std::size_t(3));
        QCOMPARE(m_panel->contenders()[0].settings.arithmetic, Arithmetic::Float32);
        QCOMPARE(m_panel->contenders()[1].settings.arithmetic, Arithmetic::Exact);
        QVERIFY(m_panel->contest()->agreement.differing() > 0);
    }

    void everyPaneStandsWhereThePlayheadDoes()
    {
        open();
        const TracedScene &traced = *m_playhead->traced();
        for (const std::int64_t x : {1, 11, 40}) {
            m_playhead->seekToSpan(*traced.trace->spanOn(0, SpanAxis::Column, x));
            for (std::size_t pane = 0; pane < 3; ++pane) {
                const ScanTrace &trace = *m_panel->contest()->runs[pane].traced->trace;
                const TraceStep step = trace.stepAt(*m_panel->panes()[pane]->position() - 1);
                QCOMPARE(step.kind, StepKind::Span);
                QCOMPARE(trace.placeOf(step.span).coordinate, x);
            }
        }
        m_playhead->seek(m_playhead->end());
        QCOMPARE(*m_panel->panes()[1]->position(),
                 m_panel->contest()->runs[1].traced->trace->stepCount());
    }

    void theCountsAreThoseUpToTheStep()
    {
        open();
        const auto told = [this] { return m_panel->panes()[0]->findChild<QLabel *>()->text(); };
        const ContenderRun &run = m_panel->contest()->runs[0];
        const ContenderPace pace(*m_panel->contest(), 0);
        QVERIFY(pace.at(run.traced->trace->stepCount()) == run.tally);
        QCOMPARE(pace.at(0).written, 0);
        ContenderTally before;
        for (std::size_t position = 0; position <= run.traced->trace->stepCount(); position += 50) {
            const ContenderTally tally = pace.at(position);
            QVERIFY(tally.written >= before.written);
            QVERIFY(tally.againstTruth.count(Difference::Missing)
                    >= before.againstTruth.count(Difference::Missing));
            before = tally;
        }

        m_playhead->seekToSpan(10);
        QVERIFY2(told().contains(u"so far"_s) || told().contains(u'/'), qPrintable(told()));
        QVERIFY2(told().contains(u"so far"_s) || !told().contains(u"correct"_s),
                 qPrintable(told()));
        m_playhead->seek(m_playhead->end());
        QVERIFY2(!told().contains(u"so far"_s) && !told().contains(u'/'), qPrintable(told()));
    }

    void zoomsAndMovesAllViewsTogether()
    {
        open();
        CompareView *first = m_panel->panes()[0]->view();
        auto *map = named<AgreementView>(*m_panel, "agreementMap");
        const int before = first->mapping().zoom().number();
        QWheelEvent wheel(first->rect().center(), first->mapToGlobal(first->rect().center()), {},
                          {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);

        QCoreApplication::sendEvent(first, &wheel);

        QVERIFY(first->mapping().zoom().number() > before);
        QCOMPARE(map->mapping().zoom(), first->mapping().zoom());
        const LatticePoint here = first->mapping().latticeAt(QRectF(first->rect()).center());
        const LatticePoint there = map->mapping().latticeAt(QRectF(map->rect()).center());
        QVERIFY(std::abs(here.x - there.x) < unitsPerPixel);
        QVERIFY(std::abs(here.y - there.y) < unitsPerPixel);
    }

    void aFrameThatIsSeenWholeGetsNoSmallerByTheWheel()
    {
        open();
        CompareView *first = m_panel->panes()[0]->view();
        const ViewZoom whole = first->mapping().zoom();
        const QPointF centre = first->rect().center();
        for (const int notches : {1, -8, 1}) {
            QWheelEvent wheel(centre, first->mapToGlobal(centre), {}, {0, 120 * notches},
                              Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(first, &wheel);
            QVERIFY(first->mapping().zoom().number() >= whole.number());
            QCOMPARE(first->mapping().zoom() == whole, notches < 0);
        }
    }

    void aFrameThatHasRoomIsSeenWholeWhereAPixelIsLookedAt()
    {
        CompareLink link;
        FrameSpec frame;
        frame.width = 12;
        frame.height = 9;
        link.setFrame(frame);
        link.lookAt(QPoint(4, 8));
        const auto sees = [&link](const QSizeF &size, const QPoint &pixel) {
            return QRectF(QPointF(), size).contains(link.mappingFor(size, 1, {}).cellOf(pixel));
        };
        QVERIFY(sees({250, 200}, QPoint(0, 0)) && sees({250, 200}, QPoint(11, 8)));
        QVERIFY(sees({100, 80}, QPoint(4, 8)) && !sees({100, 80}, QPoint(11, 0)));
    }

    void aLongReasonMakesThePanelNoHigher()
    {
        open();
        m_panel->resize(480, m_panel->minimumSizeHint().height());
        const int before = m_panel->minimumSizeHint().height();
        m_playhead->pick(firstDifferingPixel());
        const auto *reason = named<QLabel>(*m_panel, "compareReason");
        QVERIFY(reason->heightForWidth(reason->width()) > 3 * reason->fontMetrics().lineSpacing());
        QCOMPARE(m_panel->minimumSizeHint().height(), before);
    }

    void aClickOnTheMapPicksThePixelAndTellsTheReason()
    {
        open();
        auto *map = named<AgreementView>(*m_panel, "agreementMap");
        const QPoint pixel = firstDifferingPixel();

        QTest::mouseClick(map, Qt::LeftButton, {}, map->positionOf(pixel).toPoint());

        QCOMPARE(m_playhead->pickedPixel(), std::optional(pixel));
        const QString reason = named<QLabel>(*m_panel, "compareReason")->text();
        QVERIFY2(
            reason.contains(nameOf(m_panel->contest()->agreement.reasonAt(pixel.x(), pixel.y()))),
            qPrintable(reason));
        QVERIFY2(reason.contains(u"instead of"_s), qPrintable(reason));
    }

    void takesPanesAwayAndAddsThemUpToFour()
    {
        open();
        auto *more = named<QToolButton>(*m_panel, "compareMore");
        auto *fewer = named<QToolButton>(*m_panel, "compareFewer");

        QTest::mouseClick(more, Qt::LeftButton);
        QTRY_COMPARE(m_panel->contest()->runs.size(), std::size_t(4));
        QVERIFY(!more->isEnabled());
        QTest::mouseClick(fewer, Qt::LeftButton);
        QTest::mouseClick(fewer, Qt::LeftButton);

        QTRY_COMPARE(m_panel->contest()->runs.size(), std::size_t(2));
        QVERIFY(!fewer->isEnabled());
    }

    void comparesWithTheTruthWhenAPaneAsksForIt()
    {
        open();
        auto *box = named<QComboBox>(*m_panel, "compareMethod2");
        box->setCurrentIndex(0);

        emit box->activated(0);

        QTRY_VERIFY(m_panel->contest()->runs[1].contender.isTruth());
        QVERIFY(!m_panel->panes()[1]->position());
    }

    void showsOverdrawInTheCanvasMapping()
    {
        auto *overlay = named<OverdrawOverlay>(*m_window, "overdrawMap");
        QVERIFY(!overlay->isVisible());

        action(*m_window, "showOverdraw")->trigger();

        QVERIFY(overlay->isVisible());
        QCOMPARE(overlay->geometry(), m_window->parts().canvas->rect());
        QCOMPARE(overlay->map().gaps(),
                 m_playhead->traced()->differences.count(Difference::Missing));
        QVERIFY(overlay->map().gaps() > 0);
        QVERIFY(overlay->summary().contains(QString::number(overlay->map().gaps())));
    }

    void looksRightInBothPalettes_data() { addPalettes(); }
    void looksRightInBothPalettes()
    {
        QFETCH(QPalette, palette);
        qApp->setPalette(palette);
        open();
        const QPoint pixel = firstDifferingPixel();
        m_playhead->pick(pixel);
        QCoreApplication::processEvents();

        const QImage picture = grabbed(*m_window, u"compare"_s);

        auto *map = named<AgreementView>(*m_panel, "agreementMap");
        const QImage cells = map->grab().toImage();
        const QColor expected = agreementColour(
            m_panel->contest()->agreement.agreeingAt(pixel.x(), pixel.y()), 3, map->palette());
        bool found = false;
        for (int y = 0; y < cells.height() && !found; ++y) {
            for (int x = 0; x < cells.width() && !found; ++x)
                found = cells.pixelColor(x, y) == expected;
        }
        QVERIFY(found);
    }

private:
    void open()
    {
        action(*m_window, "compareDockToggle")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(m_panel->contest() && !m_panel->isRunning(), 20000);
        QCoreApplication::processEvents();
    }
    QPoint firstDifferingPixel() const
    {
        const AgreementMap &agreement = m_panel->contest()->agreement;
        for (int x = 0; x < agreement.spec().width; ++x) {
            for (int y = 0; y < agreement.spec().height; ++y) {
                const Disagreement reason = agreement.reasonAt(x, y);
                if (reason == Disagreement::Drift || reason == Disagreement::Rounding)
                    return {x, y};
            }
        }
        return {-1, -1};
    }

    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
    ComparePanel *m_panel = nullptr;
    Playhead *m_playhead = nullptr;
};

PIXELPLUMB_TEST(TestComparePanel)

} // namespace tst_comparepanel

#include "tst_comparepanel.moc"
