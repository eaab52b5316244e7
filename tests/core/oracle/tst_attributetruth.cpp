// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/effectslope.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_attributetruth {

using namespace pixelplumb;

namespace {

Material checker(TextureWrap wrap)
{
    Material material;
    material.texture = std::make_shared<Texture>(checkerTexture());
    material.wrap = wrap;
    return material;
}

/// Two adjacent texels, 0 and 255, sampled between them.
Material blackAndWhite(TextureWrap wrap)
{
    Material material;
    material.texture = std::make_shared<Texture>(Texture{"two", 2, 1, {black, white}});
    material.filter = TextureFilter::Bilinear;
    material.wrap = wrap;
    return material;
}

} // namespace

/// The truth of perspective and textures against values worked out by hand.
class TestAttributeTruth : public QObject {
    Q_OBJECT

private slots:
    void aThirdOfTheTextureIsSeenInTheMiddleOfAnEdgeThatGoesTwiceAsFar()
    {
        std::array<VertexAttributes, 3> vertices = withU(0, attributeOne);
        vertices[1].w = attribute(2);
        vertices[1].z = attributeOne;
        Primitives primitives = oneSlope(vertices, black);
        primitives.triangles[0].vertices[1].colour = white;

        const oracle::EffectSample sample = sampleOf(primitives, 8, 0);

        QCOMPARE(sample.texture[0], Quantity::rational(1, 3));
        QCOMPARE(sample.affineTexture[0], Quantity::rational(1, 2));
        QCOMPARE(sample.reciprocalW, Quantity::rational(3, 4));
        QCOMPARE(sample.levels[0], Quantity::integer(85)); // the colour too
        QCOMPARE(sample.z, Quantity::rational(1, 2)); // but not the depth
    }

    void onlyTheRatioOfTheWCounts()
    {
        std::array<VertexAttributes, 3> vertices = withU(attribute(1, 7), attribute(-5, 3));
        vertices[0].w = attribute(3);
        vertices[1].w = attribute(1, 4);
        const auto textureOf = [&] {
            Primitives primitives = oneSlope(vertices);
            setMaterial(primitives, checker(TextureWrap::Repeat));
            return sampleOf(primitives, 5, 7).texture[0];
        };
        const Quantity before = textureOf();
        for (VertexAttributes &vertex : vertices)
            vertex.w *= 12;
        QCOMPARE(textureOf(), before);
    }

    void aBoardInPerspectiveHasItsTexelBordersWhereTheyAre()
    {
        // u = x/(32 - x); the borders u = k/8 lie at x = 32k/(8 + k).
        std::array<VertexAttributes, 3> vertices = withU(0, attributeOne);
        vertices[1].w = attribute(2);
        Primitives primitives = oneSlope(vertices);
        setMaterial(primitives, checker(TextureWrap::Repeat));

        QCOMPARE(rowText(primitives), u"####...##..##.#.#"_s);
        primitives.appearance.forced[Effect::Perspective] = Forcing::Off;
        QCOMPARE(rowText(primitives), u"##..##..##..##..#"_s);
        primitives.appearance.forced[Effect::Texture] = Forcing::Off;
        QCOMPARE(rowText(primitives), u"#################"_s);
    }

    void aTexelBeginsOnItsBorder_data()
    {
        QTest::addColumn<int>("sixteenths"); // u at x = 16, in 1/16
        QTest::addColumn<TextureWrap>("wrap");
        QTest::addColumn<QString>("row");
        QTest::newRow("rising, repeated") << 16 << TextureWrap::Repeat << u"##..##..##..##..#"_s;
        QTest::newRow("rising, clamped") << 16 << TextureWrap::Clamp << u"##..##..##..##..."_s;
        QTest::newRow("falling below 0, repeated")
            << -16 << TextureWrap::Repeat << u"#..##..##..##..##"_s;
        QTest::newRow("falling below 0, clamped")
            << -16 << TextureWrap::Clamp << u"#################"_s;
        QTest::newRow("twice, repeated") << 32 << TextureWrap::Repeat << u"#.#.#.#.#.#.#.#.#"_s;
        QTest::newRow("twice, clamped") << 32 << TextureWrap::Clamp << u"#.#.#.#.........."_s;
    }
    void aTexelBeginsOnItsBorder()
    {
        QFETCH(int, sixteenths);
        QFETCH(TextureWrap, wrap);
        QFETCH(QString, row);
        Primitives primitives = oneSlope(withU(0, attribute(sixteenths, 16)));
        setMaterial(primitives, checker(wrap));
        QCOMPARE(rowText(primitives), row);
    }

