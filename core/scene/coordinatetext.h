// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"
#include "core/number/quantity.h"
#include "core/scene/result.h"

#include <QStringView>

namespace pixelplumb {

/// A coordinate as it was written, brought to the lattice.
struct SnappedCoordinate {
    Lattice units = 0;
    /// Lattice point − written value, px, in [−1/512, 1/512]; 0 when the value was on the lattice.
    /// An exact rational where 128 bits hold it, the nearest double where they do not.
    Quantity displacement = Quantity::integer(0);

    bool isDisplaced() const { return displacement != Quantity::integer(0); }
};

/// Reads "26", "26.5", "2.65e1", "53/2", "26 1/2" and their negatives, exactly: no double on the
/// way. A value between two lattice points goes to the nearer one, and from the middle to the
/// greater one. Refused: anything else, NaN, infinity, values beyond ±2^30 px, more than 400
/// characters.
Result<SnappedCoordinate> parseCoordinate(QStringView text);

/// The shortest exact text: "26" or "53/2".
QString coordinateText(Lattice units);

/// What parseCoordinate reads, for messages.
QString coordinateExpectation();

} // namespace pixelplumb
