// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.h"

#include <QFile>
#include <QJsonArray>
#include <QSysInfo>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

namespace pixelplumb::bench {

namespace {

/// More than this runs beside us before we begin: others share processors, caches and memory.
constexpr double quietLoad = 0.5;

QByteArray contentOf(const char *path)
{
    QFile file(QString::fromLatin1(path));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// What stands behind "key:" in a file of lines "key : value"; empty without such a line.
QByteArray valueOf(const char *path, const QByteArray &key)
{
    for (const QByteArray &line : contentOf(path).split('\n')) {
        const qsizetype colon = line.indexOf(':');
        if (colon > 0 && line.left(colon).trimmed() == key)
            return line.mid(colon + 1).trimmed();
    }
    return {};
}

std::int64_t kibibytesOf(const char *path, const QByteArray &key)
{
    return valueOf(path, key).split(' ').first().toLongLong() * 1024;
}

} // namespace

QStringList Machine::warnings() const
{
    QStringList warnings;
    if (load > quietLoad) {
        warnings << QStringLiteral("Other programs were running when this began (load average %1). "
                                   "Trust the ratios, which are taken within a round, more than "
                                   "the times, and nothing closer than 20 %.")
                        .arg(load, 0, 'f', 2);
    }
    if (!governor.isEmpty() && governor != QLatin1String("performance")) {
        warnings << QStringLiteral("The processor changes its clock by itself (governor %1).")
                        .arg(governor);
    }
    if (buildType != QLatin1String("Release"))
        warnings << QStringLiteral("This is a %1 build: its times say nothing.").arg(buildType);
    return warnings;
}

Machine thisMachine()
{
    const benchmark::CPUInfo &info = benchmark::CPUInfo::Get();
    Machine machine;
    machine.processor = QString::fromLatin1(valueOf("/proc/cpuinfo", "model name"));
    machine.processors = info.num_cpus;
    for (const benchmark::CPUInfo::CacheInfo &cache : info.caches) {
        machine.caches << QStringLiteral("L%1%2 %3 KiB")
                              .arg(cache.level)
                              .arg(cache.type == "Data"              ? QStringLiteral("d")
                                       : cache.type == "Instruction" ? QStringLiteral("i")
                                                                     : QString())
                              .arg(cache.size / 1024);
    }
    machine.governor = QString::fromLatin1(
        contentOf("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor").trimmed());
    machine.system
        = QSysInfo::prettyProductName() + QStringLiteral(", kernel ") + QSysInfo::kernelVersion();
#ifdef __clang__
    machine.compiler = QStringLiteral("clang %1.%2").arg(__clang_major__).arg(__clang_minor__);
#else
    machine.compiler = QStringLiteral("g++ %1.%2").arg(__GNUC__).arg(__GNUC_MINOR__);
#endif
    machine.buildType = QStringLiteral(PIXELPLUMB_BENCH_BUILD_TYPE);
    machine.load = loadNow();
    return machine;
}

QString markdown(const Machine &machine)
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
    lines
        << QStringLiteral("- %1, %2, %3").arg(machine.system, machine.compiler, machine.buildType);
    for (const QString &warning : machine.warnings())
        lines << QStringLiteral("- **%1**").arg(warning);
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

QJsonObject json(const Machine &machine)
{
    return {{QStringLiteral("processor"), machine.processor},
            {QStringLiteral("processors"), machine.processors},
            {QStringLiteral("caches"), QJsonArray::fromStringList(machine.caches)},
            {QStringLiteral("governor"), machine.governor},
            {QStringLiteral("system"), machine.system},
            {QStringLiteral("compiler"), machine.compiler},
            {QStringLiteral("buildType"), machine.buildType},
            {QStringLiteral("loadBefore"), machine.load},
            {QStringLiteral("warnings"), QJsonArray::fromStringList(machine.warnings())}};
}

double loadNow()
{
    std::array<double, 1> load = {};
    return getloadavg(load.data(), 1) == 1 ? load[0] : 0;
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

std::int64_t peakMemory() { return kibibytesOf("/proc/self/status", "VmHWM"); }

std::int64_t memoryInUse() { return kibibytesOf("/proc/self/status", "VmRSS"); }

} // namespace pixelplumb::bench
