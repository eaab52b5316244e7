// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layermoment.h"
#include "core/number/wideinteger.h"

#include <array>

/// Affine maps of the plane, in exact numbers: what they do to a triangle, and what they leave.
/// Coordinates are the scene's.
namespace pixelplumb {

/// px.
struct RationalPoint {
    BigRational x, y;
};

RationalPoint rationalPoint(const LatticePoint &point);

/// p ↦ (xx·x + xy·y + shift.x, yx·x + yy·y + shift.y).
struct AffineMap {
    BigRational xx, xy, yx, yy;
    RationalPoint shift;

    /// By which it multiplies areas: below 0 it mirrors, 0 where it flattens the plane.
    BigRational determinant() const { return xx * yy - xy * yx; }
    RationalPoint of(const RationalPoint &point) const;
};

/// The one that takes three corners, which are not on one line, to their images.
AffineMap affineMapOf(const Corners &corners, const Corners &images);

/// Doubled areas with their signs, square px: of a triangle, and of those that a point makes with
/// the edges opposite to its corners. Each is computed by itself.
struct PointAreas {
    std::array<BigRational, 3> parts;
    BigRational whole;

    /// The barycentric weight of a corner; the whole is not 0.
    BigRational weight(std::size_t corner) const { return parts[corner] / whole; }
};
PointAreas pointAreas(const Corners &corners, const RationalPoint &point);

/// Images of the corners that are worth a look: turned, sheared and moved to where the frame has
/// room, on whole pixels where these leave them an area.
Corners defaultImages(const Corners &corners, const FrameSpec &frame);

/// Of a triangle of the run that is looked at, in the order in which the person gave its corners:
/// those that the view asks for, else the default ones.
Corners imagesOf(const LayerView &view, std::size_t triangle);

} // namespace pixelplumb
