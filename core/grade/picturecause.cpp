// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/picturecause.h"

#include "core/frame/srgb.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr int farthestShift = 4; // px

/// The pixel of the expected picture that is found at (x, line).
using PlaceMap = std::function<std::pair<int, int>(const Picture &expected, int x, int line)>;

using Change = std::function<Picture(const Picture &expected)>;

Picture moved(const Picture &expected, const PlaceMap &source, const Colour &background)
{
    Picture picture = expected;
    for (int line = 0; line < expected.height; ++line) {
        for (int x = 0; x < expected.width; ++x) {
            const auto [fromX, fromLine] = source(expected, x, line);
            const bool isInside = expected.contains(fromX, fromLine);
            const std::size_t to = picture.placeOf(x, line);
            const std::size_t from = isInside ? expected.placeOf(fromX, fromLine) : 0;
            picture.colours[to] = isInside ? expected.colours[from] : background;
            picture.covered[to] = isInside ? expected.covered[from] : std::uint8_t(0);
        }
    }
    return picture;
}

Change move(const Colour &background, const PlaceMap &source)
{
    return [=](const Picture &expected) { return moved(expected, source, background); };
}

Change recolour(const std::function<Colour(const Colour &)> &change)
{
    return [=](const Picture &expected) {
        Picture picture = expected;
        std::ranges::transform(picture.colours, picture.colours.begin(), change);
        return picture;
    };
}

QString shiftName(int right, int down)
{
    QStringList ways;
    if (right != 0)
        ways += QStringLiteral("%1 to the %2")
                    .arg(std::abs(right))
                    .arg(right > 0 ? QStringLiteral("right") : QStringLiteral("left"));
    if (down != 0)
        ways += QStringLiteral("%1 %2")
                    .arg(std::abs(down))
                    .arg(down > 0 ? QStringLiteral("down") : QStringLiteral("up"));
    return QStringLiteral("shifted by ") + ways.join(QStringLiteral(" and "));
}

void appendShifts(const Colour &background, std::vector<PictureChange> &changes)
{
    for (int dy = -farthestShift; dy <= farthestShift; ++dy) {
        for (int dx = -farthestShift; dx <= farthestShift; ++dx) {
            if (dx == 0 && dy == 0)
                continue;
            changes.push_back({shiftName(dx, dy),
                               move(background,
                                    [=](const Picture &, int x, int line) {
                                        return std::pair(x - dx, line - dy);
                                    }),
                               QStringLiteral("shift"), std::max(std::abs(dx), std::abs(dy)) > 1});
        }
    }
}

void appendFlips(const Picture &expected, const Colour &background,
                 std::vector<PictureChange> &changes)
{
    const auto right = [](const Picture &picture) { return picture.width - 1; };
    const auto bottom = [](const Picture &picture) { return picture.height - 1; };
    const auto add = [&](const QString &name, const PlaceMap &source) {
        changes.push_back({name, move(background, source), QStringLiteral("flip")});
    };
    add(QStringLiteral("upside down"),
        [=](const Picture &of, int x, int line) { return std::pair(x, bottom(of) - line); });
    add(QStringLiteral("left and right exchanged"),
        [=](const Picture &of, int x, int line) { return std::pair(right(of) - x, line); });
    add(QStringLiteral("turned by half a turn"), [=](const Picture &of, int x, int line) {
        return std::pair(right(of) - x, bottom(of) - line);
    });
    if (expected.width != expected.height)
        return;
    // Rows are counted from the bottom: x and y exchanged are lines and columns, mirrored.
    add(QStringLiteral("x and y exchanged"), [=](const Picture &of, int x, int line) {
        return std::pair(bottom(of) - line, right(of) - x);
    });
    add(QStringLiteral("lines and columns exchanged"),
        [](const Picture &, int x, int line) { return std::pair(line, x); });
}

