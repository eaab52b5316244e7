// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/effectplan.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace pixelplumb {

/// The values that shaded triangles interpolate linearly in the frame.
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

/// A value for each channel; channels that are not carried are never read.
template <class Value>
using PerChannel = std::array<Value, shadedChannelCount>;

constexpr std::size_t indexOf(Channel channel) { return std::size_t(channel); }
constexpr Channel channelAt(std::size_t index) { return Channel(index); }

/// Whether the channel is divided by w at the vertices for perspective correction.
constexpr bool followsPerspective(Channel channel)
{
    return channel != Channel::Depth && channel != Channel::Reciprocal;
}

/// Whether the channel counts in whole levels; the others count in 2^-24.
constexpr bool isLevel(Channel channel) { return channel <= Channel::Alpha; }

/// Whether the effects read the channel.
constexpr bool carries(const EffectSet &effects, Channel channel)
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

/// The indices of the channels that the effects read, in order.
class ShadedChannels {
public:
    constexpr explicit ShadedChannels(const EffectSet &effects)
    {
        for (std::size_t index = 0; index < shadedChannelCount; ++index) {
            if (carries(effects, channelAt(index)))
                m_channels[m_count++] = std::uint8_t(index);
        }
    }

    constexpr const std::uint8_t *begin() const { return m_channels.data(); }
    constexpr const std::uint8_t *end() const { return m_channels.data() + m_count; }

private:
    std::array<std::uint8_t, shadedChannelCount> m_channels = {};
    std::size_t m_count = 0;
};

/// Calls function(index) for each channel that the effects read.
template <class Function>
void forEachChannel(const EffectSet &effects, const Function &function)
{
    for (const std::size_t index : ShadedChannels(effects))
        function(index);
}

} // namespace pixelplumb
