// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layermoment.h"

#include <algorithm>

namespace pixelplumb {

QRectF LayerMoment::seenArea() const
{
    const SampleBox box = seen();
    return {QPointF(double(box.firstX) - 0.5, double(box.firstY) - 0.5),
            QPointF(double(box.endX) - 0.5, double(box.endY) - 0.5)};
}

std::array<LatticePoint, 3> LayerMoment::corners() const
{
    const std::array<int, 3> order = trace().setUp(primitive).order;
    std::array<LatticePoint, 3> places;
    for (std::size_t i = 0; i < 3; ++i)
        places[i] = triangle().vertices[std::size_t(order[i])].position;
    return places;
}

std::array<LatticePoint, 3> LayerMoment::weightedCorners() const
{
    const auto &[a, b, c] = triangle().vertices;
    return {a.position, b.position, c.position};
}

QString LayerMoment::weightedCornerName(std::size_t vertex, const QString &suffix) const
{
    const std::array<int, 3> order = trace().setUp(primitive).order;
    const auto rank = std::ranges::find(order, int(vertex)) - order.begin();
    return u"%1%3 = P%2%3"_s.arg(QChar(char16_t(u'a' + vertex))).arg(rank).arg(suffix);
}

std::optional<std::size_t> LayerMoment::currentSpan() const
{
    const std::size_t first = trace().firstSpanOf(primitive);
    std::size_t begin = first;
    std::size_t end = trace().endSpanOf(primitive);
    // The spans' steps ascend: those before `begin` are done.
    while (begin < end) {
        const std::size_t middle = begin + (end - begin) / 2;
        if (hasDone(trace().indexOfSpan(middle)))
            begin = middle + 1;
        else
            end = middle;
    }
    return begin > first ? std::optional(begin - 1) : std::nullopt;
}

bool LayerMoment::hidesSteps() const
{
    const std::size_t next = primitive + 1;
    const std::size_t end
        = next < trace().primitiveCount() ? trace().indexOfSetUp(next) : trace().stepCount();
    return view.ahead == Ahead::Hidden && view.position < end;
}

QString LayerMoment::inScene(Lattice sample) const
{
    return toText(Quantity::rational(sample + sampleOffset(frame()), unitsPerPixel));
}

QPointF placeOf(const LatticePoint &point)
{
    return {double(point.x) / unitsPerPixel, double(point.y) / unitsPerPixel};
}

} // namespace pixelplumb
