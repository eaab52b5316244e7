// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/oracle/oracle.h"
#include "tests/support/framespec.h"

#include <algorithm>
#include <ostream>
#include <random>
#include <vector>

/// Shared helpers of the triangle method tests: pictures of one triangle in small windows.
namespace pixelplumb {

/// The picture in a window: 0 where nothing was written (no kernel writes alpha 0).
class WindowPicture {
public:
    WindowPicture(std::int32_t width, std::int32_t height, std::int32_t firstColumn = 0,
                  std::int32_t firstRow = 0)
        : m_spec(frameOf(width, height, firstColumn, firstRow))
        , m_pixels(std::size_t(width) * std::size_t(height), QRgb(0))
    {
    }

    FrameView view()
    {
        return {m_pixels.data(), m_spec.width, m_spec.firstColumn,
                m_spec.firstRow, m_spec.width, m_spec.height};
    }
    void clear() { std::ranges::fill(m_pixels, QRgb(0)); }
    const FrameSpec &spec() const { return m_spec; }
    const std::vector<QRgb> &pixels() const { return m_pixels; }
    QRgb at(std::int64_t x, std::int64_t y) const
    {
        return m_pixels[std::size_t((y - m_spec.firstRow) * m_spec.width + x - m_spec.firstColumn)];
    }

    void draw(const Method &method, const Triangle &triangle, const ScanSettings &settings)
    {
        Run(&method, {{triangle}, {}}, settings, view(), Kernels::Plain).draw(view());
    }
    void drawTruth(const Triangle &triangle, const ScanSettings &settings)
    {
        oracle::draw(triangle, settings.fillRule, settings.rounding, view());
    }

    friend bool operator==(const WindowPicture &a, const WindowPicture &b)
    {
        return a.m_pixels == b.m_pixels;
    }

private:
    FrameSpec m_spec;
    std::vector<QRgb> m_pixels;
};

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
