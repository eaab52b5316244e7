// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/attributes.h"
#include "core/geometry/colour.h"
#include "core/geometry/effect.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// How a scene's triangles look, apart from their positions and colours: materials, lights, depth
/// and antialiasing. Plain values; kernels read them and never change them.
namespace pixelplumb {

/// How a texture is read between its texels, and outside 0 … 1.
enum class TextureFilter : std::uint8_t { Nearest, Bilinear };
enum class TextureWrap : std::uint8_t { Repeat, Clamp };

/// A picture of texels, row 0 the lowest: texel (i, j) covers u in [i/width, (i+1)/width) and v in
/// [j/height, (j+1)/height).
struct Texture {
    std::string name; ///< as named in the scene: "checker", "picture.png"
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::vector<Colour> texels; ///< width * height, rows upward

    const Colour &texel(std::int32_t i, std::int32_t j) const
    {
        return texels[std::size_t(j) * std::size_t(width) + std::size_t(i)];
    }
    friend bool operator==(const Texture &, const Texture &) = default;
};

/// "checker": 8 × 8 texels, (i, j) white where i + j is even, black elsewhere.
Texture checkerTexture();

inline constexpr int mostShininess = 1024;

/// What a triangle is made of.
struct Material {
    std::string name;
    std::shared_ptr<const Texture> texture; ///< null: none
    TextureFilter filter = TextureFilter::Nearest;
    TextureWrap wrap = TextureWrap::Repeat;
    /// Multiplied into the vertices' colours, channel by channel: ⌊c·d/255 + ½⌋.
    Colour diffuse = {{255, 255, 255}};
    Colour specular = {{0, 0, 0}};
    int shininess = 32; ///< the exponent of the highlight, 1 … mostShininess

    friend bool operator==(const Material &a, const Material &b)
    {
        const bool sameTexture
            = a.texture == b.texture || (a.texture && b.texture && *a.texture == *b.texture);
        return sameTexture && a.name == b.name && a.filter == b.filter && a.wrap == b.wrap
            && a.diffuse == b.diffuse && a.specular == b.specular && a.shininess == b.shininess;
    }
};

/// A light of the scene: far away, shining along a direction, or at a place.
struct Light {
    enum class Kind : std::uint8_t { Directional, Positional };

    Kind kind = Kind::Directional;
    /// The direction in which it shines, of any length but 0, or the place of the light.
    std::array<Attribute, 3> at = {};
    Colour colour = {{255, 255, 255}};

    friend bool operator==(const Light &, const Light &) = default;
};

inline constexpr std::size_t mostLights = 8;

/// Where light is computed: once per triangle, at its vertices, or at every sample.
enum class Shading : std::uint8_t { Flat, Gouraud, Phong };

/// Whether samples are tested against the nearest depth so far: where the scene calls for it,
/// never, or always.
enum class DepthUse : std::uint8_t { Auto, Off, On };

/// What a depth buffer stores: the kernel's own number, or an integer of this many bits whose
/// levels are evenly spaced from 0 (nearest) to 1; depths outside are clamped.
enum class DepthFormat : std::uint8_t { Exact = 0, Bits16 = 16, Bits24 = 24, Bits32 = 32 };

/// One sample per pixel; 4 or 16 samples, each with its own colour and depth, averaged, in the
/// pixels that an edge passes through; or α times the exact area of the primitive in the pixel's
/// square.
enum class Antialiasing : std::uint8_t { None, Samples4, Samples16, Area };

/// Everything about how a scene looks.
struct Appearance {
    std::vector<Material> materials;
    std::vector<Light> lights; ///< at most mostLights
    Colour ambient = {{32, 32, 32}}; ///< #202020; used only where there is a light
    Shading shading = Shading::Phong;
    DepthUse depth = DepthUse::Auto;
    DepthFormat depthFormat = DepthFormat::Exact;
    Antialiasing antialiasing = Antialiasing::None;
    /// Where the viewer for lighting stands (a perspective camera's eye), or the direction towards
    /// it.
    Light::Kind viewerKind = Light::Kind::Directional;
    std::array<Attribute, 3> viewer = {0, 0, -attributeOne};
    EffectForcing forced;

    /// Whether it asks for more than colours, whatever triangles carry and is forced.
    bool namesEffects() const
    {
        return depth == DepthUse::On || antialiasing != Antialiasing::None;
    }
    /// The same, or something is forced.
    bool asksForEffects() const { return namesEffects() || forced != EffectForcing{}; }

    friend bool operator==(const Appearance &, const Appearance &) = default;
};

} // namespace pixelplumb
