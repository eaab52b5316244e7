// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace pixelplumb {

class DisplayOptions;
class Playhead;

/// The largest frame that a figure shows; a larger one would be a file that no viewer opens.
inline constexpr int largestSvgArea = 1 << 18;

/// The frame at the playhead's position as a figure for print: its cells, runs of one colour in a
/// row as one rectangle, with the grid, the true outlines, the column in hand with y_B and y_T, and
/// the differences, where the options show them. The playhead must have a run, of a frame no larger
/// than largestSvgArea. A caption stands in a corner and describes the file. The same state gives
/// the same bytes.
QByteArray svgFigure(const Playhead &playhead, const DisplayOptions &options,
                     const QString &caption = {});

/// Writes the figure. Empty when it is written, else why it could not be.
QString exportSvg(const QString &path, const Playhead &playhead, const DisplayOptions &options,
                  const QString &caption = {});

} // namespace pixelplumb
