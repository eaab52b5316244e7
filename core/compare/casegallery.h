// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/hardcase.h"
#include "core/methods/method.h"
#include "core/scene/scene.h"

namespace pixelplumb {

/// A hard case with the explanations shown to a person.
struct GalleryCase {
    HardCase hardCase;
    QString family; ///< "tie"; where the file gives none, the kind's name
    QStringList failsIn; ///< what gets it wrong, according to the file
    QString note; ///< from the file; may be empty
    QString why; ///< two sentences: why methods go wrong here
};

/// Reads a file of hard cases (see readHardCases) with its families and remarks. Cases whose
/// coordinates are refused have no picture and are left out.
Result<std::vector<GalleryCase>> readGallery(const QByteArray &text);

/// Two sentences on why cases of a family go wrong.
QString whyOf(const QString &family);

/// The case as a scene under a method's settings: its canvas and its triangles or shapes. A
/// sequence gives its first frame and a motion, a translation its unmoved triangle. The method is
/// the given one if it draws the case, else the first that does.
Scene sceneOf(const HardCase &hardCase, const Method &method, const ScanSettings &settings);

} // namespace pixelplumb
