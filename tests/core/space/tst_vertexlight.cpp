// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/vertexlight.h"
#include "tests/support/scenes/spacescenes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <cmath>

namespace tst_vertexlight {

using namespace pixelplumb;

namespace {

const double turn = 2 * std::acos(-1.0);

/// A light that shines down at an angle to the z axis, in the xz plane.
Light lightFrom(double angle, const Colour &colour)
{
    Light light;
    light.at = {Attribute(std::llround(-std::sin(angle) * double(attributeOne))), 0,
                Attribute(std::llround(-std::cos(angle) * double(attributeOne)))};
    light.colour = colour;
    return light;
}

/// A triangle of one material in the plane z = 0 that faces the orthographic viewer.
Scene facingScene(double angle, Shading shading)
{
    Scene scene = sceneOf({triangle3({-1, -1, 0}, {1, -1, 0}, {0, 1, 0})});
    scene.camera->projection = Projection::Orthographic;
    Material material;
    material.diffuse = {{200, 100, 50}};
    material.specular = {{90, 80, 70}};
    material.shininess = 5;
    scene.appearance.materials = {material};
    scene.appearance.shading = shading;
    scene.appearance.lights = {lightFrom(angle, {{255, 250, 240}})};
    scene.solids[0].material = 0;
    return scene;
}

/// The level for a normal towards the viewer, by angles: H bisects the angle of L and V.
std::uint8_t expectedLevel(double angle, int colour, int diffuse, int specular, int light)
{
    const int own = int(std::floor(colour * diffuse / 255.0 + 0.5));
    const double facing = std::max(0.0, std::cos(angle));
    const double highlight = facing > 0 ? std::pow(std::cos(angle / 2), 5) : 0;
    const double level = own * (32 + light * facing) / 255 + light * specular / 255.0 * highlight;
    return std::uint8_t(std::clamp(std::floor(level + 0.5), 0.0, 255.0));
}

} // namespace

/// Light before scan conversion: flat and Gouraud shading, and the material's diffuse colour.
class TestVertexLight : public QObject {
    Q_OBJECT

private slots:
    void aFacingTriangleIsLitByTheAnglesOfLightAndHighlight_data()
    {
        QTest::addColumn<double>("angle");
        for (const int degrees : {0, 30, 60, 80, 100, 180})
            QTest::addRow("%d degrees", degrees) << degrees / 360.0 * turn;
    }
    void aFacingTriangleIsLitByTheAnglesOfLightAndHighlight()
    {
        QFETCH(double, angle);
        for (const Shading shading : {Shading::Flat, Shading::Gouraud}) {
            const Primitives lit = primitivesOnSamples(facingScene(angle, shading));

            const Colour expected = {{expectedLevel(angle, 255, 200, 90, 255),
                                      expectedLevel(angle, 255, 100, 80, 250),
                                      expectedLevel(angle, 255, 50, 70, 240)}};
            for (const Vertex &vertex : lit.triangles.at(0).vertices)
                QCOMPARE(vertex.colour, expected);
        }
    }

    void shadingBySamplesLeavesTheVerticesTheirOwnColours()
    {
        const Primitives lit = primitivesOnSamples(facingScene(0.5, Shading::Phong));

        QCOMPARE(lit.triangles.at(0).vertices[0].colour, (Colour{{200, 100, 50}}));
        QCOMPARE(lit.attributes.at(0).vertices[0].normal,
                 (std::array{Attribute(0), Attribute(0), attributeOne}));
    }

    void flatFacesHaveOneColourAndGouraudsCornersTheirOwn()
    {
        // A lamp above the first corner.
        Scene scene = facingScene(0, Shading::Gouraud);
        scene.appearance.lights[0].kind = Light::Kind::Positional;
        scene.appearance.lights[0].at = {-attributeOne, -attributeOne, attributeOne / 2};

        const auto gouraud = primitivesOnSamples(scene).triangles.at(0).vertices;
        scene.appearance.shading = Shading::Flat;
        const auto flat = primitivesOnSamples(scene).triangles.at(0).vertices;

        QVERIFY(gouraud[0].colour.red() > gouraud[1].colour.red());
        QVERIFY(gouraud[1].colour.red() > 0);
        QCOMPARE(flat[0].colour, flat[1].colour);
        QCOMPARE(flat[0].colour, flat[2].colour);
        QVERIFY(flat[0].colour.red() < gouraud[0].colour.red());
        QVERIFY(flat[0].colour.red() > gouraud[1].colour.red());
    }

    void aNormalThatTurnsAwayGetsTheAmbientLightAlone()
    {
        Scene scene = facingScene(0, Shading::Gouraud);
        std::swap(scene.solids[0].corners[0], scene.solids[0].corners[1]);

        const Colour colour = primitivesOnSamples(scene).triangles.at(0).vertices[0].colour;

        QCOMPARE(colour, (Colour{{25, 13, 6}})); // 200·32/255, 100·32/255, 50·32/255
    }

    void aViewerWhereTheLightFallsMakesNoHighlight()
    {
        Appearance appearance;
        appearance.viewer = {};
        const Light light = lightFrom(0, {{255, 255, 255}});
        const LitPoint<double> point{{}, {0, 0, 1}};

        const LightTerm<double> term = lightTerm(appearance, light, 3, point);

        QCOMPARE(term.diffuse, 1.0);
        QCOMPARE(term.specular, 0.0);
    }

    void plainTrianglesWithNormalsAreLitAndThoseWithoutKeepTheirColours()
    {
        Scene scene;
        const Colour grey = {{100, 100, 100}};
        const Triangle triangle{{{{{0, 0}, grey}, {{2560, 0}, grey}, {{0, 2560}, grey}}}};
        scene.triangles = {triangle, triangle};
        TriangleAttributes attributes;
        scene.attributes = {attributes, attributes};
        scene.attributes[1].triangle = 1;
        for (VertexAttributes &vertex : scene.attributes[1].vertices)
            vertex.normal = {0, 0, -3 * attributeOne}; // towards the viewer
        scene.appearance.lights = {{Light::Kind::Directional, {0, 0, attributeOne}, grey}};
        scene.appearance.shading = Shading::Gouraud;

        const Primitives lit = primitivesOnSamples(scene);

        QCOMPARE(lit.triangles[0].vertices[0].colour, grey);
        QCOMPARE(lit.triangles[1].vertices[0].colour, (Colour{{52, 52, 52}})); // 100·132/255
        QCOMPARE(lit.attributes[1].vertices[1].place,
                 (std::array{10 * attributeOne, Attribute(0), Attribute(0)}));
    }

    void aMaterialsDiffuseColourIsMultipliedInAndRounded()
    {
        for (int level = 0; level < 256; ++level) {
            for (int tint = 0; tint < 256; ++tint) {
                const auto expected = int(std::floor(double(level * tint) / 255 + 0.5));
                QCOMPARE(int(tinted(std::uint8_t(level), std::uint8_t(tint))), expected);
            }
        }
    }
};

PIXELPLUMB_TEST(TestVertexLight)

} // namespace tst_vertexlight

#include "tst_vertexlight.moc"
