// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/contenderpace.h"

#include "core/runs/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

std::int64_t countUpTo(const std::vector<std::size_t> &positions, std::size_t position)
{
    return std::ranges::upper_bound(positions, position) - positions.begin();
}

} // namespace

ContenderPace::ContenderPace(const Contest &contest, std::size_t run)
    : m_end(contest.runs[run].tally)
{
    const TracedScene &traced = *contest.runs[run].traced;
    const ScanTrace &trace = *traced.trace;
    CoverageMask covered(contest.scene.frame);
    for (std::size_t sample = 0; sample < trace.sampleCount(); ++sample) {
        const PixelChange &change = trace.changes()[sample];
        if (!change.isWritten() || covered.covers(change.x, change.y))
            continue;
        covered.cover(change.x, change.y);
        m_written.push_back(trace.indexOfSample(sample) + 1);
    }
    const JudgedRun judged = contest.judged(run);
    const FrameView frame = contest.runs[run].picture.view();
    for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
        for (std::int64_t x = frame.firstColumn; x < frame.endColumn(); ++x) {
            const Difference kind = differenceAt(judged, x, y);
            if (kind != Difference::None)
                m_differences[std::size_t(kind)].push_back(traced.decidedAt(x, y));
        }
    }
    for (std::vector<std::size_t> &positions : m_differences)
        std::ranges::sort(positions);
}

ContenderTally ContenderPace::at(std::size_t position) const
{
    ContenderTally tally = m_end;
    tally.written = countUpTo(m_written, position);
    for (std::size_t kind = 1; kind < m_differences.size(); ++kind)
        tally.againstTruth.pixels[kind] = countUpTo(m_differences[kind], position);
    return tally;
}

} // namespace pixelplumb
