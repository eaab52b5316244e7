// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framemap.h"
#include "core/lab/judging/labfigures.h"
#include "core/scan/tests/edgeteststate.h"

namespace pixelplumb {

/// How often the triangles of a mesh paint each sample of a frame, to find gaps and doubles.
class MeshCover {
public:
    explicit MeshCover(const FrameSpec &spec)
        : m_times(spec)
    {
    }

    /// Adds one triangle's picture on a frame that was transparent.
    void add(const FrameView &drawn, const SampleBox &box)
    {
        for (std::int64_t y = box.firstY; y < box.endY; ++y) {
            for (std::int64_t x = box.firstX; x < box.endX; ++x) {
                std::uint8_t &times = m_times.at(x, y);
                if (*drawn.at(x, y) != 0 && times < 255)
                    ++times;
            }
        }
    }

    /// Samples that the true mesh covers and this one does not.
    LabShare gapsBeside(const MeshCover &truth) const
    {
        return count(truth, [](int drawn, int wanted) { return wanted > 0 && drawn == 0; });
    }
    /// Samples that this one paints more often than the true mesh, and more than once.
    LabShare doublesBeside(const MeshCover &truth) const
    {
        return count(truth, [](int drawn, int wanted) { return drawn > std::max(wanted, 1); });
    }

private:
    template <class Is>
    LabShare count(const MeshCover &truth, const Is &is) const
    {
        LabShare share;
        const FrameSpec &spec = m_times.spec();
        for (std::int64_t y = spec.firstRow; y < std::int64_t(spec.firstRow) + spec.height; ++y) {
            const auto drawn = m_times.row(y), wanted = truth.m_times.row(y);
            for (std::size_t i = 0; i < drawn.size(); ++i) {
                share.of += wanted[i] > 0 ? 1 : 0;
                share.count += is(drawn[i], wanted[i]) ? 1 : 0;
            }
        }
        return share;
    }

    FrameMap<std::uint8_t> m_times;
};

} // namespace pixelplumb
