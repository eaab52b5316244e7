// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/oracle/oracle.h"
#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// What one primitive did to one pixel, and what the truth says of it.
struct PixelAttempt {
    std::size_t primitive = 0;
    PrimitiveKind kind = PrimitiveKind::Triangle;
    /// Of a triangle: its edges as the pixel's own sample has them, and whether it covers that or,
    /// antialiased, some part of the pixel. Of a shape: `covered` alone.
    oracle::SampleVerdict verdict;
    std::array<QString, 3> edgeNames; ///< of the verdict's edges, where it tells of them
    /// exactLevelsAt() the sample that the run visited; none where it has no levels there.
    std::array<Quantity, 3> exactColour;
    /// The span's numbers, where the primitive's run entered the pixel's column or row, or visited
    /// the pixel.
    std::optional<SpanRecord> span;
    QString spanHeading; ///< as the step in hand is headed: "Column 27, second half"
    /// The last visit, where the kernel came to this pixel at all; the numbers that it used.
    std::optional<SampleRecord> sample;

    /// What of z, w, u, v and N the kernel computed at the sample, whether it was written or not;
    /// empty where the primitive is given none of them.
    struct Carried {
        QString title; ///< "z", "N_x"
        Quantity used;
        Quantity exact; ///< none where there is nothing to compare
    };
    std::vector<Carried> carried;

    bool written = false;
    std::size_t step = 0; ///< index of the step that visited it; meaningful with a sample
    /// The position at which the run has done with the pixel: behind that step, or else behind the
    /// primitive's span on the pixel's column or row, or behind the primitive.
    std::size_t decided = 0;
    PixelChange change; ///< what it wrote

    /// One or two sentences: the numbers that wrote it, or the edge that refuses it, by how much,
    /// under which rule; and how that differs from the truth, where it does.
    QString reason;

    /// True where the verdict tells of three edges.
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

/// The same without most of those that rightly leave it alone: a scene may hold a million.
struct BriefPixelHistory {
    std::vector<PixelAttempt> attempts;
    std::size_t furtherRefusals = 0; ///< that are not among the attempts
};
BriefPixelHistory briefPixelHistory(const TracedScene &traced, std::int64_t x, std::int64_t y,
                                    std::size_t listedRefusals);
/// Takes the attempts away that are decided behind a position. Whether there were some.
bool leaveOutAhead(BriefPixelHistory &history, std::size_t position);

} // namespace pixelplumb
