// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defectpictures.h"
#include "core/grade/rounding/margin.h"

#include <cstdint>
#include <span>

namespace pixelplumb {

class SampledSpans;
struct SampledPart;

/// A picture of one of several scenes.
struct FoundPicture {
    std::size_t scene = 0; ///< its index among the scenes
    Picture picture;
};

/// How the pictures of programs with a set of defects compare with those found.
struct SetMatch {
    DefectSet set; ///< with the arithmetic in which the pictures are equal, if any
    std::int64_t distance = 0; ///< pixels that the set does not explain
    /// Pixels that differ, but may do so in a program with this set, by rounding or on an edge.
    std::int64_t undecidable = 0;
};

/// Compares sets of defects with pictures found of some scenes. A program may compute in arithmetic
/// up to the margin's tolerance, unless that is strict.
class PictureMatcher {
public:
    static constexpr std::int64_t unknown = std::numeric_limits<std::int64_t>::max();

    PictureMatcher(DefectPictures &pictures, std::span<const FoundPicture> found,
                   const Margin &margin);
    ~PictureMatcher();

    /// Differing pixels in all found pictures, up to a limit; unknown where a scene cannot be drawn
    /// so. A limit of 1 only tests equality. What lies beyond the limit is estimated where pictures
    /// are large (SampledSpans).
    std::int64_t distance(const DefectSet &set, std::int64_t limit = unknown);
    /// What some spans tell of it, up to the limit; none where they do not.
    std::optional<std::int64_t> estimate(const DefectSet &set, std::int64_t limit) const;
    /// The part of the pictures by which sets are refused that leave clearly more; none: all.
    std::optional<SampledPart> sampledPart() const;
    /// Pixels: more are never left open by rounding, and by samples on edges where these are open.
    std::int64_t mostOpen();
    const Margin &margin() const { return m_margin; }
    /// The match if a program with this set, in a tolerated arithmetic, may draw what was found; if
    /// possible with an arithmetic in which its pictures are equal.
    std::optional<SetMatch> allowedMatch(const DefectSet &set);
    /// The arithmetics other than the scenes' own in which a program with this set draws exactly
    /// what was found.
    std::vector<Arithmetic> equalIn(const DefectSet &set);

    /// Whether the set has a defect that leaves samples out (Defect::leavesOut), and the found
    /// picture differs from the set's at one of these.
    bool isDrawnAllTheSame(const DefectSet &set);

    /// Whether nothing is to be seen of any scene because of two defects, each of which alone
    /// leaves something: a program that draws nothing has one mistake.
    bool drawsNothingTogether(const DefectSet &set);

    /// Whether a smaller set, or none, leaves only a handful of levels that are off by one: so
    /// little is explained by many a defect, and proves none.
    bool isByChance(const DefectSet &set);

    bool isTolerated(Arithmetic arithmetic) const;

private:
    std::optional<std::int64_t> openPixels(const DefectSet &set, const FoundPicture &each);
    bool leavesFewLevels(const DefectSet &set);
    bool hasUnseenPart(const DefectSet &set);
    bool isUnseen(const DefectSet &part, const DefectSet &set);

    DefectPictures &m_pictures;
    std::span<const FoundPicture> m_found;
    Margin m_margin;
    std::unique_ptr<const SampledSpans> m_spans;
};

} // namespace pixelplumb
