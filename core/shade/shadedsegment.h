// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"
#include "core/scan/interpolation/interpolationcoefficients.h"
#include "core/shade/channel.h"

#include <array>

/// The set-up of a triangle without area: the closed rule draws the segment between its extreme
/// vertices in (x, y) order. SetUp is a ShadedSetUp.
namespace pixelplumb::shadedsetup {

/// A sample's position between the ends of a segment: (at − start)/length along its axis.
struct SegmentAxis {
    template <class SetUp>
    explicit SegmentAxis(const SetUp &setUp)
        : first(std::size_t(setUp.order[0]))
        , last(std::size_t(setUp.order[2]))
    {
        const LatticePoint &from = setUp.vertices[first].position;
        const LatticePoint &to = setUp.vertices[last].position;
        axis = from.x == to.x ? 1 : 0;
        start = axis == 1 ? from.y : from.x;
        length = axis == 1 ? to.y - from.y : to.x - from.x;
    }

    std::size_t first, last; ///< vertices, numbered as by the caller
    std::size_t axis; ///< 0: x, 1: y
    Lattice start, length; ///< lattice units; 0 where the segment is a point
};

/// In exact numbers: the weights of the segment's ends, over its length.
template <class SetUp>
void setSegmentWeights(SetUp &setUp)
{
    using Integer = typename SetUp::Number;
    const SegmentAxis along(setUp);
    setUp.area = along.length == 0 ? 1 : along.length;
    std::array<Integer, 3> &first = setUp.weight[along.first];
    std::array<Integer, 3> &last = setUp.weight[along.last];
    setUp.weight = {};
    if (along.length != 0) {
        last[along.axis] = unitsPerPixel;
        last[2] = -along.start;
        first[along.axis] = -unitsPerPixel;
    }
    first[2] = setUp.area - last[2];
}

/// In floating numbers: the weight of the segment's last vertex, and what follows from it.
template <class SetUp>
void setSegmentForm(SetUp &setUp)
{
    using Float = typename SetUp::Number;
    const SegmentAxis along(setUp);
    std::array<Float, 3> share = {};
    if (along.length != 0) {
        const Float length = NumberTraits<Float>::fromLattice(along.length);
        share[along.axis] = 1 / length;
        share[2] = -NumberTraits<Float>::fromLattice(along.start) / length;
    }
    setUp.weight = {};
    setUp.weight[along.last] = share;
    setUp.weight[along.first] = {-share[0], -share[1], 1 - share[2]};
    if (setUp.form == InterpolationForm::Plane) {
        for (const std::size_t channel : setUp.carried) {
            const Float from = setUp.vertices[along.first].channels[channel];
            const Float rise = setUp.vertices[along.last].channels[channel] - from;
            setUp.plane[channel] = {rise * share[0], rise * share[1], from + rise * share[2]};
        }
    }
}

} // namespace pixelplumb::shadedsetup
