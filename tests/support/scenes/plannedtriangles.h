// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/shade/effectplan.h"

/// Shared helpers of the effect tests: short ways to write triangles with attributes.
namespace pixelplumb {

/// A white triangle with whole-pixel corners.
inline Triangle triangleAt(std::array<std::array<int, 2>, 3> corners)
{
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i)
        triangle.vertices[i]
            = {latticePixel(corners[i][0], corners[i][1]), Colour{{255, 255, 255}}};
    return triangle;
}

/// The attributes of a triangle, inserted if it has none.
inline TriangleAttributes &attributesAt(Primitives &primitives, std::size_t triangle)
{
    auto found = std::ranges::lower_bound(primitives.attributes, triangle, {},
                                          &TriangleAttributes::triangle);
    if (found == primitives.attributes.end() || found->triangle != triangle)
        found = primitives.attributes.insert(found, {triangle, {}, noMaterial});
    return *found;
}

/// Sets the depth of each vertex, in quarters.
inline void setDepths(Primitives &primitives, std::size_t triangle, std::array<int, 3> quarters)
{
    for (std::size_t i = 0; i < 3; ++i)
        attributesAt(primitives, triangle).vertices[i].z = quarters[i] * attributeOne / 4;
}

inline void setAlpha(Primitives &primitives, std::size_t triangle, std::uint8_t alpha)
{
    for (VertexAttributes &vertex : attributesAt(primitives, triangle).vertices)
        vertex.alpha = alpha;
}

/// Gives the triangle a checker material, with its own u and v at the corners.
inline void setTexture(Primitives &primitives, std::size_t triangle)
{
    Material board;
    board.name = "board";
    board.texture = std::make_shared<const Texture>(checkerTexture());
    primitives.appearance.materials = {board};
    TriangleAttributes &attributes = attributesAt(primitives, triangle);
    attributes.material = 0;
    attributes.vertices[1].texture = {attributeOne, 0};
    attributes.vertices[2].texture = {0, attributeOne};
}

/// Points the normals at the viewer and lights the triangle from there.
inline void setLight(Primitives &primitives, std::size_t triangle)
{
    primitives.appearance.lights = {{Light::Kind::Directional, {0, 0, attributeOne}, {}}};
    for (VertexAttributes &vertex : attributesAt(primitives, triangle).vertices)
        vertex.normal = {0, 0, -attributeOne};
}

} // namespace pixelplumb
