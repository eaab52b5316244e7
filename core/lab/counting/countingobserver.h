// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/primitiverejection.h"
#include "core/lab/counting/operationtally.h"
#include "core/scan/polygons/polygonrows.h"
#include "core/scan/scanobserver.h"

#include <QRgb>

#include <concepts>

namespace pixelplumb {

/// Tells a tally which stage the kernel's operations belong to; counts primitives, spans and
/// samples.
class CountingObserver {
public:
    explicit CountingObserver(OperationTally &tally)
        : m_tally(&tally)
    {
    }

    WorkStage enter(WorkStage stage) const { return m_tally->enter(stage); }

    template <class SetUp>
    void primitiveBegun([[maybe_unused]] const SetUp &setUp)
    {
        ++m_tally->counts.primitives;
        // In a polygon that is broken into triangles each has its own table.
        if constexpr (std::same_as<SetUp, PolygonSetUp>)
            m_edges = setUp.pieceCount == 0 ? std::int64_t(setUp.edgeCount) : 0;
    }
    void primitiveRejected(const Rejection &) { }
    template <class Span>
    void spanEntered([[maybe_unused]] const Span &span)
    {
        ++m_tally->counts.spans;
        if constexpr (requires { span.crossings.size(); }) {
            if (m_edges > 0)
                m_tally->counts.edgesLookedAt += std::int64_t(span.crossings.size());
            m_tally->counts.edgesOfRows += m_edges;
        }
    }
    template <class Sample>
    void sampleRejected(std::int64_t, std::int64_t, QRgb, const Sample &)
    {
        ++m_tally->counts.refused;
    }
    template <class Sample>
    void pixelWritten(std::int64_t, std::int64_t, QRgb, QRgb, const Sample &)
    {
        ++m_tally->counts.pixels;
    }

private:
    OperationTally *m_tally;
    std::int64_t m_edges = 0; ///< of the polygon that was begun
};

/// Only the operations that draw are counted.
template <>
inline constexpr bool readsNumbers<CountingObserver> = false;

} // namespace pixelplumb
