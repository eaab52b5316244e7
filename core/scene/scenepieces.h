// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QByteArrayView>

#include <optional>
#include <vector>

namespace pixelplumb {

/// A scene's text with the elements of its "primitives" apart, so that a scene of a million
/// triangles is never in memory as a whole JSON document. Nothing is judged here: a text whose
/// structure is not plain to see gives none, and is then read as a whole, which finds what is wrong
/// with it.
struct ScenePieces {
    QByteArray frame; ///< the text with an empty array of primitives
    qsizetype gapAt = 0; ///< the byte of `frame` from which on it is the text, …
    qsizetype gap = 0; ///< … so many bytes later
    std::vector<QByteArrayView> primitives; ///< views of the text
};

std::optional<ScenePieces> piecesOf(const QByteArray &text);

} // namespace pixelplumb
