// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/contenders/columnwalk.h"
#include "core/lab/contenders/effectloop.h"
#include "core/lab/contenders/effectloopscenes.h"
#include "core/shade/samplelight.h"

#include <limits>

/// Textures and light.
namespace pixelplumb {

namespace {

int multiplied(int level, int tint) { return (2 * level * tint + 255) / 510; }

int repeated(int index, int size)
{
    const int rest = index % size;
    return rest < 0 ? rest + size : rest;
}

/// 1/w, u/w, v/w.
WalkedValues<3> dividedTexturePoint(const VertexAttributes &vertex)
{
    const float w = unitsOf(vertex.w);
    return {1 / w, unitsOf(vertex.texture[0]) / w, unitsOf(vertex.texture[1]) / w};
}

void drawTexture(const Primitives &primitives, FrameView frame)
{
    const Texture &texture = *primitives.appearance.materials[0].texture;
    drawTriangles<3>(primitives, dividedTexturePoint,
                     [&](const Colour &colour, std::int64_t x, std::int64_t first, std::int64_t end,
                         WalkedValues<3> value, const WalkedValues<3> &rate) {
                         QRgb *pixel = frame.at(x, first);
                         for (std::int64_t y = first; y < end; ++y) {
                             const float u = value[1] / value[0] * float(texture.width);
                             const float v = value[2] / value[0] * float(texture.height);
                             const Colour &texel
                                 = texture.texel(repeated(int(straightFloor(u)), texture.width),
                                                 repeated(int(straightFloor(v)), texture.height));
                             *pixel = qRgb(multiplied(colour.red(), texel.red()),
                                           multiplied(colour.green(), texel.green()),
                                           multiplied(colour.blue(), texel.blue()));
                             pixel += frame.stride;
                             for (std::size_t i = 0; i < 3; ++i)
                                 value[i] += rate[i];
                         }
                     });
}

void drawFilteredTextureAndDepth(const Primitives &primitives, FrameView frame)
{
    const Texture &texture = *primitives.appearance.materials[0].texture;
    ColumnMajor<float> depths(frame, std::numeric_limits<float>::infinity());
    drawTriangles<4>(
        primitives,
        [](const VertexAttributes &vertex) -> WalkedValues<4> {
            const auto [q, u, v] = dividedTexturePoint(vertex);
            return {unitsOf(vertex.z), q, u, v};
        },
        [&](const Colour &colour, std::int64_t x, std::int64_t first, std::int64_t end,
            WalkedValues<4> value, const WalkedValues<4> &rate) {
            QRgb *pixel = frame.at(x, first);
            float *depth = depths.at(x, first);
            for (std::int64_t y = first; y < end; ++y) {
                if (value[0] <= *depth) {
                    *depth = value[0];
                    const float u = value[2] / value[1] * float(texture.width) - 0.5F;
                    const float v = value[3] / value[1] * float(texture.height) - 0.5F;
                    const auto left = int(straightFloor(u)), low = int(straightFloor(v));
                    const float fu = u - float(left), fv = v - float(low);
                    const int i = repeated(left, texture.width);
                    const int j = repeated(low, texture.height);
                    const int right = repeated(left + 1, texture.width);
                    const int high = repeated(low + 1, texture.height);
                    const Colour &a = texture.texel(i, j), &b = texture.texel(right, j);
                    const Colour &c = texture.texel(i, high), &d = texture.texel(right, high);
                    int byte[3];
                    for (std::size_t k = 0; k < 3; ++k) {
                        const float below = float(a.channels[k])
                            + (float(b.channels[k]) - float(a.channels[k])) * fu;
                        const float above = float(c.channels[k])
                            + (float(d.channels[k]) - float(c.channels[k])) * fu;
                        byte[k]
                            = multiplied(colour.channels[k], byteOf(below + (above - below) * fv));
                    }
                    *pixel = qRgb(byte[0], byte[1], byte[2]);
                }
                ++depth;
                pixel += frame.stride;
                for (std::size_t i = 0; i < 4; ++i)
                    value[i] += rate[i];
            }
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
    drawTriangles<3>(
        primitives,
        [](const VertexAttributes &vertex) -> WalkedValues<3> {
            return {unitsOf(vertex.normal[0]), unitsOf(vertex.normal[1]),
                    unitsOf(vertex.normal[2])};
        },
        [&](const Colour &colour, std::int64_t x, std::int64_t first, std::int64_t end,
            WalkedValues<3> value, const WalkedValues<3> &rate) {
            QRgb *pixel = frame.at(x, first);
            for (std::int64_t y = first; y < end; ++y) {
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
                    byte[k] = byteOf(
                        float(colour.channels[k]) * (lighting.ambient[k] + lamp * diffuse) / 255
                        + float(material.specular.channels[k]) * (lamp * highlight) / 255);
                }
                *pixel = qRgb(byte[0], byte[1], byte[2]);
                pixel += frame.stride;
                for (std::size_t i = 0; i < 3; ++i)
                    value[i] += rate[i];
            }
        });
}

constexpr EffectLoop loops[] = {
    {"perspective, texture", drawTexture, effectscenes::textured},
    {"perspective, filtered texture, depth", drawFilteredTextureAndDepth,
     effectscenes::filteredAndDeep},
    {"light", drawLight, effectscenes::lit},
};

} // namespace

std::span<const EffectLoop> loopsOfSurfaces() { return loops; }

} // namespace pixelplumb
