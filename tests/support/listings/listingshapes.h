// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/polygons/contours.h"
#include "tests/support/listings/listingscenes.h"
#include "tests/support/scenes/shapes.h"

/// Random shapes whose listings are run.
namespace pixelplumb {

constexpr unsigned shapeSeed = 17;

/// Random places of shapes in and around a small frame: on whole pixels, on halves, between them.
class Places {
public:
    explicit Places(int number)
        : m_step(number % 3 == 0       ? unitsPerPixel
                     : number % 3 == 1 ? unitsPerPixel / 2
                                       : 37)
    {
    }

    Lattice between(std::int64_t first, std::int64_t last, std::mt19937 &random) const
    {
        std::uniform_int_distribution<Lattice> place(first * unitsPerPixel / m_step,
                                                     last * unitsPerPixel / m_step);
        return place(random) * m_step;
    }
    LatticePoint point(std::mt19937 &random) const
    {
        const Lattice x = between(-4, 17, random);
        return {x, between(-4, 17, random)};
    }

private:
    Lattice m_step;
};

/// The shapes of every second three are seen in frames whose y points down.
FrameSpec frameFor(int number);
/// The shape's colour, by the names "colour R" and so on.
void setColour(ListingNames &names, const Colour &colour);

/// A circle or an ellipse, often smaller than a pixel or wider than the frame.
Shape oddRound(int number, std::mt19937 &random);
/// A polygon of one or two contours that often cross themselves and each other, with ties, level
/// and upright edges and vertices that coincide.
Shape oddPolygon(int number, std::mt19937 &random, ShapeFill fill);
/// A quadratic or a cubic curve, closed by a straight edge.
Shape oddPath(int number, std::mt19937 &random, ShapeFill fill);

std::vector<ListingRun::Item> itemsOf(const std::vector<ContourEdge> &edges);
/// Tells which shape departs; empty if nothing does.
QString message(int number, const QString &departure);

} // namespace pixelplumb
