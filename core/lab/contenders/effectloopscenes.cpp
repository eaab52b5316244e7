// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/effectloopscenes.h"

#include "core/frame/frameview.h"
#include "core/geometry/seededrandom.h"
#include "core/lab/contenders/effectloop.h"
#include "core/methods/method.h"

namespace pixelplumb::effectscenes {

namespace {

/// Triangles of one colour each, with neutral attributes.
Primitives largeTriangles(std::uint64_t seed)
{
    SeededRandom random(seed);
    Primitives primitives;
    constexpr std::size_t count = 16;
    constexpr std::int64_t leastArea = effectLoopSide * effectLoopSide / 4; // doubled, square px
    while (primitives.triangles.size() < count) {
        const Colour colour = random.colour();
        const auto anywhere = [&]() -> LatticePoint {
            constexpr Lattice first = 4 * unitsPerPixel;
            constexpr Lattice last = (effectLoopSide - 4) * unitsPerPixel;
            return {random.between(first, last), random.between(first, last)};
        };
        Triangle triangle;
        for (Vertex &vertex : triangle.vertices)
            vertex = {anywhere(), colour};
        if (absolute(doubledArea(triangle)) < leastArea * unitsPerPixel * unitsPerPixel)
            continue;
        TriangleAttributes &attributes = primitives.attributes.emplace_back();
        attributes.triangle = primitives.triangles.size();
        attributes.material = 0;
        primitives.triangles.push_back(triangle);
    }
    primitives.appearance.materials.emplace_back().name = "board";
    primitives.appearance.depth = DepthUse::Off;
    return primitives;
}

/// Calls setVertex(attributes, random) for each vertex.
template <class SetVertex>
Primitives withVertices(Primitives primitives, const SetVertex &setVertex)
{
    SeededRandom random(7);
    for (TriangleAttributes &attributes : primitives.attributes) {
        for (VertexAttributes &vertex : attributes.vertices)
            setVertex(vertex, random);
    }
    return primitives;
}

void setDepth(VertexAttributes &vertex, SeededRandom &random)
{
    vertex.z = random.between(0, attributeOne);
}

void setTexturePoint(VertexAttributes &vertex, SeededRandom &random)
{
    vertex.w = random.between(attributeOne, 4 * attributeOne);
    vertex.texture = {random.between(0, 2 * attributeOne), random.between(0, 2 * attributeOne)};
}

Primitives ofTexture(TextureFilter filter)
{
    Primitives primitives = largeTriangles(2);
    Material &board = primitives.appearance.materials.front();
    board.texture = std::make_shared<const Texture>(checkerTexture());
    board.filter = filter;
    return withVertices(std::move(primitives), setTexturePoint);
}

} // namespace

Primitives deep()
{
    Primitives primitives = withVertices(largeTriangles(1), setDepth);
    primitives.appearance.depth = DepthUse::On;
    return primitives;
}

Primitives deepIn24Bits()
{
    Primitives primitives = deep();
    primitives.appearance.depthFormat = DepthFormat::Bits24;
    return primitives;
}

Primitives textured() { return ofTexture(TextureFilter::Nearest); }

Primitives filteredAndDeep()
{
    Primitives primitives = withVertices(ofTexture(TextureFilter::Bilinear), setDepth);
    primitives.appearance.depth = DepthUse::On;
    return primitives;
}

Primitives lit()
{
    Primitives primitives
        = withVertices(largeTriangles(3), [](VertexAttributes &vertex, SeededRandom &random) {
              vertex.normal = {random.between(-attributeOne, attributeOne),
                               random.between(-attributeOne, attributeOne), -attributeOne};
          });
    primitives.appearance.materials.front().specular = {{64, 64, 64}};
    primitives.appearance.lights
        = {{Light::Kind::Directional, {attributeOne, -attributeOne, attributeOne}, {}}};
    primitives.appearance.lights.front().colour = {{200, 220, 180}};
    return primitives;
}

Primitives glass()
{
    return withVertices(largeTriangles(4), [](VertexAttributes &vertex, SeededRandom &random) {
        vertex.alpha = std::uint8_t(random.between(40, 200));
    });
}

Primitives sampled()
{
    Primitives primitives = largeTriangles(5);
    primitives.appearance.antialiasing = Antialiasing::Samples4;
    return primitives;
}

} // namespace pixelplumb::effectscenes

namespace pixelplumb {

namespace {

FrameSpec frameOfLoops()
{
    FrameSpec frame;
    frame.width = frame.height = effectLoopSide;
    frame.background = {{30, 60, 90}}; // not a texel's colour
    return frame;
}

} // namespace

EffectLoopScene::EffectLoopScene(const EffectLoop &loop)
    : frame(frameOfLoops())
    , run(methodNamed(u"column-scan"), loop.makeScene(),
          {Arithmetic::Float32, FillRule::HalfOpenColumn, ByteRounding::Nearest}, windowOf(frame))
{
}

} // namespace pixelplumb
