// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>

/// What the tests of the command line share: the headless program, run as a person would.
namespace pixelplumb {

/// How a run of the program ended and what it said.
struct ProgramRun {
    int exitCode = -1;
    QByteArray output;
    QByteArray messages;
};

/// Where the program and a scene of resources/scenes are.
QString program();
QString sceneFile(const QString &name);

ProgramRun run(const QStringList &arguments, const QByteArray &input = {});

/// The default scene's file.
inline QString defaultScene() { return sceneFile(QStringLiteral("default.json")); }
/// A scene whose triangle covers all of a frame of this size.
QByteArray sceneOfSize(int width, int height);

} // namespace pixelplumb
