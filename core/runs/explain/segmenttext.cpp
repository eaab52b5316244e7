// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/segmenttext.h"

#include "core/methods/words/formulatext.h"
#include "core/scan/degeneratesegment.h"
#include "core/scan/tests/edgeline.h"

namespace pixelplumb {

namespace {

/// "(9 − 1)·(3 − 1) − (5 − 1)·(6 − 1) = −4": twice the area, in px², of the triangle that the
/// sample makes with the segment.
QString areaText(const LatticePoint &first, const LatticePoint &last, const LatticePoint &sample)
{
    const Quantity area = Quantity::rational(doubledArea(first, last, sample), squareUnitsPerPixel);
    return differenceText(last.x, first.x) + u'·' + differenceText(sample.y, first.y) + u" − "_s
        + differenceText(last.y, first.y) + u'·' + differenceText(sample.x, first.x) + u" = "_s
        + term(area);
}

} // namespace

QString segmentText(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    const DegenerateSegment segment(triangle);
    const LatticePoint first = segment.first().position;
    const LatticePoint last = segment.last().position;
    const LatticePoint sample = latticePixel(x, y);
    if (first == last)
        return u"its vertices are all at %1, which is %2the sample"_s.arg(
            pointText(first), first == sample ? QString() : u"not "_s);
    const QString its = u"its segment from %1 to %2 "_s.arg(pointText(first), pointText(last));
    const QString area = areaText(first, last, sample);
    if (segment.covers(x, y))
        return its + u"passes through the sample: "_s + area;
    if (doubledArea(first, last, sample) == 0)
        return its + u"lies in line with the sample, %1, but does not reach it"_s.arg(area);
    return its + u"passes the sample by: %1, not 0"_s.arg(area);
}

} // namespace pixelplumb
