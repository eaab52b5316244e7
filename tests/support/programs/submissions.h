// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/grader.h"

#include <QByteArray>
#include <QMap>

/// Shared helpers of the grading tests: folders of submissions as students hand them in.
namespace pixelplumb {

/// The assignment in resources/assignments.
Assignment exampleAssignment();
/// The defects that its first scene can have and that are searched in pairs.
std::vector<Defect> defectsOf(const Assignment &assignment);

bool writeTo(const QString &path, const QByteArray &content);
QByteArray contentOf(const QString &path);
/// All files below a folder, with their contents.
QMap<QString, QByteArray> filesIn(const QString &folder);

/// Writes what a program with these defects draws of each scene, as PNG files.
bool deliver(const QString &folder, const Assignment &assignment,
             const std::vector<Defect> &defects = {});

} // namespace pixelplumb
