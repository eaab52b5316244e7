// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "tests/support/scenes/effectchanges.h"
#include "tests/support/testprogram.h"

#include <QtTest>

namespace tst_effectplan {

using namespace pixelplumb;

namespace {

/// "plain", "smooth blending", …
QString textOf(const EffectSet &effects)
{
    QStringList words;
    const auto addIf = [&words](bool isThere, const char *word) {
        if (isThere)
            words.append(QString::fromLatin1(word));
    };
    addIf(effects.smooth, "smooth");
    addIf(effects.perspective, "perspective");
    addIf(effects.texture, "texture");
    addIf(effects.light, "light");
    addIf(effects.blending, "blending");
    addIf(effects.depth == DepthTest::Number, "depth");
    addIf(effects.depth == DepthTest::Levels, "depth-levels");
    return words.isEmpty() ? QStringLiteral("plain") : words.join(u' ');
}

/// "0+2 plain, 2+1 smooth"
QString textOf(const std::vector<EffectBatch> &batches)
{
    QStringList words;
    for (const EffectBatch &batch : batches)
        words.append(QStringLiteral("%1+%2 %3")
                         .arg(batch.first)
                         .arg(batch.count)
                         .arg(textOf(batch.effects)));
    return words.join(QStringLiteral(", "));
}

} // namespace

/// Which effects a plan runs, and for which triangles.
class TestEffectPlan : public QObject {
    Q_OBJECT

private slots:
    void batchesAreRunsOfTheSameNeeds_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("batches");
        const auto add = [](const char *name, const Change &change, const char *batches) {
            QTest::newRow(name) << change << QString::fromLatin1(batches);
        };
        add(
            "nothing", [](Primitives &p) { p.triangles.clear(); }, "");
        add(
            "plain", [](Primitives &) {}, "0+2 plain");
        add(
            "one smooth", [](Primitives &p) { setColour(p, 1); }, "0+1 plain, 1+1 smooth");
        add(
            "glass before a wall", [](Primitives &p) { setAlpha(p, 0, 1); },
            "0+1 blending, 1+1 plain");
        add(
            "outside joins what stands before it",
            [](Primitives &p) {
                p.triangles.insert(p.triangles.begin() + 1,
                                   triangleAt({{{-9, 2}, {-2, 2}, {-9, 10}}}));
                p.triangles[1].vertices[0].colour = {};
                setAlpha(p, 2, 1);
            },
            "0+2 plain, 2+1 blending");
        add(
            "outside at the beginning joins what follows",
            [](Primitives &p) {
                p.triangles[0] = triangleAt({{{-9, 2}, {-2, 2}, {-9, 10}}});
                setAlpha(p, 0, 1);
                setColour(p, 1);
            },
            "0+2 smooth");
        const Change crossing = [](Primitives &p) {
            overlap(p);
            setDepths(p, 0, {1, 1, 1});
            setDepths(p, 1, {2, 2, 2});
        };
        add("depth where it is in question", crossing, "0+2 depth");
        add(
            "depth in levels",
            [=](Primitives &p) {
                crossing(p);
                p.appearance.depthFormat = DepthFormat::Bits16;
            },
            "0+2 depth-levels");
        add(
            "no depth where it is not in question",
            [=](Primitives &p) {
                crossing(p);
                p.triangles.push_back(triangleAt({{{22, 2}, {30, 2}, {22, 10}}}));
                setAlpha(p, 2, 7);
            },
            "0+2 depth, 2+1 blending");
        add(
            "depth parts a run",
            [=](Primitives &p) {
                crossing(p);
                p.triangles.push_back(triangleAt({{{22, 2}, {30, 2}, {22, 10}}}));
            },
            "0+2 depth, 2+1 plain");
        add(
            "a segment in depth",
            [](Primitives &p) {
                p.triangles[1] = triangleAt({{{2, 2}, {4, 4}, {5, 5}}});
                setDepths(p, 1, {1, 1, 1});
            },
            "0+2 depth");
    }
    void batchesAreRunsOfTheSameNeeds()
    {
        QFETCH(Change, change);
        QFETCH(QString, batches);

        QCOMPARE(textOf(planOf(changed(change)).batches), batches);
    }

