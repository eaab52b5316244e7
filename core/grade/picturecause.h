// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"

#include <functional>
#include <optional>

namespace pixelplumb {

/// Something that a program may have done to its whole picture, background and all.
struct PictureChange {
    QString name; ///< as what the picture is: "shifted by 1 up"
    /// To any picture that is drawn on that background, which fills what a shift leaves empty.
    std::function<Picture(const Picture &expected, const Colour &background)> apply;
    QString kind; ///< two of one kind are a third one: "shift", "flip", "stride", …
    bool isFar = false; ///< a shift by more than 1 px
    QString sentence = {}; ///< what was done, where the name does not tell it all
};

/// Of pictures like the expected one in size and in whether they have colours: pixels in other
/// places (placeChangesFor), channels exchanged, the two ways between linear and sRGB levels,
/// gray of the mean or the luma, levels cut to 5-6-5 bits, all that is drawn in white alone, and
/// white or black for the background.
std::vector<PictureChange> pictureChangesFor(const Picture &expected, const Colour &background);

/// What most of the pixels have that are background where it is right, if that is neither this
/// background nor, which pictureChangesFor() knows, black or white, and hardly one has it right.
std::optional<Colour> otherBackgroundIn(const Picture &found, const Picture &expected,
                                        const Colour &background);
/// "black", "(64, 64, 64)".
QString nameOf(const Colour &colour);
/// "drawn on (64, 64, 64) in place of black", which is the name of the right background.
PictureChange drawnOn(const Colour &other, const QString &right);

} // namespace pixelplumb
