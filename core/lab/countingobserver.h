// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/primitiverejection.h"
#include "core/lab/operationtally.h"
#include "core/scan/scanobserver.h"

#include <QRgb>

namespace pixelplumb {

/// Tells a tally what the kernel's operations are for, and counts primitives, spans and samples.
class CountingObserver {
public:
    explicit CountingObserver(OperationTally &tally)
        : m_tally(&tally)
    {
    }

    WorkStage enter(WorkStage stage) const { return m_tally->enter(stage); }

    template <class SetUp>
    void primitiveBegun(const SetUp &)
    {
        ++m_tally->counts.primitives;
    }
    void primitiveRejected(const Rejection &) { }
    template <class Span>
    void spanEntered(const Span &)
    {
        ++m_tally->counts.spans;
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
};

/// It counts the operations that draw, and no others.
template <>
inline constexpr bool readsNumbers<CountingObserver> = false;

} // namespace pixelplumb
