// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/wideinteger.h"
#include "core/plan/framereach.h"
#include "core/plan/planeorder.h"

#include <vector>

namespace pixelplumb {

/// x·column + y·row + constant over the pixels of a frame.
template <class Integer>
struct PixelForm {
    Integer x = 0, y = 0, constant = 0;

    Integer at(std::int64_t column, std::int64_t row) const
    {
        return x * column + y * row + constant;
    }
};

template <class To, class From>
PixelForm<To> widened(const PixelForm<From> &form)
{
    return {To(form.x), To(form.y), To(form.constant)};
}

template <class Integer>
PixelForm<Integer> operator*(const PixelForm<Integer> &form, const Integer &factor)
{
    return {Integer(form.x * factor), Integer(form.y * factor), Integer(form.constant * factor)};
}

template <class Integer>
PixelForm<Integer> operator+(const PixelForm<Integer> &a, const PixelForm<Integer> &b)
{
    return {Integer(a.x + b.x), Integer(a.y + b.y), Integer(a.constant + b.constant)};
}

/// The columns [first, end) of one row.
struct RowPixels {
    std::int64_t first = 0, end = 0;

    bool isEmpty() const { return first >= end; }

    /// Keeps the columns at which a form is above 0.
    template <class Integer>
    void keepPositive(const PixelForm<Integer> &form, std::int64_t row)
    {
        const Integer least = form.y * row + form.constant - 1; // x·column + least >= 0
        const bool isFirst = form.x * first + least >= 0;
        const bool isLast = form.x * (end - 1) + least >= 0;
        if (isFirst && isLast) // as nearly always; a division takes far longer
            return;
        if (!isFirst && !isLast) {
            end = first;
        } else if (form.x > 0) {
            const Integer from = ceilDivide<Integer>(Integer(-least), form.x);
            if (from > first)
                first = from < end ? std::int64_t(from) : end;
        } else {
            const Integer to = floorDivide<Integer>(least, Integer(-form.x)) + 1;
            if (to < end)
                end = to > first ? std::int64_t(to) : first;
        }
    }
};

/// A triangle, or under the closed rule the segment of one without area, as seen by one sample of
/// each pixel: where it is drawn, and its depth there.
struct DrawnPlane {
    /// `sample` is the sample's offset in its pixel; a segment is always drawn at the pixel's own
    /// sample.
    DrawnPlane(const DepthTriangle &triangle, const LatticePoint &sample,
               const SampledFrame &where);

    /// Keeps the part of a row where it is drawn.
    void keepDrawn(RowPixels &columns, std::int64_t row) const
    {
        for (const PixelForm<Int128> &form : inside) {
            columns.keepPositive(form, row);
            if (columns.isEmpty())
                return;
        }
        if (isDivided)
            columns.keepPositive(reciprocal, row);
    }

    std::vector<PixelForm<Int128>> inside; ///< all above 0 where it is drawn
    PixelForm<Int256> depth; ///< z times the denominator
    Int256 denominator = 1; ///< > 0
    /// With area antialiasing and attributes divided by w: has the sign of 1/w.
    PixelForm<Int256> reciprocal;
    bool isDivided = false;

private:
    void setTriangle(const DepthTriangle &given, const Triangle &seen, const SampledFrame &where);
    void setSegment(const DepthTriangle &given);
};

} // namespace pixelplumb
