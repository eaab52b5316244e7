// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/oracle/oracle.h"
#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// What one primitive did to one pixel, and what the truth says of it.
struct PixelAttempt {
    std::size_t primitive = 0;
    std::int64_t x = 0, y = 0; ///< the pixel
    PrimitiveKind kind = PrimitiveKind::Triangle;
    /// For a triangle: its edges at the pixel's own sample, and whether it covers that or,
    /// antialiased, some part of the pixel. For a shape: only `covered`.
    oracle::SampleVerdict verdict;
    std::array<QString, 3> edgeNames; ///< of the verdict's edges, if it has them
    /// exactLevelsAt() the visited sample; none if there are no levels.
    std::array<Quantity, 3> exactColour;
    /// The span's numbers, if the primitive's run entered the pixel's column or row, or visited the
    /// pixel.
    std::optional<SpanRecord> span;
    QString spanHeading; ///< the heading that the current step would have: "Column 27, second half"
    /// The last visit and the numbers that it used, if the kernel came to this pixel at all.
    std::optional<SampleRecord> sample;

    /// Which of z, w, u, v and N the kernel computed at the sample, written or not; empty if the
    /// primitive has none of them.
    struct Carried {
        QString title; ///< "z", "N_x"
        Quantity used;
        Quantity exact; ///< none if there is nothing to compare
    };
    std::vector<Carried> carried;

    bool written = false;
    std::size_t step = 0; ///< index of the step that visited it; meaningful with a sample
    /// The position at which the run is done with the pixel: after that step, or else after the
    /// primitive's span on the pixel's column or row, or after the primitive.
    std::size_t decided = 0;
    PixelChange change; ///< what it wrote

    /// One or two sentences: the numbers that wrote it, or the edge that refuses it, by how much,
    /// under which rule; and how that differs from the truth, where it does.
    QString reason;

    /// True if the verdict has three edges.
    bool hasEdges() const { return kind == PrimitiveKind::Triangle && !verdict.zeroArea; }
    /// Whether an edge has the pixel's own sample on its outer side.
    bool isCentreRefused() const
    {
        return hasEdges()
            && !(verdict.edges[0].accepts && verdict.edges[1].accepts && verdict.edges[2].accepts);
    }
};

/// The attempts of all primitives on a pixel, in drawing order.
std::vector<PixelAttempt> pixelHistory(const TracedScene &traced, std::int64_t x, std::int64_t y);

/// The attempt of one primitive that the method draws.
PixelAttempt pixelAttempt(const TracedScene &traced, std::size_t primitive, std::int64_t x,
                          std::int64_t y);

/// A history without most primitives that rightly leave the pixel alone: there may be a million.
struct BriefPixelHistory {
    std::vector<PixelAttempt> attempts;
    std::size_t furtherRefusals = 0; ///< that are not among the attempts
};
inline constexpr std::size_t fewRefusals = 20;
/// How many refusals are listed.
struct ListedRefusals {
    std::size_t inBox = fewRefusals; ///< of primitives whose box holds the pixel
    std::size_t outside = fewRefusals; ///< of all others
};
BriefPixelHistory briefPixelHistory(const TracedScene &traced, std::int64_t x, std::int64_t y,
                                    const ListedRefusals &most = {});
/// Removes the attempts that are decided after a position; returns whether there were any.
bool leaveOutAhead(BriefPixelHistory &history, std::size_t position);

} // namespace pixelplumb
