// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/shade/strokes/strokepixels.h"

#include <span>

namespace pixelplumb {

/// How much of one pixel a stroke covers.
class StrokeCoverage {
public:
    /// `pixel` holds the pixel's entries, at least one, for these quadrilaterals; both must outlive
    /// this.
    StrokeCoverage(std::span<const StrokePixel> pixel, std::span<const StrokeQuad> quads)
        : m_pixel(pixel)
        , m_quads(quads)
    {
    }

    /// Whether the stroke covers a point, given relative to the pixel's sample: its quadrilaterals
    /// wind around it. A point on a border counts as displaced to the right and, by less, up, so
    /// that neighbours count it once.
    bool covers(const LatticePoint &offset) const;

    struct Share {
        /// ⌊255·area + ½⌋, exactly: the part of the pixel's square, centred on its sample, that the
        /// stroke covers. The areas of its quadrilaterals are added, each as often as its border
        /// winds around it; where the stroke overlaps itself the sum is at most the square.
        std::uint8_t alpha = 0;
        bool isEmpty = true; ///< not even a part too small for a byte is covered
    };
    Share share() const;
    /// The area itself, px²; the nearest double where 128 bits do not hold it.
    Quantity area() const;

private:
    template <class Number>
    Number sumOfAreas() const;

    std::span<const StrokePixel> m_pixel;
    std::span<const StrokeQuad> m_quads;
};

} // namespace pixelplumb
