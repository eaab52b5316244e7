// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/effectscenes.h"

#include "core/frame/framebuffer.h"
#include "core/geometry/seededrandom.h"
#include "core/runs/tracedscene.h"
#include "core/space/surfaces.h"

#include <cmath>

namespace pixelplumb::effectscenes {

namespace {

Scene emptyScene(std::int32_t width, std::int32_t height)
{
    Scene scene;
    scene.frame.width = width;
    scene.frame.height = height;
    scene.settings.fillRule = FillRule::HalfOpenColumn;
    return scene;
}

Triangle flat(const std::array<LatticePoint, 3> &corners, const Colour &colour)
{
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i)
        triangle.vertices[i] = {corners[i], colour};
    return triangle;
}

/// Thin blades from one corner, in every direction of a quarter turn.
Group antialiasing()
{
    Scene scene = emptyScene(96, 96);
    constexpr int blades = 12;
    for (int blade = 0; blade < blades; ++blade) {
        const auto tip = [&](double turn) -> LatticePoint {
            const double angle = (blade + turn) * std::acos(0.0) / blades;
            return {Lattice(std::lround((4 + 86 * std::cos(angle)) * unitsPerPixel)),
                    Lattice(std::lround((4 + 86 * std::sin(angle)) * unitsPerPixel))};
        };
        scene.triangles.push_back(flat({latticePixel(4, 4), tip(0.3), tip(0.6)},
                                       {{255, 255, std::uint8_t(blade % 2 * 255)}}));
    }
    Group group{"antialiasing", {}, scene};
    group.truth.appearance.antialiasing = Antialiasing::Area;
    const auto add = [&](const char *name, Antialiasing antialiasing) {
        Way &way = group.ways.emplace_back(Way{QLatin1String(name), scene});
        way.scene.appearance.antialiasing = antialiasing;
    };
    add("1 sample", Antialiasing::None);
    add("4 samples", Antialiasing::Samples4);
    add("16 samples", Antialiasing::Samples16);
    add("exact area", Antialiasing::Area);
    return group;
}

/// Pairs of triangles that cross at flat angles, so close that 16 bits can hardly separate them.
Group depthBuffer()
{
    Scene scene = emptyScene(96, 96);
    scene.appearance.depth = DepthUse::On;
    SeededRandom random(11);
    for (std::size_t i = 0; i < 24; ++i) {
        const auto anywhere = [&]() -> LatticePoint {
            return {random.between(0, 96 * unitsPerPixel), random.between(0, 96 * unitsPerPixel)};
        };
        scene.triangles.push_back(flat({anywhere(), anywhere(), anywhere()}, random.colour()));
        TriangleAttributes attributes;
        attributes.triangle = i;
        for (VertexAttributes &vertex : attributes.vertices)
            vertex.z = attributeOne / 2 + random.between(-600, 600);
        scene.attributes.push_back(attributes);
    }
    Group group{"depth buffer", {}, scene};
    const auto add = [&](const char *name, DepthUse use, DepthFormat format) {
        Way &way = group.ways.emplace_back(Way{QLatin1String(name), scene});
        way.scene.appearance.depth = use;
        way.scene.appearance.depthFormat = format;
    };
    add("none: drawing order", DepthUse::Off, DepthFormat::Exact);
    add("16 bits", DepthUse::On, DepthFormat::Bits16);
    add("24 bits", DepthUse::On, DepthFormat::Bits24);
    add("32 bits", DepthUse::On, DepthFormat::Bits32);
    add("the kernel's number", DepthUse::On, DepthFormat::Exact);
    return group;
}

/// A checkered floor that recedes from the eye.
Scene board()
{
    Scene scene = emptyScene(96, 72);
    Material &material = scene.appearance.materials.emplace_back();
    material.name = "board";
    material.texture = std::make_shared<const Texture>(checkerTexture());
    const std::array<LatticePoint, 4> corner
        = {latticePixel(3, 3), latticePixel(92, 3), latticePixel(64, 66), latticePixel(31, 66)};
    constexpr std::array<int, 4> w = {1, 1, 4, 4};
    constexpr std::array<std::array<int, 2>, 4> uv = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (const std::array<std::size_t, 3> &face :
         {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
        TriangleAttributes attributes;
        attributes.triangle = scene.triangles.size();
        attributes.material = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            attributes.vertices[i].w = w[face[i]] * attributeOne;
            for (std::size_t side = 0; side < 2; ++side)
                attributes.vertices[i].texture[side] = uv[face[i]][side] * attributeOne;
        }
        scene.attributes.push_back(attributes);
        scene.triangles.push_back(
            flat({corner[face[0]], corner[face[1]], corner[face[2]]}, {{255, 255, 255}}));
    }
    return scene;
}

Group perspective()
{
    Group group{"perspective", {}, board()};
    Way &affine = group.ways.emplace_back(Way{"affine", board()});
    affine.scene.appearance.forced[Effect::Perspective] = Forcing::Off;
    group.ways.push_back({"perspective", board()});
    return group;
}

Scene lit(const Solid &solid)
{
    Scene scene = emptyScene(96, 96);
    scene.camera.emplace();
    scene.camera->eye = {0, 0, 3};
    scene.solids = {solid};
    scene.solids.front().colour = {{200, 80, 40}};
    scene.appearance.lights = {Light{
        Light::Kind::Directional, {attributeOne, -attributeOne, -attributeOne}, {{255, 255, 255}}}};
    scene.appearance.shading = Shading::Gouraud;
    return scene;
}

template <class MakeSolid, class DistanceOf>
Group segments(const QString &name, const MakeSolid &solidOf, const DistanceOf &distanceOf)
{
    constexpr std::array<int, 4> counts = {8, 16, 32, 64};
    Group group{name, {}, lit(solidOf(128))};
    for (const int count : counts) {
        const Solid solid = solidOf(count);
        group.ways.push_back({u"%1 segments"_s.arg(count), lit(solid), distanceOf(solid)});
    }
    return group;
}

Group sphere()
{
    return segments(
        "sphere",
        [](int count) {
            Solid solid;
            solid.kind = SolidKind::Sphere;
            solid.corners.resize(1);
            solid.segments = {count, count / 2};
            return solid;
        },
        [](const Solid &solid) { return sphereDistance(solid.radius, solid.segments); });
}

Group patch()
{
    return segments(
        "patch",
        [](int count) {
            Solid solid;
            solid.kind = SolidKind::Patch;
            for (int row = 0; row < 4; ++row) {
                for (int column = 0; column < 4; ++column) {
                    SolidCorner &corner = solid.corners.emplace_back();
                    const bool isInner = row % 3 != 0 && column % 3 != 0;
                    corner.position = {column * 0.6 - 0.9, row * 0.6 - 0.9, isInner ? 0.9 : 0.0};
                }
            }
            solid.segments = {count, count};
            return solid;
        },
        [](const Solid &solid) { return patchDistance(solid); });
}

/// A flat opaque scene, and the same scene with each effect that does not change it.
Group neutralEffects()
{
    Scene scene = emptyScene(96, 96);
    SeededRandom random(5);
    for (std::size_t i = 0; i < 8; ++i) {
        const auto anywhere = [&]() -> LatticePoint {
            return {random.between(0, 96 * unitsPerPixel), random.between(0, 96 * unitsPerPixel)};
        };
        scene.triangles.push_back(flat({anywhere(), anywhere(), anywhere()}, random.colour()));
    }
    Group group{"neutral effects", {}, scene};
    group.ways.push_back({"as called for", scene});
    for (const Effect effect :
         {Effect::SmoothColour, Effect::Depth, Effect::Perspective, Effect::Blending}) {
        Way &way = group.ways.emplace_back(
            Way{QLatin1String(nameOf(effect).data(), qsizetype(nameOf(effect).size()))
                    + u" forced on"_s,
                scene});
        way.scene.appearance.forced[effect] = Forcing::On;
    }
    return group;
}

/// A scene's brightness, in pixels: the sum of all pixels' shares of white.
double brightnessOf(const Scene &scene)
{
    const FrameBuffer frame(scene.frame);
    drawScene(scene, frame);
    const FrameView view = frame.view();
    double sum = 0;
    for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
        for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x)
            sum += unpacked(*view.at(x, y)).red() / 255.0;
    }
    return sum;
}

