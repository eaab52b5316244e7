// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/attributes.h"
#include "core/geometry/lattice.h"
#include "core/space/spacevector.h"

#include <algorithm>
#include <optional>

namespace pixelplumb {

/// The nearest integer; a tie goes up. |value| < 2^62.
inline std::int64_t nearestWhole(double value)
{
    const double whole = std::floor(value);
    return std::int64_t(whole) + (value - whole >= 0.5 ? 1 : 0);
}

/// The nearest attribute; none beyond largestAttributeValue and for NaN.
inline std::optional<Attribute> nearestAttribute(double value)
{
    if (!(std::abs(value) <= double(largestAttributeValue)))
        return std::nullopt;
    return nearestWhole(value * double(attributeOne));
}

/// Like nearestAttribute(), but clamped to ±largestAttributeValue; 0 for NaN.
inline Attribute clampedAttribute(double value)
{
    const auto limit = double(largestAttributeValue);
    return std::isnan(value) ? 0 : nearestAttribute(std::clamp(value, -limit, limit)).value();
}

/// The lattice coordinate nearest to a value in px; none beyond ±2^30 px and for NaN.
inline std::optional<Lattice> nearestLattice(double pixels)
{
    if (!(std::abs(pixels) <= double(largestPixel)))
        return std::nullopt;
    return nearestWhole(pixels * double(unitsPerPixel));
}

template <class Number>
SpaceVector<Number> spaceVectorOf(const std::array<Attribute, 3> &attributes)
{
    const Number one(attributeOne);
    return {Number(attributes[0]) / one, Number(attributes[1]) / one, Number(attributes[2]) / one};
}

} // namespace pixelplumb
