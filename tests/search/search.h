// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/search/recipe.h"

namespace pixelplumb::search {

/// A hard case that a search found, with its score for the arithmetic of its recipe.
struct Find {
    const Recipe *recipe = nullptr;
    Genes genes;
    HardCase hardCase; ///< with its facts
    Score score;
};

/// Tries random figures, climbs from the worst of them towards a larger error, then simplifies to
/// the simplest that is still bad enough. The same recipe always gives the same case. None if
/// nothing fails.
std::optional<Find> search(const Recipe &recipe);

} // namespace pixelplumb::search
