// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scanning.h"
#include "tests/support/scenes/effectslope.h"
#include "tests/support/testprogram.h"

#include <QRandomGenerator>
#include <QTest>

namespace tst_effectoracle {

using namespace pixelplumb;

/// The truth of depth and blending against values worked out by hand; tst_effectcases checks that
/// all effects agree with a second derivation in fractions.
class TestEffectOracle : public QObject {
    Q_OBJECT

private slots:
    void whatIsNearerShowsAndTheLaterOneOfTwoThatAreEquallyNear()
    {
        // z = 1/2 and z = x/16 cross at x = 8.
        std::array<VertexAttributes, 3> rising;
        rising[1].z = attributeOne;
        Primitives levelFirst = oneSlope(atDepth(attribute(1, 2)), black);
        addSlope(levelFirst, rising, white);
        Primitives risingFirst = oneSlope(rising, white);
        addSlope(risingFirst, atDepth(attribute(1, 2)), black);

        QCOMPARE(rowText(levelFirst), u"#########........"_s);
        QCOMPARE(rowText(risingFirst), u"########........."_s);
    }

    void withoutDepthTheLaterTriangleShows()
    {
        Primitives primitives = oneSlope(atDepth(0), black);
        addSlope(primitives, atDepth(attributeOne), white);
        QCOMPARE(rowText(primitives), u"................."_s);

        primitives.appearance.depth = DepthUse::Off;
        QCOMPARE(rowText(primitives), u"#################"_s);
        primitives.appearance.depth = DepthUse::On;
        primitives.appearance.forced[Effect::Depth] = Forcing::Off;
        QCOMPARE(rowText(primitives), u"#################"_s);
    }

    void aLastBitOfDepthCountsInTheExactBufferAlone()
    {
        // Both z are nearest to the level 32768 of 65535.
        Primitives primitives = oneSlope(atDepth(attribute(1, 2)), white);
        addSlope(primitives, atDepth(attribute(1, 2) + 1), black);

        QCOMPARE(rowText(primitives), u"#################"_s);
        primitives.appearance.depthFormat = DepthFormat::Bits16;
        QCOMPARE(rowText(primitives), u"................."_s);
        // (1/2 + 2^-24)(2^24 - 1) + 1/2 = 8388608 + 1 - 2^-24: one above the level of 1/2.
        primitives.appearance.depthFormat = DepthFormat::Bits24;
        QCOMPARE(sampleOf(primitives, 3, 0).depth, Quantity::integer(8388608));
        QCOMPARE(rowText(primitives), u"................."_s);
        // 2^-24 is 256 of the 32-bit levels.
        primitives.appearance.depthFormat = DepthFormat::Bits32;
        QCOMPARE(rowText(primitives), u"#################"_s);
    }

    void levelsOfDepthAreClampedAndRounded_data()
    {
        QTest::addColumn<int>("numerator");
        QTest::addColumn<int>("denominator");
        QTest::addColumn<int>("level");
        QTest::newRow("in front of the near plane") << -3 << 1 << 0;
        QTest::newRow("nearest") << 0 << 1 << 0;
        QTest::newRow("a quarter: 16383 3/4") << 1 << 4 << 16384;
        QTest::newRow("a half: 32767 1/2") << 1 << 2 << 32768;
        QTest::newRow("farthest") << 1 << 1 << 65535;
        QTest::newRow("beyond the far plane") << 7 << 2 << 65535;
    }
    void levelsOfDepthAreClampedAndRounded()
    {
        QFETCH(int, numerator);
        QFETCH(int, denominator);
        QFETCH(int, level);
        Primitives primitives = oneSlope(atDepth(attribute(numerator, denominator)));
        primitives.appearance.depthFormat = DepthFormat::Bits16;

        const oracle::EffectSample sample = sampleOf(primitives, 2, 3);

        QCOMPARE(sample.z, Quantity::rational(numerator, denominator));
        QCOMPARE(sample.depth, Quantity::integer(level));
    }

    void depthBeyondItsRangeIsComparedAllTheSame()
    {
        Primitives primitives = oneSlope(atDepth(attribute(3)), white);
        addSlope(primitives, atDepth(attribute(2)), black);
        addSlope(primitives, atDepth(attribute(5, 2)), white);
        QCOMPARE(rowText(primitives, 1), u"."_s);
    }

    void blendingRoundsToTheNearestByte()
    {
        for (int alpha = 0; alpha <= 255; ++alpha) {
            for (const int source : {0, 1, 2, 77, 127, 128, 254, 255}) {
                for (const int destination : {0, 1, 3, 100, 128, 200, 255}) {
                    const Colour blended
                        = oracle::blended({{std::uint8_t(source), 0, 0}}, std::uint8_t(alpha),
                                          {{std::uint8_t(destination), 0, 0}});
                    const int sum = source * alpha + destination * (255 - alpha);
                    // 255 is odd: there is no tie, and exactly one byte is nearer than half a
                    // level.
                    QVERIFY(std::abs(255 * blended.red() - sum) <= 127);
                }
            }
        }
    }

