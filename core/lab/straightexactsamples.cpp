// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/straightbox.h"
#include "core/lab/straightloop.h"

/// Edge equations and barycentric coordinates in integers: every sample of the box is tested.
namespace pixelplumb {

namespace {

/// Edge functions in 64-bit integers, positive inside, each facing a vertex; colours are the
/// plane's: the weighted sum over the doubled area, rounded by one division.
struct ExactLines {
    std::int64_t a[3], b[3], c[3];
    std::int64_t level[3][3];
    std::int64_t area;

    ExactLines(const Triangle &triangle, bool isBarycentric)
    {
        area = std::int64_t(doubledArea(triangle));
        const std::int64_t sign = area < 0 ? -1 : 1;
        area *= sign;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t vertex = facedVertex(isBarycentric, i);
            const LatticePoint &p = triangle.vertices[(vertex + 1) % 3].position;
            const LatticePoint &q = triangle.vertices[(vertex + 2) % 3].position;
            a[i] = sign * (p.y - q.y);
            b[i] = sign * (q.x - p.x);
            c[i] = sign * (p.x * q.y - q.x * p.y);
            for (std::size_t channel = 0; channel < 3; ++channel)
                level[i][channel] = triangle.vertices[vertex].colour.channels[channel];
        }
    }

    std::int64_t at(std::size_t i, std::int64_t x, std::int64_t y) const
    {
        return (a[i] * x + b[i] * y) * unitsPerPixel + c[i];
    }
    /// ⌊sum / area + ½⌋; sums inside are not negative.
    int byte(std::int64_t sum) const { return clampedByte((2 * sum + area) / (2 * area)); }
};

template <bool isBarycentric, bool isColumnWise>
void drawExactLines(const Triangle &triangle, RawFrame frame)
{
    const ExactLines lines(triangle, isBarycentric);
    const StraightBox box = straightBoxOf(triangle);
    const auto draw = [&](std::int64_t x, std::int64_t y, QRgb *pixel) {
        const std::int64_t e[3] = {lines.at(0, x, y), lines.at(1, x, y), lines.at(2, x, y)};
        if ((e[0] | e[1] | e[2]) < 0)
            return;
        int byte[3];
        for (std::size_t i = 0; i < 3; ++i) {
            byte[i] = lines.byte(e[0] * lines.level[0][i] + e[1] * lines.level[1][i]
                                 + e[2] * lines.level[2][i]);
        }
        *pixel = qRgb(byte[0], byte[1], byte[2]);
    };
    if constexpr (isColumnWise) {
        for (std::int64_t x = box.left; x <= box.right; ++x) {
            for (std::int64_t y = box.low; y <= box.high; ++y)
                draw(x, y, frame.at(x, y));
        }
    } else {
        for (std::int64_t y = box.low; y <= box.high; ++y) {
            for (std::int64_t x = box.left; x <= box.right; ++x)
                draw(x, y, frame.at(x, y));
        }
    }
}

void drawExactEdgesIncremental(const Triangle &triangle, RawFrame frame)
{
    const ExactLines lines(triangle, false);
    const StraightBox box = straightBoxOf(triangle);
    for (std::int64_t y = box.low; y <= box.high; ++y) {
        std::int64_t e[3];
        for (std::size_t i = 0; i < 3; ++i)
            e[i] = lines.at(i, box.left, y);
        QRgb *pixel = frame.at(box.left, y);
        for (std::int64_t x = box.left; x <= box.right; ++x, pixel += frame.perU) {
            if ((e[0] | e[1] | e[2]) >= 0) {
                int byte[3];
                for (std::size_t i = 0; i < 3; ++i) {
                    byte[i] = lines.byte(e[0] * lines.level[0][i] + e[1] * lines.level[1][i]
                                         + e[2] * lines.level[2][i]);
                }
                *pixel = qRgb(byte[0], byte[1], byte[2]);
            }
            for (std::size_t i = 0; i < 3; ++i)
                e[i] += lines.a[i] * unitsPerPixel;
        }
    }
}

void drawExactBarycentricIncremental(const Triangle &triangle, RawFrame frame)
{
    const ExactLines lines(triangle, true);
    const StraightBox box = straightBoxOf(triangle);
    std::int64_t perY[6];
    const auto levels = [&](std::int64_t(&v)[6]) {
        for (std::size_t i = 0; i < 3; ++i)
            v[3 + i]
                = v[0] * lines.level[0][i] + v[1] * lines.level[1][i] + v[2] * lines.level[2][i];
    };
    for (std::size_t i = 0; i < 3; ++i)
        perY[i] = lines.b[i] * unitsPerPixel;
    levels(perY);
    for (std::int64_t x = box.left; x <= box.right; ++x) {
        std::int64_t v[6];
        for (std::size_t i = 0; i < 3; ++i)
            v[i] = lines.at(i, x, box.low);
        levels(v);
        QRgb *pixel = frame.at(x, box.low);
        for (std::int64_t y = box.low; y <= box.high; ++y, pixel += frame.perV) {
            if ((v[0] | v[1] | v[2]) >= 0)
                *pixel = qRgb(lines.byte(v[3]), lines.byte(v[4]), lines.byte(v[5]));
            for (std::size_t i = 0; i < 6; ++i)
                v[i] += perY[i];
        }
    }
}

constexpr StraightLoop rows[] = {
    {"edge-equations", Arithmetic::Exact, false, drawExactLines<false, false>},
    {"edge-equations-incremental", Arithmetic::Exact, false, drawExactEdgesIncremental},
    {"barycentric-rectangle", Arithmetic::Exact, false, drawExactLines<true, true>},
    {"barycentric-incremental", Arithmetic::Exact, false, drawExactBarycentricIncremental},
    {"barycentric-relative", Arithmetic::Exact, false, drawExactLines<true, true>},
};

} // namespace

std::span<const StraightLoop> straightExactSamples() { return rows; }

} // namespace pixelplumb
