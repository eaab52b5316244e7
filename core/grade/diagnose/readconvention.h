// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"
#include "core/grade/diagnose/picturematch.h"

namespace pixelplumb {

/// The conventions under which pictures have the fewest wrong pixels, where they are not the
/// scenes': from which side rows are counted, where in a pixel its sample stands, whether the first
/// row and column are 0 or 1, which edges own samples, how levels become bytes.
struct ReadConvention {
    std::vector<Scene> scenes; ///< as a program of these conventions reads them
    std::vector<Defect> told; ///< what is not as the scenes say
};

/// None where the scenes' own conventions leave as few wrong pixels, or nearly.
std::optional<ReadConvention> readConvention(DefectPictures &pictures,
                                             std::span<const FoundPicture> found);

} // namespace pixelplumb
