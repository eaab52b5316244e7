// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/attributes.h"
#include "core/geometry/lattice.h"
#include "core/number/quantity.h"
#include "core/scene/text/result.h"

#include <QStringView>

namespace pixelplumb {

/// A format of numbers in files: integers of 1/one, and the words that messages use.
struct NumberFormat {
    std::int64_t one; ///< a power of two
    std::int64_t largest; ///< the largest absolute value
    const char *name; ///< "coordinate"
    const char *examples; ///< "26, 26.5 or 53/2"
    const char *unit; ///< " px", or nothing
    const char *use; ///< "drawn at"
};

/// Coordinates in the frame: the lattice of 1/256 px.
inline constexpr NumberFormat coordinateFormat
    = {unitsPerPixel, largestPixel, "coordinate", "26, 26.5 or 53/2", " px", "drawn at"};
/// What vertices carry besides coordinates (core/geometry/attributes.h).
inline constexpr NumberFormat attributeFormat
    = {attributeOne, largestAttributeValue, "number", "1, 0.5 or 1/3", "", "read as"};

/// The most characters that a number may have; it is read to its last digit.
inline constexpr qsizetype longestNumberText = 400;

/// A written number, snapped to its format.
struct SnappedNumber {
    std::int64_t units = 0;
    /// units / one − written value, at most half a unit; 0 when the format holds the value. An
    /// exact rational where 64 bits hold its numerator and denominator, otherwise the nearest
    /// double.
    Quantity displacement = Quantity::integer(0);

    bool isDisplaced() const { return displacement != Quantity::integer(0); }
};

/// Reads "26", "26.5", "2.65e1", "53/2", "26 1/2" and their negatives exactly, without a double on
/// the way. A value between two numbers of the format goes to the nearer one, a tie to the greater
/// one. Refused: anything else, NaN, infinity, values beyond the format's largest, more than 400
/// characters.
Result<SnappedNumber> parseNumber(QStringView text, const NumberFormat &format);
inline Result<SnappedNumber> parseCoordinate(QStringView text)
{
    return parseNumber(text, coordinateFormat);
}

/// The double nearest to a number written in one of these ways, within the same limits.
Result<double> parseReal(QStringView text, const NumberFormat &format);

/// The shortest exact text: "26" or "53/2".
QString numberText(std::int64_t units, const NumberFormat &format);
inline QString coordinateText(Lattice units) { return numberText(units, coordinateFormat); }

/// What parseNumber() accepts, for messages.
QString expectationOf(const NumberFormat &format);

} // namespace pixelplumb
