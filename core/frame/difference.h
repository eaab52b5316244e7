// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <array>
#include <cstdint>

namespace pixelplumb {

/// How a pixel of a picture differs from the right one.
enum class Difference : std::uint8_t {
    None,
    Missing, ///< should be covered, and is not
    Extra, ///< is covered, and should not be
    Colour, ///< covered as it should be, with other bytes
    Undecidable, ///< different, but left open by the scene: a sample on an edge
};
inline constexpr std::array allDifferences
    = {Difference::None, Difference::Missing, Difference::Extra, Difference::Colour,
       Difference::Undecidable};

/// "none", "missing", "extra", "colour", "undecidable".
QString nameOf(Difference difference);

/// Of a pixel that is not the same in both pictures.
constexpr Difference differenceOf(bool isDrawn, bool shouldBeDrawn)
{
    return isDrawn == shouldBeDrawn ? Difference::Colour
                                    : (isDrawn ? Difference::Extra : Difference::Missing);
}

/// Numbers of pixels, by how they differ.
struct DifferenceCounts {
    std::array<std::int64_t, allDifferences.size()> pixels = {};

    void add(Difference difference, std::int64_t more = 1)
    {
        pixels[std::size_t(difference)] += more;
    }
    std::int64_t count(Difference difference) const { return pixels[std::size_t(difference)]; }
    /// Wrong pixels; undecidable ones are not counted.
    std::int64_t total() const
    {
        return count(Difference::Missing) + count(Difference::Extra) + count(Difference::Colour);
    }
    /// "3 pixels missing, 1 pixel in another colour"; empty where none is wrong.
    QString message() const;

    friend bool operator==(const DifferenceCounts &, const DifferenceCounts &) = default;
};

} // namespace pixelplumb
