// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/effectplan.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace pixelplumb {

/// What shaded triangles interpolate, linearly in the frame.
enum class Channel : std::uint8_t {
    Red,
    Green,
    Blue,
    Alpha,
    Depth,
    Reciprocal, ///< 1/w
    U,
    V,
    NormalX,
    NormalY,
    NormalZ,
    PlaceX,
    PlaceY,
    PlaceZ,
};
inline constexpr std::size_t shadedChannelCount = 14;

/// A value for each channel; those that are not carried are never read.
template <class Value>
using PerChannel = std::array<Value, shadedChannelCount>;

constexpr std::size_t indexOf(Channel channel) { return std::size_t(channel); }
constexpr Channel channelAt(std::size_t index) { return Channel(index); }

/// Whether the channel is divided by w at the vertices where perspective is corrected.
constexpr bool followsPerspective(Channel channel)
{
    return channel != Channel::Depth && channel != Channel::Reciprocal;
}

/// Levels count in whole levels, the other channels in 2^-24.
constexpr bool isLevel(Channel channel) { return channel <= Channel::Alpha; }

/// Whether the effects read a channel. Effects is an EffectSet or a CompiledEffects.
template <class Effects>
constexpr bool carries(const Effects &effects, Channel channel)
{
    switch (channel) {
    case Channel::Red:
    case Channel::Green:
    case Channel::Blue:
        return effects.smooth;
    case Channel::Alpha:
        return effects.blending;
    case Channel::Depth:
        return effects.depth != DepthTest::None;
    case Channel::Reciprocal:
        return effects.perspective;
    case Channel::U:
    case Channel::V:
        return effects.texture;
    case Channel::NormalX:
    case Channel::NormalY:
    case Channel::NormalZ:
    case Channel::PlaceX:
    case Channel::PlaceY:
    case Channel::PlaceZ:
        return effects.light;
    }
    return false;
}

/// Calls function(index) for each channel that the effects carry, in order; for the compiled ones
/// of CompiledEffects a straight line of code.
template <class Effects, class Function>
[[gnu::always_inline]] inline void forEachChannel(const Effects &effects, const Function &function)
{
    for (std::size_t index = 0; index < shadedChannelCount; ++index) {
        if (carries(effects, channelAt(index)))
            function(index);
    }
}

} // namespace pixelplumb
