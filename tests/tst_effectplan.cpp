// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/effectplan.h"
#include "tests/support/framespec.h"
#include "tests/support/plannedtriangles.h"

#include <QtTest>

#include <functional>

using namespace pixelplumb;

namespace {

using Change = std::function<void(Primitives &)>;

const FrameSpec &frameSpec()
{
    static const FrameSpec spec = frameOf(32, 24);
    return spec;
}

FrameView frameView()
{
    static const FrameBuffer frame(frameSpec());
    return frame.view();
}

/// Two white triangles side by side, within the frame of 32 × 24 pixels.
Primitives plain()
{
    Primitives primitives;
    primitives.triangles
        = {triangleAt({{{2, 2}, {10, 2}, {2, 10}}}), triangleAt({{{12, 2}, {20, 2}, {12, 10}}})};
    return primitives;
}

Primitives changed(const Change &change)
{
    Primitives primitives = plain();
    change(primitives);
    return primitives;
}

/// The second triangle over the first, moved by 10 px to the left and 3 px up.
void overlap(Primitives &primitives)
{
    for (Vertex &vertex : primitives.triangles[1].vertices)
        vertex.position
            = {vertex.position.x - 10 * unitsPerPixel, vertex.position.y + 3 * unitsPerPixel};
}

void setW(Primitives &primitives, std::size_t triangle, Attribute w)
{
    attributesAt(primitives, triangle).vertices[2].w = w;
}

void setColour(Primitives &primitives, std::size_t triangle)
{
    primitives.triangles[triangle].vertices[1].colour.channels[2] = 254;
}

PerEffect<EffectVerdict> verdictsOf(const Primitives &primitives, ScanSettings settings = {})
{
    return requirementsOf(primitives, settings, frameView());
}

EffectPlan planOf(const Primitives &primitives)
{
    return planFor(primitives, ScanSettings{}, frameView());
}

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

class TestEffectPlan : public QObject {
    Q_OBJECT

private slots:
    void eachVerdictSaysWhy_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<Effect>("effect");
        QTest::addColumn<Verdict>("verdict");
        QTest::addColumn<int>("primitives");
        QTest::addColumn<QString>("reason");
        const auto add = [](const char *name, const Change &change, Effect effect, Verdict verdict,
                            int primitives, const char *reason) {
            QTest::newRow(name) << change << effect << verdict << primitives
                                << QString::fromUtf8(reason);
        };
        const Change none = [](Primitives &) {};
        constexpr Verdict no = Verdict::NotCalledFor;
        constexpr Verdict yes = Verdict::CalledFor;

        add("one colour each", none, Effect::SmoothColour, no, 0,
            "the vertex colours are equal in each of 2 triangles");
        add(
            "one colour differs", [](Primitives &p) { setColour(p, 1); }, Effect::SmoothColour, yes,
            1, "1 of 2 triangles has vertex colours that differ");
        add(
            "one triangle whose colours differ",
            [](Primitives &p) {
                p.triangles.pop_back();
                setColour(p, 0);
            },
            Effect::SmoothColour, yes, 1, "the triangle has vertex colours that differ");
        add(
            "nothing there", [](Primitives &p) { p.triangles.clear(); }, Effect::SmoothColour, no,
            0, "nothing reaches the frame");

        add("within", none, Effect::Clipping, no, 0, "what is drawn lies within the frame");
        add(
            "one crosses the border",
            [](Primitives &p) { p.triangles[0].vertices[0].position.x = -unitsPerPixel; },
            Effect::Clipping, yes, 1, "1 of 2 triangles crosses the frame's border");
        add(
            "one is outside",
            [](Primitives &p) {
                p.triangles[0] = triangleAt({{{-9, 2}, {-2, 2}, {-9, 10}}});
            },
            Effect::Clipping, no, 0, "what is drawn lies within the frame; 1 outside");
        add(
            "the box alone crosses the border",
            [](Primitives &p) {
                p.triangles[0] = triangleAt({{{-9, 2}, {2, -9}, {-9, -9}}});
            },
            Effect::Clipping, no, 0, "what is drawn lies within the frame");

