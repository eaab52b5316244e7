// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

#include <variant>

namespace pixelplumb {

/// Where the playhead starts in a scene that was opened.
enum class OpeningMoment {
    HalfDrawn, ///< a third of the way up the first column past the middle vertex
    Finished,
};
/// On entering the column at x.
struct OpeningColumn {
    std::int64_t x = 0;
};
using OpeningPlace = std::variant<OpeningMoment, std::size_t, OpeningColumn>;

/// The position of a place in a run; the end where the run lacks that place.
std::size_t positionOf(const OpeningPlace &place, const ScanTrace &trace);

} // namespace pixelplumb
