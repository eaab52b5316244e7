// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/columnwalk.h"
#include "core/lab/contenders/effectloop.h"
#include "core/lab/contenders/effectloopscenes.h"
#include "core/shade/edgepixels.h"

#include <limits>

/// Loops for triangles of one colour each.
namespace pixelplumb {

namespace {

void drawDepth(const Primitives &primitives, FrameView frame)
{
    ColumnMajor<float> depths(frame, std::numeric_limits<float>::infinity());
    drawTriangles<1>(
        primitives,
        [](const VertexAttributes &vertex) { return WalkedValues<1>{unitsOf(vertex.z)}; },
        [&](const Colour &colour, std::int64_t x, std::int64_t first, std::int64_t end,
            WalkedValues<1> value, const WalkedValues<1> &rate) {
            const QRgb painted = packed(colour);
            QRgb *pixel = frame.at(x, first);
            float *depth = depths.at(x, first);
            for (std::int64_t y = first; y < end; ++y) {
                if (value[0] <= *depth) {
                    *depth = value[0];
                    *pixel = painted;
                }
                ++depth;
                pixel += frame.stride;
                value[0] += rate[0];
            }
        });
}

void drawDepthLevels(const Primitives &primitives, FrameView frame)
{
    constexpr double most = (1 << 24) - 1;
    ColumnMajor<std::uint32_t> depths(frame, std::numeric_limits<std::uint32_t>::max());
    drawTriangles<1>(
        primitives,
        [](const VertexAttributes &vertex) { return WalkedValues<1>{unitsOf(vertex.z)}; },
        [&](const Colour &colour, std::int64_t x, std::int64_t first, std::int64_t end,
            WalkedValues<1> value, const WalkedValues<1> &rate) {
            const QRgb painted = packed(colour);
            QRgb *pixel = frame.at(x, first);
            std::uint32_t *depth = depths.at(x, first);
            for (std::int64_t y = first; y < end; ++y) {
                const double z = std::clamp(double(value[0]), 0.0, 1.0);
                const auto level = std::uint32_t(std::int64_t(z * most + 0.5));
                if (level <= *depth) {
                    *depth = level;
                    *pixel = painted;
                }
                ++depth;
                pixel += frame.stride;
                value[0] += rate[0];
            }
        });
}

void drawGlass(const Primitives &primitives, FrameView frame)
{
    drawTriangles<1>(
        primitives,
        [](const VertexAttributes &vertex) { return WalkedValues<1>{float(vertex.alpha)}; },
        [&](const Colour &colour, std::int64_t x, std::int64_t first, std::int64_t end,
            WalkedValues<1> value, const WalkedValues<1> &rate) {
            QRgb *pixel = frame.at(x, first);
            const auto mixed = [](int source, int destination, int alpha) {
                return (2 * (source * alpha + destination * (255 - alpha)) + 255) / 510;
            };
            for (std::int64_t y = first; y < end; ++y) {
                const int alpha = byteOf(value[0]);
                *pixel = qRgb(mixed(colour.red(), qRed(*pixel), alpha),
                              mixed(colour.green(), qGreen(*pixel), alpha),
                              mixed(colour.blue(), qBlue(*pixel), alpha));
                pixel += frame.stride;
                value[0] += rate[0];
            }
        });
}

/// The whole picture four times, each seen from one sample, and the mean of these.
void drawFourSamples(const Primitives &primitives, FrameView frame)
{
    const auto size = std::size_t(frame.width) * std::size_t(frame.height);
    std::vector<std::array<std::uint16_t, 4>> sums(size);
    std::vector<QRgb> pixels(size);
    FrameView seen = frame;
    seen.base = pixels.data();
    seen.stride = frame.width;
    for (const LatticePoint &sample : samplePattern(Antialiasing::Samples4)) {
        for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y)
            std::copy_n(frame.at(frame.firstColumn, y), frame.width, seen.at(frame.firstColumn, y));
        for (const Triangle &triangle : primitives.triangles) {
            const QRgb painted = packed(triangle.vertices[0].colour);
            walkColumns<0>(seenFrom(triangle, sample), {},
                           [&](std::int64_t x, std::int64_t first, std::int64_t end,
                               const WalkedValues<0> &, const WalkedValues<0> &) {
                               QRgb *pixel = seen.at(x, first);
                               for (std::int64_t y = first; y < end; ++y) {
                                   *pixel = painted;
                                   pixel += seen.stride;
                               }
                           });
        }
        for (std::size_t i = 0; i < size; ++i) {
            for (std::size_t k = 0; k < 4; ++k)
                sums[i][k] = std::uint16_t(sums[i][k] + (pixels[i] >> (8 * k) & 255U));
        }
    }
    for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
        for (std::int64_t x = frame.firstColumn; x < frame.endColumn(); ++x) {
            const auto &sum
                = sums[std::size_t((y - frame.firstRow) * frame.width + x - frame.firstColumn)];
            QRgb mean = sum[3] > 0 ? 0xff000000U : 0;
            for (std::size_t k = 0; k < 3; ++k)
                mean |= QRgb((2U * sum[k] + 4U) / 8U) << (8 * k);
            *frame.at(x, y) = mean;
        }
    }
}

constexpr EffectLoop loops[] = {
    {"depth", drawDepth, effectscenes::deep},
    {"depth, 24 bits", drawDepthLevels, effectscenes::deepIn24Bits},
    {"blending", drawGlass, effectscenes::glass},
    {"4 samples", drawFourSamples, effectscenes::sampled},
};

} // namespace

std::vector<EffectLoop> effectLoops()
{
    std::vector<EffectLoop> all(std::begin(loops), std::end(loops));
    const std::span<const EffectLoop> more = loopsOfSurfaces();
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace pixelplumb
