// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/probescenes.h"

#include "core/scene/scenefile.h"
#include "tests/support/sourcetree.h"

#include <QDir>

namespace pixelplumb {

Triangle coloured(const std::array<LatticePoint, 3> &points)
{
    return {{{{points[0], {{250, 40, 10}}},
              {points[1], {{20, 200, 90}}},
              {points[2], {{60, 30, 240}}}}}};
}

Scene sceneWith(std::vector<Triangle> triangles, const char *method)
{
    Scene scene;
    scene.frame.width = 40;
    scene.frame.height = 40;
    scene.method = method;
    scene.triangles = std::move(triangles);
    return scene;
}

std::vector<Scene> probeScenes(const char *method)
{
    const auto at = [](std::int64_t x, std::int64_t y) { return LatticePoint{x * 128, y * 128}; };
    return {sceneWith({coloured({at(71, 73), at(27, 13), at(50, 12)})}, method),
            sceneWith({coloured({at(8, 60), at(58, 66), at(50, 16)}),
                       coloured({at(58, 66), at(50, 16), at(75, 20)})},
                      method),
            // A square of two triangles: edges along rows, columns and the diagonal pass through
            // samples.
            sceneWith({coloured({at(58, 72), at(24, 66), at(58, 40)}),
                       coloured({at(10, 10), at(40, 10), at(10, 40)}),
                       coloured({at(40, 40), at(40, 10), at(10, 40)})},
                      method)};
}

std::vector<Scene> probeSheet(const QString &method)
{
    const QDir folder(resource(u"/probes"_s));
    std::vector<Scene> scenes;
    for (const QString &name : folder.entryList({method + u"-*.json"_s})) {
        if (const auto reading = readSceneFile(folder.filePath(name)))
            scenes.push_back(reading->scene);
    }
    return scenes;
}

} // namespace pixelplumb
