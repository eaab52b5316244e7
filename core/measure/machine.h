// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace pixelplumb {

/// The machine behind the figures: without it times mean nothing.
struct MachineConditions {
    QString processor;
    int processors = 0;
    QStringList caches; ///< "L1d 32 KiB", one per level and kind, of the first processor
    QString governor; ///< of the first processor's clock; empty if the system does not say
    QString system;
    QString compiler; ///< "g++ 12.2"
    QString flags; ///< of this build's optimiser: "-O3 -DNDEBUG"
    QString buildType; ///< "Release"
    QStringList sanitizers; ///< "address"; none in a build meant for timing
    QString instructionSet; ///< what the fast kernels use: "avx2"
    double load = 0; ///< processes that ran or waited over the last minute, before we began

    friend bool operator==(const MachineConditions &, const MachineConditions &) = default;
};

MachineConditions thisMachine();

/// Sentences about what makes the figures worse than they could be: other load, a clock that
/// changes by itself, a build that is not optimised, sanitizers.
QStringList warningsOf(const MachineConditions &conditions);

/// "Xeon, 2 processors, g++ 12.2 -O3 -DNDEBUG, Release, avx2": for the foot of a chart.
QString summaryOf(const MachineConditions &conditions);

/// Processes that ran or waited over the last minute; ours among them.
double loadNow();

} // namespace pixelplumb