/// Rows that are stored more or fewer pixels apart than they are read: the picture leans.
void appendStrides(const Colour &background, std::vector<PictureChange> &changes)
{
    const auto add = [&](const QString &name, int more, bool fromBottom) {
        const auto source = [=](const Picture &of, int x, int line) {
            const int row = fromBottom ? of.height - 1 - line : line;
            const std::int64_t address = std::int64_t(row) * of.width + x;
            const std::int64_t stride = std::max(1, of.width + more);
            const int from = int(address / stride);
            return std::pair(int(address % stride), fromBottom ? of.height - 1 - from : from);
        };
        changes.push_back({name, move(background, source), QStringLiteral("stride")});
    };
    add(QStringLiteral("rows stored a pixel too far apart from the top on"), 1, false);
    add(QStringLiteral("rows stored a pixel too far apart from the bottom on"), 1, true);
    add(QStringLiteral("rows stored a pixel too near from the top on"), -1, false);
    add(QStringLiteral("rows stored a pixel too near from the bottom on"), -1, true);
}

void appendChannels(std::vector<PictureChange> &changes)
{
    std::array<std::size_t, 3> order = {0, 1, 2};
    while (std::ranges::next_permutation(order).found) {
        QString name;
        for (const std::size_t channel : order)
            name += channelLetters[channel];
        const auto exchanged = [order](const Colour &colour) {
            Colour result;
            for (std::size_t i = 0; i < 3; ++i)
                result.channels[i] = colour.channels[order[i]];
            return result;
        };
        changes.push_back({QStringLiteral("channels %1 in place of RGB").arg(name),
                           recolour(exchanged), QStringLiteral("channels")});
    }
}

using Curve = double (*)(double);

Colour mapped(const Colour &colour, Curve curve)
{
    Colour result;
    for (std::size_t i = 0; i < 3; ++i)
        result.channels[i] = std::uint8_t(std::lround(255 * curve(colour.channels[i] / 255.0)));
    return result;
}

void appendLevels(std::vector<PictureChange> &changes)
{
    const auto add = [&](const QString &name, Curve curve) {
        changes.push_back(
            {name, recolour([curve](const Colour &colour) { return mapped(colour, curve); }),
             QStringLiteral("levels")});
    };
    add(QStringLiteral("encoded as sRGB once too often"), levelOfLight);
    add(QStringLiteral("decoded from sRGB once too often"), linearLight);
}

/// A frame that was filled with another colour than the scene's before anything was drawn.
void appendBackgrounds(const Colour &background, std::vector<PictureChange> &changes)
{
    const auto add = [&](const QString &name, const Colour &colour) {
        if (colour == background)
            return;
        changes.push_back({name,
                           [colour](const Picture &expected) {
                               Picture picture = expected;
                               for (std::size_t i = 0; i < picture.size(); ++i) {
                                   if (picture.covered[i] == 0)
                                       picture.colours[i] = colour;
                                   picture.covered[i] = 1; // it is not the scene's background
                               }
                               return picture;
                           },
                           QStringLiteral("background")});
    };
    add(QStringLiteral("drawn on black"), {{0, 0, 0}});
    add(QStringLiteral("drawn on white"), {{255, 255, 255}});
}

/// What is drawn is a mask.
void appendMask(std::vector<PictureChange> &changes)
{
    changes.push_back({QStringLiteral("drawn in white alone"),
                       [](const Picture &expected) {
                           Picture picture = expected;
                           for (std::size_t i = 0; i < picture.size(); ++i) {
                               if (picture.covered[i] != 0)
                                   picture.colours[i] = {{255, 255, 255}};
                           }
                           return picture;
                       },
                       QStringLiteral("mask")});
}

} // namespace

std::vector<PictureChange> pictureChangesFor(const Picture &expected, const Colour &background)
{
    std::vector<PictureChange> changes;
    appendFlips(expected, background, changes);
    appendStrides(background, changes);
    appendShifts(background, changes);
    if (!expected.hasColours)
        return changes;
    appendChannels(changes);
    appendLevels(changes);
    appendMask(changes);
    appendBackgrounds(background, changes);
    return changes;
}

} // namespace pixelplumb
