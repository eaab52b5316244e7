// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/srgb.h"
#include "core/grade/pictures/pixelplaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pixelplumb {

namespace {

template <class Change>
PixelRule recolour(const Change &change)
{
    return ruleOf([=](const Picture &expected, int x, int line, const Colour &) {
        const std::size_t place = expected.placeOf(x, line);
        return ChangedPixel{change(expected.colours[place]), expected.covered[place]};
    });
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
        changes.push_back(
            {u"channels %1 in place of RGB"_s.arg(name), recolour(exchanged), u"channels"_s});
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

/// The low bits of a level that was kept in fewer than eight.
enum class Widening { ByZeros, ByOwnBits };

/// The colour after it was kept in 16 bits: five of R, six of G, five of B.
Colour inHighColour(const Colour &colour, Widening widening)
{
    constexpr std::array<unsigned, 3> bits = {5, 6, 5};
    Colour result;
    for (std::size_t i = 0; i < 3; ++i) {
        const unsigned lost = 8 - bits[i];
        const unsigned kept = unsigned(colour.channels[i]) >> lost;
        const unsigned low = widening == Widening::ByOwnBits ? kept >> (bits[i] - lost) : 0;
        result.channels[i] = std::uint8_t(kept << lost | low);
    }
    return result;
}

void appendLevels(std::vector<PictureChange> &changes)
{
    const auto add = [&](const QString &name, Curve curve) {
        changes.push_back(
            {name, recolour([curve](const Colour &colour) { return mapped(colour, curve); }),
             u"levels"_s});
    };
    add(u"encoded as sRGB once too often"_s, levelOfLight);
    add(u"decoded from sRGB once too often"_s, linearLight);
    constexpr double gamma = 2.2;
    add(u"raised to the power 1/2.2"_s, [](double level) { return std::pow(level, 1 / gamma); });
    add(u"raised to the power 2.2"_s, [](double level) { return std::pow(level, gamma); });
    const auto addGray = [&](const QString &name, int (*level)(int red, int green, int blue),
                             const QString &sentence) {
        const auto gray = [level](const Colour &colour) {
            const auto &[red, green, blue] = colour.channels;
            const auto each = std::uint8_t(level(red, green, blue));
            return Colour{{each, each, each}};
        };
        changes.push_back({name, recolour(gray), u"levels"_s, false, sentence});
    };
    addGray(u"gray of the mean of R G B"_s,
            [](int red, int green, int blue) { return (red + green + blue) / 3; }, {});
    addGray(
        u"gray of the luma of R G B"_s,
        [](int red, int green, int blue) {
            // 0.299, 0.587 and 0.114 in whole 65536ths, as in Pillow's convert("L").
            return (19595 * red + 38470 * green + 7471 * blue + 32768) / 65536;
        },
        u"Done to the whole picture: gray of 0.299 R + 0.587 G + 0.114 B."_s);
    const auto addBits = [&](const QString &name, Widening widening) {
        changes.push_back({name, recolour([widening](const Colour &colour) {
                               return inHighColour(colour, widening);
                           }),
                           u"levels"_s});
    };
    addBits(u"cut to 5-6-5 bits"_s, Widening::ByZeros);
    addBits(u"cut to 5-6-5 bits and widened to all levels"_s, Widening::ByOwnBits);
}

PictureChange ofBackground(const QString &name, const Colour &colour)
{
    return {
        name, ruleOf([colour](const Picture &expected, int x, int line, const Colour &) {
            const std::size_t place = expected.placeOf(x, line);
            // What is covered is not the scene's background.
            return ChangedPixel{expected.covered[place] == 0 ? colour : expected.colours[place], 1};
        }),
        u"background"_s};
}

constexpr Colour blackFrame{{0, 0, 0}};
constexpr Colour whiteFrame{{255, 255, 255}};

/// Changes for a frame filled with another colour than the scene's before anything was drawn.
void appendBackgrounds(const Colour &background, std::vector<PictureChange> &changes)
{
    for (const Colour &colour : {blackFrame, whiteFrame}) {
        if (colour != background)
            changes.push_back(ofBackground(u"drawn on "_s + nameOf(colour), colour));
    }
}

/// The change that draws only a mask.
void appendMask(std::vector<PictureChange> &changes)
{
    changes.push_back(
        {u"drawn in white alone"_s,
         ruleOf([](const Picture &expected, int x, int line, const Colour &) {
             const std::size_t place = expected.placeOf(x, line);
             const std::uint8_t covered = expected.covered[place];
             return ChangedPixel{covered != 0 ? whiteFrame : expected.colours[place], covered};
         }),
         u"mask"_s});
}

} // namespace

Picture changed(const Picture &expected, const PixelRule &rule, const Colour &background)
{
    Picture picture = expected;
    std::size_t place = 0;
    std::vector<ChangedPixel> pixels(std::size_t(expected.width));
    for (int line = 0; line < expected.height; ++line) {
        rule(expected, 0, line, background, pixels);
        for (const ChangedPixel &pixel : pixels) {
            picture.colours[place] = pixel.colour;
            picture.covered[place++] = pixel.covered;
        }
    }
    return picture;
}

QString nameOf(const Colour &colour)
{
    if (colour == blackFrame)
        return u"black"_s;
    if (colour == whiteFrame)
        return u"white"_s;
    const auto &[red, green, blue] = colour.channels;
    return u"(%1, %2, %3)"_s.arg(red).arg(green).arg(blue);
}

std::vector<PictureChange> pictureChangesFor(const Picture &expected, const Colour &background)
{
    std::vector<PictureChange> changes = placeChangesFor(expected);
    if (!expected.hasColours)
        return changes;
    appendChannels(changes);
    appendLevels(changes);
    appendMask(changes);
    appendBackgrounds(background, changes);
    return changes;
}

std::optional<Colour> otherBackgroundIn(const Picture &found, const Picture &expected,
                                        const Colour &background)
{
    if (!found.hasColours)
        return std::nullopt;
    std::map<std::array<std::uint8_t, 3>, std::size_t> counts;
    std::size_t bare = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (expected.covered[i] != 0)
            continue;
        ++bare;
        ++counts[found.colours[i].channels];
    }
    const auto most = std::ranges::max_element(
        counts, {}, [](const auto &colourCount) { return colourCount.second; });
    if (most == counts.end() || 2 * most->second < bare)
        return std::nullopt;
    const Colour other{most->first};
    const bool isOther = other != background && other != blackFrame && other != whiteFrame
        && 8 * counts[background.channels] <= bare;
    return isOther ? std::optional(other) : std::nullopt;
}

PictureChange drawnOn(const Colour &other, const QString &right)
{
    return ofBackground(u"drawn on %1 in place of %2"_s.arg(nameOf(other), right), other);
}

} // namespace pixelplumb
