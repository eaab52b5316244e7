// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/bugs/drawnline.h"

#include "core/frame/framebuffer.h"
#include "core/grade/scan/redrawing.h"
#include "core/runs/scenerun.h"

#include <algorithm>

namespace pixelplumb {

namespace {

DrawnLine drawnLine(const Scene &alone)
{
    const Picture picture = pictureOf(alone);
    const Shape shape = primitivesOnSamples(alone).shapes.front();
    const Vertex &from = shape.vertices[0];
    const Vertex &to = shape.vertices[1];
    DrawnLine line{from.position, to.position, from.colour, to.colour, {}};
    for (int x = 0; x < picture.width; ++x) {
        for (int row = 0; row < picture.height; ++row) {
            const std::int64_t y = alone.frame.firstRow + row;
            const std::size_t place = picture.placeOf(x, int(pictureLine(alone.frame, y)));
            if (picture.covered[place] != 0)
                line.pixels.push_back({alone.frame.firstColumn + x, y, picture.colours[place]});
        }
    }
    return line;
}

} // namespace

bool isOfLines(const Scene &scene)
{
    return !scene.shapes.empty() && !scene.hasTriangles() && !mayCallForEffects(scene)
        && std::ranges::all_of(
            scene.shapes, [](const Shape &shape) { return shape.kind == PrimitiveKind::Line; });
}

Picture redrawnLines(const Scene &scene, const std::function<void(DrawnLine &line)> &change)
{
    Scene empty = scene;
    empty.shapes.clear();
    Picture picture = pictureOf(empty);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        DrawnLine line = drawnLine(shapeAlone(scene, i));
        change(line);
        for (const LinePixel &pixel : line.pixels) {
            const std::int64_t x = pixel.x - scene.frame.firstColumn;
            const bool isInside = x >= 0 && x < scene.frame.width && pixel.y >= scene.frame.firstRow
                && pixel.y - scene.frame.firstRow < scene.frame.height;
            if (!isInside)
                continue;
            const std::size_t place
                = picture.placeOf(int(x), int(pictureLine(scene.frame, pixel.y)));
            picture.colours[place] = pixel.colour;
            picture.covered[place] = 1;
        }
    }
    return picture;
}

DrawnLine ascending(DrawnLine line)
{
    const bool falls = line.isSteep() ? line.to.y < line.from.y : line.to.x < line.from.x;
    if (falls) {
        std::swap(line.from, line.to);
        std::swap(line.fromColour, line.toColour);
    }
    return line;
}

} // namespace pixelplumb
