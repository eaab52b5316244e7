// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/studentwalk.h"

#include <QString>

#include <vector>

namespace pixelplumb {

/// A student's program and the defect that describes its mistake.
struct MistakenProgram {
    QString method; ///< "column-scan" or "row-walk"
    QString id; ///< id of the defect
    std::set<WalkMistake> mistakes;
    QString group; ///< programs of one method that go wrong in the same part: "edges from below"
};

std::vector<MistakenProgram> mistakenPrograms();

} // namespace pixelplumb
