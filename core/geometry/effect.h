// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pixelplumb {

/// What a scene may call for beyond covering samples with one colour.
enum class Effect : std::uint8_t {
    SmoothColour, ///< vertex colours differ
    Clipping, ///< a primitive crosses the frame's border or the near plane
    Depth, ///< a later triangle lies behind an earlier one
    Perspective, ///< w differs between vertices that carry something
    Texture,
    Light, ///< computed at every sample (Phong shading); otherwise it is part of the set-up colours
    Blending, ///< an alpha below 255
    Antialiasing,
};
inline constexpr std::array allEffects
    = {Effect::SmoothColour, Effect::Clipping, Effect::Depth,    Effect::Perspective,
       Effect::Texture,      Effect::Light,    Effect::Blending, Effect::Antialiasing};

/// "smooth colour", "clipping", "depth", "perspective", "texture", "light", "blending",
/// "antialiasing".
std::string_view nameOf(Effect effect);

/// A value for each effect.
template <class Value>
struct PerEffect {
    std::array<Value, allEffects.size()> values = {};

    constexpr Value &operator[](Effect effect) { return values[std::size_t(effect)]; }
    constexpr const Value &operator[](Effect effect) const { return values[std::size_t(effect)]; }
    friend constexpr bool operator==(const PerEffect &, const PerEffect &) = default;
};

/// A person's manual override, to see what an effect costs or changes; never in a file.
enum class Forcing : std::uint8_t { AsCalledFor, On, Off };
/// Whether the effect runs.
constexpr bool isForced(bool isCalledFor, Forcing forcing)
{
    return forcing == Forcing::AsCalledFor ? isCalledFor : forcing == Forcing::On;
}
using EffectForcing = PerEffect<Forcing>;

} // namespace pixelplumb
