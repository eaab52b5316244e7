// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/search/recipe.h"

namespace pixelplumb::search {

/// A hard case that a search found, and how bad it is for the arithmetic that it was found for.
struct Find {
    const Recipe *recipe = nullptr;
    Genes genes;
    HardCase hardCase; ///< with its facts
    Score score;
};

/// Random figures, then uphill from the worst of them by the error, then down to the simplest that
/// is bad enough. The same recipe gives the same case. None where nothing fails.
std::optional<Find> search(const Recipe &recipe);

} // namespace pixelplumb::search