/// A white line from (0, 0) to `times` times (dx, dy), in a frame that holds it.
Scene lineScene(std::int64_t dx, std::int64_t dy, int times)
{
    constexpr std::int32_t margin = 2;
    Scene scene = emptyScene(std::int32_t(absolute(dx) * times + 1 + 2 * margin),
                             std::int32_t(absolute(dy) * times + 1 + 2 * margin));
    scene.frame.firstColumn = std::int32_t(std::min<std::int64_t>(dx * times, 0) - margin);
    scene.frame.firstRow = std::int32_t(std::min<std::int64_t>(dy * times, 0) - margin);
    scene.settings.fillRule = FillRule::Closed;
    Shape &line = scene.shapes.emplace_back();
    line.kind = PrimitiveKind::Line;
    line.vertices
        = {{{0, 0}, {{255, 255, 255}}}, {latticePixel(dx * times, dy * times), {{255, 255, 255}}}};
    return scene;
}

/// Lines every 15°, between whole pixels. Brightness per pixel of length is measured by drawing a
/// line twice as long: the ends, which have a brightness of their own, stay the same.
Group lines(const QString &name, const std::string &method, Antialiasing antialiasing)
{
    constexpr int everyDegrees = 15;
    constexpr double length = 60;
    Group group{name, {}, {}};
    for (int degrees = 0; degrees < 180; degrees += everyDegrees) {
        const double angle = degrees * std::acos(-1.0) / 180;
        const std::int64_t dx = std::lround(length * std::cos(angle));
        const std::int64_t dy = std::lround(length * std::sin(angle));
        const auto drawn = [&](int times) {
            Scene scene = lineScene(dx, dy, times);
            scene.method = method;
            scene.appearance.antialiasing = antialiasing;
            return scene;
        };
        Way &way = group.ways.emplace_back(Way{u"%1°"_s.arg(degrees), drawn(2)});
        way.brightness = (brightnessOf(drawn(2)) - brightnessOf(drawn(1))) / std::hypot(dx, dy);
        way.truth = way.scene;
        way.truth->method = "stroke-coverage";
        way.truth->appearance.antialiasing = Antialiasing::Area;
    }
    group.truth = *group.ways.front().truth;
    return group;
}

} // namespace

std::vector<Group> all()
{
    return {antialiasing(),
            depthBuffer(),
            perspective(),
            sphere(),
            patch(),
            neutralEffects(),
            lines("lines, Bresenham", "line-bresenham", Antialiasing::None),
            lines("lines, exact area", "stroke-coverage", Antialiasing::Area)};
}

} // namespace pixelplumb::effectscenes
