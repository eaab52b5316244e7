// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/studentoutput.h"

#include "core/frame/framebuffer.h"
#include "core/grade/rounding/arithmeticbound.h"
#include "core/grade/showntext.h"
#include "core/oracle/oracle.h"
#include "core/scene/asciiraster.h"
#include "core/scene/files/picturereader.h"
#include "core/scene/text/byteordermark.h"

#include <QSize>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr qsizetype longestQuoted = 60;

InputError otherSize(const QString &name, const QSize &size, const FrameSpec &frame)
{
    const QString text = u"%1 × %2 pixels"_s;
    return {name,
            u"a picture of "_s + text.arg(size.width()).arg(size.height())
                + sizeHint(size, {frame.width, frame.height}),
            text.arg(frame.width).arg(frame.height)};
}

InputError noPicture(const QString &name, const QByteArray &output)
{
    const QString shown = shownText(output.left(longestQuoted * 4), longestQuoted);
    return {name,
            output.isEmpty() ? u"it is empty"_s
                : isUtf16(output)
                ? u"text in UTF-16"_s
                : u"neither a picture nor lines of a trace: “%1”"_s.arg(shown.simplified()),
            u"PNG, PPM, BMP, a raster of # and ., or lines such as column 12 5 41.5"_s};
}

/// Why a picture must not be decoded; none where it may be.
std::optional<InputError> objectionToHeader(const QString &name, const QByteArray &output,
                                            const FrameSpec &frame)
{
    PictureReader reader(output);
    if (!reader.fault().isEmpty())
        return InputError{name, reader.fault(), {}};
    const QByteArray format = reader.format();
    if (!isPictureFormat(format))
        return noPicture(name, output);
    const QSize size = reader.size();
    if (!size.isValid())
        return InputError{
            name,
            u"a picture (%1) that is broken or ends early"_s.arg(QString::fromLatin1(format)),
            {}};
    if (size != QSize(frame.width, frame.height))
        return otherSize(name, size, frame);
    return std::nullopt;
}

/// The levels of a pixel that a program printed, each within half a unit of its last digit.
using PrintedLevels = std::array<LevelRange, 3>;

bool hasBytes(const PrintedLevels &levels, const Colour &colour, ByteRounding rounding)
{
    // Allows for the last bits of these doubles, so that 0.05 is not above 0.05.
    constexpr double ownError = 1e-9;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const LevelRange range{levels[channel].least - ownError, levels[channel].most + ownError};
        if (!range.hasByte(colour.channels[channel], rounding))
            return false;
    }
    return true;
}

/// Few digits may stand for several bytes: those of a triangle at the sample are taken where they
/// are among them, else the nearest to what was printed.
Colour byteColour(const std::vector<WrittenNumber> &numbers, const WrittenLine &line,
                  const std::vector<Triangle> &triangles, ByteRounding rounding)
{
    PrintedLevels levels;
    Colour nearest;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const WrittenNumber &number = numbers[channel];
        const double level = std::clamp(number.value.toDouble(), -1e6, 1e6); // also infinities
        levels[channel] = {level - number.halfUnit, level + number.halfUnit};
        // What is no byte keeps its lowest eight bits, as when it is stored.
        if (level <= -1 || level >= 256) {
            nearest.channels[channel] = std::uint8_t(std::int64_t(std::floor(level)));
            continue;
        }
        const auto byte
            = LevelRange{level, level}.bytes(number.isWhole ? ByteRounding::Nearest : rounding);
        nearest.channels[channel] = std::uint8_t(byte.first);
    }
    const auto isRough = [](const WrittenNumber &number) { return number.halfUnit > 0; };
    if (std::ranges::none_of(numbers, isRough))
        return nearest;
    for (const Triangle &triangle : triangles) {
        if (!oracle::covers(triangle, FillRule::Closed, line.x, line.y))
            continue;
        const Colour exact = oracle::byteColourAt(triangle, line.x, line.y, rounding);
        if (hasBytes(levels, exact, rounding))
            return exact;
    }
    return nearest;
}

/// The last colour of each pixel counts; pixels without a line have the background.
Picture pictureFrom(const ProgramTrace &trace, const Scene &scene)
{
    const FrameSpec &frame = scene.frame;
    const std::vector<Triangle> triangles = primitivesOnSamples(scene).triangles;
    Picture picture = emptyPicture(frame);
    for (const WrittenLine &line : trace.lines) {
        if (line.axis)
            continue;
        const std::size_t place
            = picture.placeOf(line.x - frame.firstColumn, int(pictureLine(frame, line.y)));
        picture.covered[place] = 1;
        picture.colours[place]
            = byteColour(trace.numbersOf(line), line, triangles, scene.settings.rounding);
    }
    return picture;
}

} // namespace

bool looksLikeTrace(const QByteArray &output)
{
    const QByteArray start = withoutByteOrderMark(output.left(longestQuoted)).trimmed();
    constexpr std::array words = {"column", "row", "pixel", "triangle"};
    return std::ranges::any_of(words, [&](const char *word) { return start.startsWith(word); });
}

bool isOfOtherSize(const QByteArray &given, const FrameSpec &frame)
{
    const QByteArray output = withoutByteOrderMark(given);
    if (looksLikeTrace(output))
        return false;
    QSize size;
    if (looksLikeRaster(output)) {
        const Result<Picture> raster = parsePicture(output, {});
        size = raster ? QSize(raster->width, raster->height) : size;
    } else if (PictureReader reader(output); reader.fault().isEmpty()) {
        size = isPictureFormat(reader.format()) ? reader.size() : size;
    }
    return size.isValid() && size != QSize(frame.width, frame.height);
}

Result<StudentOutput> readStudentOutput(const QByteArray &given, const Scene &scene,
                                        const QString &name)
{
    const QByteArray output = withoutByteOrderMark(given);
    const FrameSpec &frame = scene.frame;
    if (looksLikeTrace(output)) {
        Result<ProgramTrace> trace = parseWrittenTrace(output, frame);
        if (!trace)
            return trace.error();
        StudentOutput read{std::nullopt, std::move(*trace)};
        if (read.trace->kinds.hasPixels)
            read.picture = pictureFrom(*read.trace, scene);
        return read;
    }
    if (!looksLikeRaster(output)) {
        if (const auto objection = objectionToHeader(name, output, frame))
            return *objection;
    }
    Result<Picture> picture = parsePicture(output, name);
    if (!picture)
        return picture.error();
    if (picture->width != frame.width || picture->height != frame.height)
        return otherSize(name, QSize(picture->width, picture->height), frame);
    if (picture->hasColours)
        coverAllBut(frame.background, *picture);
    return StudentOutput{std::move(*picture), std::nullopt};
}

} // namespace pixelplumb
