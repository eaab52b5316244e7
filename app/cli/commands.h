// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/compare/contest.h"
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/pictures/picturediff.h"
#include "core/lab/study/study.h"
#include "core/layers/affineimage.h"
#include "core/runs/explain/pixelhistory.h"
#include "core/scene/scene.h"

#include <QImage>
#include <QJsonObject>
#include <QStringList>

#include <span>

namespace pixelplumb::cli {

// One function per command, each in its own file.
ExitCode render(const Command &command, const QStringList &arguments);
ExitCode trace(const Command &command, const QStringList &arguments);
ExitCode pixel(const Command &command, const QStringList &arguments);
ExitCode listMethods(const Command &command, const QStringList &arguments);
ExitCode plan(const Command &command, const QStringList &arguments);
ExitCode check(const Command &command, const QStringList &arguments);
ExitCode diagnose(const Command &command, const QStringList &arguments);
ExitCode grade(const Command &command, const QStringList &arguments);
ExitCode invariants(const Command &command, const QStringList &arguments);
ExitCode counterExample(const Command &command, const QStringList &arguments);
ExitCode diff(const Command &command, const QStringList &arguments);
ExitCode tryProgram(const Command &command, const QStringList &arguments);
ExitCode motion(const Command &command, const QStringList &arguments);
ExitCode compare(const Command &command, const QStringList &arguments);
ExitCode lab(const Command &command, const QStringList &arguments);
ExitCode help(const Command &command, const QStringList &arguments);

// Reports that two commands print, and parts of commands in files of their own.

/// How many pixels have which verdict, and what would explain them.
QStringList diffLines(const PictureDiff &diff);
QJsonObject diffJson(const PictureDiff &diff);

/// The verdict and each set of defects, with the step at which its run departs from the right one.
QStringList diagnosisLines(const Diagnosis &diagnosis, std::span<const Submission> submissions);
QJsonObject diagnosisJson(const Diagnosis &diagnosis, std::span<const Submission> submissions);

/// A contest to report as text or as JSON, with the first `pixelLimit` differing pixels by columns.
struct CompareReport {
    const Contest &contest;
    std::size_t pixelLimit;
};

QStringList compareLines(const CompareReport &report);
QJsonObject compareJson(const CompareReport &report);

/// A study as readable text: warnings, a table per family, the costs of set-up, columns and pixels,
/// and the command that repeats it.
QStringList studyLines(const Study &study);

/// How much of a run is drawn, and which layers over it.
struct LayerRequest {
    QStringList layers; ///< ids
    std::optional<std::int64_t> position; ///< how many steps are done; none: all
    std::optional<std::int64_t> primitive; ///< that the layers describe; none: the current one
    std::optional<Corners> affineImage; ///< of the layer affine-map; none: its first map

    /// Whether the finished picture alone is not enough.
    bool asksForRun() const { return position || !layers.isEmpty(); }
};

/// --layers, --position, --triangle and --affine-image.
void addLayerOptions(CommandLine &line);
LayerRequest layerRequestFrom(const CommandLine &line);

/// The picture at the position, each pixel a square of `scale` pixels a side, with the layers over
/// it. Texts that belong to the layers, and why one shows nothing, go to stderr.
QImage pictureWithLayers(const SceneRun &run, const LayerRequest &request, std::int64_t scale);

/// The history of one pixel, to report as text or as JSON.
struct PixelReport {
    const TracedScene &traced;
    std::int64_t x = 0;
    std::int64_t y = 0;
    BriefPixelHistory history; ///< in JSON with all attempts
    Colour colour; ///< in the finished picture
    Colour truth; ///< from the primitives that the method draws
    Colour truthOfAll; ///< from all primitives of the scene
    QStringList undrawn; ///< the primitives at the pixel that the method does not draw
};

QStringList pixelLines(const PixelReport &report);
QJsonObject pixelJson(const PixelReport &report);

} // namespace pixelplumb::cli
