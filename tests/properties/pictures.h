// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/properties/tilings.h"
#include "tests/support/scanning.h"

/// Random triangles for RapidCheck, their pictures in exact arithmetic, and the comparison of a
/// picture with its image under a map.
namespace pixelplumb {

using tilings::Place;

inline constexpr FillRule watertight[] = {FillRule::HalfOpenColumn, FillRule::TopLeft};

/// How far apart the vertices of a random triangle may lie, and on which grid.
inline Place somePlace()
{
    return {*rc::gen::element<Lattice>(256, 16, 1),
            *rc::gen::element<Lattice>(0, 16384, -16384, Lattice(1) << 20, -(Lattice(1) << 20)),
            *rc::gen::element<Lattice>(2, 5, 11)};
}

inline Triangle someTriangle(const Place &place)
{
    const Lattice steps = 4 * place.cell * unitsPerPixel / place.grid;
    Triangle triangle;
    for (Vertex &vertex : triangle.vertices) {
        const auto coordinate = [&] {
            return place.origin * unitsPerPixel + *rc::gen::inRange<Lattice>(0, steps) * place.grid;
        };
        vertex.position.x = coordinate();
        vertex.position.y = coordinate();
        for (std::uint8_t &channel : vertex.colour.channels)
            channel = std::uint8_t(*rc::gen::inRange(0, 256));
    }
    return triangle;
}

/// A frame that holds everything within four cells of the place.
inline FrameSpec frameAround(const Place &place)
{
    const auto side = std::int32_t(8 * place.cell + 2);
    const auto corner = std::int32_t(place.origin - 2 * place.cell - 1);
    return frameOf(side, side, corner, corner);
}

/// Drawn by the scan under its own rules, by the oracle under top-left.
inline ScanPicture drawn(const Triangle &triangle, FillRule rule, const FrameSpec &frame)
{
    ScanPicture drawing(frame);
    if (rule == FillRule::TopLeft)
        drawing.drawTruth(triangle, {Arithmetic::Exact, rule});
    else
        drawing.draw(columnScan(), triangle, {Arithmetic::Exact, rule});
    return drawing;
}

inline Triangle mapped(Triangle triangle, LatticePoint (*map)(LatticePoint))
{
    for (Vertex &vertex : triangle.vertices)
        vertex.position = map(vertex.position);
    return triangle;
}

/// Whether each sample (x, y) and its image are both uncovered, or both covered in the same colour.
template <class Image>
bool isImage(const ScanPicture &original, const ScanPicture &image, const Image &at)
{
    const FrameSpec &frame = original.spec();
    for (std::int64_t y = frame.firstRow; y < frame.firstRow + frame.height; ++y) {
        for (std::int64_t x = frame.firstColumn; x < frame.firstColumn + frame.width; ++x) {
            const LatticePoint other = at(x, y);
            if (original.at(x, y) != image.at(other.x, other.y))
                return false;
        }
    }
    return true;
}

} // namespace pixelplumb
