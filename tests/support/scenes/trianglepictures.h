// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/scanpicture.h"

#include <ostream>
#include <random>
#include <vector>

/// Shared helpers of the triangle method tests: pictures of one triangle in small windows.
namespace pixelplumb {

/// The methods that draw triangles alone and decide by samples, not by pixels near an outline, in
/// the table's order.
inline std::vector<const Method *> triangleMethods()
{
    std::vector<const Method *> found;
    for (const Method &method : methods()) {
        const bool isOfFamily = method.family == MethodFamily::Triangles
            || method.family == MethodFamily::StableForms;
        if (isOfFamily && method.draws(PrimitiveKind::Triangle)
            && method.isStableIn(Arithmetic::Exact))
            found.push_back(&method);
    }
    return found;
}

inline std::string rowName(const Method &method, const ScanSettings &settings)
{
    return method.id.toStdString() + ", " + std::string(nameOf(settings.arithmetic)) + ", "
        + std::string(nameOf(settings.fillRule));
}

/// A triangle with three vertex colours that share no channel level.
inline Triangle triangleOf(const std::array<LatticePoint, 3> &points)
{
    constexpr std::array<Colour, 3> colours = {{{{255, 0, 10}}, {{0, 255, 77}}, {{31, 7, 255}}}};
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i)
        triangle.vertices[i] = {points[i], colours[i]};
    return triangle;
}

/// Positions in lattice units, for failure messages.
inline std::string textOfTriangle(const Triangle &triangle)
{
    std::string text = "units of 1/256 px:";
    for (const Vertex &vertex : triangle.vertices)
        text += " (" + std::to_string(vertex.position.x) + ", " + std::to_string(vertex.position.y)
            + ")";
    return text;
}

} // namespace pixelplumb
