// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/idlesetting.h"
#include "core/runs/scenerun.h"
#include "core/runs/tracedscene.h"
#include "tests/support/scenes/scenesformethods.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_idlesettings {

using namespace pixelplumb;

namespace {

QImage drawn(Scene scene, ByteRounding rounding)
{
    scene.settings.rounding = rounding;
    const FrameBuffer frame(scene.frame);
    drawScene(scene, frame);
    return frame.image().copy();
}

bool roundingMatters(const Scene &scene)
{
    return drawn(scene, ByteRounding::Nearest) != drawn(scene, ByteRounding::Truncate);
}

/// The scene by a method, under the settings that the method supports.
Scene by(const Method &method, Scene scene)
{
    scene.method = method.id.toStdString();
    scene.settings = method.adapted(scene.settings);
    return scene;
}

Scene lineScene(const Colour &from, const Colour &to)
{
    Shape line = lineAt(1, 1, 12, 6);
    line.vertices[0].colour = from;
    line.vertices[1].colour = to;
    return sceneOf(line, "line-bresenham", frameOf(16, 12));
}

} // namespace

/// A setting that is said to change nothing changes nothing.
class TestIdleSettings : public QObject {
    Q_OBJECT

private slots:
    void whatIsIdleChangesNoPictureAndWhatIsNotMay_data()
    {
        QTest::addColumn<QString>("id");
        for (const Method &method : methods())
            QTest::newRow(qPrintable(method.id)) << method.id;
    }
    void whatIsIdleChangesNoPictureAndWhatIsNotMay()
    {
        QFETCH(QString, id);
        const Method &method = *methodNamed(id);
        for (const auto &[name, example] : scenesForEveryMethod()) {
            const Scene scene = by(method, example);
            const bool hasOneArithmetic = method.arithmetics.size() == 1;
            QCOMPARE(!idleReason(DrawingSetting::Arithmetic, scene).isEmpty(), hasOneArithmetic);
            QCOMPARE(!idleReason(DrawingSetting::FillRule, scene).isEmpty(),
                     method.fillRules.size() == 1);
            if (objectionTo(scene).isEmpty()
                && !idleReason(DrawingSetting::Rounding, scene).isEmpty())
                QVERIFY2(!roundingMatters(scene), qPrintable(name));
        }
    }

    void roundingIsIdleForALineInOneColourAlone()
    {
        const Scene even = lineScene({{10, 20, 30}}, {{10, 20, 30}});
        const Scene smooth = lineScene({{10, 20, 30}}, {{200, 20, 31}});

        QVERIFY(!roundingMatters(even));
        QVERIFY(idleReason(DrawingSetting::Rounding, even).contains("one colour"));
        QVERIFY(roundingMatters(smooth));
        QCOMPARE(idleReason(DrawingSetting::Rounding, smooth), QString());
    }

    void aReasonSaysWhy()
    {
        const Scene line = lineScene({{10, 20, 30}}, {{10, 20, 30}});
        QCOMPARE(idleReason(DrawingSetting::FillRule, line),
                 u"keeps the fill rule “closed” alone: a line has no inside that an "
                 "edge could bound"_s);
        QCOMPARE(idleReason(DrawingSetting::Arithmetic, line), u"computes in “exact” alone"_s);
    }

    void nothingIsIdleBeforeSomethingIsDrawn()
    {
        Scene scene;
        scene.method = "circle-midpoint";
        QCOMPARE(idleReason(DrawingSetting::Rounding, scene), QString());
        scene.method = "no-such-method";
        QCOMPARE(idleReason(DrawingSetting::FillRule, scene), QString());
    }
};

PIXELPLUMB_TEST(TestIdleSettings)

} // namespace tst_idlesettings

#include "tst_idlesettings.moc"
