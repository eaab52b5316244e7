// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QString>

#include <optional>

namespace pixelplumb {

struct TracedScene;

/// The pixel that is written next behind a position, and why. Where the span in hand is one pixel
/// that its own numbers tell, that of the span behind it.
struct NextPixel {
    QPoint pixel;
    QString reason;
    std::size_t step = 0; ///< index of the step that writes it
};
std::optional<NextPixel> nextPixelAfter(const TracedScene &traced, std::size_t position);
/// Why another pixel than that is not the next one: it lies off the frame, has been drawn, comes
/// later, or the primitive does not own it. Empty where no pixel follows.
QString wrongPixelText(const TracedScene &traced, std::size_t position, const QPoint &pixel);

} // namespace pixelplumb
