// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/effectchanges.h"
#include "tests/support/testprogram.h"

#include <QtTest>

namespace tst_effectreasons {

using namespace pixelplumb;

/// Which effects are needed, and the words that say why.
class TestEffectReasons : public QObject {
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
            0, "nothing is drawn in the frame");

        add("within", none, Effect::Clipping, no, 0, "what is drawn lies within the frame");
        add(
            "one crosses the border",
            [](Primitives &p) { p.triangles[0].vertices[0].position.x = -unitsPerPixel; },
            Effect::Clipping, yes, 1, "1 of 2 triangles has samples beyond the frame");
        add(
            "one is outside",
            [](Primitives &p) {
                p.triangles[0] = triangleAt({{{-9, 2}, {-2, 2}, {-9, 10}}});
            },
            Effect::Clipping, no, 0,
            "what is drawn lies within the frame; 1 other triangle covers no sample of the frame");
        add(
            "one is outside, of areas",
            [](Primitives &p) {
                p.triangles[0] = triangleAt({{{-9, 2}, {-2, 2}, {-9, 10}}});
                p.appearance.antialiasing = Antialiasing::Area;
            },
            Effect::Clipping, no, 0,
            "what is drawn lies within the frame; 1 other triangle covers no part of the frame");
        add(
            "the box alone crosses the border",
            [](Primitives &p) {
                p.triangles[0] = triangleAt({{{-9, 2}, {2, -9}, {-9, -9}}});
            },
            Effect::Clipping, no, 0,
            "what is drawn lies within the frame; 1 other triangle covers no sample of the frame");

        add(
            "a part of the area of pixels beyond the border",
            [](Primitives &p) {
                p.triangles[0].vertices[0].position.x = -unitsPerPixel + 1;
                p.appearance.antialiasing = Antialiasing::Area;
            },
            Effect::Clipping, yes, 1, "1 of 2 triangles has a part beyond the frame");

