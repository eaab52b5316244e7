// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contender.h"
#include "tierule.h"

#include <map>

namespace pixelplumb::bench {

/// How far a renderer's picture is from the oracle's under one rule. Shares are of the pixels that
/// the truth covers.
struct PictureDifference {
    TieRule rule; ///< the rule that the picture is nearest to
    double coverage = 0; ///< written and not in the truth, or the other way round
    double colour = 0; ///< in both, with a channel more than one level off
    double bytes = 0; ///< anything that differs at all, coverage or a single level
};

/// The triangles as they lie to a renderer's samples, then in the rule's mirror.
std::vector<Triangle> seenBy(std::span<const Triangle> triangles, const TieRule &rule,
                             const LatticePoint &sampleOffset, FrameSize size);

/// The share of a picture's pixels, of all that either writes, that are not the same bytes.
double differingShare(const Picture &a, const Picture &b);

/// A workload's triangles for looking at pictures: none touches another, so that every wrong edge
/// shows and nothing hides what lies below.
class PictureCheck {
public:
    PictureCheck(const Workload &workload, Extent extent);

    PictureDifference check(Contender &contender);

private:
    /// Made when first asked for.
    const Picture &truth(std::size_t ruleIndex, const ContenderInfo &info);

    FrameSize m_size;
    std::vector<Triangle> m_smooth;
    std::vector<Triangle> m_flat;
    std::map<std::tuple<std::size_t, Shading, LatticePoint>, Picture> m_truths;
};

} // namespace pixelplumb::bench
