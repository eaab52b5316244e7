// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/programuser.h"

#include "core/grade/try/processtime.h"

#include <linux/capability.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace pixelplumb {

namespace {

/// Whether this process has the capability.
bool hasCapability(int capability)
{
    const QByteArray status = procText(QStringLiteral("/proc/self/status"));
    const QByteArray key = "\nCapEff:";
    const QByteArray mask = status.mid(status.indexOf(key) + key.size()).trimmed().left(16);
    return (mask.toULongLong(nullptr, 16) >> capability & 1U) != 0;
}

/// False in a container that maps only some of the system's users: its root is not the system's.
bool canChangeUser()
{
    constexpr std::array needed = {CAP_SETUID, CAP_SETGID, CAP_SETPCAP, CAP_CHOWN};
    return geteuid() == 0 && std::ranges::all_of(needed, hasCapability)
        && procText(QStringLiteral("/proc/self/uid_map")).simplified() == "0 0 4294967295";
}

} // namespace

ProgramUser ProgramUser::ofNextRun()
{
    static std::atomic<uid_t> runs = 0;
    constexpr uid_t first = 1'000'000'000; // far from those that systems assign
    constexpr uid_t each = 1000; // for one process that runs programs
    constexpr pid_t processes = 1'000'000;
    if (!canChangeUser())
        return {geteuid(), false};
    return {first + uid_t(getpid() % processes) * each + runs++ % each, true};
}

QStringList ProgramUser::command() const
{
    if (!isOwn)
        return {};
    const auto kept = hasCapability(CAP_DAC_READ_SEARCH) ? QStringLiteral("-all,+dac_read_search")
                                                         : QStringLiteral("-all");
    return {QStringLiteral("/usr/bin/setpriv"),
            QStringLiteral("--reuid=%1").arg(id),
            QStringLiteral("--regid=%1").arg(id),
            QStringLiteral("--clear-groups"),
            QStringLiteral("--inh-caps=") + kept,
            QStringLiteral("--ambient-caps=") + kept,
            QStringLiteral("--bounding-set=") + kept,
            QStringLiteral("--securebits=+noroot,+noroot_locked"),
            QStringLiteral("--")};
}

QStringList ProgramUser::capabilities()
{
    QStringList names = {QStringLiteral("CAP_SETUID"), QStringLiteral("CAP_SETGID"),
                         QStringLiteral("CAP_SETPCAP")};
    if (hasCapability(CAP_DAC_READ_SEARCH))
        names += QStringLiteral("CAP_DAC_READ_SEARCH");
    if (hasCapability(CAP_DAC_OVERRIDE))
        names += QStringLiteral("CAP_DAC_OVERRIDE");
    return names;
}

} // namespace pixelplumb
