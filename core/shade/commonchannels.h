// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/channel.h"

/// In which channels the vertices of a triangle agree, so that nothing is interpolated. SetUp is a
/// ShadedSetUp.
namespace pixelplumb {

/// What the vertices' w do: where they are equal, or nothing that is divided by them differs, there
/// is nothing to correct.
enum class DivisionBy : std::uint8_t { W, One };

/// Whether a value, by the place of its vertex in (x, y) order, is the same at all that count: of a
/// segment only its two ends, of a point only its first vertex.
template <class ValueAt>
constexpr bool agreeInOrder(const ValueAt &valueAt, bool isSegment, bool isPoint)
{
    return isPoint || (valueAt(0) == valueAt(2) && (isSegment || valueAt(0) == valueAt(1)));
}

namespace shadedsetup {

/// The three colours count as one channel: one that is interpolated is interpolated as without
/// effects.
template <class SetUp, class ShadedTriangle>
void setCommonChannels(SetUp &setUp, const ShadedTriangle &triangle)
{
    const auto agree = [&](Channel channel) {
        const auto valueAt = [&](std::size_t corner) {
            return triangle.valueAt(std::size_t(setUp.order[corner]), channel);
        };
        const auto &place = setUp.vertices;
        const bool isPoint = setUp.zeroArea
            && place[std::size_t(setUp.order[0])].position
                == place[std::size_t(setUp.order[2])].position;
        return agreeInOrder(valueAt, setUp.zeroArea, isPoint);
    };
    const bool isOneColour = agree(Channel::Red) && agree(Channel::Green) && agree(Channel::Blue);
    for (const Channel channel : {Channel::Red, Channel::Green, Channel::Blue})
        setUp.isCommon[indexOf(channel)] = isOneColour;
    for (const Channel channel : {Channel::Alpha, Channel::Depth})
        setUp.isCommon[indexOf(channel)] = agree(channel);
    setUp.isCommon[indexOf(Channel::Reciprocal)] = triangle.division == DivisionBy::One;
}

} // namespace shadedsetup

} // namespace pixelplumb
