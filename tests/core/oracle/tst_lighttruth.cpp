// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/effectslope.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_lighttruth {

using namespace pixelplumb;

namespace {

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

/// The truth of light against values worked out by hand.
class TestLightTruth : public QObject {
    Q_OBJECT

private slots:
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
            << Vector{0, 0, 3 * one} // 0.92388² = 0.85355 of 100, plus the same
            << Colour{{227, 156, 85}};
        QTest::newRow("from behind")
            << Vector{one, 0, -one} << Vector{0, 0, one} << Colour{{0, 0, 0}};
        QTest::newRow("along the surface")
            << Vector{one, 0, 0} << Vector{0, 0, one} << Colour{{0, 0, 0}};
        QTest::newRow("seen from where it shines to")
            << Vector{one, 0, one} << Vector{-5 * one, 0, -5 * one} << Colour{{141, 71, 0}};
        QTest::newRow("no viewer")
            << Vector{one, 0, one} << Vector{0, 0, 0} << Colour{{141, 71, 0}};
        // N·L = 3/5; N·V = -24/25, so H points backward: 3/5 - 24/25 < 0.
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
        // With the viewer at the light, H = L = V and the highlight is N·L².
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
            primitives, closedRule, oracle::truthOf(primitives.appearance), frame.view());
        QCOMPARE(undecided, (std::vector<oracle::PixelPlace>{{15, 0}, {16, 0}, {15, 1}}));
    }

    void lightFallsOnTheColourAfterTheTexture()
    {
        Primitives primitives = litSlope({0, 0, attributeOne}, {0, 0, attributeOne});
        Material &material = primitives.appearance.materials[0];
        material.texture = std::make_shared<Texture>(Texture{"one", 1, 1, {Colour{{51, 0, 0}}}});
        // 200·51/255 = 40 plus the highlight's 100, which the texel does not darken
        QCOMPARE(sampleOf(primitives, 3, 4).colour, (Colour{{140, 100, 100}}));
    }
};

PIXELPLUMB_TEST(TestLightTruth)

} // namespace tst_lighttruth

#include "tst_lighttruth.moc"
