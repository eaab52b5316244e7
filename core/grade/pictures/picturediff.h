// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/difference.h"
#include "core/grade/pictures/picture.h"

#include <QRgb>
#include <QString>

#include <limits>
#include <optional>
#include <span>

namespace pixelplumb {

/// A change of the whole expected picture that leaves fewer differences.
struct PictureCause {
    QString name; ///< "shifted by (1, 0)", "rows counted from the other side", "R and B swapped"
    std::int64_t left = 0; ///< pixels that still differ

    friend bool operator==(const PictureCause &, const PictureCause &) = default;
};

/// Compares two pictures of the same size, pixel by pixel.
struct PictureDiff {
    int width = 0;
    int height = 0;
    std::vector<Difference> verdicts; ///< line by line, the top line first
    DifferenceCounts counts;
    int largestError = 0; ///< of a byte, where the verdict is Colour
    std::vector<PictureCause> causes; ///< those that leave at most half; the best first

    std::int64_t count(Difference verdict) const { return counts.count(verdict); }
    std::int64_t differing() const { return counts.total(); }
};

/// Counts differing pixels, stopping at a limit: by colour alone where both pictures have colours,
/// since a changed background counts as no drawing. Both have the same size.
std::int64_t differingPixels(const Picture &expected, const Picture &found,
                             std::int64_t limit = std::numeric_limits<std::int64_t>::max());

/// Both have the same size. `undecidable` holds a 1 for each pixel that the scene leaves open;
/// empty: none. Colours are compared where both pictures have them.
PictureDiff differenceOf(const Picture &expected, const Picture &found,
                         std::span<const std::uint8_t> undecidable = {});

/// A 1 for each pixel whose sample lies exactly on an edge of one of the scene's triangles, where
/// the rules differ; line by line, the top line first.
std::vector<std::uint8_t> tiesOf(const Scene &scene);

/// The colours that mark differing pixels in pictures (Okabe and Ito's): vermilion missing, blue
/// extra, purple another colour, yellow undecidable; none where nothing differs.
std::optional<QRgb> markOf(Difference verdict);

/// `#` covered in both, `?` missing, `!` extra, `c` another colour, `=` undecidable, `.` otherwise;
/// every line ends with a line feed.
QString rasterOf(const PictureDiff &diff, const Picture &expected);

} // namespace pixelplumb