    void glassShowsWhatIsBehindIt()
    {
        Primitives primitives = oneSlope(withAlpha(255), {{200, 0, 10}});
        addSlope(primitives, withAlpha(100), {{0, 255, 20}});
        const FrameBuffer frame = truthOver(primitives, frameOf(4, 4));
        // (200·155)/255 = 121.57, (255·100)/255 = 100, (10·155 + 20·100)/255 = 13.92
        QCOMPARE(pixelOf(frame, 1, 1), (Colour{{122, 100, 14}}));
        primitives.appearance.forced[Effect::Blending] = Forcing::Off;
        QCOMPARE(pixelOf(truthOver(primitives, frameOf(4, 4)), 1, 1), (Colour{{0, 255, 20}}));
    }

    void whatIsFullyTransparentHidesWhatLiesBehindIt()
    {
        std::array<VertexAttributes, 3> glass = withAlpha(0);
        Primitives primitives = oneSlope(glass, white);
        addSlope(primitives, atDepth(attribute(1, 2)), white);
        FrameSpec spec = frameOf(4, 4);
        spec.background = {{9, 8, 7}};
        // A sample that passes writes z, whatever its alpha.
        QCOMPARE(pixelOf(truthOver(primitives, spec), 1, 1), spec.background);
        primitives.appearance.depth = DepthUse::Off;
        QCOMPARE(pixelOf(truthOver(primitives, spec), 1, 1), white);
    }

    void withoutEffectsThePictureIsThatOfTheTriangles()
    {
        QRandomGenerator random(5);
        for (const FillRule rule : allFillRules) {
            const ScanSettings settings = {Arithmetic::Exact, rule, ByteRounding::Truncate};
            const FrameSpec spec = frameOf(24, 24, -12, -12);
            Primitives primitives;
            ScanPicture byTriangle(spec);
            for (int i = 0; i < 12; ++i) {
                const auto coordinate = [&] { return Lattice(random.bounded(-4, 5)) * 512; };
                Triangle triangle
                    = triangleAtUnits({coordinate(), coordinate()}, {coordinate(), coordinate()},
                                      {coordinate(), coordinate()});
                primitives.triangles.push_back(triangle);
                byTriangle.draw([&](FrameView frame) {
                    oracle::draw(triangle, {settings, frame}, settings.rounding, frame);
                });
            }
            primitives.appearance.depth = DepthUse::Off;
            ScanPicture byEffects(spec);
            byEffects.draw([&](FrameView frame) {
                oracle::drawEffects(primitives, settings, oracle::truthOf(primitives.appearance),
                                    frame);
            });
            QCOMPARE(byEffects.text(), byTriangle.text());
            QVERIFY(byEffects == byTriangle);
        }
    }

    void aTriangleWithoutAreaDrawsItsSegmentWithEveryEffect()
    {
        Primitives primitives;
        primitives.triangles = {triangleAt(0, 0, 3, 3, 6, 6)};
        primitives.appearance.depth = DepthUse::Off;
        const auto count = [&] {
            ScanPicture drawing(frameOf(8, 8));
            drawing.draw([&](FrameView frame) {
                oracle::drawEffects(primitives, closedRule, oracle::truthOf(primitives.appearance),
                                    frame);
            });
            return drawing.count();
        };
        QCOMPARE(count(), std::int64_t(7));
        primitives.attributes = {{0, withAlpha(254)}};
        QCOMPARE(count(), std::int64_t(7));
        for (const Antialiasing antialiasing :
             {Antialiasing::Samples4, Antialiasing::Samples16, Antialiasing::Area}) {
            primitives.appearance.antialiasing = antialiasing;
            QCOMPARE(count(), std::int64_t(7));
        }
    }

    void whatASegmentCarriesIsDividedByW()
    {
        // From black with w = 1 at (0, 0) to white with w = 3 at (8, 0); a vertex between them is
        // ignored. Halfway: (½·255/3) ÷ (½/1 + ½/3) = 42½ ÷ ⅔ = 63¾, and z, which is not divided,
        // (0 + 1)/2.
        Primitives primitives;
        primitives.triangles = {triangleAt(0, 0, 3, 0, 8, 0)};
        primitives.triangles[0].vertices[0].colour = {{0, 0, 0}};
        primitives.triangles[0].vertices[2].colour = {{255, 255, 255}};
        std::array<VertexAttributes, 3> vertices;
        vertices[1].w = 7 * attributeOne;
        vertices[1].z = 5 * attributeOne;
        vertices[2].w = 3 * attributeOne;
        vertices[2].z = attributeOne;
        primitives.attributes = {{0, vertices}};
        const auto sample = oracle::effectSampleAt(primitives, 0, ByteRounding::Nearest, {}, 4, 0);
        QVERIFY(sample.has_value());
        QCOMPARE(toText(sample->levels[0]), u"63 3/4"_s);
        QCOMPARE(toText(sample->z), u"1/2"_s);
        QCOMPARE(sample->interpolated, (Colour{{64, 64, 64}}));
    }
};

PIXELPLUMB_TEST(TestEffectOracle)

} // namespace tst_effectoracle

#include "tst_effectoracle.moc"
