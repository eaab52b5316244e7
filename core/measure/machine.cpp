// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/machine.h"

#include "core/fast/instructionset.h"

#include <QDir>
#include <QFile>
#include <QSysInfo>

#include <array>
#include <cstdlib>
#include <thread>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// If more than this runs besides us before we begin, it shares processors, caches and memory.
constexpr double quietLoad = 0.5;

QString contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromLatin1(file.readAll()).trimmed()
                                          : QString();
}

/// The text after "key:" in a file of lines "key : value"; empty if there is no such line.
QString valueOf(const QString &path, const QString &key)
{
    const QStringList lines = contentOf(path).split(u'\n');
    for (const QString &line : lines) {
        const qsizetype colon = line.indexOf(u':');
        if (colon > 0 && line.left(colon).trimmed() == key)
            return line.mid(colon + 1).trimmed();
    }
    return {};
}

QStringList cachesOfFirstProcessor()
{
    const QString folder = "/sys/devices/system/cpu/cpu0/cache/";
    QStringList caches;
    const QStringList entries = QDir(folder).entryList({"index*"}, QDir::Dirs);
    for (const QString &entry : entries) {
        const QString place = folder + entry + u'/';
        const QString type = contentOf(place + u"type"_s);
        QString size = contentOf(place + u"size"_s);
        if (size.endsWith(u'K'))
            size = size.chopped(1) + u" KiB"_s;
        caches.append(u"L%1%2 %3"_s.arg(contentOf(place + u"level"_s),
                                        type == QLatin1String("Data")              ? u"d"_s
                                            : type == QLatin1String("Instruction") ? u"i"_s
                                                                                   : QString(),
                                        size));
    }
    return caches;
}

QString compilerName()
{
#ifdef __clang__
    return u"clang %1.%2"_s.arg(__clang_major__).arg(__clang_minor__);
#else
    return u"g++ %1.%2"_s.arg(__GNUC__).arg(__GNUC_MINOR__);
#endif
}

} // namespace

MachineConditions thisMachine()
{
    MachineConditions machine;
    machine.processor = valueOf("/proc/cpuinfo", "model name");
    machine.processors = int(std::thread::hardware_concurrency());
    machine.caches = cachesOfFirstProcessor();
    machine.governor = contentOf("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
    machine.system = QSysInfo::prettyProductName() + u", kernel "_s + QSysInfo::kernelVersion();
    machine.compiler = compilerName();
    machine.flags = QStringLiteral(PIXELPLUMB_COMPILER_FLAGS).simplified();
    machine.buildType = QStringLiteral(PIXELPLUMB_BUILD_TYPE);
    machine.sanitizers = QStringLiteral(PIXELPLUMB_SANITIZERS).split(u',', Qt::SkipEmptyParts);
    const std::string_view set = nameOf(supportedInstructionSets().back());
    machine.instructionSet = QString::fromLatin1(set.data(), qsizetype(set.size()));
    machine.load = loadNow();
    return machine;
}

QStringList warningsOf(const MachineConditions &conditions)
{
    QStringList warnings;
    if (conditions.load > quietLoad) {
        warnings << u"Other programs were running when this began (load average %1). "
                    "Trust the ratios, which are taken within a round, more than "
                    "the times, and nothing closer than 20 %."_s.arg(conditions.load, 0, 'f', 2);
    }
    if (!conditions.governor.isEmpty() && conditions.governor != QLatin1String("performance")) {
        warnings << u"The processor changes its clock by itself (governor %1)."_s.arg(
            conditions.governor);
    }
    if (conditions.buildType != QLatin1String("Release")) {
        warnings << u"This is a %1 build: its times say nothing."_s.arg(conditions.buildType);
    } else if (!conditions.flags.contains(QLatin1String("-O2"))
               && !conditions.flags.contains(QLatin1String("-O3"))) {
        warnings << u"This build is hardly optimised (%1): its times say little."_s.arg(
            conditions.flags);
    }
    if (!conditions.sanitizers.isEmpty()) {
        warnings << u"This build has sanitizers (%1): its times say nothing."_s.arg(
            conditions.sanitizers.join(u", "_s));
    }
    return warnings;
}

QString summaryOf(const MachineConditions &conditions)
{
    return u"%1, %2 processors, %3 %4, %5, %6"_s.arg(conditions.processor)
        .arg(conditions.processors)
        .arg(conditions.compiler, conditions.flags, conditions.buildType,
             conditions.instructionSet);
}

double loadNow()
{
    std::array<double, 1> load = {};
    return getloadavg(load.data(), 1) == 1 ? load[0] : 0;
}

} // namespace pixelplumb
