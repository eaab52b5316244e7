// SPDX-License-Identifier: GPL-3.0-or-later
#include "machinereport.h"

#include <QFile>

#include <unistd.h>

namespace pixelplumb::bench {

namespace {

/// The value of a line "key: 12 kB" in the system's status of this process.
std::int64_t bytesOf(const QByteArray &key)
{
    QFile file(QStringLiteral("/proc/self/status"));
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    const QList<QByteArray> lines = file.readAll().split('\n');
    for (const QByteArray &line : lines) {
        if (line.startsWith(key + ':'))
            return line.mid(key.size() + 1).trimmed().split(' ').first().toLongLong() * 1024;
    }
    return 0;
}

} // namespace

QString markdown(const MachineConditions &machine)
{
    QStringList lines;
    lines << QStringLiteral("- %1, %2 processors, %3")
                 .arg(machine.processor)
                 .arg(machine.processors)
                 .arg(machine.caches.join(QStringLiteral(", ")));
    lines << QStringLiteral("- governor %1, load average %2 before this began")
                 .arg(machine.governor.isEmpty() ? QStringLiteral("not told by the system")
                                                 : machine.governor)
                 .arg(machine.load, 0, 'f', 2);
    lines << QStringLiteral("- %1, %2 %3, %4")
                 .arg(machine.system, machine.compiler, machine.flags, machine.buildType);
    for (const QString &warning : warningsOf(machine))
        lines << QStringLiteral("- **%1**").arg(warning);
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

std::int64_t installedMemory()
{
    return std::int64_t(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
}

bool resetPeakMemory()
{
    QFile file(QStringLiteral("/proc/self/clear_refs"));
    return file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) && file.write("5") == 1;
}

std::int64_t peakMemory() { return bytesOf("VmHWM"); }

std::int64_t memoryInUse() { return bytesOf("VmRSS"); }

} // namespace pixelplumb::bench
