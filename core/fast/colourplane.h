// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fast/trianglebatch.h"
#include "core/scan/scansettings.h"

#include <optional>

namespace pixelplumb {

/// The colour plane of a triangle in fixed point, made exact by the half-quantum bias
/// (resources/numerics.md, 3.3 b). Each number is a 64-bit word whose top byte is the level and
/// whose other bits are its fraction; additions wrap, so values outside the triangle may overflow
/// harmlessly.
///
/// Let t be the level, plus 1/2 where the byte is rounded to nearest: a multiple of 1/(2A'), A' the
/// doubled area on the coarsest lattice of the corners. A word of F fraction bits holds t + β with
/// an error of at most e; its top byte is ⌊t⌋ if e <= β and β + e < 1/(2A'), because a t that is
/// not an integer is at least 1/(2A') below the next one. Each gradient and the start are rounded
/// with an error below 2^-F, so n = |dx| + |dy| steps from the start e < (n + 1)·2^-F, and with β =
/// (n + 1)·2^-F the condition is
///
///     4 A' (n + 1) < 2^F.
///
/// A table adds a column's word and a row's word, each cut to 24 fraction bits from 40 or more:
/// whatever n is, the error lies in (−2 − ε, ε)·2^-24, ε = (n + 1)·2^-16 <= 1/8 for n < 2^13. With
/// β = (2 + 1/8)·2^-24 the condition is 2 A' · 2.25 < 2^24.
struct ColourPlane {
    std::array<std::uint64_t, 3> start = {}; ///< at the first sample of the box, β included
    std::array<std::uint64_t, 3> perColumn = {};
    std::array<std::uint64_t, 3> perRow = {};

    /// The words of the batch's set-up.
    ColourPlane(const TriangleBatch &batch, std::size_t i)
    {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            start[channel] = batch.start[channel][i];
            perColumn[channel] = batch.perColumn[channel][i];
            perRow[channel] = batch.perRow[channel][i];
        }
    }

    /// A plane with 56 fraction bits, by divisions of 128-bit integers, for triangles whose area is
    /// too large for the batch's 40. Nothing if 56 do not suffice either.
    static std::optional<ColourPlane> wide(const TriangleBatch &batch, std::size_t i,
                                           ByteRounding rounding);

    /// The word at a sample counted from the first sample of the box.
    std::uint64_t at(std::size_t channel, std::int64_t column, std::int64_t row) const
    {
        return start[channel] + std::uint64_t(column) * perColumn[channel]
            + std::uint64_t(row) * perRow[channel];
    }

private:
    ColourPlane() = default;
};

/// Fraction bits of the words: the fewest that suffice are used.
inline constexpr int narrowFractionBits = 24;
inline constexpr int middleFractionBits = 40;
inline constexpr int wideFractionBits = 56;

/// The largest resolution 4 A' (n + 1) for this many bits.
constexpr double resolutionLimit(int fractionBits)
{
    return double(std::uint64_t(1) << fractionBits);
}

/// Below this, a double's last bit is still worth a quarter or less; rounding it to an integer
/// through 1.5 · 2^52, after one rounded product, leaves an error below 1.
inline constexpr double magnitudeLimit = double(std::int64_t(1) << 50);

/// The largest A' for which a table of 24-bit words is exact.
inline constexpr double largestTableArea = 3.7e6; // 2 · 2.25 · 3.7e6 < 2^24
inline constexpr std::int64_t longestTableWalk = std::int64_t(1) << 13;
/// β of a table, as a 64-bit word: (2 + 1/8)·2^-24 levels.
inline constexpr std::uint64_t tableBias = std::uint64_t(17) << (56 - 24 - 3);

} // namespace pixelplumb
