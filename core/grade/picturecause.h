// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"

#include <functional>

namespace pixelplumb {

/// Something that a program may have done to its whole picture, background and all.
struct PictureChange {
    QString name;
    std::function<Picture(const Picture &expected)> apply;
    QString kind; ///< two of one kind are a third one: "shift", "flip", "stride", …
    bool isFar = false; ///< a shift by more than 1 px
};

/// Of pictures like the expected one in size and in whether they have colours: shifts by up to 4 px
/// each way, flips, rows stored a pixel too far apart or too near, the two coordinates exchanged
/// (where the frame is square), channels exchanged, the two ways between linear and sRGB levels,
/// all that is drawn in white alone, and white or black for the background.
std::vector<PictureChange> pictureChangesFor(const Picture &expected, const Colour &background);

} // namespace pixelplumb