        add("no depths", none, Effect::Depth, no, 0, "all triangles have the same depth");
        add(
            "one triangle", [](Primitives &p) { p.triangles.pop_back(); }, Effect::Depth, no, 0,
            "there are no two triangles in the frame");
        add(
            "the later one is nearer",
            [](Primitives &p) {
                overlap(p);
                setDepths(p, 0, {3, 3, 3});
                setDepths(p, 1, {1, 2, 3});
            },
            Effect::Depth, no, 0,
            "every triangle is nearer than all that are drawn before it, or as near");
        add(
            "side by side",
            [](Primitives &p) {
                setDepths(p, 0, {1, 1, 1});
                setDepths(p, 1, {2, 2, 2});
            },
            Effect::Depth, no, 0, "no two triangles overlap");
        add(
            "tilted, but nearer where they overlap",
            [](Primitives &p) {
                overlap(p);
                setDepths(p, 0, {2, 2, 3});
                setDepths(p, 1, {1, 1, 3});
            },
            Effect::Depth, no, 0,
            "where triangles overlap or touch, the later one is nearer or as near");
        add(
            "the later one is behind",
            [](Primitives &p) {
                overlap(p);
                setDepths(p, 0, {1, 1, 1});
                setDepths(p, 1, {2, 2, 2});
            },
            Effect::Depth, yes, 2,
            "at pixel (2, 5) triangle 1 lies behind triangle 0, which is drawn before it; 2 "
            "triangles are in question");
        add(
            "behind between samples alone",
            [](Primitives &p) {
                p.triangles[1] = p.triangles[0];
                p.triangles[1].vertices[1].position = {2 * unitsPerPixel + 9, 2 * unitsPerPixel};
                p.triangles[1].vertices[2].position = {2 * unitsPerPixel, 2 * unitsPerPixel + 9};
                setDepths(p, 0, {1, 1, 1});
                setDepths(p, 1, {1, 2, 2});
            },
            Effect::Depth, no, 0,
            "at every sample that two triangles cover, the later one is nearer or as near");
        add(
            "depth off",
            [](Primitives &p) {
                overlap(p);
                setDepths(p, 0, {1, 1, 1});
                setDepths(p, 1, {2, 2, 2});
                p.appearance.depth = DepthUse::Off;
            },
            Effect::Depth, no, 0,
            "the scene says so: what is drawn later covers what was drawn before");
        add(
            "depth on", [](Primitives &p) { p.appearance.depth = DepthUse::On; }, Effect::Depth,
            yes, 2, "the scene says so, for all triangles");

        add("one w", none, Effect::Perspective, no, 0,
            "w is the same at the three vertices of every triangle");
        add(
            "w differs alone", [](Primitives &p) { setW(p, 0, 2 * attributeOne); },
            Effect::Perspective, no, 0,
            "w differs between the vertices of 1 of 2 triangles, but nothing else does that is "
            "divided by it");
        add(
            "w and the colours differ",
            [](Primitives &p) {
                setW(p, 0, 2 * attributeOne);
                setColour(p, 0);
            },
            Effect::Perspective, yes, 1,
            "w differs between the vertices of 1 of 2 triangles, and so do colours: these change "
            "evenly only when divided by w");
        add(
            "w and u differ",
            [](Primitives &p) {
                setW(p, 0, 2 * attributeOne);
                setTexture(p, 0);
            },
            Effect::Perspective, yes, 1,
            "w differs between the vertices of 1 of 2 triangles, and so do u and v: these change "
            "evenly only when divided by w");

        add("no texture", none, Effect::Texture, no, 0, "no triangle's material has a texture");
        add(
            "a texture", [](Primitives &p) { setTexture(p, 0); }, Effect::Texture, yes, 1,
            "1 of 2 triangles has a material with a texture: “checker”");

