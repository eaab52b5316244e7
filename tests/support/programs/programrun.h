// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>

/// Shared helpers of the command-line tests: the headless program, run as a user would.
namespace pixelplumb {

using namespace Qt::StringLiterals;

/// The exit code and output of a run of the program.
struct ProgramRun {
    int exitCode = -1;
    QByteArray output;
    QByteArray messages;
};

/// The paths of the program and of a scene in resources/scenes.
QString program();
QString sceneFile(const QString &name);

ProgramRun run(const QStringList &arguments, const QByteArray &input = {});

/// The default scene's file.
inline QString defaultScene() { return sceneFile(u"default.json"_s); }
/// A scene whose triangle covers a whole frame of this size.
QByteArray sceneOfSize(int width, int height);

} // namespace pixelplumb