    void forcingTakesAnEffectIntoEveryBatchOrOutOfIt_data()
    {
        QTest::addColumn<Effect>("effect");
        QTest::addColumn<Forcing>("forcing");
        QTest::addColumn<QString>("batches");
        const auto add = [](const char *name, Effect effect, Forcing forcing, const char *batches) {
            QTest::newRow(name) << effect << forcing << QString::fromLatin1(batches);
        };
        add("as called for", Effect::Depth, Forcing::AsCalledFor,
            "0+1 texture light, 1+1 smooth blending");
        add("smooth on", Effect::SmoothColour, Forcing::On,
            "0+1 smooth texture light, 1+1 smooth blending");
        add("smooth off", Effect::SmoothColour, Forcing::Off, "0+1 texture light, 1+1 blending");
        add("depth on", Effect::Depth, Forcing::On,
            "0+1 texture light depth, 1+1 smooth blending depth");
        add("perspective on", Effect::Perspective, Forcing::On,
            "0+1 perspective texture light, 1+1 smooth perspective blending");
        add("texture on, where there are texels", Effect::Texture, Forcing::On,
            "0+1 texture light, 1+1 smooth blending");
        add("texture off", Effect::Texture, Forcing::Off, "0+1 light, 1+1 smooth blending");
        add("light on, where there are normals", Effect::Light, Forcing::On,
            "0+1 texture light, 1+1 smooth blending");
        add("light off", Effect::Light, Forcing::Off, "0+1 texture, 1+1 smooth blending");
        add("blending on", Effect::Blending, Forcing::On,
            "0+1 texture light blending, 1+1 smooth blending");
        add("blending off", Effect::Blending, Forcing::Off, "0+1 texture light, 1+1 smooth");
        add("clipping has no switch", Effect::Clipping, Forcing::Off,
            "0+1 texture light, 1+1 smooth blending");
    }
    void forcingTakesAnEffectIntoEveryBatchOrOutOfIt()
    {
        QFETCH(Effect, effect);
        QFETCH(Forcing, forcing);
        QFETCH(QString, batches);
        Primitives primitives = plain();
        setTexture(primitives, 0);
        setLight(primitives, 0);
        setAlpha(primitives, 1, 9);
        setColour(primitives, 1);
        const PerEffect<EffectVerdict> unforced = planOf(primitives).verdicts;

        primitives.appearance.forced[effect] = forcing;
        const EffectPlan plan = planOf(primitives);

        QCOMPARE(textOf(plan.batches), batches);
        for (const Effect each : allEffects)
            QCOMPARE(plan.verdicts[each].reason, unforced[each].reason);
    }

    void forcedAntialiasingMeansFourSamples()
    {
        Primitives primitives = plain();
        primitives.appearance.forced[Effect::Antialiasing] = Forcing::On;
        QCOMPARE(int(planOf(primitives).antialiasing), int(Antialiasing::Samples4));
        QVERIFY(planOf(primitives).runs(Effect::Antialiasing));

        primitives.appearance.antialiasing = Antialiasing::Area;
        QCOMPARE(int(planOf(primitives).antialiasing), int(Antialiasing::Area));

        primitives.appearance.forced[Effect::Antialiasing] = Forcing::Off;
        QCOMPARE(int(planOf(primitives).antialiasing), int(Antialiasing::None));
        QVERIFY(!planOf(primitives).runs(Effect::Antialiasing));
    }

