// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layermoment.h"
#include "core/number/wideinteger.h"

#include <QString>
#include <QStringList>

#include <array>

/// Affine maps of the plane, in exact numbers: what they do to a triangle, and what they preserve.
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

    /// The factor by which it scales areas: below 0 it mirrors, at 0 it flattens the plane.
    BigRational determinant() const { return xx * yy - xy * yx; }
    RationalPoint of(const RationalPoint &point) const;
};

/// The map that takes three corners, not on one line, to their images.
AffineMap affineMapOf(const Corners &corners, const Corners &images);

/// Signed doubled areas, square px: of a triangle, and of those that a point makes with the edges
/// opposite its corners. Each is computed by itself.
struct PointAreas {
    std::array<BigRational, 3> parts;
    BigRational whole;

    /// The barycentric weight of a corner; the whole is not 0.
    BigRational weight(std::size_t corner) const { return parts[corner] / whole; }
};
PointAreas pointAreas(const Corners &corners, const RationalPoint &point);

/// Default images of the corners: turned, sheared and moved to where the frame has room, on whole
/// pixels if these leave them an area.
Corners defaultImages(const Corners &corners, const FrameSpec &frame);

/// For the viewed triangle of the run, in the user's order of its corners: the images that the view
/// asks for, else the default ones.
Corners imagesOf(const LayerView &view, std::size_t triangle);

// What is said of them: exact fractions or, if one in a sentence is long, the whole sentence
// rounded and marked by ≈.

/// "(27/2, 9)", px.
QString pointText(const RationalPoint &point);
/// The two rows of a map, which form one sentence.
QStringList rowsText(const AffineMap &map);
QString weightsText(const PointAreas &areas);
QString areasText(const PointAreas &areas);
/// The factor by which the map scales areas, and whether it mirrors.
QString areasChangeText(const AffineMap &map);

} // namespace pixelplumb
