// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defectpictures.h"

#include <cstdint>
#include <span>

namespace pixelplumb {

/// A picture of one of several scenes.
struct FoundPicture {
    std::size_t scene = 0; ///< its place among them
    Picture picture;
};

/// How the pictures of programs with a set of defects stand to those that were found.
struct SetMatch {
    DefectSet set; ///< with the arithmetic in which the pictures are equal, if they are in one
    std::int64_t distance = 0; ///< pixels that the set does not explain
    /// Pixels that differ and that a program with this set may have all the same, by rounding or on
    /// an edge.
    std::int64_t undecidable = 0;
};

/// Holds sets of defects against what was found of some scenes. A program may compute in arithmetic
/// up to the tolerance; exact: samples on an edge are open; none: nothing is.
class PictureMatcher {
public:
    static constexpr std::int64_t unknown = std::numeric_limits<std::int64_t>::max();

    PictureMatcher(DefectPictures &pictures, std::span<const FoundPicture> found,
                   std::optional<Arithmetic> tolerance);

    /// Pixels of all found pictures that differ, up to a limit; unknown where a scene cannot be
    /// drawn so. Of those at a limit of 1 nobody asks but whether they are the same.
    std::int64_t distance(const DefectSet &set, std::int64_t limit = unknown);
    /// Pixels to be covered in all.
    std::int64_t coveredPixels();
    /// Whether what was found is what a program with this set may draw that computes in what is
    /// allowed for: if it can, in one in which its pictures are equal.
    std::optional<SetMatch> allowedMatch(const DefectSet &set);
    /// The arithmetics, beside the scenes' own, in which a program with this set draws just that.
    std::vector<Arithmetic> equalIn(const DefectSet &set);

    /// Whether one of the set says that some of the scene is not drawn (Defect::leavesOut) where
    /// something is that the set does not draw.
    bool isDrawnAllTheSame(const DefectSet &set);

    bool isTolerated(Arithmetic arithmetic) const;

private:
    std::optional<std::int64_t> openPixels(const DefectSet &set, const FoundPicture &each);
    bool hasUnseenPart(const DefectSet &set);
    bool isUnseen(const DefectSet &part, const DefectSet &set);

    DefectPictures &m_pictures;
    std::span<const FoundPicture> m_found;
    std::optional<Arithmetic> m_tolerance;
};

} // namespace pixelplumb
