// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/geometry/colour.h"
#include "core/runs/scenerun.h"
#include "core/scene/text/result.h"

#include <cstdint>
#include <optional>
#include <vector>

class QImage;
class QSize;

namespace pixelplumb {

/// A picture to be judged, whoever drew it; line by line, the top line first, as in files.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Colour> colours;
    std::vector<std::uint8_t> covered; ///< 1 where something was drawn
    bool hasColours = true; ///< false for a raster of characters
    bool isTransparent = false; ///< some pixel of the file is; its colour counts as if opaque

    std::size_t size() const { return colours.size(); }
    std::size_t placeOf(int x, int line) const
    {
        return std::size_t(line) * std::size_t(width) + std::size_t(x);
    }
    bool contains(int x, int line) const
    {
        return x >= 0 && x < width && line >= 0 && line < height;
    }

    friend bool operator==(const Picture &, const Picture &) = default;
};

/// Like ==, which compares three bytes by a call.
constexpr bool isEqual(const Colour &one, const Colour &other)
{
    return one.red() == other.red() && one.green() == other.green() && one.blue() == other.blue();
}

/// Whether two pictures of a size have the same pixel: the colour, where both have colours.
inline bool isSameAt(const Picture &one, const Picture &other, std::size_t place)
{
    return one.hasColours && other.hasColours ? isEqual(one.colours[place], other.colours[place])
                                              : one.covered[place] == other.covered[place];
}

/// The background of a picture without a scene: the colour that most corners have. Pixels of other
/// colours then count as covered.
Colour backgroundOf(const Picture &picture);
void coverAllBut(const Colour &background, Picture &picture);

/// All background, nothing covered.
Picture emptyPicture(const FrameSpec &frame);
/// What the scene's method draws; the pixels it writes are covered.
Picture pictureOf(const SceneRun &run);
inline Picture pictureOf(const Scene &scene) { return pictureOf(SceneRun(scene)); }

/// Nothing is covered yet.
Picture pictureIn(QImage image);
/// The oracle's picture; pixels of another colour than the background are covered.
Picture truePictureOf(const Scene &scene);

/// The largest picture file that is read, bytes; the largest picture that can be drawn is smaller
/// as PPM, BMP and raster.
inline constexpr std::int64_t largestPictureFile = (largestFrameArea << 2) + (1 << 20);

/// The largest picture file for a frame, bytes; enough for text with a word for each level. Small
/// frames get more, so that an enlarged picture can be reported as such.
std::int64_t largestPictureFileOf(const FrameSpec &frame);

/// Whether the format is read; by its name in Qt: "png", "ppm" …
bool isPictureFormat(const QByteArray &format);

/// "PNG, PPM, …": the formats that parsePicture() reads.
QString pictureFormatsText();

/// Parses a picture file of at most 2^28 pixels, or a raster of `#` and `.` (asciiRaster). A file
/// with colours covers nothing yet. For other content the error lists `formats`.
Result<Picture> parsePicture(const QByteArray &content, const QString &name,
                             const QString &formats = pictureFormatsText());

/// A remark on a picture's size if it is a multiple of the expected one, and may be enlarged, or if
/// width and height are swapped. Otherwise empty.
QString sizeHint(const QSize &size, const QSize &expected);

/// The remark, after its name, on a picture that is transparent somewhere.
QString transparencyText();

} // namespace pixelplumb
