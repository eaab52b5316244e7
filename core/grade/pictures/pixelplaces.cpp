// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/pictures/pixelplaces.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr int farthestShift = 4; // px

/// The pixel of the expected picture that is found at (x, line).
using PlaceMap = std::function<std::pair<int, int>(const Picture &expected, int x, int line)>;

template <class Source>
PixelRule moving(const Source &source)
{
    return ruleOf([=](const Picture &expected, int x, int line, const Colour &background) {
        const auto [fromX, fromLine] = source(expected, x, line);
        if (!expected.contains(fromX, fromLine))
            return ChangedPixel{background, 0};
        const std::size_t from = expected.placeOf(fromX, fromLine);
        return ChangedPixel{expected.colours[from], expected.covered[from]};
    });
}

QString shiftName(int right, int down)
{
    QStringList ways;
    if (right != 0)
        ways += u"%1 to the %2"_s.arg(std::abs(right)).arg(right > 0 ? u"right"_s : u"left"_s);
    if (down != 0)
        ways += u"%1 %2"_s.arg(std::abs(down)).arg(down > 0 ? u"down"_s : u"up"_s);
    return u"shifted by "_s + ways.join(u" and "_s);
}

void appendShifts(std::vector<PictureChange> &changes)
{
    for (int dy = -farthestShift; dy <= farthestShift; ++dy) {
        for (int dx = -farthestShift; dx <= farthestShift; ++dx) {
            if (dx == 0 && dy == 0)
                continue;
            changes.push_back({shiftName(dx, dy), moving([=](const Picture &, int x, int line) {
                                   return std::pair(x - dx, line - dy);
                               }),
                               u"shift"_s, std::max(std::abs(dx), std::abs(dy)) > 1});
        }
    }
}

void appendFlips(std::vector<PictureChange> &changes)
{
    const auto right = [](const Picture &picture) { return picture.width - 1; };
    const auto bottom = [](const Picture &picture) { return picture.height - 1; };
    const auto add = [&](const QString &name, const auto &source) {
        changes.push_back({name, moving(source), u"flip"_s});
    };
    add(u"upside down"_s,
        [=](const Picture &of, int x, int line) { return std::pair(x, bottom(of) - line); });
    add(u"left and right exchanged"_s,
        [=](const Picture &of, int x, int line) { return std::pair(right(of) - x, line); });
    add(u"turned by half a turn"_s, [=](const Picture &of, int x, int line) {
        return std::pair(right(of) - x, bottom(of) - line);
    });
    // Rows are counted from the bottom: exchanging x and y exchanges lines and columns, mirrored.
    // What leaves a frame that is not square is lost.
    add(u"x and y exchanged"_s, [=](const Picture &of, int x, int line) {
        return std::pair(bottom(of) - line, bottom(of) - x);
    });
    add(u"lines and columns exchanged"_s,
        [](const Picture &, int x, int line) { return std::pair(line, x); });
}

/// Where a program starts counting rows.
enum class RowOrigin { Top, Bottom };

/// Converts a line to a row as the program counts it, and back.
int countedFrom(RowOrigin origin, const Picture &of, int line)
{
    return origin == RowOrigin::Bottom ? of.height - 1 - line : line;
}

/// The distance in pixels between the starts of adjacent rows, as written.
using Stride = std::function<int(const Picture &of)>;

/// Pixel (x, row) is written at row·stride + x and read at row·width + x. Where rows overlap, drawn
/// pixels win; of two drawn ones that with the greater x, as if drawn by columns.
PlaceMap storedWith(const Stride &strideOf, RowOrigin origin)
{
    return [=](const Picture &of, int x, int line) {
        const int stride = strideOf(of);
        const std::int64_t address = std::int64_t(countedFrom(origin, of, line)) * of.width + x;
        const auto writer = [&](std::int64_t rowsBefore) {
            const auto row = int(address / stride - rowsBefore);
            return std::pair(int(address % stride + rowsBefore * stride),
                             countedFrom(origin, of, row));
        };
        auto found = writer(0);
        for (std::int64_t before = 1; address % stride + before * stride < of.width; ++before) {
            const auto [fromX, fromLine] = writer(before);
            if (of.contains(fromX, fromLine) && of.covered[of.placeOf(fromX, fromLine)] != 0)
                found = {fromX, fromLine};
        }
        return found;
    };
}

/// Pixel (x, row) is written at x·height + row and read at row·width + x.
PlaceMap storedByColumns(RowOrigin origin)
{
    return [=](const Picture &of, int x, int line) {
        const std::int64_t address = std::int64_t(countedFrom(origin, of, line)) * of.width + x;
        return std::pair(int(address / of.height),
                         countedFrom(origin, of, int(address % of.height)));
    };
}

/// Rows are stored at another distance than they are read: the picture leans.
void appendStrides(const Picture &expected, std::vector<PictureChange> &changes)
{
    const auto add = [&](const QString &what, const char *address, const auto &stored) {
        for (const auto &[origin, from] :
             {std::pair(RowOrigin::Top, "top"), std::pair(RowOrigin::Bottom, "bottom")})
            changes.push_back(
                {u"%1 from the %2 on"_s.arg(what, QLatin1String(from)), moving(stored(origin)),
                 u"stride"_s, false,
                 u"The pixel (x, y) is written at %1 and read at y·width + x, y "
                 "counted from the %2."_s.arg(QString::fromUtf8(address), QLatin1String(from))});
    };
    const auto apart = [](const Stride &stride) {
        return [stride](RowOrigin origin) { return storedWith(stride, origin); };
    };
    add(u"rows stored a pixel too far apart"_s, "y·(width + 1) + x",
        apart([](const Picture &of) { return of.width + 1; }));
    add(u"rows stored a pixel too near"_s, "y·(width − 1) + x",
        apart([](const Picture &of) { return std::max(1, of.width - 1); }));
    if (expected.height == expected.width)
        return;
    if (std::abs(expected.height - expected.width) > 1)
        add(u"rows stored as far apart as columns are high"_s, "y·height + x",
            apart([](const Picture &of) { return of.height; }));
    add(u"columns stored in place of rows"_s, "x·height + y", storedByColumns);
}

} // namespace

std::vector<PictureChange> placeChangesFor(const Picture &expected)
{
    std::vector<PictureChange> changes;
    appendFlips(changes);
    appendStrides(expected, changes);
    appendShifts(changes);
    for (PictureChange &change : changes)
        change.movesPixels = true;
    return changes;
}

} // namespace pixelplumb