        add("no light", none, Effect::Light, no, 0, "no light is on");
        add(
            "a light", [](Primitives &p) { setLight(p, 1); }, Effect::Light, yes, 1,
            "1 of 2 triangles has normals, and a light is on (Phong shading: at every sample)");
        add(
            "a light without normals",
            [](Primitives &p) {
                setLight(p, 1);
                p.attributes.clear();
            },
            Effect::Light, no, 0, "no triangle has normals");
        add(
            "flat shading",
            [](Primitives &p) {
                setLight(p, 1);
                p.appearance.shading = Shading::Flat;
            },
            Effect::Light, no, 0, "flat shading: light is in the colours, once a triangle");

        add("opaque", none, Effect::Blending, no, 0, "every alpha is 255: opaque");
        add(
            "glass", [](Primitives &p) { setAlpha(p, 0, 128); }, Effect::Blending, yes, 1,
            "1 of 2 triangles has an alpha below 255, the lowest is 128");
        add(
            "two panes that share an edge",
            [](Primitives &p) {
                p.triangles[1] = triangleAt({{{10, 2}, {10, 10}, {2, 10}}});
                setAlpha(p, 0, 128);
                setAlpha(p, 1, 254);
            },
            Effect::Blending, yes, 2,
            "both triangles have an alpha below 255, the lowest is 128; the closed rule paints 9 "
            "samples on their shared edges twice");

        add("one sample", none, Effect::Antialiasing, no, 0,
            "the scene asks for one sample a pixel");
        add(
            "four samples",
            [](Primitives &p) { p.appearance.antialiasing = Antialiasing::Samples4; },
            Effect::Antialiasing, yes, 2,
            "the scene asks for 4 samples in each pixel that an edge passes");
        add(
            "exact area", [](Primitives &p) { p.appearance.antialiasing = Antialiasing::Area; },
            Effect::Antialiasing, yes, 2,
            "the scene asks for the exact area that a triangle has of a pixel");
    }
    void eachVerdictSaysWhy()
    {
        QFETCH(Change, change);
        QFETCH(Effect, effect);
        QFETCH(Verdict, verdict);
        QFETCH(int, primitives);
        QFETCH(QString, reason);

        const EffectVerdict found = verdictsOf(changed(change))[effect];

        QCOMPARE(found.reason, reason);
        QCOMPARE(int(found.verdict), int(verdict));
        QCOMPARE(int(found.primitives), primitives);
        QCOMPARE(found.pixels > 0, primitives > 0);
    }

