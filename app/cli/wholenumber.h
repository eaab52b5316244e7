// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"

#include <limits>

namespace pixelplumb::cli {

struct WholeRange {
    std::int64_t first = 0;
    std::int64_t last = std::numeric_limits<std::int64_t>::max();
    QString outside = QStringLiteral("out of range"); ///< "5 is out of range"
};

/// Reads the word as a whole number in the range; the error names the place ("--limit", "X"), the
/// word and the range.
Result<std::int64_t> wholeNumber(const QString &place, const QString &word,
                                 const WholeRange &range);

/// Reads an option's number; none where it is not set and has no default.
Result<std::optional<std::int64_t>> wholeNumberOf(const CommandLine &line, const QString &option,
                                                  const WholeRange &range);

} // namespace pixelplumb::cli
