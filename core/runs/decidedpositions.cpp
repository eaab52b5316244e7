// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/decidedpositions.h"

#include "core/runs/spanheadings.h"

#include <algorithm>
#include <tuple>

namespace pixelplumb {

namespace {

/// The position just after a span was entered.
std::size_t enteredAt(const ScanTrace &trace, std::size_t span)
{
    return trace.indexOfSpan(span) + 1;
}

} // namespace

DecidedPositions::DecidedPositions(const ScanTrace &trace, const DifferenceMap &differences,
                                   const FrameSpec &frame)
    : m_end(trace.stepCount())
    , m_axis(commonAxis(trace))
{
    decidePlaces(trace, frame);
    if (differences.total() > 0 || m_axis == SpanAxis::Free)
        decideOwnPixels(trace, differences);
}

void DecidedPositions::decidePlaces(const ScanTrace &trace, const FrameSpec &frame)
{
    if (m_axis == SpanAxis::Free)
        return;
    const bool byColumn = m_axis == SpanAxis::Column;
    m_firstPlace = byColumn ? frame.firstColumn : frame.firstRow;
    // A column or row that the kernel never entered is decided at the end.
    m_places.assign(std::size_t(byColumn ? frame.width : frame.height), m_end);
    for (std::size_t span = 0; span < trace.spanCount(); ++span) {
        const std::int64_t place = trace.placeOf(span).coordinate - m_firstPlace;
        if (place >= 0 && place < std::int64_t(m_places.size()))
            m_places[std::size_t(place)]
                = enteredAt(trace, span) + trace.endSampleOf(span) - trace.firstSampleOf(span);
    }
}

void DecidedPositions::decideOwnPixels(const ScanTrace &trace, const DifferenceMap &differences)
{
    // Somewhat more visits than pixels, so that many visits of few pixels take no memory.
    std::size_t most = 2 * std::size_t(differences.total()) + 1024;
    for (std::size_t span = 0; span < trace.spanCount(); ++span) {
        const std::size_t first = trace.firstSampleOf(span);
        for (std::size_t sample = first; sample < trace.endSampleOf(span); ++sample) {
            const PixelChange &change = trace.changes()[sample];
            const Difference kind = differences.at(change.x, change.y);
            // A missing pixel was never written: refusals decide it.
            const bool isOwn = kind == Difference::None
                ? m_axis == SpanAxis::Free && change.isWritten()
                : kind == Difference::Missing || change.isWritten();
            if (!isOwn)
                continue;
            m_own.push_back({change.y, change.x, enteredAt(trace, span) + 1 + sample - first});
            if (m_own.size() > most) {
                keepLastVisits();
                most = std::max(most, 2 * m_own.size());
            }
        }
    }
    keepLastVisits();
    m_own.shrink_to_fit();
}

void DecidedPositions::keepLastVisits()
{
    const auto placeOf = [](const OwnPixel &pixel) { return std::tie(pixel.y, pixel.x); };
    std::ranges::stable_sort(m_own, {}, placeOf);
    const auto isSamePlace
        = [&](const OwnPixel &a, const OwnPixel &b) { return placeOf(a) == placeOf(b); };
    m_own.erase(m_own.begin(), std::unique(m_own.rbegin(), m_own.rend(), isSamePlace).base());
}

std::size_t DecidedPositions::at(std::int64_t x, std::int64_t y) const
{
    const auto own
        = std::ranges::lower_bound(m_own, std::pair(y, x), {}, [](const OwnPixel &pixel) {
              return std::pair<std::int64_t, std::int64_t>(pixel.y, pixel.x);
          });
    if (own != m_own.end() && own->x == x && own->y == y)
        return own->position;
    const std::int64_t place = (m_axis == SpanAxis::Column ? x : y) - m_firstPlace;
    if (place < 0 || place >= std::int64_t(m_places.size()))
        return m_end;
    return m_places[std::size_t(place)];
}

} // namespace pixelplumb
