// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>
#include <QStringList>

namespace pixelplumb::bench {

/// Where the figures come from: without it they mean nothing.
struct Machine {
    QString processor;
    int processors = 0;
    QStringList caches; ///< "L1d 32 KiB", one per instance
    QString governor; ///< of the first processor's clock; empty where the system does not tell
    QString system;
    QString compiler;
    QString buildType;
    double load = 0; ///< processes that ran or waited over the last minute, before we began

    /// Sentences about what makes the figures worse than they could be.
    QStringList warnings() const;
};

Machine thisMachine();

/// Lines of a list, warnings in bold.
QString markdown(const Machine &machine);
QJsonObject json(const Machine &machine);

/// Processes that ran or waited over the last minute; ours among them.
double loadNow();

/// Bytes of memory in the machine.
std::int64_t installedMemory();

/// Forgets the process's greatest memory use up to now; false where the system does not allow it.
bool resetPeakMemory();
/// Bytes, the greatest since the last reset.
std::int64_t peakMemory();
/// Bytes in use now.
std::int64_t memoryInUse();

} // namespace pixelplumb::bench
