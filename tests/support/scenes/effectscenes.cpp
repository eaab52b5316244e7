// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/effectscenes.h"

#include "core/geometry/seededrandom.h"

#include <QStringList>

#include <algorithm>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

using VertexArray = std::array<VertexAttributes, 3>;

class SceneMaker {
public:
    SceneMaker(std::uint64_t seed, EffectHardship hardship)
        : m_random(seed * 16 + std::uint64_t(hardship))
        , m_hardship(hardship)
        , m_appearance(m_scene.primitives.appearance)
    {
    }

    EffectScene make()
    {
        chooseFrame();
        chooseEffects();
        addTriangles();
        m_scene.name = nameOf(m_hardship) + u": "_s + m_words.join(u", "_s);
        return std::move(m_scene);
    }

private:
    template <class Value>
    Value oneOf(std::initializer_list<Value> values)
    {
        return values.begin()[m_random.between(0, std::int64_t(values.size()) - 1)];
    }
    /// Decides whether the scene has an effect, and adds the effect's name to the scene's.
    bool chosen(Effect effect)
    {
        if (!m_random.coin())
            return false;
        const std::string_view name = nameOf(effect);
        m_words.append(QString::fromLatin1(name.data(), qsizetype(name.size())));
        return true;
    }

    void chooseFrame()
    {
        FrameSpec &frame = m_scene.frame;
        const bool isFar = m_hardship == EffectHardship::FarAway;
        const std::int32_t first = isFar ? oneOf({1 << 20, -(1 << 20)}) : oneOf({0, 0, -9, 1000});
        // Two statements, because a compiler may evaluate call arguments in any order.
        const auto width = std::int32_t(m_random.between(9, 24));
        const auto height = std::int32_t(m_random.between(9, 24));
        frame = frameOf(width, height, first, oneOf({0, -7, 3000}));
        frame.background = m_random.colour();
        frame.origin = oneOf({FrameOrigin::BottomLeft, FrameOrigin::TopLeft});
    }

    void chooseEffects()
    {
        m_isSmooth = chosen(Effect::SmoothColour);
        m_hasPerspective = chosen(Effect::Perspective) || m_hardship == EffectHardship::Horizon;
        m_hasTexture = chosen(Effect::Texture) || m_hardship == EffectHardship::TexelBorders;
        m_hasLight = chosen(Effect::Light);
        m_hasBlending = chosen(Effect::Blending);
        m_hasDepth = chosen(Effect::Depth) || m_hardship == EffectHardship::Coincident
            || m_hardship == EffectHardship::Crossing;
        m_appearance.depth = m_hasDepth ? DepthUse::On : DepthUse::Off;
        m_appearance.depthFormat
            = oneOf({DepthFormat::Exact, DepthFormat::Exact, DepthFormat::Bits16,
                     DepthFormat::Bits24, DepthFormat::Bits32});
        if (chosen(Effect::Antialiasing))
            m_appearance.antialiasing
                = oneOf({Antialiasing::Samples4, Antialiasing::Samples16, Antialiasing::Area});
        for (int i = 0; i < 3; ++i)
            m_appearance.materials.push_back(material());
        m_appearance.ambient = m_random.colour();
        const std::int64_t lights = m_hasLight ? m_random.between(1, 3) : 0;
        for (std::int64_t i = 0; i < lights; ++i) {
            m_appearance.lights.push_back(
                {oneOf({Light::Kind::Directional, Light::Kind::Positional}), vector(),
                 m_random.colour()});
        }
        m_appearance.viewerKind = oneOf({Light::Kind::Directional, Light::Kind::Positional});
        m_appearance.viewer = vector();
    }

    Material material()
    {
        Material material;
        material.filter = oneOf({TextureFilter::Nearest, TextureFilter::Bilinear});
        material.wrap = oneOf({TextureWrap::Repeat, TextureWrap::Clamp});
        material.specular = m_random.colour();
        material.shininess = oneOf({1, 2, 7, 32, 1024});
        if (!m_hasTexture)
            return material;
        Texture texture = checkerTexture();
        if (m_random.coin()) {
            texture = {"random", oneOf({1, 3, 8}), oneOf({1, 5, 8}), {}};
            for (std::int32_t i = 0; i < texture.width * texture.height; ++i)
                texture.texels.push_back(m_random.colour());
        }
        material.texture = std::make_shared<Texture>(texture);
        return material;
    }

