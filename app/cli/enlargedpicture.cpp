// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/enlargedpicture.h"

#include "core/frame/framespec.h"

namespace pixelplumb::cli {

Result<QImage> enlarged(const QImage &picture, std::int64_t scale)
{
    const std::int64_t pixels = picture.width() * scale * picture.height() * scale;
    if (pixels > largestFrameArea)
        return InputError{QStringLiteral("--scale"),
                          QStringLiteral("%1 × %2 pixels, %3 times as many each way")
                              .arg(picture.width())
                              .arg(picture.height())
                              .arg(scale),
                          QStringLiteral("at most %1 pixels").arg(largestFrameArea)};
    return scale == 1 ? picture : picture.scaled(picture.size() * int(scale));
}

} // namespace pixelplumb::cli
