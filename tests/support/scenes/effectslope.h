// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/oracle/effectoracle.h"
#include "tests/support/framespec.h"
#include "tests/support/scenes/effectsample.h"

#include <QString>

/// Shared helpers of the effect tests: a right triangle whose values are easily worked out by hand,
/// and its true picture.
namespace pixelplumb {

inline constexpr Colour white = {{255, 255, 255}};
inline constexpr Colour black = {{0, 0, 0}};
inline constexpr ScanSettings closedRule = {};

inline Attribute attribute(std::int64_t numerator, std::int64_t denominator = 1)
{
    return numerator * attributeOne / denominator;
}

/// The triangle (0, 0), (16, 0), (0, 16): in row 0 the second vertex has weight x/16 and the third
/// has weight 0.
inline Triangle slope(const Colour &colour)
{
    return {{{{latticePixel(0, 0), colour},
              {latticePixel(16, 0), colour},
              {latticePixel(0, 16), colour}}}};
}

/// One such triangle with attributes; addSlope() adds more.
inline Primitives oneSlope(const std::array<VertexAttributes, 3> &vertices,
                           const Colour &colour = white)
{
    Primitives primitives{{slope(colour)}, {}, {{0, vertices}}};
    primitives.attributes[0].material = noMaterial;
    return primitives;
}

inline void addSlope(Primitives &primitives, const std::array<VertexAttributes, 3> &vertices,
                     const Colour &colour)
{
    primitives.attributes.push_back({primitives.triangles.size(), vertices});
    primitives.triangles.push_back(slope(colour));
}

inline void setMaterial(Primitives &primitives, const Material &material)
{
    primitives.appearance.materials = {material};
    primitives.attributes[0].material = 0;
}

/// Three vertices with this depth.
inline std::array<VertexAttributes, 3> atDepth(Attribute z)
{
    std::array<VertexAttributes, 3> vertices;
    for (VertexAttributes &vertex : vertices)
        vertex.z = z;
    return vertices;
}

/// Three vertices with this alpha.
inline std::array<VertexAttributes, 3> withAlpha(std::uint8_t alpha)
{
    std::array<VertexAttributes, 3> vertices;
    for (VertexAttributes &vertex : vertices)
        vertex.alpha = alpha;
    return vertices;
}

/// Three vertices whose u goes from one value to the other along row 0.
inline std::array<VertexAttributes, 3> withU(Attribute from, Attribute to)
{
    std::array<VertexAttributes, 3> vertices;
    vertices[0].texture[0] = vertices[2].texture[0] = from;
    vertices[1].texture[0] = to;
    return vertices;
}

inline FrameBuffer truthOver(const Primitives &primitives, const FrameSpec &spec,
                             const ScanSettings &settings = closedRule)
{
    FrameBuffer frame(spec);
    oracle::drawEffects(primitives, settings, oracle::truthOf(primitives.appearance), frame.view());
    return frame;
}

inline Colour pixelOf(const FrameBuffer &frame, std::int64_t x, std::int64_t y)
{
    return unpacked(*frame.view().at(x, y));
}

/// Row 0 from column 0 on: # for white, . for black, and any other pixel by the first digit of its
/// red.
inline QString rowText(const Primitives &primitives, std::int32_t width = 17,
                       const ScanSettings &settings = closedRule)
{
    const FrameBuffer frame = truthOver(primitives, frameOf(width, 1), settings);
    QString text;
    for (std::int32_t x = 0; x < width; ++x) {
        const Colour colour = pixelOf(frame, x, 0);
        text += colour == white ? QChar(u'#')
            : colour == black   ? QChar(u'.')
                                : QString::number(colour.red()).front();
    }
    return text;
}

inline oracle::EffectSample sampleOf(const Primitives &primitives, std::int64_t x, std::int64_t y)
{
    return *oracle::effectSampleAt(primitives, 0, ByteRounding::Nearest,
                                   oracle::truthOf(primitives.appearance), x, y);
}

} // namespace pixelplumb
