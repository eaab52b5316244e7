// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/effectoracle.h"
#include "core/oracle/effectsample.h"
#include "core/oracle/squarearea.h"
#include "tests/support/scanning.h"

#include <QRandomGenerator>
#include <QTest>

using namespace pixelplumb;
using oracle::EffectTruth;

namespace {

constexpr Colour white = {{255, 255, 255}};
constexpr Colour black = {{0, 0, 0}};
constexpr ScanSettings closed = {};

Attribute attribute(std::int64_t numerator, std::int64_t denominator = 1)
{
    return numerator * attributeOne / denominator;
}

/// (0, 0), (16, 0), (0, 16): in row 0 the second vertex' weight is x/16 and the third's is 0.
Triangle slope(const Colour &colour)
{
    return {{{{latticePixel(0, 0), colour},
              {latticePixel(16, 0), colour},
              {latticePixel(0, 16), colour}}}};
}

/// Such a triangle with attributes, and room for more.
Primitives oneSlope(const std::array<VertexAttributes, 3> &vertices, const Colour &colour = white)
{
    Primitives primitives{{slope(colour)}, {}, {{0, vertices}}};
    primitives.attributes[0].material = noMaterial;
    return primitives;
}

void addSlope(Primitives &primitives, const std::array<VertexAttributes, 3> &vertices,
              const Colour &colour)
{
    primitives.attributes.push_back({primitives.triangles.size(), vertices});
    primitives.triangles.push_back(slope(colour));
}

void setMaterial(Primitives &primitives, const Material &material)
{
    primitives.appearance.materials = {material};
    primitives.attributes[0].material = 0;
}

/// All three with this depth.
std::array<VertexAttributes, 3> atDepth(Attribute z)
{
    std::array<VertexAttributes, 3> vertices;
    for (VertexAttributes &vertex : vertices)
        vertex.z = z;
    return vertices;
}

/// All three with this alpha.
std::array<VertexAttributes, 3> withAlpha(std::uint8_t alpha)
{
    std::array<VertexAttributes, 3> vertices;
    for (VertexAttributes &vertex : vertices)
        vertex.alpha = alpha;
    return vertices;
}

FrameBuffer truthOver(const Primitives &primitives, const FrameSpec &spec,
                      const ScanSettings &settings = closed)
{
    FrameBuffer frame(spec);
    oracle::drawEffects(primitives, settings, oracle::truthOf(primitives.appearance), frame.view());
    return frame;
}

Colour pixelOf(const FrameBuffer &frame, std::int64_t x, std::int64_t y)
{
    return unpacked(*frame.view().at(x, y));
}

/// The pixels of row 0 from column 0 on: # white, . black, and the others by the first digit of
/// their red.
QString rowText(const Primitives &primitives, std::int32_t width = 17,
                const ScanSettings &settings = closed)
{
    const FrameBuffer frame = truthOver(primitives, frameOf(width, 1), settings);
    QString text;
    for (std::int32_t x = 0; x < width; ++x) {
        const Colour colour = pixelOf(frame, x, 0);
        text += colour == white ? QChar(u'#')
            : colour == black   ? QChar(u'.')
                                : QString::number(colour.red()).front();
    }
    return text;
}

oracle::EffectSample sampleOf(const Primitives &primitives, std::int64_t x, std::int64_t y)
{
    return *oracle::effectSampleAt(primitives, 0, ByteRounding::Nearest,
                                   oracle::truthOf(primitives.appearance), x, y);
}

Material checker(TextureWrap wrap)
{
    Material material;
    material.texture = std::make_shared<Texture>(checkerTexture());
    material.wrap = wrap;
    return material;
}

/// Two texels side by side, 0 and 255, read between them.
Material blackAndWhite(TextureWrap wrap)
{
    Material material;
    material.texture = std::make_shared<Texture>(Texture{"two", 2, 1, {black, white}});
    material.filter = TextureFilter::Bilinear;
    material.wrap = wrap;
    return material;
}

/// u from one value to another along row 0.
std::array<VertexAttributes, 3> withU(Attribute from, Attribute to)
{
    std::array<VertexAttributes, 3> vertices;
    vertices[0].texture[0] = vertices[2].texture[0] = from;
    vertices[1].texture[0] = to;
    return vertices;
}

/// What lies at x <= edge, in lattice units, of the pixels around the origin; white, opaque.
Primitives leftHalf(Lattice edge, Antialiasing antialiasing)
{
    const Lattice far = 1024 * unitsPerPixel;
    Primitives primitives;
    primitives.triangles = {{{{{{edge, -far}, white}, {{edge, far}, white}, {{-far, 0}, white}}}}};
    primitives.appearance.antialiasing = antialiasing;
    return primitives;
}

int redOfOrigin(const Primitives &primitives, FillRule rule = FillRule::Closed)
{
    const FrameBuffer frame
        = truthOver(primitives, frameOf(3, 1, -1, 0), {Arithmetic::Exact, rule});
    return pixelOf(frame, 0, 0).red();
}

/// A triangle lit by one white light without ambient; N = (0, 0, 1).
Primitives litSlope(const std::array<Attribute, 3> &towardsLight,
                    const std::array<Attribute, 3> &viewer)
{
    std::array<VertexAttributes, 3> vertices;
    for (VertexAttributes &vertex : vertices)
        vertex.normal = {0, 0, attribute(3)};
    Primitives primitives = oneSlope(vertices, {{200, 100, 0}});
    Material material;
    material.specular = {{100, 100, 100}};
    material.shininess = 2;
    setMaterial(primitives, material);
    Appearance &appearance = primitives.appearance;
    appearance.ambient = black;
    appearance.lights = {
        {Light::Kind::Directional, {-towardsLight[0], -towardsLight[1], -towardsLight[2]}, white}};
    appearance.viewer = viewer;
    return primitives;
}

} // namespace