    void betweenTwoTexelsTheirMeanIsRead_data()
    {
        QTest::addColumn<int>("x"); // in sixteenths of the picture
        QTest::addColumn<TextureWrap>("wrap");
        QTest::addColumn<int>("level");
        QTest::newRow("the first texel's middle") << 4 << TextureWrap::Repeat << 0;
        QTest::newRow("an eighth farther") << 6 << TextureWrap::Repeat << 64; // 63.75
        QTest::newRow("the border between them") << 8 << TextureWrap::Repeat << 128; // 127.5
        QTest::newRow("the second texel's middle") << 12 << TextureWrap::Repeat << 255;
        QTest::newRow("the picture's border, repeated") << 0 << TextureWrap::Repeat << 128;
        QTest::newRow("the picture's border, clamped") << 0 << TextureWrap::Clamp << 0;
        QTest::newRow("the other border, clamped") << 16 << TextureWrap::Clamp << 255;
    }
    void betweenTwoTexelsTheirMeanIsRead()
    {
        QFETCH(int, x);
        QFETCH(TextureWrap, wrap);
        QFETCH(int, level);
        Primitives primitives = oneSlope(withU(0, attributeOne));
        setMaterial(primitives, blackAndWhite(wrap));

        const oracle::EffectSample sample = sampleOf(primitives, x, 0);

        QCOMPARE(int(sample.colour.red()), level);
        QCOMPARE(sample.texels.size(), std::size_t(4));
        Quantity upperWeight = sample.texels[2].weight; // v = 0: half of it comes from the row
                                                        // below
        QCOMPARE(upperWeight, sample.texels[0].weight);
    }

    void aTexelModulatesTheColour()
    {
        Material material;
        material.texture = std::make_shared<Texture>(Texture{"one", 1, 1, {Colour{{128, 1, 255}}}});
        Primitives primitives = oneSlope({}, {{200, 127, 77}});
        setMaterial(primitives, material);
        // 200·128/255 = 100.39, 127/255 = 0.498
        QCOMPARE(sampleOf(primitives, 1, 1).colour, (Colour{{100, 0, 77}}));
    }

    void alphaIsInterpolatedInPerspectiveToo()
    {
        std::array<VertexAttributes, 3> vertices = withAlpha(0);
        vertices[1].alpha = 255;
        vertices[1].w = attribute(2);
        const oracle::EffectSample sample = sampleOf(oneSlope(vertices), 8, 0);
        QCOMPARE(sample.alphaLevel, Quantity::integer(85));
        QCOMPARE(sample.alpha, std::uint8_t(85));
    }

    void beyondTheHorizonOfItsPlaneATriangleHasNoNumbers()
    {
        std::array<VertexAttributes, 3> vertices;
        vertices[1].w = attribute(2); // 1/w = 1 - x/32 in row 0
        Primitives primitives = oneSlope(vertices);
        const auto hasNumbersAt = [&](std::int64_t x) {
            return oracle::effectSampleAt(primitives, 0, ByteRounding::Nearest, {}, x, 0)
                .has_value();
        };
        QVERIFY(hasNumbersAt(33)); // one colour: there is nothing to divide
        primitives.triangles[0].vertices[1].colour = black;
        QVERIFY(hasNumbersAt(31));
        QVERIFY(!hasNumbersAt(32));
        QVERIFY(!hasNumbersAt(33));
    }

    void aNumberTooLongFor128BitsIsTheNearestDouble()
    {
        std::array<VertexAttributes, 3> vertices = withU(1, largestAttribute - 1);
        vertices[0].w = 1;
        vertices[1].w = largestAttribute - 3;
        vertices[2].w = (largestAttribute / 3) | 1;
        Primitives primitives = oneSlope(vertices);
        setMaterial(primitives, checker(TextureWrap::Repeat));
        primitives.triangles[0].vertices[1].position = {largestCoordinate, 12345};
        const oracle::EffectSample sample = sampleOf(primitives, 1, 1);
        QCOMPARE(sample.texture[0].kind(), Quantity::Kind::Float64);
        QVERIFY(sample.texture[0].isFinite());
    }
};

PIXELPLUMB_TEST(TestAttributeTruth)

} // namespace tst_attributetruth

#include "tst_attributetruth.moc"
