// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/asciiraster.h"

#include "core/frame/framebuffer.h"

#include <QStringList>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr QChar covered = u'#';
constexpr QChar uncovered = u'.';

/// Whether a pixel is covered: column from the picture's left, line from its top.
bool isCovered(const CoverageMask &coverage, int column, int line)
{
    const FrameSpec &spec = coverage.spec();
    return coverage.covers(std::int64_t(spec.firstColumn) + column, rowOfPictureLine(spec, line));
}

QList<QStringView> linesOf(QStringView text)
{
    QList<QStringView> lines = text.split(u'\n');
    if (lines.back().isEmpty())
        lines.removeLast();
    for (QStringView &line : lines) {
        if (line.endsWith(u'\r'))
            line.chop(1);
    }
    return lines;
}

InputError unexpected(qsizetype line, const QString &found, const QString &expected)
{
    return {u"line %1"_s.arg(line + 1), found, expected};
}

} // namespace

QString asciiRaster(const CoverageMask &coverage)
{
    const FrameSpec &spec = coverage.spec();
    QString text;
    text.reserve((qsizetype(spec.width) + 1) * spec.height);
    for (int line = 0; line < spec.height; ++line) {
        for (int column = 0; column < spec.width; ++column)
            text += isCovered(coverage, column, line) ? covered : uncovered;
        text += u'\n';
    }
    return text;
}

bool looksLikeRaster(const QByteArray &content)
{
    const QByteArray line = content.left(largestFrameSide).split('\n').front().trimmed();
    const auto drawn = std::ranges::count_if(
        line, [](char character) { return character == '#' || character == '.'; });
    return (line.startsWith('#') || line.startsWith('.')) && 2 * drawn > line.size();
}

Result<CoverageMask> parseAsciiRaster(QStringView text)
{
    const QList<QStringView> lines = linesOf(text);
    if (lines.isEmpty() || lines.front().isEmpty())
        return unexpected(0, "nothing", "a line of # and .");
    const qsizetype width = lines.front().size();
    if (width > largestFrameSide || lines.size() > largestFrameSide
        || width * lines.size() > largestFrameArea) {
        return InputError{
            {},
            u"a raster of %1 × %2"_s.arg(width).arg(lines.size()),
            u"at most %1 on a side and %2 pixels"_s.arg(largestFrameSide).arg(largestFrameArea)};
    }
    FrameSpec spec;
    spec.width = std::int32_t(width);
    spec.height = std::int32_t(lines.size());
    CoverageMask coverage(spec);
    for (qsizetype line = 0; line < lines.size(); ++line) {
        if (lines[line].size() != width)
            return unexpected(line, u"its length is %1"_s.arg(lines[line].size()),
                              u"%1, as that of the first line"_s.arg(width));
        for (qsizetype column = 0; column < width; ++column) {
            const QChar character = lines[line][column];
            if (character == covered)
                coverage.cover(column, rowOfPictureLine(spec, int(line)));
            else if (character != uncovered)
                return InputError{u"line %1, column %2"_s.arg(line + 1).arg(column + 1),
                                  u"“%1”"_s.arg(character), "# or ."};
        }
    }
    return coverage;
}

} // namespace pixelplumb
