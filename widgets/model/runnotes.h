// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/scene/scenefile.h"

#include <QString>

#include <vector>

namespace pixelplumb {

struct Method;
struct ScanSettings;
struct Scene;
struct TracedScene;

// Texts of the message bar for a scene or a run that is not what a person expects.

/// How far coordinates that were not on the lattice were moved: an input error, reported once.
QString snapNote(const SnapReports &snaps);

/// Which primitives the kernel drew nothing of, with the reason for the first; empty where there
/// are none. Primitives outside the frame, where that is obvious, and a scene of another method's
/// kinds (see foreignSceneHint()) do not count.
QString rejectionNote(const TracedScene &traced);

/// Which of the requested settings the method does not support, and what it uses instead; empty
/// where it supports them all.
QString adaptationNote(const Method &method, const ScanSettings &asked);

/// The core's text about methods in the window's words: titles in place of ids.
QString withTitles(const QString &text);
/// An objection (objectionTo) with the method's title: "Column scan draws no circles."
QString objectionNote(const Method &method, const QString &objection);

/// How far the finished picture is from the truth; empty where nothing is drawn, and for a
/// recording that ended at a limit.
QString verdictNote(const TracedScene &traced);

QString cutRunNote(const TracedScene &traced); ///< its recording ended at a limit
QString cancelledRunNote();

enum class FrameContent { Empty, Drawn };

/// What the next click on the canvas does: shown while a primitive is incomplete, and in an empty
/// frame.
QString placingHint(PrimitiveKind kind, std::size_t pendingVertices, FrameContent content);

/// Shown where the scene's method draws none of its primitives: what the method draws, and which
/// method draws these; or that all are hidden. Empty where it draws one, and for an empty scene.
QString foreignSceneHint(const Scene &scene);

/// Why a run has no steps to show, and what to do about it; without a run, that it is being traced.
QString emptyRunText(const TracedScene *traced);

} // namespace pixelplumb