        add("no depths", none, Effect::Depth, no, 0,
            "all triangles drawn in the frame have the same depth");
        add(
            "a segment behind",
            [](Primitives &p) {
                p.triangles[1] = triangleAt({{{2, 2}, {4, 4}, {5, 5}}});
                setDepths(p, 1, {1, 1, 1});
            },
            Effect::Depth, yes, 2,
            "at pixel (2, 2) triangle 1 lies behind triangle 0, which is drawn before it; 2 "
            "triangles are in question");
        const Change between = [](Primitives &p) {
            p.triangles[1] = triangleAt({{{0, 0}, {0, 0}, {0, 0}}});
            p.triangles[1].vertices[0].position = {4 * unitsPerPixel + 64, 3 * unitsPerPixel + 64};
            p.triangles[1].vertices[1].position = {4 * unitsPerPixel + 192, 3 * unitsPerPixel + 64};
            p.triangles[1].vertices[2].position
                = {4 * unitsPerPixel + 192, 3 * unitsPerPixel + 192};
            setDepths(p, 0, {0, 0, 0});
            setDepths(p, 1, {4, 4, 4});
        };
        add("behind between the samples", between, Effect::Depth, no, 0,
            "fewer than two triangles are drawn in the frame");
        add(
            "behind at one of sixteen samples",
            [=](Primitives &p) {
                between(p);
                p.appearance.antialiasing = Antialiasing::Samples16;
            },
            Effect::Depth, yes, 2,
            "at pixel (5, 4) triangle 1 lies behind triangle 0, which is drawn before it; 2 "
            "triangles are in question");
        add(
            "before it at the centres of shared pixels",
            [=](Primitives &p) {
                between(p);
                setDepths(p, 1, {0, 0, 0});
                setDepths(p, 0, {0, 2, 2});
                p.appearance.antialiasing = Antialiasing::Area;
            },
            Effect::Depth, no, 0,
            "in every pixel where two triangles are drawn, the later one is at least as near at "
            "the pixel's centre");
        add(
            "one triangle", [](Primitives &p) { p.triangles.pop_back(); }, Effect::Depth, no, 0,
            "fewer than two triangles are drawn in the frame");
        add(
            "the later one is nearer",
            [](Primitives &p) {
                overlap(p);
                setDepths(p, 0, {3, 3, 3});
                setDepths(p, 1, {1, 2, 3});
            },
            Effect::Depth, no, 0,
            "each triangle drawn in the frame is at least as near as all "
            "before it");
        add(
            "side by side",
            [](Primitives &p) {
                setDepths(p, 0, {1, 1, 1});
                setDepths(p, 1, {2, 2, 2});
            },
            Effect::Depth, no, 0, "the triangles drawn in the frame do not overlap");
        add(
            "tilted, but nearer where they overlap",
            [](Primitives &p) {
                overlap(p);
                setDepths(p, 0, {2, 2, 3});
                setDepths(p, 1, {1, 1, 3});
            },
            Effect::Depth, no, 0,
            "where triangles overlap or touch, the later one is at least as near");
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
            "at every sample that two triangles cover, the later one is at least as near");
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
            "w is the same at the vertices of every triangle");
        add(
            "w differs alone", [](Primitives &p) { setW(p, 0, 2 * attributeOne); },
            Effect::Perspective, no, 0,
            "w differs between the vertices of 1 of 2 triangles, but nothing that is divided by "
            "it does");
        add(
            "w and the colours differ",
            [](Primitives &p) {
                setW(p, 0, 2 * attributeOne);
                setColour(p, 0);
            },
            Effect::Perspective, yes, 1,
            "w differs between the vertices of 1 of 2 triangles, so these are divided by w before "
            "they are interpolated: colours");
        add(
            "w and u differ",
            [](Primitives &p) {
                setW(p, 0, 2 * attributeOne);
                setTexture(p, 0);
            },
            Effect::Perspective, yes, 1,
            "w differs between the vertices of 1 of 2 triangles, so these are divided by w before "
            "they are interpolated: u and v");
        add(
            "no triangle, no w", [](Primitives &p) { p.triangles.clear(); }, Effect::Perspective,
            no, 0, "nothing is drawn in the frame");

        // A segment uses only its two ends.
        const Change segment = [](Primitives &p) {
            p.triangles = {triangleAt({{{1, 1}, {3, 3}, {5, 5}}})};
            setColour(p, 0);
            attributesAt(p, 0).vertices[1].alpha = 128;
            setW(p, 0, 2 * attributeOne);
            std::swap(p.attributes[0].vertices[2].w, p.attributes[0].vertices[1].w);
        };
        add("a segment's middle colour", segment, Effect::SmoothColour, no, 0,
            "the vertex colours are equal; for a triangle that is a segment, only the two ends "
            "count");
        add("a segment's middle alpha", segment, Effect::Blending, no, 0,
            "every alpha is 255: opaque; for a triangle that is a segment, only the two ends "
            "count");
        add("a segment's middle w", segment, Effect::Perspective, no, 0,
            "w is the same at the vertices of every triangle; for a triangle that is a segment, "
            "only the two ends count");
        add(
            "a point's other colours",
            [=](Primitives &p) {
                segment(p);
                for (Vertex &vertex : p.triangles[0].vertices)
                    vertex.position = p.triangles[0].vertices[0].position;
            },
            Effect::SmoothColour, no, 0,
            "the vertex colours are equal; for a triangle that is a point, only the first vertex "
            "counts");
        add(
            "a segment whose middle is the first vertex",
            [=](Primitives &p) {
                segment(p);
                std::swap(p.triangles[0].vertices[0], p.triangles[0].vertices[1]);
            },
            Effect::SmoothColour, no, 0,
            "the vertex colours are equal; for a triangle that is a segment, only the two ends "
            "count");
        add(
            "a segment's lowest alpha",
            [=](Primitives &p) {
                segment(p);
                attributesAt(p, 0).vertices[2].alpha = 200;
            },
            Effect::Blending, yes, 1,
            "the triangle has an alpha below 255, the lowest is 200; for a triangle that is a "
            "segment, only the two ends count");
        add(
            "a segment that goes there and back",
            [](Primitives &p) {
                p.triangles[0] = triangleAt({{{1, 1}, {5, 1}, {1, 1}}});
                setAlpha(p, 0, 128);
            },
            Effect::Blending, yes, 1,
            "1 of 2 triangles has an alpha below 255, the lowest is 128; for a triangle that is a "
            "segment, only the two ends count");

        // A primitive that is not drawn is never mentioned, whatever it carries.
        const Change other = [](Primitives &p) {
            p.triangles[0] = triangleAt({{{-9, 2}, {-2, 2}, {-9, 10}}});
            setColour(p, 0);
            setW(p, 0, 2 * attributeOne);
            setTexture(p, 0);
            attributesAt(p, 0).vertices[1].alpha = 12;
            setLight(p, 1);
            for (TriangleAttributes &each : p.attributes) {
                for (VertexAttributes &vertex : each.vertices)
                    vertex.normal = each.triangle == 0 ? vertex.normal : std::array<Attribute, 3>{};
            }
        };
        add("colours of another", other, Effect::SmoothColour, no, 0,
            "the vertex colours are equal in each triangle that is drawn in the frame");
        add("w of another", other, Effect::Perspective, no, 0,
            "w is the same at the vertices of every triangle that is drawn in the frame");
        add("texture of another", other, Effect::Texture, no, 0,
            "no triangle that is drawn in the frame has a material with a texture");
        add("light on another", other, Effect::Light, no, 0,
            "no triangle that is drawn in the frame has normals");
        add("alpha of another", other, Effect::Blending, no, 0,
            "every alpha of a triangle that is drawn in the frame is 255: opaque");

        add("no texture", none, Effect::Texture, no, 0,
            "no triangle has a material with a texture");
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
            Effect::Light, yes, 1,
            "1 of 2 triangles has normals, and a light is on (flat shading: once a triangle, in "
            "set-up)");
        add(
            "Gouraud shading",
            [](Primitives &p) {
                setLight(p, 1);
                p.appearance.shading = Shading::Gouraud;
            },
            Effect::Light, yes, 1,
            "1 of 2 triangles has normals, and a light is on (Gouraud shading: at the vertices, "
            "in set-up)");

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
            "both triangles have an alpha below 255, the lowest is 128; the closed rule gives 9 "
            "samples on shared edges to both triangles, one of them (2, 10)");
        add(
            "a pane beside what is opaque",
            [](Primitives &p) {
                p.triangles[1] = triangleAt({{{10, 2}, {10, 10}, {2, 10}}});
                setAlpha(p, 0, 128);
            },
            Effect::Blending, yes, 1,
            "1 of 2 triangles has an alpha below 255, the lowest is 128; the closed rule gives 9 "
            "samples on shared edges to both triangles, one of them (2, 10)");
        add(
            "two panes that share an upright edge, of 16 samples a pixel",
            [](Primitives &p) {
                // One of the 16 samples lies directly below the centre, 112/256 px from it.
                p.appearance.antialiasing = Antialiasing::Samples16;
                p.triangles[0] = triangleAt({{{10, 2}, {10, 10}, {2, 10}}});
                p.triangles[1] = triangleAt({{{10, 2}, {10, 10}, {14, 6}}});
                setAlpha(p, 0, 128);
            },
            Effect::Blending, yes, 1,
            "1 of 2 triangles has an alpha below 255, the lowest is 128; the closed rule gives 8 "
            "samples on shared edges to both triangles, one of them in pixel (10, 3)");
        add(
            "a pane without area on another's edge, of 16 samples a pixel",
            [](Primitives &p) {
                // It paints whole pixels: including the sample on the diagonal, 1/16 px from the
                // centre, of all but the last pixel.
                p.appearance.antialiasing = Antialiasing::Samples16;
                p.triangles[0] = triangleAt({{{1, 1}, {4, 4}, {4, 1}}});
                p.triangles[1] = triangleAt({{{1, 1}, {4, 4}, {1, 1}}});
                setAlpha(p, 1, 128);
            },
            Effect::Blending, yes, 1,
            "1 of 2 triangles has an alpha below 255, the lowest is 128; for a triangle that is a "
            "segment, only the two ends count; the closed rule gives 3 samples on shared edges "
            "to both triangles, one of them in pixel (1, 1)");
        add(
            "two panes without area on another's edge, of 16 samples a pixel",
            [](Primitives &p) {
                p.appearance.antialiasing = Antialiasing::Samples16;
                p.triangles = {triangleAt({{{1, 1}, {3, 1}, {3, 1}}}),
                               triangleAt({{{1, 1}, {3, 1}, {3, 1}}}),
                               triangleAt({{{1, 1}, {3, 1}, {3, 2}}})};
                setAlpha(p, 0, 128);
                setAlpha(p, 1, 128);
            },
            Effect::Blending, yes, 2,
            "2 of 3 triangles have an alpha below 255, the lowest is 128; for a triangle that is "
            "a segment, only the two ends count; the closed rule gives 3 samples on shared "
            "edges to both triangles, one of them in pixel (1, 1)");
        add(
            "a face that the near plane cuts", [](Primitives &p) { p.cutAtNear = {1}; },
            Effect::Clipping, yes, 1, "1 of 2 triangles is of a face that the near plane cuts");

        const Change covering = [](Primitives &p) {
            p.triangles = {triangleAt({{{-200, -100}, {400, -100}, {-200, 500}}})};
        };
        add(
            "four samples where no edge is",
            [=](Primitives &p) {
                covering(p);
                p.appearance.antialiasing = Antialiasing::Samples4;
            },
            Effect::Antialiasing, no, 0,
            "no edge of a triangle with an area meets a pixel of the frame: each pixel is sampled "
            "once, at its "
            "centre");
        add(
            "areas where no edge is",
            [=](Primitives &p) {
                covering(p);
                p.appearance.antialiasing = Antialiasing::Area;
            },
            Effect::Antialiasing, no, 0,
            "no edge crosses a pixel of the frame: each pixel is covered entirely or not at all");
        add("one sample", none, Effect::Antialiasing, no, 0,
            "the scene asks for one sample a pixel");
        add(
            "four samples",
            [](Primitives &p) { p.appearance.antialiasing = Antialiasing::Samples4; },
            Effect::Antialiasing, yes, 2,
            "the scene asks for 4 samples in each pixel that an edge passes through");
        add(
            "exact area", [](Primitives &p) { p.appearance.antialiasing = Antialiasing::Area; },
            Effect::Antialiasing, yes, 2,
            "the scene asks for the exact area of each pixel that a triangle covers");
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

    void aLightThatIsForcedOnNeedsOne()
    {
        Primitives primitives = plain();
        for (VertexAttributes &vertex : attributesAt(primitives, 0).vertices)
            vertex.normal = {0, 0, 1};
        primitives.appearance.forced[Effect::Light] = Forcing::On;
        QVERIFY(!planOf(primitives).runs(Effect::Light));
        primitives.appearance.lights = {Light()};
        QVERIFY(planOf(primitives).runs(Effect::Light));
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
            QCOMPARE(verdict.reason.contains(QStringLiteral("shared edges")),
                     rule == FillRule::Closed);
        }
    }

    void onlyTheClosedRuleSpeaksOfTrianglesThatTouch()
    {
        // The first two share an edge, at which the later one is farther; the third is nearer than
        // what it overlaps.
        Primitives primitives = plain();
        primitives.triangles
            = {triangleAt({{{1, 1}, {9, 1}, {1, 9}}}), triangleAt({{{9, 1}, {9, 9}, {1, 9}}}),
               triangleAt({{{7, 7}, {12, 7}, {12, 12}}})};
        setDepths(primitives, 0, {0, 0, 0});
        setDepths(primitives, 1, {4, 4, 4});
        setDepths(primitives, 2, {0, 4, 4});
        for (const FillRule rule : allFillRules) {
            const EffectVerdict verdict = verdictsOf(
                primitives, {Arithmetic::Exact, rule, ByteRounding::Nearest})[Effect::Depth];
            if (rule == FillRule::Closed)
                QCOMPARE(verdict.verdict, Verdict::CalledFor);
            else
                QCOMPARE(
                    verdict.reason,
                    QStringLiteral("where triangles overlap, the later one is at least as near"));
        }
    }

    void shapesCallForColoursAndClipping()
    {
        Primitives primitives;
        primitives.shapes = {smoothLine()};
        const PerEffect<EffectVerdict> verdicts = verdictsOf(primitives);

        QCOMPARE(verdicts[Effect::SmoothColour].reason,
                 QStringLiteral("the line has vertex colours that differ"));
        QCOMPARE(verdicts[Effect::Clipping].reason,
                 QStringLiteral("the line has samples beyond the frame"));
        QCOMPARE(int(verdicts[Effect::Depth].verdict), int(Verdict::NotCalledFor));
        QVERIFY(planOf(primitives).batches.empty());
    }

    void aLineThatPassesTheFrameByCallsForNothing()
    {
        Primitives primitives;
        Shape line = smoothLine();
        line.vertices[0].position = latticePixel(-5, 1);
        line.vertices[1].position = latticePixel(1, -5);
        primitives.shapes = {line};
        QCOMPARE(verdictsOf(primitives)[Effect::SmoothColour].reason,
                 QStringLiteral("nothing is drawn in the frame"));
        QVERIFY(!planOf(primitives).runs(Effect::SmoothColour));
        // The line (−5, 5) to (5, −5) passes through pixel (0, 0).
        primitives.shapes[0].vertices[0].position = latticePixel(-5, 5);
        primitives.shapes[0].vertices[1].position = latticePixel(5, -5);
        QCOMPARE(verdictsOf(primitives)[Effect::SmoothColour].verdict, Verdict::CalledFor);
        QVERIFY(planOf(primitives).runs(Effect::SmoothColour));
    }

    void aCircleThatMayCrossTheBorderIsCounted()
    {
        Primitives primitives;
        Shape circle = smoothLine();
        circle.kind = PrimitiveKind::Circle;
        circle.vertices[0].position = latticePixel(0, 10);
        circle.vertices[1].position = latticePixel(4, 14);
        primitives.shapes = {circle};
        const EffectVerdict clipping = verdictsOf(primitives)[Effect::Clipping];
        QCOMPARE(clipping.verdict, Verdict::NotRuledOut);
        QCOMPARE(clipping.primitives, std::size_t(1));
        QCOMPARE(clipping.pixels, std::int64_t(32 * 24));
        QCOMPARE(clipping.reason,
                 QStringLiteral("the circle may go on beyond the frame, as far as bounding boxes "
                                "tell"));
    }

    void pointsHaveEachItsOwnColourAndNoneChangesOnTheWay()
    {
        Primitives primitives;
        Shape points = smoothLine();
        points.kind = PrimitiveKind::Point;
        primitives.shapes = {points};
        const EffectVerdict verdict = verdictsOf(primitives)[Effect::SmoothColour];

        QCOMPARE(verdict.verdict, Verdict::NotCalledFor);
        QCOMPARE(
            verdict.reason,
            QStringLiteral("no point goes from one vertex colour to another where it is drawn"));
    }
};

PIXELPLUMB_TEST(TestEffectReasons)

} // namespace tst_effectreasons

#include "tst_effectreasons.moc"
