// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/casecheck.h"
#include "core/runs/scenerun.h"
#include "core/scene/scenefile.h"
#include "tests/support/caselist.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/shapeexamples.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_strokeplans {

using namespace pixelplumb;

namespace {

Scene sceneOf(const Shape &shape, Antialiasing antialiasing)
{
    Scene scene;
    scene.frame = frameOf(12, 8);
    scene.method = "stroke-coverage";
    scene.shapes = {shape};
    scene.appearance.antialiasing = antialiasing;
    return scene;
}

} // namespace

/// Which methods antialias lines and curves, and which say that they do not.
class TestStrokePlans : public QObject {
    Q_OBJECT

private slots:
    void aLineMethodRefusesAntialiasingAndNamesTheOneThatCan()
    {
        Scene scene = sceneOf(lineAt(1, 1, 9, 4), Antialiasing::Samples4);
        QCOMPARE(objectionTo(scene), QString());
        for (const char *id : {"line-dda", "line-bresenham", "line-slope-intercept"}) {
            scene.method = id;
            QVERIFY2(objectionTo(scene).contains(QStringLiteral("stroke-coverage can")), id);
        }
        scene.shapes = {lineAt(100, 100, 109, 104)};
        QCOMPARE(objectionTo(scene), QString());
        scene.shapes = {circleAt(4, 4, 2, ShapeFill::NonZero)};
        scene.method = "circle-fill";
        QCOMPARE(objectionTo(scene), QString());
    }

    void aPlanSaysThatLinesAreAntialiased()
    {
        const Scene scene = sceneOf(lineAt(1, 1, 9, 4), Antialiasing::Area);
        const EffectVerdict verdict = planOf(SceneRun(scene)).verdicts[Effect::Antialiasing];
        QCOMPARE(verdict.verdict, Verdict::CalledFor);
        QCOMPARE(verdict.primitives, std::size_t(1));
        QVERIFY(verdict.pixels < 12 * 8);
        QCOMPARE(verdict.reason,
                 QStringLiteral("the scene asks for the exact area of each pixel that a line or "
                                "curve covers"));
    }

    void whatIsNotDrawnOfLinesRunsNothing_data()
    {
        QTest::addColumn<Shape>("stroke");
        QTest::newRow("a point") << lineAt(3, 3, 3, 3);
        // Its border is in the frame, but none of its samples are.
        Shape low = lineAt(1, 8, 8, 8);
        for (Vertex &vertex : low.vertices)
            vertex.position.y -= unitsPerPixel * 3 / 32;
        QTest::newRow("a line at the frame's border") << low;
        Shape curve;
        curve.kind = PrimitiveKind::Bezier;
        curve.vertices.assign(3, {latticePixel(3, 3), {}});
        QTest::newRow("a curve without length") << curve;
    }
    void whatIsNotDrawnOfLinesRunsNothing()
    {
        QFETCH(Shape, stroke);
        stroke.vertices.back().colour = {{1, 2, 3}};
        const EffectPlan plan = planOf(SceneRun(sceneOf(stroke, Antialiasing::Samples4)));
        for (const Effect effect : allEffects) {
            QVERIFY2(!plan.runs(effect), nameOf(effect).data());
            QCOMPARE(plan.verdicts[effect].verdict, Verdict::NotCalledFor);
            QVERIFY2(plan.verdicts[effect].reason.contains(u"drawn in the frame"),
                     qPrintable(plan.verdicts[effect].reason));
        }
    }

    /// The line lies between the four samples of its pixel: without antialiasing it would be drawn.
    void aShortLineNeedsOnlyAntialiasing()
    {
        Shape line = lineAt(3, 3, 3, 3);
        line.vertices[1].position.x += unitsPerPixel / 16;
        line.vertices[1].colour = {{1, 2, 3}};
        const EffectPlan plan = planOf(SceneRun(sceneOf(line, Antialiasing::Samples4)));
        for (const Effect effect : allEffects)
            QCOMPARE(plan.runs(effect), effect == Effect::Antialiasing);
    }

    void aSceneOfLinesThatNamesNoMethodGetsTheOneThatCan()
    {
        const QByteArray line = shapeExamples()[1].text;
        const QByteArray curve = shapeExamples()[5].text;
        const QByteArray antialiased = "\"antialiasing\": \"area\",";
        QCOMPARE(readScene(sceneOfPrimitives(line, antialiased))->scene.method,
                 std::string("stroke-coverage"));
        QCOMPARE(readScene(sceneOfPrimitives(curve, antialiased))->scene.method,
                 std::string("stroke-coverage"));
        QCOMPARE(readScene(sceneOfPrimitives(line))->scene.method, std::string("line-dda"));
        // No line method supports this rule.
        const Result<SceneReading> ruled
            = readScene(sceneOfPrimitives(line, antialiased + "\"fillRule\": \"top-left\","));
        QVERIFY(!ruled);
        QVERIFY2(ruled.error().message().contains(u"one does without the fill rule"),
                 qPrintable(ruled.error().message()));
    }

    void theLinesAndCirclesOfTheHardCasesAreTheTruth()
    {
        const std::vector<HardCase> cases = casesOf(testData("shape_cases.json"));
        int checked = 0;
        for (const HardCase &hardCase : fewerIfSanitized(cases)) {
            const CaseReport report = checkCase(
                hardCase, {contenderFor(*methodNamed(u"stroke-coverage"), ScanSettings{})});
            if (report.verdicts.empty())
                continue;
            QVERIFY2(report.summary() == CaseOutcome::Passed, qPrintable(hardCase.id));
            ++checked;
        }
        QCOMPARE(checked, fewerIfSanitized(24));
    }
};

PIXELPLUMB_TEST(TestStrokePlans)

} // namespace tst_strokeplans

#include "tst_strokeplans.moc"