    void antialiasingThatChangesNothingDoesNotRun()
    {
        Primitives primitives = plain();
        primitives.triangles = {triangleAt({{{-200, -100}, {400, -100}, {-200, 500}}})};
        for (const Antialiasing asked :
             {Antialiasing::Samples4, Antialiasing::Samples16, Antialiasing::Area}) {
            primitives.appearance.antialiasing = asked;
            primitives.appearance.forced = {};
            QVERIFY(!planOf(primitives).runs(Effect::Antialiasing));
            primitives.appearance.forced[Effect::Antialiasing] = Forcing::On;
            QVERIFY(planOf(primitives).runs(Effect::Antialiasing));
        }
    }

    void smoothColourRunsOnLinesUntilItIsForcedOff()
    {
        Primitives primitives;
        primitives.shapes = {smoothLine()};
        QVERIFY(planOf(primitives).runs(Effect::SmoothColour));
        primitives.appearance.forced[Effect::SmoothColour] = Forcing::Off;
        QVERIFY(!planOf(primitives).runs(Effect::SmoothColour));
        QCOMPARE(planOf(primitives).verdicts[Effect::SmoothColour].verdict, Verdict::CalledFor);
    }

    void lightOfFlatAndGouraudShadingRunsInSetUpAlone()
    {
        Primitives primitives = plain();
        setLight(primitives, 0);
        for (const Shading shading : {Shading::Flat, Shading::Gouraud}) {
            primitives.appearance.shading = shading;
            primitives.appearance.forced = {};
            QVERIFY(planOf(primitives).runs(Effect::Light));
            QVERIFY(!planOf(primitives).runsOnTriangles(Effect::Light));
            primitives.appearance.forced[Effect::Light] = Forcing::Off;
            QVERIFY(!planOf(primitives).runs(Effect::Light));
        }
    }

    void anyPrimitivesHaveAPlan()
    {
        Primitives primitives = plain();
        const LatticePoint far = {largestCoordinate, largestCoordinate};
        primitives.triangles.push_back(triangleAt({{{5, 5}, {5, 5}, {5, 5}}}));
        primitives.triangles.push_back(primitives.triangles[0]);
        primitives.triangles.back().vertices[2].position = far;
        primitives.triangles.push_back(primitives.triangles.back());
        primitives.triangles.back().vertices[1].position = {-far.x, far.y};
        for (std::size_t i = 0; i < primitives.triangles.size(); ++i) {
            for (VertexAttributes &vertex : attributesAt(primitives, i).vertices)
                vertex.z = i % 2 == 0 ? largestAttribute : -largestAttribute;
        }
        attributesAt(primitives, 1).material = 5; // there is no such material
        attributesAt(primitives, 2).vertices[1].z = 0;
        Shape empty;
        primitives.shapes = {empty};

        for (const Antialiasing antialiasing :
             {Antialiasing::None, Antialiasing::Samples4, Antialiasing::Area}) {
            primitives.appearance.antialiasing = antialiasing;
            std::size_t count = 0;
            for (const EffectBatch &batch : planOf(primitives).batches) {
                QCOMPARE(batch.first, count);
                count += batch.count;
            }
            QCOMPARE(count, primitives.triangles.size());
        }
    }

