// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programs/programrun.h"

#include "tests/support/sourcetree.h"

#include <QProcess>

#include <chrono>

namespace pixelplumb {

namespace {

// Several times the longest run with sanitizers on a busy machine. Without sanitizers, the limit of
// 5 minutes for a test function ends a run that hangs.
constexpr auto longestRun = std::chrono::minutes(15);

} // namespace

QString program() { return QStringLiteral(PIXELPLUMB_CLI); }

QString sceneFile(const QString &name) { return resource(u"/scenes/"_s) + name; }

ProgramRun run(const QStringList &arguments, const QByteArray &input)
{
    QProcess process;
    process.start(program(), arguments);
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(int(std::chrono::milliseconds(longestRun).count()))
        || process.exitStatus() != QProcess::NormalExit)
        return {-1, {}, "did not end by itself"};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

QByteArray sceneOfSize(int width, int height)
{
    return "{ \"pixelplumb\": 1, \"frame\": { \"width\": " + QByteArray::number(width)
        + ", \"height\": " + QByteArray::number(height) + " }, \"primitives\": [ { \"triangle\": "
        + "[[-5, -5], [90000, 0], [0, 90000]], \"colors\": [\"#ff0000\", \"#00ff00\", \"#0000ff\"] "
          "} ] }";
}

} // namespace pixelplumb
