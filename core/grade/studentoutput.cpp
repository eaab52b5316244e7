// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/studentoutput.h"

#include "core/grade/showntext.h"
#include "core/scene/asciiraster.h"
#include "core/scene/picturereader.h"
#include "core/scene/pnmfault.h"

#include <QSize>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr qsizetype longestQuoted = 60;

InputError otherSize(const QString &name, const QSize &size, const FrameSpec &frame)
{
    const QString text = QStringLiteral("%1 × %2 pixels");
    return {name,
            QStringLiteral("a picture of ") + text.arg(size.width()).arg(size.height())
                + sizeHint(size, {frame.width, frame.height}),
            text.arg(frame.width).arg(frame.height)};
}

InputError noPicture(const QString &name, const QByteArray &output)
{
    const QString shown = shownText(output.left(longestQuoted * 4), longestQuoted);
    return {
        name,
        output.isEmpty() ? QStringLiteral("it is empty")
                         : QStringLiteral("neither a picture nor lines of a trace: “%1”")
                               .arg(shown.simplified()),
        QStringLiteral("PNG, PPM, BMP, a raster of # and ., or lines such as column 12 5 41.5")};
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
    if (!size.isValid()) {
        const QString fault = pnmFault(output);
        return InputError{name,
                          fault.isEmpty()
                              ? QStringLiteral("a picture (%1) that is broken or ends early")
                                    .arg(QString::fromLatin1(format))
                              : fault,
                          {}};
    }
    if (size != QSize(frame.width, frame.height))
        return otherSize(name, size, frame);
    return std::nullopt;
}

/// The last colour of each pixel counts; pixels without a line have the background.
Picture pictureFrom(const ProgramTrace &trace, const FrameSpec &frame)
{
    Picture picture{frame.width, frame.height, {}, {}};
    const std::size_t pixels = std::size_t(frame.width) * std::size_t(frame.height);
    picture.colours.resize(pixels, frame.background);
    picture.covered.resize(pixels, 0);
    for (const WrittenLine &line : trace.lines) {
        if (line.axis)
            continue;
        const int x = line.x - frame.firstColumn;
        const int row = line.y - frame.firstRow;
        const int top = frame.origin == FrameOrigin::TopLeft ? row : frame.height - 1 - row;
        const std::size_t place = picture.placeOf(x, top);
        const std::vector<WrittenNumber> numbers = trace.numbersOf(line);
        picture.covered[place] = 1;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double level = numbers[channel].value.toDouble();
            const double nearest = level > 0 ? std::floor(std::min(level, 255.0) + 0.5) : 0;
            picture.colours[place].channels[channel] = std::uint8_t(nearest);
        }
    }
    return picture;
}

} // namespace

bool looksLikeTrace(const QByteArray &output)
{
    const QByteArray start = output.left(longestQuoted).trimmed();
    constexpr std::array words = {"column", "row", "pixel", "triangle"};
    return std::ranges::any_of(words, [&](const char *word) { return start.startsWith(word); });
}

bool isOfOtherSize(const QByteArray &output, const FrameSpec &frame)
{
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

Result<StudentOutput> readStudentOutput(const QByteArray &output, const Scene &scene,
                                        const QString &name)
{
    const FrameSpec &frame = scene.frame;
    if (looksLikeTrace(output)) {
        Result<ProgramTrace> trace = parseWrittenTrace(output, frame);
        if (!trace)
            return trace.error();
        StudentOutput read{std::nullopt, std::move(*trace)};
        if (read.trace->kinds.hasPixels)
            read.picture = pictureFrom(*read.trace, frame);
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