    /// A point is its first vertex; a segment ignores its middle vertex, wherever it is listed.
    void aPointAndASegmentNeedWhatTheirEndsHave()
    {
        Primitives point;
        point.triangles = {triangleAt({{{2, 2}, {2, 2}, {2, 2}}})};
        point.triangles[0].vertices[1].colour = {{0, 255, 0}};
        for (std::size_t i = 0; i < 3; ++i) {
            VertexAttributes &vertex = attributesAt(point, 0).vertices[i];
            vertex.w = attributeOne << i;
            vertex.alpha = std::uint8_t(255 >> i);
        }
        const EffectPlan plan = planOf(point);
        for (const Effect effect : {Effect::SmoothColour, Effect::Perspective, Effect::Blending})
            QCOMPARE(plan.verdicts[effect].verdict, Verdict::NotCalledFor);

        const Colour red = {{255, 0, 0}};
        const Colour white = {{255, 255, 255}};
        std::array<Vertex, 3> vertices
            = {{{latticePixel(0, 0), red}, {latticePixel(2, 2), white}, {latticePixel(4, 4), red}}};
        std::array<int, 3> order = {0, 1, 2};
        do {
            Primitives segment;
            segment.triangles.resize(1);
            for (std::size_t i = 0; i < 3; ++i)
                segment.triangles[0].vertices[i] = vertices[std::size_t(order[i])];
            QCOMPARE(planOf(segment).verdicts[Effect::SmoothColour].verdict, Verdict::NotCalledFor);
            segment.appearance.forced[Effect::SmoothColour] = Forcing::Off;
            segment.appearance.antialiasing = Antialiasing::Area;
            const FrameBuffer frame(frameOf(6, 6));
            Run(methodNamed(u"column-scan"), segment, {}, frame.view()).draw(frame.view());
            QCOMPARE(*frame.view().at(2, 2), packed(red));
        } while (std::ranges::next_permutation(order).found);
    }

    void antialiasingIsNotForcedWhereNothingCanHaveIt()
    {
        Primitives primitives;
        Shape polygon = smoothLine();
        polygon.kind = PrimitiveKind::Polygon;
        polygon.vertices.push_back({latticePixel(5, 20), {}});
        primitives.shapes = {polygon};
        Primitives outside;
        outside.triangles = {triangleAt({{{-9, 0}, {-2, 0}, {-9, 6}}})};
        for (Primitives *each : {&primitives, &outside}) {
            for (const Antialiasing antialiasing : {Antialiasing::None, Antialiasing::Area}) {
                each->appearance.antialiasing = antialiasing;
                each->appearance.forced[Effect::Antialiasing] = Forcing::On;
                QVERIFY(!planOf(*each).runs(Effect::Antialiasing));
            }
        }
    }

    void whatIsForcedOffIsNotDivided()
    {
        Primitives primitives;
        primitives.triangles = {triangleAt({{{0, 0}, {6, 0}, {0, 6}}})};
        primitives.triangles[0].vertices[1].colour = {{0, 255, 0}};
        attributesAt(primitives, 0).vertices[1].w = 2 * attributeOne;
        QVERIFY(planOf(primitives).runs(Effect::Perspective));
        primitives.appearance.forced[Effect::SmoothColour] = Forcing::Off;
        QCOMPARE(planOf(primitives).verdicts[Effect::Perspective].verdict, Verdict::NotCalledFor);
    }

    /// Nothing of a triangle is drawn beyond its horizon, and only perspective knows where that is.
    void whatLiesBeyondItsHorizonKeepsItsPerspective()
    {
        Primitives primitives;
        primitives.triangles
            = {triangleAt({{{9, 0}, {9, 2}, {1, 1}}}), triangleAt({{{0, 0}, {1, 0}, {0, 1}}})};
        primitives.triangles[0].vertices[2].position.x += unitsPerPixel * 3 / 8;
        primitives.triangles[0].vertices[2].colour = {{255, 0, 0}};
        attributesAt(primitives, 0).vertices[2].w = 64 * attributeOne;
        primitives.appearance.antialiasing = Antialiasing::Area;
        const FrameBuffer frame(frameOf(2, 2));
        const EffectPlan plan = planFor(primitives, ScanSettings(), frame.view());

        QCOMPARE(textOf(plan.batches), QStringLiteral("0+1 smooth perspective, 1+1 plain"));
        QCOMPARE(plan.batches[0].unseen, std::size_t(0));
        QCOMPARE(plan.verdicts[Effect::Perspective].verdict, Verdict::CalledFor);
    }
};

PIXELPLUMB_TEST(TestEffectPlan)

} // namespace tst_effectplan

#include "tst_effectplan.moc"
