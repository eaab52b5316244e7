// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/picturecause.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr int farthestShift = 4; // px

/// The pixel of the expected picture that is found at (x, line).
using PlaceMap = std::function<std::pair<int, int>(const Picture &expected, int x, int line)>;

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

PictureChange move(const QString &name, const Colour &background, const PlaceMap &source)
{
    return {name, [=](const Picture &expected) { return moved(expected, source, background); },
            QStringLiteral("flip")};
}

PictureChange recolour(const QString &name, const std::function<Colour(const Colour &)> &change)
{
    return {name,
            [=](const Picture &expected) {
                Picture picture = expected;
                for (std::size_t i = 0; i < picture.size(); ++i) {
                    picture.colours[i] = change(picture.colours[i]);
                }
                return picture;
            },
            QStringLiteral("channels")};
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
            changes.push_back(
                move(shiftName(dx, dy), background, [=](const Picture &, int x, int line) {
                    return std::pair(x - dx, line - dy);
                }));
            changes.back().kind = QStringLiteral("shift");
            changes.back().isFar = std::max(std::abs(dx), std::abs(dy)) > 1;
        }
    }
}

void appendFlips(const Picture &expected, const Colour &background,
                 std::vector<PictureChange> &changes)
{
    const auto right = [](const Picture &picture) { return picture.width - 1; };
    const auto bottom = [](const Picture &picture) { return picture.height - 1; };
    changes.push_back(
        move(QStringLiteral("upside down"), background,
             [=](const Picture &of, int x, int line) { return std::pair(x, bottom(of) - line); }));
    changes.push_back(
        move(QStringLiteral("left and right exchanged"), background,
             [=](const Picture &of, int x, int line) { return std::pair(right(of) - x, line); }));
    changes.push_back(move(QStringLiteral("turned by half a turn"), background,
                           [=](const Picture &of, int x, int line) {
                               return std::pair(right(of) - x, bottom(of) - line);
                           }));
    if (expected.width != expected.height)
        return;
    // Rows are counted from the bottom: x and y exchanged are lines and columns, mirrored.
    changes.push_back(move(QStringLiteral("x and y exchanged"), background,
                           [=](const Picture &of, int x, int line) {
                               return std::pair(bottom(of) - line, right(of) - x);
                           }));
    changes.push_back(move(QStringLiteral("lines and columns exchanged"), background,
                           [=](const Picture &, int x, int line) { return std::pair(line, x); }));
}

void appendChannels(std::vector<PictureChange> &changes)
{
    constexpr std::array letters = {'R', 'G', 'B'};
    std::array<std::size_t, 3> order = {0, 1, 2};
    while (std::ranges::next_permutation(order).found) {
        QString name;
        for (const std::size_t channel : order)
            name += QLatin1Char(letters[channel]);
        changes.push_back(recolour(QStringLiteral("channels %1 in place of RGB").arg(name),
                                   [order](const Colour &colour) {
                                       Colour exchanged;
                                       for (std::size_t i = 0; i < 3; ++i)
                                           exchanged.channels[i] = colour.channels[order[i]];
                                       return exchanged;
                                   }));
    }
}

/// IEC 61966-2-1.
double toLinear(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}
double toEncoded(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

Colour mapped(const Colour &colour, double (*curve)(double))
{
    Colour result;
    for (std::size_t i = 0; i < 3; ++i)
        result.channels[i] = std::uint8_t(std::lround(255 * curve(colour.channels[i] / 255.0)));
    return result;
}

} // namespace

std::vector<PictureChange> pictureChangesFor(const Picture &expected, const Colour &background)
{
    std::vector<PictureChange> changes;
    appendFlips(expected, background, changes);
    appendShifts(background, changes);
    if (!expected.hasColours)
        return changes;
    appendChannels(changes);
    changes.push_back(recolour(QStringLiteral("encoded as sRGB once too often"),
                               [](const Colour &colour) { return mapped(colour, toEncoded); }));
    changes.push_back(recolour(QStringLiteral("decoded from sRGB once too often"),
                               [](const Colour &colour) { return mapped(colour, toLinear); }));
    for (auto curve = changes.end() - 2; curve != changes.end(); ++curve)
        curve->kind = QStringLiteral("levels");
    return changes;
}

} // namespace pixelplumb
