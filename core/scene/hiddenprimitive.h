// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/attributes.h"
#include "core/geometry/shape.h"

#include <span>
#include <variant>
#include <vector>

namespace pixelplumb {

struct HiddenTriangle {
    Triangle triangle;
    TriangleAttributes attributes; ///< their own triangle index is unused

    friend bool operator==(const HiddenTriangle &, const HiddenTriangle &) = default;
};

/// A triangle or shape that the user keeps without drawing it. It is stored apart from the scene's
/// primitives: nothing draws, judges or counts it.
struct HiddenPrimitive {
    /// How many of the scene's drawn triangles, or of its drawn shapes, come before it.
    std::size_t place = 0;
    std::variant<HiddenTriangle, Shape> primitive;

    bool isTriangle() const { return primitive.index() == 0; }
    PrimitiveKind kind() const
    {
        const Shape *shape = std::get_if<Shape>(&primitive);
        return shape ? shape->kind : PrimitiveKind::Triangle;
    }
    std::span<const Vertex> vertices() const
    {
        if (const Shape *shape = std::get_if<Shape>(&primitive))
            return shape->vertices;
        return std::get<HiddenTriangle>(primitive).triangle.vertices;
    }

    friend bool operator==(const HiddenPrimitive &, const HiddenPrimitive &) = default;
};

/// In drawing order: triangles, then shapes.
using HiddenPrimitives = std::vector<HiddenPrimitive>;

} // namespace pixelplumb
