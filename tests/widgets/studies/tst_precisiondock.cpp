// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/bounderrors.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/model/playhead.h"
#include "widgets/studies/accuracy/precisionpanel.h"
#include "widgets/studies/accuracy/precisionplot.h"

#include <QTest>
#include <QtWidgets>
#include <qcustomplot.h>

#include <cmath>
#include <set>

namespace tst_precisiondock {

using namespace pixelplumb;

class TestPrecisionDock : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_settings.clear();
        m_window = openedWindow(u"ties-at-tenths.json"_s);
        m_panel = named<PrecisionPanel>(*m_window, "precision");
        m_playhead = m_window->parts().playhead;
    }
    void cleanup() { m_window.reset(); }

    void scalesErrorsByDecadesWithATrueZero()
    {
        const PrecisionScale scale(3e-7, 0.5);

        QCOMPARE(scale.leastExponent(), -8);
        QCOMPARE(scale.largestExponent(), 0);
        QCOMPARE(scale.toAxis(0), 0.0);
        QCOMPARE(scale.toAxis(1e-8), 1.0);
        QCOMPARE(scale.toAxis(-1e-3), -6.0);
        QCOMPARE(scale.toAxis(1), scale.extent());
        double before = scale.toAxis(-2);
        for (const double error : {-0.5, -1e-8, -1e-9, 0.0, 1e-9, 1e-8, 1e-7, 2.0}) {
            QVERIFY(scale.toAxis(error) > before);
            before = scale.toAxis(error);
        }
        bool hasZero = false;
        for (const PrecisionScale::Tick &tick : scale.ticks(4))
            hasZero = hasZero || (tick.axis == 0 && tick.label == u"0"_s);
        QVERIFY(hasZero);
    }

    void staysWithinTheBoundOfFixedPoint()
    {
        const auto all = boundErrorsOf(m_playhead->traced()->scene, 0);

        QCOMPARE(all->size(), std::size_t(4));
        for (const BoundErrors &errors : *all) {
            if (errors.arithmetic != Arithmetic::Fixed16
                && errors.arithmetic != Arithmetic::Fixed32)
                continue;
            for (const BoundError &error : errors.spans) {
                QVERIFY(std::abs(error.lower) <= error.limit);
                QVERIFY(std::abs(error.upper) <= error.limit);
            }
        }
        QCOMPARE(errorLimit(Arithmetic::Fixed16, 10, 1, 1), 11 * std::ldexp(1.0, -17));
        QCOMPARE(errorLimit(Arithmetic::Fixed32, 10, 1, 1), 11 * std::ldexp(1.0, -33));
        QCOMPARE(errorLimit(Arithmetic::Float32, 2, 1024.0, 0), std::ldexp(1.0, -13));
        QCOMPARE(errorLimit(Arithmetic::Float64, 2, 1024.0, 0), std::ldexp(1.0, -42));
    }

    void aBoundIsWrongWhereItsOwnEndOfTheSpanIs()
    {
        const TracedScene &traced = *m_playhead->traced();
        const auto all = boundErrorsOf(traced.scene, 0);
        const auto errors
            = std::ranges::find(*all, traced.scene.settings.arithmetic, &BoundErrors::arithmetic);

        std::set<std::int64_t> lower;
        std::set<std::int64_t> upper;
        for (const BoundError &error : errors->spans) {
            if (error.isLowerWrong)
                lower.insert(error.place.coordinate);
            if (error.isUpperWrong)
                upper.insert(error.place.coordinate);
        }
        // The lost pixels are the highest of their columns.
        QVERIFY(lower.empty());
        QCOMPARE(upper, (std::set<std::int64_t>{11, 21}));
        std::set<std::int64_t> lost;
        for (int x = 0; x < traced.scene.frame.width; ++x) {
            for (int y = 0; y < traced.scene.frame.height; ++y) {
                if (traced.differences.at(x, y) == Difference::Missing)
                    lost.insert(x);
            }
        }
        QCOMPARE(upper, lost);
    }

    void stopsWhenItIsToldAndHasNothingForATriangleThatIsNotThere()
    {
        const Scene &scene = m_playhead->traced()->scene;
        QVERIFY(boundErrorsOf(scene, 7)->empty()); // there is no such triangle
        QVERIFY(!boundErrorsOf(scene, 0, [](const JobProgress &) { return false; }));
    }

    void plotsEveryArithmeticOfTheMethodThatIsNotHidden()
    {
        open();

        QCOMPARE(m_panel->plot()->curveCount(), 4);
        const QString summary = named<QLabel>(*m_panel, "precisionSummary")->text();
        QVERIFY2(summary.contains(u"float32: at most"_s), qPrintable(summary));
        QVERIFY(m_window->parts().canvas->isVisible());

        QTest::mouseClick(named<QToolButton>(*m_panel, "precision_fixed16.16"), Qt::LeftButton);
        QCOMPARE(m_panel->plot()->curveCount(), 3);
    }

    void noLineGoesThroughALabel()
    {
        open();
        const auto *plot = m_panel->plot()->findChild<QCustomPlot *>();
        int labels = 0;
        for (int i = 0; i < plot->itemCount(); ++i) {
            const auto *label = qobject_cast<const QCPItemText *>(plot->item(i));
            if (!label)
                continue;
            QVERIFY2(label->brush().isOpaque(), qPrintable(label->text()));
            QCOMPARE(label->layer()->name(), "overlay"); // above all lines
            ++labels;
        }
        QVERIFY(labels > 2); // of both fences, and of a first wrong column
    }

    void aClickGoesToTheColumn()
    {
        open();
        QWidget *plot = m_panel->plot()->findChild<QWidget *>();
        const QPoint place
            = plot->mapFrom(m_panel->plot(), m_panel->plot()->positionOf(37).toPoint());

        QTest::mouseClick(plot, Qt::LeftButton, {}, place);

        QVERIFY(m_playhead->currentColumnX());
        QVERIFY(std::abs(*m_playhead->currentColumnX() - 37) <= 1);
    }

    void looksRightInBothPalettes_data() { addPalettes(); }
    void looksRightInBothPalettes()
    {
        QFETCH(QPalette, palette);
        qApp->setPalette(palette);
        open();

        grabbed(*m_window, u"precision"_s);
        QTRY_COMPARE(readingFault(*m_panel->plot()), QString());
        QTRY_COMPARE(readingFault(*m_panel), QString());
    }

private:
    void open()
    {
        action(*m_window, "precisionDockToggle")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!m_panel->errors().empty() && !m_panel->isRunning(), 20000);
        QCoreApplication::processEvents();
    }

    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
    PrecisionPanel *m_panel = nullptr;
    Playhead *m_playhead = nullptr;
};

PIXELPLUMB_TEST(TestPrecisionDock)

} // namespace tst_precisiondock

#include "tst_precisiondock.moc"
