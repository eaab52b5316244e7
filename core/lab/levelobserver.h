// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/exactlevel.h"
#include "core/lab/levelprobe.h"
#include "core/methods/kernelmethod.h"
#include "core/scan/columnstate.h"
#include "core/scan/edgeteststate.h"
#include "core/scan/interpolationnumbers.h"
#include "core/scan/scanobserver.h"

namespace pixelplumb {

// The R G B that a sample was coloured by, and their rounded levels.
template <class A>
const auto &coloursOf(const Fragment<A> &sample)
{
    return sample.colour;
}
template <class A>
const auto &coloursOf(const TestedSample<A> &sample)
{
    return sample.colour;
}
template <class N, std::size_t channels>
const auto &coloursOf(const InterpolationSample<N, channels> &sample)
{
    return sample.value;
}

template <class Number>
bool isNotANumber(const Number &number)
{
    if constexpr (std::floating_point<Number>)
        return std::isnan(number);
    return false;
}
template <class Number>
bool isInfinite(const Number &number)
{
    if constexpr (std::floating_point<Number>)
        return std::isinf(number);
    return false;
}

/// Hears of pixels and tells a tally how far their levels are from the exact ones.
class LevelObserver : public NullObserver {
public:
    LevelObserver(const ExactLevels &exact, const FrameView &truth, LevelTally &tally)
        : m_exact(&exact)
        , m_truth(&truth)
        , m_tally(&tally)
    {
    }

    template <class Sample>
    void pixelWritten(std::int64_t x, std::int64_t y, QRgb, QRgb, const Sample &sample)
    {
        const auto &colours = coloursOf(sample);
        bool hasNoNumber = false, hasInfinity = false;
        for (std::size_t i = 0; i < 3; ++i) {
            hasNoNumber = hasNoNumber || isNotANumber(colours[i]);
            hasInfinity = hasInfinity || isInfinite(colours[i]);
        }
        count(m_tally->notANumber, hasNoNumber);
        count(m_tally->infinite, hasInfinity);
        count(m_tally->clamped, sample.isClamped());
        if (hasNoNumber || hasInfinity || !m_truth->contains(x, y) || *m_truth->at(x, y) == 0)
            return;
        for (std::size_t i = 0; i < 3; ++i)
            m_tally->add(levelError(m_exact->at(i, x, y), colours[i]));
    }

private:
    static void count(LabShare &share, bool is)
    {
        share.count += is ? 1 : 0;
        ++share.of;
    }

    const ExactLevels *m_exact;
    const FrameView *m_truth;
    LevelTally *m_tally;
};

template <class Kernel>
void probeWith(const Primitives &one, const ScanSettings &settings, FrameView frame,
               const FrameView &truth, LevelTally &tally)
{
    const ExactLevels exact(one.triangles.front());
    const auto &geometry = Kernel::geometryOf(one, 0);
    Kernel::withNumbers(settings, Kernel::widthFor(geometry, frame), [&]<class A>() {
        Kernel::template scan<WidestOf<A>>(geometry, settings, frame,
                                           LevelObserver(exact, truth, tally));
    });
}

} // namespace pixelplumb
