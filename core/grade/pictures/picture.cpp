// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/pictures/picture.h"

#include "core/runs/tracedscene.h"
#include "core/scene/asciiraster.h"
#include "core/scene/files/picturereader.h"
#include "core/scene/text/byteordermark.h"

#include <QImage>
#include <QSize>

#include <algorithm>
#include <array>

namespace pixelplumb {

namespace {

Picture blankPicture(int width, int height)
{
    Picture picture{width, height, {}, {}};
    const std::size_t pixels = std::size_t(width) * std::size_t(height);
    picture.colours.resize(pixels);
    picture.covered.resize(pixels, 0);
    return picture;
}

void takeColours(const QImage &image, Picture &picture)
{
    for (int line = 0; line < picture.height; ++line) {
        const auto *pixels = reinterpret_cast<const QRgb *>(image.constScanLine(line));
        for (int x = 0; x < picture.width; ++x)
            picture.colours[picture.placeOf(x, line)] = unpacked(pixels[x]);
    }
}

void takeCoverage(const CoverageMask &coverage, Picture &picture)
{
    const FrameSpec &frame = coverage.spec();
    for (int line = 0; line < picture.height; ++line) {
        const std::int64_t y = rowOfPictureLine(frame, line);
        for (int x = 0; x < picture.width; ++x)
            picture.covered[picture.placeOf(x, line)]
                = coverage.covers(frame.firstColumn + x, y) ? 1 : 0;
    }
}

/// Whether any pixel is transparent.
bool hasTransparentPixel(const QImage &image)
{
    if (!image.hasAlphaChannel())
        return false;
    const QImage pixels = image.convertToFormat(QImage::Format_ARGB32);
    for (int line = 0; line < pixels.height(); ++line) {
        const auto *first = reinterpret_cast<const QRgb *>(pixels.constScanLine(line));
        if (std::any_of(first, first + pixels.width(),
                        [](QRgb pixel) { return qAlpha(pixel) != 255; }))
            return true;
    }
    return false;
}

InputError tooLarge(const QString &name, const QSize &size)
{
    return {name, u"%1 × %2 pixels"_s.arg(size.width()).arg(size.height()),
            u"at most %1 pixels"_s.arg(largestFrameArea)};
}

bool isTooLarge(const QSize &size)
{
    return std::int64_t(size.width()) * size.height() > largestFrameArea;
}

} // namespace

Colour backgroundOf(const Picture &picture)
{
    const int right = picture.width - 1;
    const int bottom = picture.height - 1;
    std::array<Colour, 4> corners;
    const std::array places = {picture.placeOf(0, 0), picture.placeOf(right, 0),
                               picture.placeOf(0, bottom), picture.placeOf(right, bottom)};
    for (std::size_t i = 0; i < places.size(); ++i)
        corners[i] = picture.colours[places[i]];
    return *std::ranges::max_element(corners, {}, [&corners](const Colour &corner) {
        return std::ranges::count(corners, corner);
    });
}

void coverAllBut(const Colour &background, Picture &picture)
{
    for (std::size_t i = 0; i < picture.size(); ++i)
        picture.covered[i] = picture.colours[i] == background ? 0 : 1;
}

Picture emptyPicture(const FrameSpec &frame)
{
    Picture picture = blankPicture(frame.width, frame.height);
    std::ranges::fill(picture.colours, frame.background);
    return picture;
}

Picture pictureOf(const SceneRun &run)
{
    const FrameSpec &spec = run.scene.frame;
    const FrameBuffer frame(spec);
    run.draw(frame.view());
    Picture picture = blankPicture(spec.width, spec.height);
    takeColours(frame.image(), picture);
    takeCoverage(coverageOf(run), picture);
    return picture;
}

Picture pictureIn(QImage image)
{
    Picture picture = blankPicture(image.width(), image.height());
    picture.isTransparent = hasTransparentPixel(image);
    takeColours(std::move(image).convertToFormat(QImage::Format_RGB32), picture);
    return picture;
}

Picture truePictureOf(const Scene &scene)
{
    const FrameBuffer frame(scene.frame);
    drawTruth(scene, frame);
    Picture picture = blankPicture(scene.frame.width, scene.frame.height);
    takeColours(frame.image(), picture);
    coverAllBut(scene.frame.background, picture);
    return picture;
}

QString transparencyText()
{
    return u"has transparent pixels; their transparency is ignored, their colours count"_s;
}

QString sizeHint(const QSize &size, const QSize &expected)
{
    if (size != expected && size == expected.transposed())
        return u", as if width and height were exchanged"_s;
    const int times = size.width() / std::max(1, expected.width());
    if (times < 2 || size != times * expected)
        return {};
    return u", %1 times as many each way, as if enlarged"_s.arg(times);
}

std::int64_t largestPictureFileOf(const FrameSpec &frame)
{
    constexpr std::int64_t bytesOfPixel = 12; // "255 255 255 "
    constexpr std::int64_t least = std::int64_t(64) << 20;
    return std::max(least, bytesOfPixel * frame.width * frame.height);
}

bool isPictureFormat(const QByteArray &format)
{
    static const QList<QByteArray> formats = {"png", "ppm", "pgm", "pbm", "bmp"};
    return formats.contains(format);
}

QString pictureFormatsText() { return u"PNG, PPM, BMP, or a raster of # and ."_s; }

Result<Picture> parsePicture(const QByteArray &given, const QString &name, const QString &formats)
{
    if (isUtf16(given))
        return InputError{name, u"text in UTF-16"_s, formats};
    const QByteArray content = withoutByteOrderMark(given);
    if (looksLikeRaster(content)) {
        const Result<CoverageMask> raster = parseAsciiRaster(QString::fromLatin1(content));
        if (!raster)
            return InputError{name, raster.error().message(), {}};
        const FrameSpec &frame = raster->spec();
        Picture picture = blankPicture(frame.width, frame.height);
        picture.hasColours = false;
        takeCoverage(*raster, picture);
        return picture;
    }
    if (content.isEmpty())
        return InputError{name, u"it is empty"_s, formats};
    const auto broken = [&name](const QString &fault) {
        return InputError{name, u"no picture: "_s + fault, u"a whole file"_s};
    };
    PictureReader reader(content);
    if (!reader.fault().isEmpty())
        return broken(reader.fault());
    if (const QByteArray format = reader.format(); !format.isEmpty() && !isPictureFormat(format))
        return InputError{name, u"a picture of the kind %1"_s.arg(QString::fromLatin1(format)),
                          formats};
    if (const QSize size = reader.size(); size.isValid() && isTooLarge(size))
        return tooLarge(name, size);
    QImage image = reader.read();
    if (image.isNull() && !reader.fault().isEmpty())
        return broken(reader.fault());
    if (image.isNull())
        return InputError{name, u"no picture: "_s + reader.errorString(), formats};
    if (isTooLarge(image.size()))
        return tooLarge(name, image.size());
    return pictureIn(std::move(image));
}

} // namespace pixelplumb