    void aMutationTurnsExactlyItsVerdictBothWays_data()
    {
        QTest::addColumn<Change>("before");
        QTest::addColumn<Change>("after");
        QTest::addColumn<QList<Effect>>("turned");
        const auto add
            = [](const char *name, const Change &before, const Change &after,
                 const QList<Effect> &turned) { QTest::newRow(name) << before << after << turned; };
        const Change rich = [](Primitives &p) {
            setLight(p, 0);
            setTexture(p, 0);
            setAlpha(p, 0, 255);
            setDepths(p, 0, {2, 2, 2});
            setDepths(p, 1, {2, 2, 2});
        };
        const auto with = [](const Change &first, const Change &second) -> Change {
            return [=](Primitives &p) {
                first(p);
                second(p);
            };
        };
        const Change none = [](Primitives &) {};
        const QList<Effect> blending = {Effect::Blending};
        add(
            "alpha from 255 to 254", none, [](Primitives &p) { setAlpha(p, 0, 254); }, blending);
        add("alpha from 255 to 254 of a lit board", rich,
            with(rich, [](Primitives &p) { attributesAt(p, 0).vertices[1].alpha = 254; }),
            blending);
        add("one channel of one colour by 1", none, [](Primitives &p) { setColour(p, 0); },
            {Effect::SmoothColour});
        const Change apart = [](Primitives &p) {
            setDepths(p, 0, {2, 2, 2});
            setDepths(p, 1, {3, 3, 3});
        };
        add("the farther one moved over the nearer", apart, with(apart, overlap), {Effect::Depth});
        const Change coplanar = with(overlap, [](Primitives &p) {
            setDepths(p, 0, {2, 2, 2});
            setDepths(p, 1, {2, 2, 2});
        });
        add("one of two tilted backward", coplanar,
            with(coplanar,
                 [](Primitives &p) {
                     setDepths(p, 1, {2, 2, 3});
                 }),
            {Effect::Depth});
        const Change smooth = [](Primitives &p) { setColour(p, 0); };
        add("one w by 2^-24", smooth,
            with(smooth, [](Primitives &p) { setW(p, 0, attributeOne + 1); }),
            {Effect::Perspective});
        const Change textured = [](Primitives &p) { setTexture(p, 0); };
        add("the material's texture away", textured,
            with(textured, [](Primitives &p) { p.appearance.materials[0].texture = nullptr; }),
            {Effect::Texture});
        const Change lit = [](Primitives &p) { setLight(p, 0); };
        add("the light switched off", lit,
            with(lit, [](Primitives &p) { p.appearance.lights.clear(); }), {Effect::Light});
        add(
            "a vertex moved by 1/256 px beyond the border",
            [](Primitives &p) { p.triangles[0].vertices[0].position.x = -unitsPerPixel + 1; },
            [](Primitives &p) { p.triangles[0].vertices[0].position.x = -unitsPerPixel; },
            {Effect::Clipping});
        add("four samples", none,
            [](Primitives &p) { p.appearance.antialiasing = Antialiasing::Samples4; },
            {Effect::Antialiasing});
    }
    void aMutationTurnsExactlyItsVerdictBothWays()
    {
        QFETCH(Change, before);
        QFETCH(Change, after);
        QFETCH(QList<Effect>, turned);

        const EffectPlan first = planOf(changed(before));
        const EffectPlan second = planOf(changed(after));

        for (const Effect effect : allEffects) {
            const QByteArray name(nameOf(effect).data(), qsizetype(nameOf(effect).size()));
            QVERIFY2((first.verdicts[effect].verdict != second.verdicts[effect].verdict)
                         == turned.contains(effect),
                     name);
            QVERIFY2((first.runs(effect) != second.runs(effect)) == turned.contains(effect), name);
        }
    }

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
            "depth does not part a run",
            [=](Primitives &p) {
                crossing(p);
                p.triangles.push_back(triangleAt({{{22, 2}, {30, 2}, {22, 10}}}));
            },
            "0+3 depth");
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

    void otherFillRulesPaintNoSampleOfASharedEdgeTwice()
    {
        Primitives primitives = plain();
        primitives.triangles[1] = triangleAt({{{10, 2}, {10, 10}, {2, 10}}});
        setAlpha(primitives, 0, 128);
        setAlpha(primitives, 1, 128);
        for (const FillRule rule : allFillRules) {
            const EffectVerdict verdict = verdictsOf(
                primitives, {Arithmetic::Exact, rule, ByteRounding::Nearest})[Effect::Blending];
            QCOMPARE(verdict.reason.contains(QStringLiteral("twice")), rule == FillRule::Closed);
        }
    }

    void shapesCallForColoursAndClipping()
    {
        Primitives primitives;
        Shape line;
        line.vertices = {{latticePixel(2, 2), Colour{{255, 0, 0}}},
                         {latticePixel(40, 2), Colour{{0, 255, 0}}}};
        primitives.shapes = {line};
        const PerEffect<EffectVerdict> verdicts = verdictsOf(primitives);

        QCOMPARE(verdicts[Effect::SmoothColour].reason,
                 QStringLiteral("the primitive has vertex colours that differ"));
        QCOMPARE(verdicts[Effect::Clipping].reason,
                 QStringLiteral("the primitive crosses the frame's border"));
        QCOMPARE(int(verdicts[Effect::Depth].verdict), int(Verdict::NotCalledFor));
        QVERIFY(planOf(primitives).batches.empty());
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
        attributesAt(primitives, 1).material = 5; // there is none
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
};

QTEST_APPLESS_MAIN(TestEffectPlan)
#include "tst_effectplan.moc"
