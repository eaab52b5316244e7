// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/drawnplane.h"

#include "core/scan/tests/edgetestsetup.h"
#include "core/scan/tests/planearithmetic.h"
#include "core/shade/edgepixels.h"

#include <algorithm>

namespace pixelplumb {

namespace {

using Form = PixelForm<Int128>;

/// The edge function from a to b, positive to its left, over the pixels' own samples.
Form edgeForm(const LatticePoint &a, const LatticePoint &b)
{
    const Int128 width = b.x - a.x;
    const Int128 height = b.y - a.y;
    return {-height * unitsPerPixel, width * unitsPerPixel, height * a.x - width * a.y};
}

Form negative(const Form &form) { return {-form.x, -form.y, -form.constant}; }

/// Above 0 where the form is at least 0.
Form orZero(const Form &form) { return {form.x, form.y, form.constant + 1}; }

} // namespace

DrawnPlane::DrawnPlane(const DepthTriangle &triangle, const LatticePoint &sample,
                       const SampledFrame &where)
{
    inside.reserve(7);
    if (doubledArea(*triangle.triangle) == 0)
        setSegment(triangle);
    else
        setTriangle(triangle, seenFrom(*triangle.triangle, sample), where);
}

void DrawnPlane::setTriangle(const DepthTriangle &given, const Triangle &seen,
                             const SampledFrame &where)
{
    const BoundaryRule rule(where.rule, where.frame.origin, where.frame.offScreenPoint);
    const auto owned
        = edgeTestSetUp<ExactPlane<Int128>, canonicalEdgeEquationsForm>(seen, rule, {}).ownsTie;
    const bool isClockwise = doubledArea(seen) < 0;
    denominator = Int256(absolute(doubledArea(seen)));
    isDivided = given.w != std::array<Attribute, 3>{};
    Form depths; // below 2^126
    for (std::size_t edge = 0; edge < 3; ++edge) {
        Form form = edgeForm(seen.vertices[edge].position, seen.vertices[(edge + 1) % 3].position);
        if (isClockwise)
            form = negative(form);
        const std::size_t facing = (edge + 2) % 3;
        depths = depths + form * Int128(given.z[facing]);
        if (isDivided)
            reciprocal = reciprocal
                + widened<Int256>(form)
                    * Int256(Int256(given.w[(facing + 1) % 3]) * given.w[(facing + 2) % 3]);
        if (where.antialiasing == Antialiasing::Area) {
            // The pixel's square reaches beyond its centre, across the edge's line.
            form.constant += (absolute(form.x) + absolute(form.y)) / 2;
            inside.push_back(form);
        } else {
            inside.push_back(owned[edge] ? orZero(form) : form);
        }
    }
    depth = widened<Int256>(depths);
    if (where.antialiasing != Antialiasing::Area)
        return;
    // Two convex figures are also apart where one lies beyond a side of the square.
    const auto [least, greatest] = boundingCornersOf(seen);
    inside.push_back({unitsPerPixel, 0, halfPixel - least.x});
    inside.push_back({-unitsPerPixel, 0, halfPixel + greatest.x});
    inside.push_back({0, unitsPerPixel, halfPixel - least.y});
    inside.push_back({0, -unitsPerPixel, halfPixel + greatest.y});
}

void DrawnPlane::setSegment(const DepthTriangle &given)
{
    const std::array<int, 3> order = sortedByColumn(*given.triangle);
    const auto first = std::size_t(order[0]);
    const auto last = std::size_t(order[2]);
    const LatticePoint &from = given.triangle->vertices[first].position;
    const LatticePoint &to = given.triangle->vertices[last].position;
    const Form across = edgeForm(from, to);
    const auto [low, high] = std::minmax(from.y, to.y);
    for (const Form &form :
         {across, negative(across), Form{unitsPerPixel, 0, -from.x}, Form{-unitsPerPixel, 0, to.x},
          Form{0, unitsPerPixel, -low}, Form{0, -unitsPerPixel, high}})
        inside.push_back(orZero(form));
    // Along x, or along y where the segment lies in one column.
    const bool isVertical = from.x == to.x;
    const Lattice start = isVertical ? from.y : from.x;
    const Lattice length = isVertical ? to.y - from.y : to.x - from.x;
    const Int256 rise = Int256(given.z[last]) - given.z[first];
    if (length == 0) {
        depth.constant = given.z[first];
        return;
    }
    denominator = length;
    (isVertical ? depth.y : depth.x) = rise * unitsPerPixel;
    depth.constant = Int256(given.z[first]) * length - rise * start;
}

} // namespace pixelplumb
