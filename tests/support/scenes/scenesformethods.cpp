// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/scenesformethods.h"

#include "core/runs/scenerun.h"
#include "core/scene/scenefile.h"
#include "tests/support/scenes/polygons.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/sourcetree.h"

#include <QDirIterator>

#include <algorithm>

namespace pixelplumb {

namespace {

Triangle triangleAt(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1,
                    std::int64_t x2, std::int64_t y2)
{
    return {{{{latticePixel(x0, y0), {{255, 0, 0}}},
              {latticePixel(x1, y1), {{0, 255, 0}}},
              {latticePixel(x2, y2), {{0, 0, 255}}}}}};
}

Scene sceneOfTriangles(const std::vector<Triangle> &triangles)
{
    Scene scene;
    scene.frame.width = 16;
    scene.frame.height = 12;
    scene.triangles = triangles;
    return scene;
}

} // namespace

std::vector<NamedScene> scenesForEveryMethod()
{
    std::vector<NamedScene> scenes;
    QDirIterator files(resource(u"/scenes"_s), {u"*.json"_s}, QDir::Files);
    while (files.hasNext()) {
        Scene scene = readSceneFile(files.next())->scene;
        if (!planOf(SceneRun(scene)).isPlain())
            continue;
        scene.frame.width = std::min(scene.frame.width, 16);
        scene.frame.height = std::min(scene.frame.height, 16);
        scenes.push_back({files.fileName(), scene});
    }
    scenes.push_back({u"empty"_s, sceneOfTriangles({})});
    scenes.push_back({u"collinear"_s, sceneOfTriangles({triangleAt(1, 1, 5, 3, 9, 5)})});
    scenes.push_back({u"upright"_s, sceneOfTriangles({triangleAt(3, 1, 3, 9, 3, 4)})});
    scenes.push_back({u"point"_s, sceneOfTriangles({triangleAt(4, 4, 4, 4, 4, 4)})});
    scenes.push_back({u"far"_s,
                      sceneOfTriangles({triangleAt(-(1 << 30), 3, 1 << 30, 1, 7, 1 << 30),
                                        triangleAt(1, 1, 9, 2, 4, 8)})});
    Scene mixed = sceneOfTriangles({triangleAt(1, 1, 9, 2, 4, 8), triangleAt(1, 1, 5, 3, 9, 5)});
    mixed.shapes = {lineAtUnits({300, 700}, {3333, 1111}),
                    lineAt(3, 2, 3, 9),
                    ellipseAtUnits({1551, 1333}, 1031, 777),
                    circleAt(7, 6, 4),
                    circleAt(7, 6, 3, ShapeFill::NonZero),
                    bezierAt({{256, 256}, {1500, 3000}, {3500, 300}}),
                    polygonOf({{{300, 500}, {3333, 1111}, {2900, 2600}, {700, 2100}}})};
    mixed.shapes.push_back(mixed.shapes.back());
    mixed.shapes.back().fill = ShapeFill::Outline;
    mixed.shapes.push_back(mixed.shapes.back());
    for (Vertex &vertex : mixed.shapes.back().vertices)
        vertex.position.x += 40 * unitsPerPixel; // outside the frame
    mixed.shapes.push_back(bezierAt({{256, 256}, {1500, 3000}, {3500, 300}}));
    mixed.shapes.back().fill = ShapeFill::EvenOdd;
    mixed.shapes.push_back(polygonOf({{{300, 500}, {3333, 2111}, {2900, 300}, {700, 2100}}}));
    Shape points;
    points.kind = PrimitiveKind::Point;
    points.vertices = {{latticePixel(2, 3), {{255, 0, 0}}}, {{2816, 1400}, {{0, 255, 0}}}};
    mixed.shapes.push_back(points);
    scenes.push_back({u"mixed"_s, mixed});
    return scenes;
}

std::shared_ptr<const TracedScene> tracedBy(const Method &method, Arithmetic arithmetic,
                                            Scene scene)
{
    scene.method = method.id.toStdString();
    scene.settings.arithmetic = arithmetic;
    scene.settings = method.adapted(scene.settings);
    return traceScene(scene);
}

} // namespace pixelplumb
