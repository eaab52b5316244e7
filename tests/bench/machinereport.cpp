// SPDX-License-Identifier: GPL-3.0-or-later
#include "machinereport.h"

#include <QFile>

#include <unistd.h>

namespace pixelplumb::bench {

using namespace Qt::StringLiterals;

namespace {

/// The value of a line "key: 12 kB" in the system's status of this process.
std::int64_t bytesOf(const QByteArray &key)
{
    QFile file(u"/proc/self/status"_s);
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
    lines << u"- %1, %2 processors, %3"_s.arg(machine.processor)
                 .arg(machine.processors)
                 .arg(machine.caches.join(u", "_s));
    lines << u"- governor %1, load average %2 before this began"_s
                 .arg(machine.governor.isEmpty() ? u"not told by the system"_s : machine.governor)
                 .arg(machine.load, 0, 'f', 2);
    lines << u"- %1, %2 %3, %4"_s.arg(machine.system, machine.compiler, machine.flags,
                                      machine.buildType);
    for (const QString &warning : warningsOf(machine))
        lines << u"- **%1**"_s.arg(warning);
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

std::int64_t installedMemory()
{
    return std::int64_t(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
}

bool resetPeakMemory()
{
    QFile file(u"/proc/self/clear_refs"_s);
    return file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) && file.write("5") == 1;
}

std::int64_t peakMemory() { return bytesOf("VmHWM"); }

std::int64_t memoryInUse() { return bytesOf("VmRSS"); }

} // namespace pixelplumb::bench
