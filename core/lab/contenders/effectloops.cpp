// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/effectloop.h"
#include "core/lab/contenders/effectloopscenes.h"
#include "core/lab/contenders/straightwalk.h"
#include "core/shade/edgepixels.h"
#include "core/shade/samplelight.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace pixelplumb {

namespace {

template <std::size_t count>
using Values = StraightValues<Real<float>, count>;

float unitsOf(Attribute attribute) { return float(double(attribute) / double(attributeOne)); }

/// The assignment's column scan in float32, with half-open columns and rows, of all triangles:
/// calls paint(colour of the triangle, the values at the sample, its pixel, its place in a map that
/// is stored column by column, as it is walked). valuesOf(attributes) are the values of a vertex.
template <std::size_t count, class ValuesOf, class Paint>
void paintTriangles(const Primitives &primitives, const FrameView &frame, const ValuesOf &valuesOf,
                    const Paint &paint)
{
    using Edge = RoundedEdge<Real<float>, count>;
    for (std::size_t i = 0; i < primitives.triangles.size(); ++i) {
        std::array<Values<count>, 3> values;
        for (std::size_t k = 0; k < 3; ++k)
            values[k] = valuesOf(primitives.attributes[i].vertices[k]);
        const Triangle &triangle = primitives.triangles[i];
        const Colour &colour = triangle.vertices[0].colour;
        const auto edgeOn = [&](std::size_t from, std::size_t to, std::int64_t column) {
            return Edge(triangle.vertices[from].position, values[from],
                        triangle.vertices[to].position, values[to], column);
        };
        walkStraight<StraightRule::HalfOpen>(
            triangle, edgeOn,
            [&](std::int64_t x, std::int64_t first, std::int64_t end, const Edge &bottom,
                const Edge &top) {
                StraightColumn<Real<float>, count> column(bottom, top, first);
                QRgb *pixel = frame.at(x, first);
                auto place
                    = std::size_t((x - frame.firstColumn) * frame.height + first - frame.firstRow);
                for (std::int64_t y = first; y < end; ++y, ++place, pixel += frame.stride) {
                    paint(colour, column.value, *pixel, place);
                    column.step();
                }
            });
    }
}

/// The nearest depths so far, as paintTriangles() tells their places.
template <class Level>
std::vector<Level> farthestDepths(const FrameView &frame, Level farthest)
{
    return std::vector<Level>(std::size_t(frame.width) * std::size_t(frame.height), farthest);
}

Values<1> depthOf(const VertexAttributes &vertex) { return {unitsOf(vertex.z)}; }

void drawDepth(const Primitives &primitives, FrameView frame)
{
    auto depths = farthestDepths(frame, std::numeric_limits<float>::infinity());
    paintTriangles<1>(
        primitives, frame, depthOf,
        [&](const Colour &colour, const Values<1> &value, QRgb &pixel, std::size_t place) {
            if (value[0] <= depths[place]) {
                depths[place] = value[0];
                pixel = packed(colour);
            }
        });
}

void drawDepthLevels(const Primitives &primitives, FrameView frame)
{
    constexpr double most = (1 << 24) - 1;
    auto depths = farthestDepths(frame, std::numeric_limits<std::uint32_t>::max());
    paintTriangles<1>(
        primitives, frame, depthOf,
        [&](const Colour &colour, const Values<1> &value, QRgb &pixel, std::size_t place) {
            const double z = std::clamp(double(value[0]), 0.0, 1.0);
            const auto level = std::uint32_t(std::int64_t(z * most + 0.5));
            if (level <= depths[place]) {
                depths[place] = level;
                pixel = packed(colour);
            }
        });
}

void drawGlass(const Primitives &primitives, FrameView frame)
{
    paintTriangles<1>(
        primitives, frame,
        [](const VertexAttributes &vertex) { return Values<1>{float(vertex.alpha)}; },
        [](const Colour &colour, const Values<1> &value, QRgb &pixel, std::size_t) {
            const int alpha = byteOf(value[0]);
            const auto mixed = [&](int source, int destination) {
                return (2 * (source * alpha + destination * (255 - alpha)) + 255) / 510;
            };
            pixel = qRgb(mixed(colour.red(), qRed(pixel)), mixed(colour.green(), qGreen(pixel)),
                         mixed(colour.blue(), qBlue(pixel)));
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
    Primitives moved = primitives;
    for (const LatticePoint &sample : samplePattern(Antialiasing::Samples4)) {
        for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y)
            std::copy_n(frame.at(frame.firstColumn, y), frame.width, seen.at(frame.firstColumn, y));
        for (std::size_t i = 0; i < moved.triangles.size(); ++i)
            moved.triangles[i] = seenFrom(primitives.triangles[i], sample);
        paintTriangles<0>(
            moved, seen, [](const VertexAttributes &) { return Values<0>(); },
            [](const Colour &colour, const Values<0> &, QRgb &pixel, std::size_t) {
                pixel = packed(colour);
            });
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

int multiplied(int level, int tint) { return (2 * level * tint + 255) / 510; }

int repeated(int index, int size)
{
    const int rest = index % size;
    return rest < 0 ? rest + size : rest;
}

/// 1/w, u/w, v/w.
Values<3> dividedTexturePoint(const VertexAttributes &vertex)
{
    const float w = unitsOf(vertex.w);
    return {1 / w, unitsOf(vertex.texture[0]) / w, unitsOf(vertex.texture[1]) / w};
}

void drawTexture(const Primitives &primitives, FrameView frame)
{
    const Texture &texture = *primitives.appearance.materials[0].texture;
    paintTriangles<3>(primitives, frame, dividedTexturePoint,
                      [&](const Colour &colour, const Values<3> &value, QRgb &pixel, std::size_t) {
                          const float u = value[1] / value[0] * float(texture.width);
                          const float v = value[2] / value[0] * float(texture.height);
                          const Colour &texel
                              = texture.texel(repeated(int(Real<float>::floor(u)), texture.width),
                                              repeated(int(Real<float>::floor(v)), texture.height));
                          pixel = qRgb(multiplied(colour.red(), texel.red()),
                                       multiplied(colour.green(), texel.green()),
                                       multiplied(colour.blue(), texel.blue()));
                      });
}

void drawFilteredTextureAndDepth(const Primitives &primitives, FrameView frame)
{
    const Texture &texture = *primitives.appearance.materials[0].texture;
    auto depths = farthestDepths(frame, std::numeric_limits<float>::infinity());
    paintTriangles<4>(
        primitives, frame,
        [](const VertexAttributes &vertex) -> Values<4> {
            const auto [q, u, v] = dividedTexturePoint(vertex);
            return {unitsOf(vertex.z), q, u, v};
        },
        [&](const Colour &colour, const Values<4> &value, QRgb &pixel, std::size_t place) {
            if (value[0] > depths[place])
                return;
            depths[place] = value[0];
            const float u = value[2] / value[1] * float(texture.width) - 0.5F;
            const float v = value[3] / value[1] * float(texture.height) - 0.5F;
            const auto left = int(Real<float>::floor(u)), low = int(Real<float>::floor(v));
            const float fu = u - float(left), fv = v - float(low);
            const int i = repeated(left, texture.width);
            const int j = repeated(low, texture.height);
            const int right = repeated(left + 1, texture.width);
            const int high = repeated(low + 1, texture.height);
            const Colour &a = texture.texel(i, j), &b = texture.texel(right, j);
            const Colour &c = texture.texel(i, high), &d = texture.texel(right, high);
            int byte[3];
            for (std::size_t k = 0; k < 3; ++k) {
                const float below
                    = float(a.channels[k]) + (float(b.channels[k]) - float(a.channels[k])) * fu;
                const float above
                    = float(c.channels[k]) + (float(d.channels[k]) - float(c.channels[k])) * fu;
                byte[k] = multiplied(colour.channels[k], byteOf(below + (above - below) * fv));
            }
            pixel = qRgb(byte[0], byte[1], byte[2]);
        });
}

/// One lamp and the viewer are far away: the halfway vector is the same everywhere.
void drawLight(const Primitives &primitives, FrameView frame)
{
    const Appearance &appearance = primitives.appearance;
    const Material &material = appearance.materials[0];
    const Lighting<float> lighting(appearance);
    const Vector<float> toLight = lighting.sources[0].way.at, toViewer = lighting.viewer.at;
    const Vector<float> halfway = unitVector<float>(
        {toLight[0] + toViewer[0], toLight[1] + toViewer[1], toLight[2] + toViewer[2]});
    paintTriangles<3>(
        primitives, frame,
        [](const VertexAttributes &vertex) -> Values<3> {
            return {unitsOf(vertex.normal[0]), unitsOf(vertex.normal[1]),
                    unitsOf(vertex.normal[2])};
        },
        [&](const Colour &colour, const Values<3> &value, QRgb &pixel, std::size_t) {
            const Vector<float> normal = unitVector<float>(value);
            const float diffuse = std::max(0.0F, dot(normal, toLight));
            const float facing = std::max(0.0F, dot(normal, halfway));
            float highlight = 0;
            if (diffuse > 0) {
                highlight = 1;
                float power = facing;
                for (int n = material.shininess; n > 0; n /= 2) {
                    if (n % 2 == 1)
                        highlight *= power;
                    power *= power;
                }
            }
            int byte[3];
            for (std::size_t k = 0; k < 3; ++k) {
                const float lamp = lighting.sources[0].colour[k];
                byte[k] = byteOf(float(colour.channels[k]) * (lighting.ambient[k] + lamp * diffuse)
                                     / 255
                                 + float(material.specular.channels[k]) * (lamp * highlight) / 255);
            }
            pixel = qRgb(byte[0], byte[1], byte[2]);
        });
}

constexpr EffectLoop loops[] = {
    {"depth", drawDepth, effectscenes::deep},
    {"depth, 24 bits", drawDepthLevels, effectscenes::deepIn24Bits},
    {"blending", drawGlass, effectscenes::glass},
    {"4 samples", drawFourSamples, effectscenes::sampled},
    {"perspective, texture", drawTexture, effectscenes::textured},
    {"perspective, filtered texture, depth", drawFilteredTextureAndDepth,
     effectscenes::filteredAndDeep},
    {"light", drawLight, effectscenes::lit},
};

} // namespace

std::span<const EffectLoop> effectLoops() { return loops; }

} // namespace pixelplumb
