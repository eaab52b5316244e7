// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contender.h"
#include "tierule.h"

#include <map>

namespace pixelplumb::bench {

/// How far a renderer's picture is from the oracle's under one rule, as shares of the pixels that
/// the truth covers.
struct PictureDifference {
    TieRule rule; ///< the rule that fits the picture best
    double coverage = 0; ///< pixels covered in the picture or in the truth, but not in both
    double colour = 0; ///< pixels covered in both, with a channel more than one level off
    double bytes = 0; ///< pixels that differ at all, in coverage or by a single level
};

/// The triangles relative to a renderer's samples, then mirrored as the rule says.
std::vector<Triangle> seenBy(std::span<const Triangle> triangles, const TieRule &rule,
                             const LatticePoint &sampleOffset, FrameSize size);

/// The share of pixels that differ, of all that either picture writes.
double differingShare(const Picture &a, const Picture &b);

/// A workload's triangles for comparing pictures: none touches another, so every wrong edge shows
/// and nothing is hidden.
class PictureCheck {
public:
    PictureCheck(const Workload &workload, Extent extent);

    PictureDifference check(Contender &contender);

private:
    /// Drawn on first use.
    const Picture &truth(std::size_t ruleIndex, const ContenderInfo &info);

    FrameSize m_size;
    std::vector<Triangle> m_smooth;
    std::vector<Triangle> m_flat;
    std::map<std::tuple<std::size_t, Shading, LatticePoint>, Picture> m_truths;
};

} // namespace pixelplumb::bench
