// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"

#include <QString>

#include <array>
#include <limits>
#include <span>

namespace pixelplumb {

/// How a pixel of a picture stands to that of the expected one.
enum class PixelVerdict : std::uint8_t {
    Same,
    Missing, ///< expected to be covered
    Extra, ///< expected not to be
    Colour, ///< covered in both, with other bytes
    Undecidable, ///< other, where the scene leaves it open: a sample on an edge
};
inline constexpr std::array allPixelVerdicts
    = {PixelVerdict::Same, PixelVerdict::Missing, PixelVerdict::Extra, PixelVerdict::Colour,
       PixelVerdict::Undecidable};

/// "same", "missing", …
QString nameOf(PixelVerdict verdict);

/// One thing that, done to the whole of what was expected, leaves fewer differences.
struct PictureCause {
    QString name; ///< "shifted by (1, 0)", "rows counted from the other side", "R and B swapped"
    std::int64_t left = 0; ///< pixels that differ still

    friend bool operator==(const PictureCause &, const PictureCause &) = default;
};

/// Two pictures of one size, pixel by pixel.
struct PictureDiff {
    int width = 0;
    int height = 0;
    std::vector<PixelVerdict> verdicts; ///< line by line, the top line first
    std::array<std::int64_t, allPixelVerdicts.size()> counts = {};
    int largestError = 0; ///< of a byte, where the verdict is Colour
    std::vector<PictureCause> causes; ///< those that leave at most half; the best first

    std::int64_t count(PixelVerdict verdict) const { return counts[std::size_t(verdict)]; }
    /// Pixels that are wrong; those that are undecidable are not.
    std::int64_t differing() const
    {
        return count(PixelVerdict::Missing) + count(PixelVerdict::Extra)
            + count(PixelVerdict::Colour);
    }
};

/// Pixels that differ, up to a limit at which nobody cares: by colours alone where both have them,
/// for what is done to a background makes it no drawing. Both have one size.
std::int64_t differingPixels(const Picture &expected, const Picture &found,
                             std::int64_t limit = std::numeric_limits<std::int64_t>::max());

/// Both have one size. `undecidable` holds a 1 for each pixel that the scene leaves open; empty:
/// none. Colours are compared where both pictures have them.
PictureDiff differenceOf(const Picture &expected, const Picture &found,
                         std::span<const std::uint8_t> undecidable = {});

/// A 1 for each pixel whose sample lies exactly on an edge of one of the scene's triangles, where
/// the rules differ: line by line, the top line first.
std::vector<std::uint8_t> tiesOf(const Scene &scene);

/// `#` where both are covered, `?` missing, `!` extra, `c` another colour, `=` undecidable, `.`
/// else; every line ends with a line feed.
QString rasterOf(const PictureDiff &diff, const Picture &expected);

} // namespace pixelplumb
