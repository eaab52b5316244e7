// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/grader.h"

#include <QByteArray>
#include <QMap>

/// What the tests of grading share: folders of submissions, as students deliver them.
namespace pixelplumb {

/// The assignment in resources/assignments.
Assignment exampleAssignment();
/// Those that its first scene can have and that are looked for in pairs.
std::vector<Defect> defectsOf(const Assignment &assignment);

bool writeTo(const QString &path, const QByteArray &content);
QByteArray contentOf(const QString &path);
/// All files below a folder with their bytes.
QMap<QString, QByteArray> filesIn(const QString &folder);

/// What a program with these defects draws of each scene, as PNG files.
bool deliver(const QString &folder, const Assignment &assignment,
             const std::vector<Defect> &defects = {});

} // namespace pixelplumb
