// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/curveoracle.h"

#include "core/oracle/truepixel.h"

#include <algorithm>
#include <array>
#include <span>

namespace pixelplumb::oracle {

namespace {

constexpr int deepest = 33;

/// One coordinate of the control points of a piece.
using Controls = std::array<Int128, 4>;

/// The window of pixels whose neighbourhood matters. Coordinates are counted from its first pixel,
/// so that a piece near it has small ones and 128 bits hold every fraction.
struct Window {
    std::int64_t columns = 0;
    std::int64_t rows = 0;
};

/// The left half of the control points by averages of averages, scaled by 2^degree; the right half
/// is the left half of the points in reverse.
Controls leftHalf(Controls points, std::size_t count)
{
    Controls half = {};
    for (std::size_t level = 0; level < count; ++level) {
        half[level] = points[0] << (count - 1 - level);
        for (std::size_t i = 0; i + level + 1 < count; ++i)
            points[i] += points[i + 1];
    }
    return half;
}

Controls reversed(Controls points, std::size_t count)
{
    std::reverse(points.begin(), points.begin() + std::ptrdiff_t(count));
    return points;
}

/// Calls a function with the pixel nearest to each end of each smallest piece near the window.
template <class Function>
class Subdivision {
public:
    Subdivision(std::size_t count, Window window, const Function &function)
        : m_count(count)
        , m_window(window)
        , m_function(function)
    {
    }

    void run(const Controls &x, const Controls &y, int depth)
    {
        const Int128 pixel = Int128(unitsPerPixel) << (int(m_count - 1) * depth);
        const auto [left, right] = std::ranges::minmax(std::span(x).first(m_count));
        const auto [bottom, top] = std::ranges::minmax(std::span(y).first(m_count));
        if (right < -pixel || left > m_window.columns * pixel || top < -pixel
            || bottom > m_window.rows * pixel)
            return;
        const Int128 quarter = pixel / 4;
        if ((right - left <= quarter && top - bottom <= quarter) || depth == deepest) {
            for (const std::size_t end : {std::size_t(0), m_count - 1})
                m_function(nearest(x[end], pixel), nearest(y[end], pixel));
            return;
        }
        run(leftHalf(x, m_count), leftHalf(y, m_count), depth + 1);
        run(rightHalf(x), rightHalf(y), depth + 1);
    }

private:
    Controls rightHalf(const Controls &points) const
    {
        return reversed(leftHalf(reversed(points, m_count), m_count), m_count);
    }
    static std::int64_t nearest(Int128 coordinate, Int128 pixel)
    {
        return std::int64_t(floorDivide<Int128>(coordinate + pixel / 2, pixel));
    }

    std::size_t m_count;
    Window m_window;
    const Function &m_function;
};

/// Calls a function with the curve's pixels in a window from (firstX, firstY), counted from there.
template <class Function>
void forEachPixel(const Shape &curve, std::int64_t firstX, std::int64_t firstY, Window window,
                  const Function &function)
{
    Controls x = {};
    Controls y = {};
    const std::size_t count = std::min<std::size_t>(curve.vertices.size(), 4);
    for (std::size_t i = 0; i < count; ++i) {
        x[i] = curve.vertices[i].position.x - firstX * unitsPerPixel;
        y[i] = curve.vertices[i].position.y - firstY * unitsPerPixel;
    }
    Subdivision(count, window, function).run(x, y, 0);
}

} // namespace

bool curveCovers(const Shape &curve, std::int64_t x, std::int64_t y)
{
    bool covered = false;
    forEachPixel(curve, x, y, {1, 1}, [&](std::int64_t right, std::int64_t up) {
        covered = covered || (right == 0 && up == 0);
    });
    return covered;
}

void drawCurve(const Shape &curve, FrameView frame, CoverageMask &coverage)
{
    forEachPixel(curve, frame.firstColumn, frame.firstRow, {frame.width, frame.height},
                 [&](std::int64_t right, std::int64_t up) {
                     writeTruePixel(frame, coverage, frame.firstColumn + right, frame.firstRow + up,
                                    curve.vertices[0].colour);
                 });
}

} // namespace pixelplumb::oracle
