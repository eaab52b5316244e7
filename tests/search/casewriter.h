// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/search/search.h"

namespace pixelplumb::search {

/// Writes the finds as a hard-case file in the format of hard_cases.json, version 1. The same finds
/// always give the same bytes.
QByteArray casesText(std::span<const Find> finds);

} // namespace pixelplumb::search