    void addTriangles()
    {
        const std::int64_t count = m_random.between(2, 6);
        const Triangle first = triangle();
        const VertexArray firstVertices = vertices();
        for (std::int64_t i = 0; i < count; ++i) {
            Triangle made = i == 0 ? first : triangle();
            VertexArray attributes = i == 0 ? firstVertices : vertices();
            if (m_hardship == EffectHardship::Coincident) {
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    made.vertices[corner].position = first.vertices[corner].position;
                    attributes[corner].z = firstVertices[corner].z + m_random.between(-1, 1);
                }
            }
            if (m_hardship == EffectHardship::SharedEdges
                && !m_scene.primitives.triangles.empty()) {
                made.vertices[0].position = first.vertices[0].position;
                made.vertices[1].position
                    = m_scene.primitives.triangles.back().vertices[2].position;
            }
            if (m_hardship == EffectHardship::Segments && i % 2 == 1)
                takeArea(made);
            else if (doubledArea(made) == 0)
                continue;
            m_scene.primitives.attributes.push_back({m_scene.primitives.triangles.size(),
                                                     attributes,
                                                     int(m_random.between(noMaterial, 2))});
            m_scene.primitives.triangles.push_back(made);
        }
    }

    LatticePoint position()
    {
        const FrameSpec &frame = m_scene.frame;
        const auto along = [&](std::int32_t first, std::int32_t size) {
            const Lattice from = (first - size / 4) * unitsPerPixel;
            const Lattice at = m_random.between(from, from + size * 3 / 2 * unitsPerPixel);
            return isOnPixels() ? floorPixel(at) * unitsPerPixel : at;
        };
        const Lattice x = along(frame.firstColumn, frame.width);
        return {x, along(frame.firstRow, frame.height)};
    }

    /// Moves two vertices onto samples, or all onto one, and the third onto their line, between or
    /// beyond them.
    void takeArea(Triangle &triangle)
    {
        const auto ownSample = [](const LatticePoint &near) {
            return latticePixel(floorPixel(near.x), floorPixel(near.y));
        };
        auto &[a, b, c] = triangle.vertices;
        a.position = ownSample(a.position);
        b.position = m_random.between(0, 5) == 0 ? a.position : ownSample(b.position);
        if (m_random.between(0, 3) == 0)
            b.position.x = a.position.x;
        const Lattice along = m_random.between(-1, 3);
        c.position = {a.position.x + along * (b.position.x - a.position.x) / 2,
                      a.position.y + along * (b.position.y - a.position.y) / 2};
        if (m_random.coin())
            std::swap(a.position, c.position);
    }

    bool isOnPixels() const
    {
        return m_hardship == EffectHardship::WholePixels || m_hardship == EffectHardship::Crossing
            || m_hardship == EffectHardship::SharedEdges
            || m_hardship == EffectHardship::TexelBorders;
    }

    Triangle triangle()
    {
        Triangle triangle;
        const Colour colour = m_random.colour();
        for (Vertex &vertex : triangle.vertices)
            vertex = {position(), m_isSmooth ? m_random.colour() : colour};
        if (m_hardship == EffectHardship::Slivers) {
            const LatticePoint a = triangle.vertices[0].position;
            const LatticePoint b = triangle.vertices[1].position;
            triangle.vertices[2].position = {(a.x + b.x) / 2 + m_random.between(-3, 3),
                                             (a.y + b.y) / 2 + m_random.between(-3, 3)};
        }
        if (m_hardship == EffectHardship::TexelBorders) { // legs of 8 or 16 px: exact borders
            const LatticePoint corner = triangle.vertices[0].position;
            triangle.vertices[1].position = {corner.x + oneOf({8, 16}) * unitsPerPixel, corner.y};
            triangle.vertices[2].position = {corner.x, corner.y + oneOf({8, -16}) * unitsPerPixel};
        }
        return triangle;
    }

    VertexArray vertices()
    {
        VertexArray vertices;
        const bool isLevel = m_random.coin() && m_random.coin();
        const std::int64_t far = isLevel ? 0 : attributeOne;
        for (VertexAttributes &vertex : vertices) {
            vertex.z = m_hardship == EffectHardship::Crossing
                ? m_random.between(0, 16) * attributeOne / 16
                : m_random.between(0, far);
            if (m_hasPerspective)
                vertex.w = divisor();
            for (Attribute &coordinate : vertex.texture)
                coordinate = textureCoordinate();
            vertex.normal = vector();
            vertex.place = vector();
            if (m_hasBlending)
                vertex.alpha
                    = std::uint8_t(oneOf<std::int64_t>({0, 1, 254, 255, m_random.between(0, 255)}));
        }
        return vertices;
    }

    Attribute divisor()
    {
        if (m_hardship == EffectHardship::Horizon)
            return std::int64_t(1) << m_random.between(4, 34); // 2^-20 … 2^10
        return m_random.between(attributeOne / 4, 4 * attributeOne);
    }

    Attribute textureCoordinate()
    {
        if (m_hardship == EffectHardship::TexelBorders)
            return m_random.between(-16, 16) * attributeOne / 8;
        return m_random.between(-2 * attributeOne, 3 * attributeOne);
    }

    /// A vector with components up to 8, along all axes or along one.
    std::array<Attribute, 3> vector()
    {
        std::array<Attribute, 3> vector;
        for (Attribute &component : vector)
            component = m_random.between(-8 * attributeOne, 8 * attributeOne);
        if (m_random.between(0, 7) == 0)
            vector[0] = vector[1] = 0;
        return vector;
    }

    SeededRandom m_random;
    EffectHardship m_hardship;
    EffectScene m_scene;
    Appearance &m_appearance;
    QStringList m_words;
    bool m_isSmooth = false, m_hasPerspective = false, m_hasTexture = false, m_hasLight = false;
    bool m_hasBlending = false, m_hasDepth = false;
};

} // namespace

QString nameOf(EffectHardship hardship)
{
    switch (hardship) {
    case EffectHardship::None:
        return u"anywhere"_s;
    case EffectHardship::WholePixels:
        return u"whole pixels"_s;
    case EffectHardship::Slivers:
        return u"slivers"_s;
    case EffectHardship::SharedEdges:
        return u"shared edges"_s;
    case EffectHardship::Coincident:
        return u"coincident"_s;
    case EffectHardship::Crossing:
        return u"crossing"_s;
    case EffectHardship::Horizon:
        return u"horizon"_s;
    case EffectHardship::TexelBorders:
        return u"texel borders"_s;
    case EffectHardship::FarAway:
        return u"far away"_s;
    case EffectHardship::Segments:
        return u"segments"_s;
    }
    return {};
}

EffectScene randomEffectScene(std::uint64_t seed, EffectHardship hardship)
{
    return SceneMaker(seed, hardship).make();
}

} // namespace pixelplumb
