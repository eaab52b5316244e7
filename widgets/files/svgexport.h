// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtCore>

namespace pixelplumb {

class DisplayOptions;
class Playhead;

/// The largest frame area that a figure shows, in pixels; viewers cannot open a larger file.
inline constexpr int largestSvgArea = 1 << 18;

/// The frame at the playhead's position as a figure for print: its cells (runs of one colour in a
/// row are one rectangle), the grid, the true outlines, the current column with y_B and y_T, and
/// the differences, where the options show them. The playhead must have a run, of a frame no larger
/// than largestSvgArea. A caption is drawn in a corner and describes the file. The same state gives
/// the same bytes.
QByteArray svgFigure(const Playhead &playhead, const DisplayOptions &options,
                     const QString &caption = {});

/// Writes the figure. Empty on success, else why it could not be written.
QString exportSvg(const QString &path, const Playhead &playhead, const DisplayOptions &options,
                  const QString &caption = {});

} // namespace pixelplumb
