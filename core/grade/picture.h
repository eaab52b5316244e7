// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/geometry/colour.h"
#include "core/scene/result.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

class QImage;
class QSize;

namespace pixelplumb {

/// A picture to be judged, whoever drew it: line by line, the top line first, as files have it.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Colour> colours;
    std::vector<std::uint8_t> covered; ///< 1 where something was drawn
    bool hasColours = true; ///< a raster of characters has none
    bool isTransparent = false; ///< a pixel's file has it so; its colour counts as if it were not

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

/// Without a scene nobody knows the background: it is what most of the corners have. Then what has
/// another colour is covered.
Colour backgroundOf(const Picture &picture);
void coverAllBut(const Colour &background, Picture &picture);

/// All background: nothing is drawn on it.
Picture emptyPicture(const FrameSpec &frame);
/// What the scene's method draws; covered is what it writes.
Picture pictureOf(const Scene &scene);

/// Nothing is covered yet.
Picture pictureIn(QImage image);
/// The oracle's; covered is what has another colour than the background.
Picture truePictureOf(const Scene &scene);

/// Of a picture's file that is read, bytes: the largest picture that is drawn has less as PPM, BMP
/// and raster.
inline constexpr std::int64_t largestPictureFile = (largestFrameArea << 2) + (1 << 20);

/// The same of a picture of the frame: as text with a word a level, too; of a small one more, for
/// whoever enlarged it is to be told.
std::int64_t largestPictureFileOf(const FrameSpec &frame);

/// "png", "ppm" …: the formats that are read, by their names in Qt.
bool isPictureFormat(const QByteArray &format);

/// "PNG, PPM, …": what parsePicture reads.
QString pictureFormatsText();

/// A picture file of at most 2^28 pixels, or a raster of `#` and `.` (asciiRaster). Nothing is
/// covered yet of a file with colours. The error of what is of another kind expects the formats.
Result<Picture> parsePicture(const QByteArray &content, const QString &name,
                             const QString &formats = pictureFormatsText());

/// Words to be added to a picture's size where it is a multiple of the expected one, which it may
/// be enlarged, or has its width as height and its height as width. Otherwise none.
QString sizeHint(const QSize &size, const QSize &expected);

/// What is said of a picture that is transparent somewhere, behind its name.
QString transparencyText();

} // namespace pixelplumb
