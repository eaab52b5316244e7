// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/runchecks/runscenes.h"

#include "core/runs/scenerun.h"
#include "core/scene/scenefile.h"
#include "tests/support/scenes/polygons.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/scenes/trianglepictures.h"
#include "tests/support/sourcetree.h"

#include <QDir>

#include <algorithm>

namespace pixelplumb {

namespace {

/// px: the part of an example with effects that its runs show.
constexpr std::int32_t middleWidth = 16;
constexpr std::int32_t middleHeight = 12;

Scene middleOf(Scene scene)
{
    FrameSpec &frame = scene.frame;
    const std::int32_t width = std::min(frame.width, middleWidth);
    const std::int32_t height = std::min(frame.height, middleHeight);
    frame.firstColumn += (frame.width - width) / 2;
    frame.firstRow += (frame.height - height) / 2;
    frame.width = width;
    frame.height = height;
    return scene;
}

Scene withAntialiasing(Scene scene, Antialiasing antialiasing)
{
    scene.appearance.antialiasing = antialiasing;
    return scene;
}

Scene withFourTexels(Scene scene)
{
    for (Material &material : scene.appearance.materials)
        material.filter = TextureFilter::Bilinear;
    return scene;
}

/// A textured triangle in three colours, everywhere at the same distance from the eye.
Scene flatTexture()
{
    Scene scene;
    scene.frame = frameOf(24, 18);
    Material material;
    material.name = "board";
    material.texture = std::make_shared<Texture>(checkerTexture());
    scene.appearance.materials = {material};
    scene.triangles = {triangleOf({latticePixel(2, 2), latticePixel(21, 5), latticePixel(7, 16)})};
    TriangleAttributes attributes{0, {}, 0};
    attributes.vertices[1].texture = {attributeOne, attributeOne / 8};
    attributes.vertices[2].texture = {attributeOne / 4, attributeOne};
    scene.attributes = {attributes};
    return scene;
}

} // namespace

Scene sceneCutByItsFrame()
{
    Scene cut;
    cut.frame = frameOf(14, 11, 3, 2);
    cut.triangles = {triangleOf({LatticePoint{100, 100}, LatticePoint{5200, 900}, {1300, 4500}}),
                     triangleOf({LatticePoint{1300, 4500}, LatticePoint{90, 3000}, {4000, 3333}}),
                     triangleOf({latticePixel(5, 3), latticePixel(5, 9), latticePixel(12, 6)}),
                     triangleOf({latticePixel(9, 3), latticePixel(9, 10), latticePixel(9, 3)})};
    cut.shapes = {lineAt(1, 1, 40, 20),
                  lineAt(16, 2, 0, 9),
                  lineAt(8, 30, 5, -4),
                  lineAt(7, 7, 7, 7),
                  lineAtUnits({900, 600}, {4000, 3000}),
                  lineAtUnits({4000, 700}, {900, 2500}),
                  lineAtUnits({2100, -300}, {2900, 5000}),
                  lineAtUnits({2900, -300}, {2100, 5000}),
                  circleAt(6, 5, 9),
                  circleAt(9, 7, 0),
                  circleAt(9, 7, 1),
                  circleAt(9, 7, 4, ShapeFill::NonZero),
                  ellipseAtUnits({2304, 1792}, 1700, 300),
                  ellipseAtUnits({2304, 1792}, 300, 1700),
                  polygonOf({pixels({{1, 1}, {15, 3}, {13, 12}, {4, 10}})}),
                  pentagram(ShapeFill::NonZero),
                  pentagram(ShapeFill::Outline),
                  bezierAt({{900, 600}, {4000, 3000}, {2100, 100}})};
    cut.shapes.back().fill = ShapeFill::EvenOdd;
    Shape points;
    points.kind = PrimitiveKind::Point;
    for (std::int64_t i = 0; i < 12; ++i)
        points.vertices.push_back({latticePixel(2 + i, 1 + i), {{200, 100, 50}}});
    cut.shapes.push_back(points);
    return cut;
}

Scene sceneThatCarriesNumbers()
{
    Scene scene;
    scene.frame = frameOf(16, 12);
    scene.triangles = {triangleOf({LatticePoint{300, 300}, LatticePoint{3700, 900}, {1500, 2900}})};
    scene.attributes.resize(1);
    for (std::size_t i = 0; i < 3; ++i) {
        VertexAttributes &vertex = scene.attributes[0].vertices[i];
        vertex.z = Attribute(i + 1) * attributeOne / 4;
        vertex.texture = {attributeOne / 3 * Attribute(i), attributeOne / Attribute(i + 1)};
        vertex.normal = {attributeOne, Attribute(i) * attributeOne / 2, attributeOne};
    }
    return scene;
}

std::vector<NamedScene> scenesWithEffects()
{
    std::vector<NamedScene> scenes;
    const QDir folder(resource(u"/scenes"_s));
    for (const QString &name : folder.entryList({u"*.json"_s})) {
        const Scene example = readSceneFile(folder.filePath(name))->scene;
        if (planOf(SceneRun(example)).isPlain())
            continue;
        const Scene middle = middleOf(example);
        scenes.push_back({name, middle});
        const std::vector<Material> &materials = example.appearance.materials;
        if (materials.empty() && !example.hasSolids())
            continue;
        scenes.push_back(
            {name + u", 4 samples"_s, withAntialiasing(middle, Antialiasing::Samples4)});
        scenes.push_back({name + u", area"_s, withAntialiasing(middle, Antialiasing::Area)});
        if (std::ranges::any_of(materials, [](const Material &each) { return bool(each.texture); }))
            scenes.push_back({name + u", four texels"_s, withFourTexels(middle)});
    }
    scenes.push_back({u"four texels without perspective"_s, withFourTexels(flatTexture())});
    return scenes;
}

Scene departingScene(const Method &method)
{
    Scene scene;
    scene.frame = frameOf(24, 20);
    scene.method = method.id.toStdString();
    if (method.draws(PrimitiveKind::Triangle)) {
        // Between pixels and not sorted by x; the rounded box of the second triangle ends a column
        // before its right side.
        scene.triangles
            = {triangleOf({LatticePoint{3000, 900}, LatticePoint{430, 300}, {5300, 4500}}),
               triangleOf(
                   {LatticePoint{384, 2944}, LatticePoint{2368, 2944}, LatticePoint{2368, 4480}})};
    } else if (method.draws(PrimitiveKind::Line)) {
        scene.shapes = {lineAt(2, 1, 12, 4), lineAtUnits({400, 700}, {4500, 4300})};
    } else {
        scene.shapes = {circleAt(9, 9, 1), circleAt(9, 9, 8)};
    }
    return scene;
}

} // namespace pixelplumb
