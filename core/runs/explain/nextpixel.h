// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QString>

#include <optional>

namespace pixelplumb {

struct TracedScene;

/// The pixel that is written next after a position, and why. If the current span is one pixel that
/// its own numbers reveal, it is the next span's.
struct NextPixel {
    QPoint pixel;
    QString reason;
    std::size_t step = 0; ///< index of the step that writes it
};
std::optional<NextPixel> nextPixelAfter(const TracedScene &traced, std::size_t position);
/// Why a given pixel is not the next one: it lies outside the frame, has been drawn, comes later,
/// or the primitive does not own it. Empty if no pixel follows.
QString wrongPixelText(const TracedScene &traced, std::size_t position, const QPoint &pixel);

} // namespace pixelplumb
