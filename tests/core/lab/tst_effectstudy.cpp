// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/effectloop.h"
#include "core/lab/study/effectstudy.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>

namespace tst_effectstudy {

using namespace pixelplumb;

/// The errors in the effect study; its times are not checked.
class TestEffectStudy : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const auto rows = runEffectStudy(0);
        QVERIFY(rows);
        m_rows = *rows;
    }

    void withoutRoundsNothingIsTimed()
    {
        QVERIFY(std::ranges::none_of(m_rows, [](const EffectRow &row) {
            return row.perPixel.has_value() || row.timesFirst.has_value();
        }));
    }

    void moreSamplesComeNearerToTheExactAreaAndTheAreaIsIt()
    {
        const double one = row("antialiasing", "1 sample").rms;
        const double four = row("antialiasing", "4 samples").rms;
        const double sixteen = row("antialiasing", "16 samples").rms;
        QVERIFY2(one > 2 * four && four > sixteen && sixteen > 0,
                 qPrintable(u"%1, %2, %3"_s.arg(one).arg(four).arg(sixteen)));
        QCOMPARE(row("antialiasing", "exact area").rms, 0.0);
        QCOMPARE(row("antialiasing", "exact area").wrongPixels, 0);
    }

    void moreBitsOfDepthLeaveFewerPixelsWrong()
    {
        const auto wrong = [this](const char *way) { return row("depth buffer", way).wrongPixels; };
        QVERIFY(wrong("none: drawing order") > wrong("16 bits"));
        QVERIFY(wrong("16 bits") > wrong("24 bits"));
        QVERIFY(wrong("24 bits") >= wrong("32 bits"));
        QCOMPARE(wrong("the kernel's number"), 0);
    }

    void affineTexturesAreWrongAndPerspectiveIsTheTruth()
    {
        QVERIFY(row("perspective", "affine").wrongPixels > 500);
        QCOMPARE(row("perspective", "perspective").wrongPixels, 0);
    }

    void surfacesOfMoreSegmentsAreNearer()
    {
        for (const char *surface : {"sphere", "patch"}) {
            double last = 1e9;
            for (const char *way : {"8 segments", "16 segments", "32 segments", "64 segments"}) {
                const double distance = row(surface, way).distance.value();
                // Twice as many chords have a quarter of the sagitta.
                QVERIFY2(distance < last / 3, surface);
                last = distance;
            }
        }
    }

    void effectsThatChangeNothingChangeNothing()
    {
        int seen = 0;
        for (const EffectRow &each : m_rows) {
            if (each.group != u"neutral effects"_s || each.arithmetic != Arithmetic::Exact)
                continue;
            QVERIFY2(each.wrongPixels == 0, qPrintable(each.way));
            ++seen;
        }
        QCOMPARE(seen, 5);
    }

    void aLineOfOnePixelAColumnIsDarkestAt45Degrees()
    {
        const auto range = brightnessRangeOf(m_rows, u"lines, Bresenham"_s);
        QVERIFY(range);
        QCOMPARE(range->greatest, 1.0);
        QCOMPARE(range->greatest / range->least, std::sqrt(2.0));
        QCOMPARE(*row("lines, Bresenham", "45°").brightness, range->least);
    }

    void aLineByItsAreaIsEquallyBrightInEveryDirection()
    {
        const QString group = u"lines, exact area"_s;
        const auto range = brightnessRangeOf(m_rows, group);
        QVERIFY(range);
        std::int64_t most = 0;
        for (const EffectRow &each : m_rows) {
            if (each.group == group)
                most = std::max(most, each.pixels);
        }
        // Each pixel's byte is off by up to half a level, both in the whole line and in its half,
        // and the area itself by one part in 2^15.5.
        constexpr double length = 60;
        const double bound = 1.5 * double(most) * 0.5 / 255 / (length - 1) + std::exp2(-15.5);
        QVERIFY2(range->least > 1 - bound && range->greatest < 1 + bound,
                 qPrintable(u"%1 to %2"_s.arg(range->least).arg(range->greatest)));
        QVERIFY(bound < 0.05);
        QCOMPARE(row("lines, exact area", "30°").wrongPixels, 0);
    }

    void eachKernelDrawsTheBytesOfItsStraightLoop()
    {
        for (const EffectLoop &loop : effectLoops()) {
            const QByteArray group = QByteArray("kernel of ") + loop.name;
            const EffectRow &straight
                = row(group.constData(), "straight loop", Arithmetic::Float32);
            const EffectRow &kernel = row(group.constData(), "kernel", Arithmetic::Float32);
            QVERIFY2(straight.wrongPixels == 0 && kernel.wrongPixels == 0, loop.name);
            QVERIFY2(kernel.pixels > effectLoopSide * effectLoopSide / 2, loop.name);
        }
    }

    void eachStraightLoopHasTheEffectsOfItsName_data()
    {
        QTest::addColumn<EffectSet>("effects");
        QTest::addColumn<Antialiasing>("antialiasing");
        const auto add = [](const char *name, const EffectSet &effects) {
            QTest::newRow(name) << effects << Antialiasing::None;
        };
        add("depth", {.depth = DepthTest::Number});
        add("depth, 24 bits", {.depth = DepthTest::Levels});
        add("perspective, texture", {.perspective = true, .texture = true});
        add("perspective, filtered texture, depth",
            {.perspective = true, .texture = true, .depth = DepthTest::Number});
        add("light", {.light = true});
        add("blending", {.blending = true});
        QTest::newRow("4 samples") << EffectSet{} << Antialiasing::Samples4;
    }
    void eachStraightLoopHasTheEffectsOfItsName()
    {
        QFETCH(EffectSet, effects);
        QFETCH(Antialiasing, antialiasing);
        const std::span<const EffectLoop> loops = effectLoops();
        const auto loop = std::ranges::find_if(loops, [](const EffectLoop &each) {
            return QLatin1String(each.name) == QLatin1String(QTest::currentDataTag());
        });
        QVERIFY(loop != loops.end());
        const EffectLoopScene scene(*loop);
        QCOMPARE(scene.run.plan->batches.size(), std::size_t(1));
        QVERIFY(scene.run.plan->batches[0].effects == effects);
        QCOMPARE(scene.run.antialiasing(), antialiasing);
    }

    void aKernelFarBehindItsLoopIsMarked()
    {
        EffectRow kernel = row("kernel of light", "kernel", Arithmetic::Float32);
        QVERIFY(!kernel.isTooSlow());
        kernel.timesFirst = Spread{1, 1.29, 2};
        QVERIFY(!kernel.isTooSlow());
        kernel.timesFirst = Spread{1, 1.31, 2};
        QVERIFY(kernel.isTooSlow());
        kernel.group = u"antialiasing"_s;
        QVERIFY(!kernel.isTooSlow());
    }

    void aListenerEndsIt()
    {
        QVERIFY(!runEffectStudy(3, [](const JobProgress &progress) { return progress.done < 2; }));
    }

private:
    const EffectRow &row(const char *group, const char *way,
                         Arithmetic arithmetic = Arithmetic::Exact) const
    {
        const auto found = std::ranges::find_if(m_rows, [&](const EffectRow &each) {
            return each.group == QLatin1String(group) && each.way == QString::fromUtf8(way)
                && each.arithmetic == arithmetic;
        });
        if (found == m_rows.end())
            qFatal("no row %s, %s", group, way);
        return *found;
    }

    std::vector<EffectRow> m_rows;
};

PIXELPLUMB_TEST(TestEffectStudy)

} // namespace tst_effectstudy

#include "tst_effectstudy.moc"
