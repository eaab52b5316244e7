// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/scan/redrawing.h"

#include "core/frame/framebuffer.h"
#include "core/grade/scan/planelevels.h"
#include "core/grade/scan/programwalk.h"
#include "core/grade/scan/redrawntriangle.h"
#include "core/runs/scenerun.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// By the bound that holds for every method.
Picture boundedPicture(const Scene &alone, const RoundingSide &side)
{
    const FrameSpec &frame = alone.frame;
    const Triangle triangle = primitivesOnSamples(alone).triangles.front();
    const ArithmeticBound bound = boundOn(side, triangle);
    if (!bound.isProved() || !alone.settings.isRight())
        return pictureOf(alone);
    Picture picture = emptyPicture(alone.frame);
    const SampleBox box = bound.reachIn(frame);
    for (std::int64_t y = box.firstY; y < box.endY; ++y) {
        for (std::int64_t x = box.firstX; x < box.endX; ++x) {
            const Containment sample = bound.containmentOf(x, y, std::nullopt);
            const bool isDrawn = sample == Containment::Inside
                || (sample == Containment::Undecided && side.isOutward);
            if (!isDrawn)
                continue;
            const std::size_t place
                = picture.placeOf(int(x - frame.firstColumn), int(pictureLine(frame, y)));
            const WholeLevels levels = levelsOn(side, bound, triangle, alone.settings, {}, x, y);
            picture.covered[place] = 1;
            for (std::size_t i = 0; i < 3; ++i)
                picture.colours[place].channels[i]
                    = std::uint8_t(std::clamp<std::int64_t>(levels[i], 0, 255));
        }
    }
    return picture;
}

/// The right picture of one triangle, on a side of rounding.
Picture rightPicture(const Scene &alone, const RoundingSide &side)
{
    const Method &method = *methodNamed(QString::fromStdString(alone.method));
    const bool hasArea = doubledArea(alone.triangles.front()) != 0;
    if (!hasArea)
        return pictureOf(alone);
    if (!method.walksEdges())
        return boundedPicture(alone, side);
    Picture picture = emptyPicture(alone.frame);
    RedrawnTriangle(
        SeenTriangles(alone), 0, redrawingBy({}), [&alone] { return pictureOf(alone); }, side)
        .paintOn(picture, Repainting::Over, alone.frame.background);
    return picture;
}

} // namespace

Triangle exchanged(Triangle triangle)
{
    for (Vertex &vertex : triangle.vertices)
        std::swap(vertex.position.x, vertex.position.y);
    return triangle;
}

Scene triangleAlone(const Scene &scene, std::size_t triangle)
{
    Scene alone = scene;
    alone.triangles = {scene.triangles[triangle]};
    alone.shapes.clear();
    return alone;
}

Scene shapeAlone(const Scene &scene, std::size_t shape)
{
    Scene alone = scene;
    alone.triangles.clear();
    alone.shapes = {scene.shapes[shape]};
    return alone;
}

Picture redrawn(const Scene &scene, const Redrawing &redrawing, const ChosenSpans *chosen)
{
    Picture picture = chosen ? emptyPicture(scene.frame, *chosen) : emptyPicture(scene.frame);
    const SeenTriangles seen(scene, chosen);
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        RedrawnTriangle(seen, i, redrawing, [&, i] {
            const Scene alone = triangleAlone(scene, i);
            return chosen ? pictureOf(alone, *chosen) : pictureOf(alone);
        }).paintOn(picture, redrawing.repainting, scene.frame.background);
    }
    return picture;
}

bool differsAtOnce(const Scene &scene, const Redrawing &redrawing, const Picture &found,
                   std::int64_t limit, const ChosenSpans *chosen)
{
    const bool isSeen
        = redrawing.walk && redrawing.repainting == Repainting::Over && !scene.triangles.empty();
    if (!isSeen)
        return false;
    return RedrawnTriangle(SeenTriangles(scene, chosen), scene.triangles.size() - 1, redrawing,
                           found, limit)
        .isRefused();
}

PictureRange redrawnRange(const Scene &scene, const Redrawing &redrawing, Arithmetic arithmetic)
{
    PictureRange range;
    const auto sides = roundingSides(arithmetic);
    const SeenTriangles seen(scene);
    for (std::size_t side = 0; side < sides.size(); ++side) {
        range.sides[side] = emptyPicture(scene.frame);
        for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
            RedrawnTriangle(
                seen, i, redrawing,
                [&] { return rightPicture(triangleAlone(scene, i), sides[side]); }, sides[side])
                .paintOn(range.sides[side], redrawing.repainting, scene.frame.background);
        }
    }
    return range;
}

bool canBeRedrawn(const Scene &scene)
{
    constexpr std::size_t mostRedrawn = 64; // triangles: each is drawn separately
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    return method.draws(PrimitiveKind::Triangle) && scene.shapes.empty() && !scene.triangles.empty()
        && scene.triangles.size() <= mostRedrawn && !mayCallForEffects(scene);
}

} // namespace pixelplumb