/// The truth of effects against what was worked out by hand; that it agrees with a second
/// derivation in fractions is the effect cases' to say (tst_effectcases).
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

        QCOMPARE(rowText(levelFirst), QStringLiteral("#########........"));
        QCOMPARE(rowText(risingFirst), QStringLiteral("########........."));
    }

    void withoutDepthTheLaterTriangleShows()
    {
        Primitives primitives = oneSlope(atDepth(0), black);
        addSlope(primitives, atDepth(attributeOne), white);
        QCOMPARE(rowText(primitives), QStringLiteral("................."));

        primitives.appearance.depth = DepthUse::Off;
        QCOMPARE(rowText(primitives), QStringLiteral("#################"));
        primitives.appearance.depth = DepthUse::On;
        primitives.appearance.forced[Effect::Depth] = Forcing::Off;
        QCOMPARE(rowText(primitives), QStringLiteral("#################"));
    }

    void aLastBitOfDepthCountsInTheExactBufferAlone()
    {
        // Both z are nearest to the level 32768 of 65535.
        Primitives primitives = oneSlope(atDepth(attribute(1, 2)), white);
        addSlope(primitives, atDepth(attribute(1, 2) + 1), black);

        QCOMPARE(rowText(primitives), QStringLiteral("#################"));
        primitives.appearance.depthFormat = DepthFormat::Bits16;
        QCOMPARE(rowText(primitives), QStringLiteral("................."));
        // (1/2 + 2^-24)(2^24 - 1) + 1/2 = 8388608 + 1 - 2^-24: one above the level of 1/2.
        primitives.appearance.depthFormat = DepthFormat::Bits24;
        QCOMPARE(sampleOf(primitives, 3, 0).depth, Quantity::integer(8388608));
        QCOMPARE(rowText(primitives), QStringLiteral("................."));
        // 2^-24 is 256 of the levels of 32 bits.
        primitives.appearance.depthFormat = DepthFormat::Bits32;
        QCOMPARE(rowText(primitives), QStringLiteral("#################"));
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
        QCOMPARE(rowText(primitives, 1), QStringLiteral("."));
    }

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
        QCOMPARE(sample.levels[0], Quantity::integer(85)); // colours too
        QCOMPARE(sample.z, Quantity::rational(1, 2)); // but not the depth
    }

    void onlyTheRatioOfTheWCounts()
    {
        std::array<VertexAttributes, 3> vertices = withU(attribute(1, 7), attribute(-5, 3));
        vertices[0].w = attribute(3);
        vertices[1].w = attribute(1, 4);
        const Quantity before = sampleOf(oneSlope(vertices), 5, 7).texture[0];
        for (VertexAttributes &vertex : vertices)
            vertex.w *= 12;
        QCOMPARE(sampleOf(oneSlope(vertices), 5, 7).texture[0], before);
    }

    void aBoardInPerspectiveHasItsTexelBordersWhereTheyAre()
    {
        // u = x/(32 - x); the borders u = k/8 stand at x = 32k/(8 + k).
        std::array<VertexAttributes, 3> vertices = withU(0, attributeOne);
        vertices[1].w = attribute(2);
        Primitives primitives = oneSlope(vertices);
        setMaterial(primitives, checker(TextureWrap::Repeat));

        QCOMPARE(rowText(primitives), QStringLiteral("####...##..##.#.#"));
        primitives.appearance.forced[Effect::Perspective] = Forcing::Off;
        QCOMPARE(rowText(primitives), QStringLiteral("##..##..##..##..#"));
        primitives.appearance.forced[Effect::Texture] = Forcing::Off;
        QCOMPARE(rowText(primitives), QStringLiteral("#################"));
    }

    void aTexelBeginsOnItsBorder_data()
    {
        QTest::addColumn<int>("sixteenths"); // u at x = 16, of 1/16
        QTest::addColumn<TextureWrap>("wrap");
        QTest::addColumn<QString>("row");
        QTest::newRow("rising, repeated")
            << 16 << TextureWrap::Repeat << QStringLiteral("##..##..##..##..#");
        QTest::newRow("rising, clamped")
            << 16 << TextureWrap::Clamp << QStringLiteral("##..##..##..##...");
        QTest::newRow("falling below 0, repeated")
            << -16 << TextureWrap::Repeat << QStringLiteral("#..##..##..##..##");
        QTest::newRow("falling below 0, clamped")
            << -16 << TextureWrap::Clamp << QStringLiteral("#################");
        QTest::newRow("twice, repeated")
            << 32 << TextureWrap::Repeat << QStringLiteral("#.#.#.#.#.#.#.#.#");
        QTest::newRow("twice, clamped")
            << 32 << TextureWrap::Clamp << QStringLiteral("#.#.#.#..........");
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
        QTest::addColumn<int>("x"); // of sixteenths of the picture
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
        Quantity upperWeight = sample.texels[2].weight; // v = 0: half of the row below
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

    void blendingRoundsToTheNearestByte()
    {
        for (int alpha = 0; alpha <= 255; ++alpha) {
            for (const int source : {0, 1, 2, 77, 127, 128, 254, 255}) {
                for (const int destination : {0, 1, 3, 100, 128, 200, 255}) {
                    const Colour blended
                        = oracle::blended({{std::uint8_t(source), 0, 0}}, std::uint8_t(alpha),
                                          {{std::uint8_t(destination), 0, 0}});
                    const int sum = source * alpha + destination * (255 - alpha);
                    // 255 is odd: there is no tie, and just one byte is nearer than half a level.
                    QVERIFY(std::abs(255 * blended.red() - sum) <= 127);
                }
            }
        }
    }

    void glassLetsThroughWhatStandsBehindIt()
    {
        Primitives primitives = oneSlope(withAlpha(255), {{200, 0, 10}});
        addSlope(primitives, withAlpha(100), {{0, 255, 20}});
        const FrameBuffer frame = truthOver(primitives, frameOf(4, 4));
        // (200·155)/255 = 121.57, (255·100)/255 = 100, (10·155 + 20·100)/255 = 13.92
        QCOMPARE(pixelOf(frame, 1, 1), (Colour{{122, 100, 14}}));
        primitives.appearance.forced[Effect::Blending] = Forcing::Off;
        QCOMPARE(pixelOf(truthOver(primitives, frameOf(4, 4)), 1, 1), (Colour{{0, 255, 20}}));
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

    void aHalfCoveredPixelHasHalfTheColour()
    {
        const Primitives half = leftHalf(0, Antialiasing::Area);
        QCOMPARE(sampleOf(half, 0, 0).area, Quantity::rational(1, 2));
        QCOMPARE(sampleOf(half, 0, 0).sharedAlpha, std::uint8_t(128)); // 127.5
        QCOMPARE(redOfOrigin(half), 128);
        // The edge stands on the pixel's side, left and right.
        QCOMPARE(redOfOrigin(leftHalf(-halfPixel, Antialiasing::Area)), 0);
        QCOMPARE(redOfOrigin(leftHalf(halfPixel, Antialiasing::Area)), 255);
        QCOMPARE(redOfOrigin(leftHalf(halfPixel - 1, Antialiasing::Area)), 254); // 255 - 0.996
        QCOMPARE(redOfOrigin(leftHalf(1 - halfPixel, Antialiasing::Area)), 1);
    }

    void thePartsOfATriangleInAllPixelsSumToItsArea()
    {
        QRandomGenerator random(20);
        const auto coordinate
            = [&](Lattice extent) { return Lattice(random.bounded(int(2 * extent + 1))) - extent; };
        for (int i = 0; i < 40; ++i) {
            const Lattice thickness = i % 4 == 0 ? 3 : 1500; // slivers too
            const LatticePoint a = {coordinate(1500), coordinate(1500)};
            const LatticePoint b = {coordinate(1500), coordinate(1500)};
            const Triangle triangle
                = triangleAtUnits(a, b, {a.x + coordinate(thickness), a.y + coordinate(thickness)});
            BigRational sum = 0;
            for (std::int64_t y = -13; y <= 13; ++y) {
                for (std::int64_t x = -13; x <= 13; ++x)
                    sum += oracle::areaInSquare(triangle, x, y);
            }
            const BigInteger whole = absolute(doubledArea(triangle));
            QVERIFY2(sum == BigRational(whole, 2 * unitsPerPixel * unitsPerPixel),
                     qPrintable(QString::number(i)));
        }
    }

    void samplesOfAHalfPlaneAreCounted_data()
    {
        QTest::addColumn<Antialiasing>("antialiasing");
        QTest::addColumn<Lattice>("edge");
        QTest::addColumn<FillRule>("rule");
        QTest::addColumn<int>("red");
        const auto four = Antialiasing::Samples4;
        const auto sixteen = Antialiasing::Samples16;
        QTest::newRow("2 of 4") << four << Lattice(0) << FillRule::Closed << 128; // 127.5
        QTest::newRow("3 of 4") << four << Lattice(64) << FillRule::Closed << 191; // 191.25
        QTest::newRow("4 of 4") << four << halfPixel << FillRule::Closed << 255;
        QTest::newRow("0 of 4") << four << -halfPixel << FillRule::Closed << 0;
        QTest::newRow("one on the edge") << four << Lattice(-96) << FillRule::Closed << 64; // 63.75
        QTest::newRow("one on the edge, open") << four << Lattice(-96) << FillRule::Open << 0;
        // Left of 0 are -1 -3 -5 -2 -4 -6 -8 -7, and 0 itself.
        QTest::newRow("9 of 16") << sixteen << Lattice(0) << FillRule::Closed << 143; // 143.44
        QTest::newRow("8 of 16") << sixteen << Lattice(0) << FillRule::Open << 128; // 127.5
        QTest::newRow("1 of 16") << sixteen << Lattice(-128) << FillRule::Closed << 16; // 15.94
    }
    void samplesOfAHalfPlaneAreCounted()
    {
        QFETCH(Antialiasing, antialiasing);
        QFETCH(Lattice, edge);
        QFETCH(FillRule, rule);
        QFETCH(int, red);
        QCOMPARE(redOfOrigin(leftHalf(edge, antialiasing), rule), red);
    }

    void aPixelHasSeveralSamplesWhereAnEdgeMeetsItsSquare()
    {
        const Triangle triangle = slope(white);
        // Row -1 touches the edge y = 0 nowhere, row 0 does; the diagonal x + y = 16 touches the
        // square around (9, 8) in its corner (8.5, 7.5).
        QVERIFY(!oracle::edgeMeetsSquare(triangle, 4, -1));
        QVERIFY(oracle::edgeMeetsSquare(triangle, 4, 0));
        QVERIFY(!oracle::edgeMeetsSquare(triangle, 4, 1));
        QVERIFY(oracle::edgeMeetsSquare(triangle, 9, 8));
        QVERIFY(!oracle::edgeMeetsSquare(triangle, 9, 9));
        QVERIFY(oracle::edgeMeetsSquare(triangle, 16, 0));
        QVERIFY(!oracle::edgeMeetsSquare(triangle, 17, 0)); // the edge's line goes on, it does not
        const Triangle touching = triangleAtUnits({128, 5}, {900, 900}, {900, 0});
        QVERIFY(oracle::edgeMeetsSquare(touching, 0, 0)); // in one point of its side
    }

    void samplesHaveDepthsAndColoursOfTheirOwn()
    {
        // z = x/16 passes z = 1/2 between the samples of pixel 8, which an edge (y = 0) meets; at
        // y = 0 the samples of the lower half are outside of both.
        std::array<VertexAttributes, 3> rising;
        rising[1].z = attributeOne;
        Primitives primitives = oneSlope(atDepth(attribute(1, 2)), {{0, 200, 0}});
        addSlope(primitives, rising, {{200, 0, 0}});
        primitives.appearance.antialiasing = Antialiasing::Samples4;
        const FrameBuffer frame = truthOver(primitives, frameOf(17, 2));
        // Of the samples (-96, 32) and (32, 96) the first is nearer than 1/2, the second is not.
        QCOMPARE(pixelOf(frame, 8, 0), (Colour{{50, 50, 0}}));
        QCOMPARE(pixelOf(frame, 8, 1), (Colour{{200, 0, 0}})); // one sample, and the later shows
    }

    void lightHasTheNumbersOfItsFormula_data()
    {
        using Vector = std::array<Attribute, 3>;
        QTest::addColumn<Vector>("light");
        QTest::addColumn<Vector>("viewer");
        QTest::addColumn<Colour>("colour");
        const Attribute one = attributeOne;
        QTest::newRow("from ahead") << Vector{0, 0, one} << Vector{0, 0, one}
                                    << Colour{{255, 200, 100}}; // 200 + 100, 100 + 100, 0 + 100
        QTest::newRow("from 45°, seen in the mirror")
            << Vector{one, 0, one} << Vector{-one, 0, one}
            << Colour{{241, 171, 100}}; // 200·0.70711 + 100, 100·0.70711 + 100, 100
        QTest::newRow("from 45°, seen from ahead")
            << Vector{one, 0, one}
            << Vector{0, 0, 3 * one} // 0.92388² = 0.85355 of 100 beside the same
            << Colour{{227, 156, 85}};
        QTest::newRow("from behind")
            << Vector{one, 0, -one} << Vector{0, 0, one} << Colour{{0, 0, 0}};
        QTest::newRow("along the surface")
            << Vector{one, 0, 0} << Vector{0, 0, one} << Colour{{0, 0, 0}};
        QTest::newRow("seen from where it shines to")
            << Vector{one, 0, one} << Vector{-5 * one, 0, -5 * one} << Colour{{141, 71, 0}};
        QTest::newRow("no viewer")
            << Vector{one, 0, one} << Vector{0, 0, 0} << Colour{{141, 71, 0}};
        // N·L = 3/5; N·V = -24/25, so that H lies behind: 3/5 - 24/25 < 0.
        QTest::newRow("seen from behind")
            << Vector{4 * one, 0, 3 * one} << Vector{7 * one, 0, -24 * one} << Colour{{120, 60, 0}};
        QTest::newRow("no light's direction")
            << Vector{0, 0, 0} << Vector{0, 0, one} << Colour{{0, 0, 0}};
    }
    void lightHasTheNumbersOfItsFormula()
    {
        using Vector = std::array<Attribute, 3>;
        QFETCH(Vector, light);
        QFETCH(Vector, viewer);
        QFETCH(Colour, colour);
        const oracle::EffectSample sample = sampleOf(litSlope(light, viewer), 3, 4);
        QCOMPARE(sample.colour, colour);
        QVERIFY(!sample.lit->undecided);
    }

    void aLightAtAPlaceShinesFromThere()
    {
        const Attribute one = attributeOne;
        Primitives primitives = litSlope({0, 0, one}, {0, 0, one});
        for (std::size_t i = 0; i < 3; ++i) {
            const LatticePoint &position = primitives.triangles[0].vertices[i].position;
            primitives.attributes[0].vertices[i].place
                = {position.x * (one / unitsPerPixel), position.y * (one / unitsPerPixel), 0};
        }
        primitives.appearance.lights = {{Light::Kind::Positional, {3 * one, 0, 4 * one}, white}};
        primitives.appearance.materials[0].specular = black;
        // Above (3, 0); at (0, 0) N·L = 4/5.
        QCOMPARE(sampleOf(primitives, 3, 0).colour, (Colour{{200, 100, 0}}));
        QCOMPARE(sampleOf(primitives, 0, 0).colour, (Colour{{160, 80, 0}}));
        QCOMPARE(sampleOf(primitives, 0, 0).lit->lights[0].diffuse, 0.8);
        // From beside the light, seen by the viewer there, H = L = V and the highlight is N·L².
        primitives.appearance.viewerKind = Light::Kind::Positional;
        primitives.appearance.viewer = {3 * one, 0, 4 * one};
        QCOMPARE(sampleOf(primitives, 0, 0).lit->lights[0].highlight, 0.64);
    }

    void surroundingLightIsThereWithoutNormalsOfAnyLengthButNotWithoutAny()
    {
        const Attribute one = attributeOne;
        Primitives primitives = litSlope({0, 0, one}, {0, 0, one});
        primitives.appearance.ambient = {{51, 102, 255}};
        std::array<VertexAttributes, 3> &vertices = primitives.attributes[0].vertices;
        for (VertexAttributes &vertex : vertices)
            vertex.normal[2] = 0;
        QVERIFY(!sampleOf(primitives, 4, 4).lit);
        QCOMPARE(sampleOf(primitives, 4, 4).colour, (Colour{{200, 100, 0}}));
        vertices[1].normal[0] = one; // and the opposite one cancels it on x = y
        vertices[2].normal[0] = -one;
        QCOMPARE(sampleOf(primitives, 4, 4).colour, (Colour{{40, 40, 0}}));
    }

    void aLimitBetweenTwoBytesThatIsMetExactlyIsSaidToBeUndecided()
    {
        const Attribute one = attributeOne;
        Primitives primitives = litSlope({0, one, one}, {0, 0, one});
        for (VertexAttributes &vertex : primitives.attributes[0].vertices)
            vertex.normal = {one, 0, one}; // N·L = 1/2
        primitives.appearance.materials[0].specular = black;
        for (Vertex &vertex : primitives.triangles[0].vertices)
            vertex.colour = {{255, 254, 0}}; // 127.5 and 127
        const oracle::EffectSample sample = sampleOf(primitives, 3, 4);
        QCOMPARE(sample.colour, (Colour{{128, 127, 0}}));
        QVERIFY(sample.lit->undecided);

        FrameBuffer frame(frameOf(2, 2, 15, 0));
        const auto undecided = oracle::drawEffects(
            primitives, closed, oracle::truthOf(primitives.appearance), frame.view());
        QCOMPARE(undecided, (std::vector<oracle::PixelPlace>{{15, 0}, {16, 0}, {15, 1}}));
    }

    void lightFallsOnTheColourAfterTheTexture()
    {
        Primitives primitives = litSlope({0, 0, attributeOne}, {0, 0, attributeOne});
        Material &material = primitives.appearance.materials[0];
        material.texture = std::make_shared<Texture>(Texture{"one", 1, 1, {Colour{{51, 0, 0}}}});
        // 200·51/255 = 40 and the highlight's 100 over it, which the texel does not darken
        QCOMPARE(sampleOf(primitives, 3, 4).colour, (Colour{{140, 100, 100}}));
    }

    void withoutEffectsThePictureIsThatOfTheTriangles()
    {
        QRandomGenerator random(5);
        for (const FillRule rule : allFillRules) {
            const ScanSettings settings = {Arithmetic::Exact, rule, ByteRounding::Truncate};
            const FrameSpec spec = frameOf(24, 24, -12, -12);
            Primitives primitives;
            Drawing byTriangle(spec);
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
            Drawing byEffects(spec);
            byEffects.draw([&](FrameView frame) {
                oracle::drawEffects(primitives, settings, oracle::truthOf(primitives.appearance),
                                    frame);
            });
            QCOMPARE(byEffects.text(), byTriangle.text());
            QVERIFY(byEffects == byTriangle);
        }
    }

    void aTriangleWithoutAreaDrawsNothingOnceItHasAnEffect()
    {
        Primitives primitives;
        primitives.triangles = {triangleAt(0, 0, 3, 3, 6, 6)};
        primitives.appearance.depth = DepthUse::Off;
        const auto count = [&] {
            Drawing drawing(frameOf(8, 8));
            drawing.draw([&](FrameView frame) {
                oracle::drawEffects(primitives, closed, oracle::truthOf(primitives.appearance),
                                    frame);
            });
            return drawing.count();
        };
        QCOMPARE(count(), std::int64_t(7));
        primitives.attributes = {{0, withAlpha(254)}};
        QCOMPARE(count(), std::int64_t(0));
        primitives.attributes.clear();
        primitives.appearance.antialiasing = Antialiasing::Area;
        QCOMPARE(count(), std::int64_t(0));
        QVERIFY(!oracle::effectSampleAt(primitives, 0, ByteRounding::Nearest, {}, 1, 1));
    }

    void beyondTheHorizonOfItsPlaneATriangleHasNoNumbers()
    {
        std::array<VertexAttributes, 3> vertices;
        vertices[1].w = attribute(2); // 1/w = 1 - x/32 in row 0
        const Primitives primitives = oneSlope(vertices);
        QVERIFY(oracle::effectSampleAt(primitives, 0, ByteRounding::Nearest, {}, 31, 0));
        QVERIFY(!oracle::effectSampleAt(primitives, 0, ByteRounding::Nearest, {}, 32, 0));
        QVERIFY(!oracle::effectSampleAt(primitives, 0, ByteRounding::Nearest, {}, 33, 0));
    }

    void aNumberTooLongFor128BitsIsTheNearestDouble()
    {
        std::array<VertexAttributes, 3> vertices = withU(1, largestAttribute - 1);
        vertices[0].w = 1;
        vertices[1].w = largestAttribute - 3;
        vertices[2].w = (largestAttribute / 3) | 1;
        Primitives primitives = oneSlope(vertices);
        primitives.triangles[0].vertices[1].position = {largestCoordinate, 12345};
        const oracle::EffectSample sample = sampleOf(primitives, 1, 1);
        QCOMPARE(sample.texture[0].kind(), Quantity::Kind::Float64);
        QVERIFY(sample.texture[0].isFinite());
    }
};

QTEST_GUILESS_MAIN(TestEffectOracle)
#include "tst_effectoracle.moc"
