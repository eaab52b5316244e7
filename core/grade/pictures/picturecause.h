// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"

#include <functional>
#include <optional>
#include <span>

namespace pixelplumb {

/// A pixel of a changed picture.
struct ChangedPixel {
    Colour colour;
    std::uint8_t covered = 0;
};

/// The pixels that a change leaves from (x, line) on of any picture drawn on that background, which
/// fills what a shift leaves empty.
using PixelRule = std::function<void(const Picture &expected, int x, int line,
                                     const Colour &background, std::span<ChangedPixel> pixels)>;

/// The rule that has the pixel pixelAt(expected, x, line, background).
template <class PixelAt>
PixelRule ruleOf(const PixelAt &pixelAt)
{
    return [=](const Picture &expected, int x, int line, const Colour &background,
               std::span<ChangedPixel> pixels) {
        for (ChangedPixel &pixel : pixels)
            pixel = pixelAt(expected, x++, line, background);
    };
}

/// The whole picture after the change.
Picture changed(const Picture &expected, const PixelRule &rule, const Colour &background);

/// A change that a program may have made to its whole picture, including the background.
struct PictureChange {
    QString name; ///< describes the picture: "shifted by 1 up"
    PixelRule pixel;
    QString kind; ///< two changes of one kind make a third: "shift", "flip", "stride", …
    bool isFar = false; ///< a shift by more than 1 px
    QString sentence = {}; ///< what was done, where the name does not say it all
    bool movesPixels = false; ///< it takes them from other places
};

/// The changes of pictures that match the expected one in size and in having colours: pixels in
/// other places (placeChangesFor), channels exchanged, conversion between linear and sRGB levels in
/// both directions, gray by mean or luma, levels cut to 5-6-5 bits, everything drawn in white, and
/// a white or black background.
std::vector<PictureChange> pictureChangesFor(const Picture &expected, const Colour &background);

/// The colour of at least half of the pixels that should be background, if at most an eighth of
/// these are right; none if it is the right background, or black or white, which
/// pictureChangesFor() covers.
std::optional<Colour> otherBackgroundIn(const Picture &found, const Picture &expected,
                                        const Colour &background);
/// "black", "(64, 64, 64)".
QString nameOf(const Colour &colour);
/// "drawn on (64, 64, 64) in place of black"; `right` names the right background.
PictureChange drawnOn(const Colour &other, const QString &right);

} // namespace pixelplumb
