// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/coordinatetext.h"
#include "core/scene/scene.h"

#include <functional>
#include <vector>

namespace pixelplumb {

/// The format that this program writes, and the newest that it reads.
inline constexpr int sceneFormat = 1;

/// A coordinate of a file that was not on the lattice. Its displacement is an error of the input,
/// never of a method.
struct SnapReport {
    QString place; ///< "primitives[0].triangle[1][0]"
    QString written; ///< as the file says it
    SnappedCoordinate snapped;

    /// "primitives[0].triangle[1][0]: 12.1 is drawn at 1549/128, displaced by 1/640 px"
    QString message() const;
};

/// A scene file as it was read.
struct SceneReading {
    Scene scene;
    std::vector<SnapReport> snaps;
};

/// Company of a reading.
struct ReadOptions {
    /// Called now and then with how many of the text's bytes are read, while a large text is read
    /// piece by piece; returning false ends the reading with an error that says so.
    std::function<bool(qsizetype bytesRead, qsizetype bytes)> progress;
};

/// Reads a scene in JSON: "pixelplumb", "frame" with "width" and "height", and "primitives" must be
/// there; everything else has a default: the method is the first that draws the first primitive,
/// arithmetic and fill rule are exact and closed, or the method's first where it keeps neither.
/// Unknown and repeated keys are errors.
Result<SceneReading> readScene(const QByteArray &text, const ReadOptions &options = {});
Result<SceneReading> readSceneFile(const QString &path, const ReadOptions &options = {});

/// Texts that are larger are read piece by piece.
inline constexpr qsizetype largestWholeText = qsizetype(1) << 20; // bytes

/// The same scene gives the same bytes, whatever the locale.
QByteArray writeScene(const Scene &scene);
std::optional<InputError> writeSceneFile(const QString &path, const Scene &scene);

} // namespace pixelplumb
