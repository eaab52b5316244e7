// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/programuser.h"

#include "core/grade/try/processtime.h"

#include <linux/capability.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// Whether this process has the capability.
bool hasCapability(int capability)
{
    const QByteArray status = procText(u"/proc/self/status"_s);
    const QByteArray key = "\nCapEff:";
    const QByteArray mask = status.mid(status.indexOf(key) + key.size()).trimmed().left(16);
    return (mask.toULongLong(nullptr, 16) >> capability & 1U) != 0;
}

/// False in a container that maps only some of the system's users: its root is not the system's.
bool canChangeUser()
{
    constexpr std::array needed = {CAP_SETUID, CAP_SETGID, CAP_SETPCAP, CAP_CHOWN};
    return geteuid() == 0 && std::ranges::all_of(needed, hasCapability)
        && procText(u"/proc/self/uid_map"_s).simplified() == "0 0 4294967295";
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
    const auto kept = hasCapability(CAP_DAC_READ_SEARCH) ? u"-all,+dac_read_search"_s : u"-all"_s;
    return {u"/usr/bin/setpriv"_s,
            u"--reuid=%1"_s.arg(id),
            u"--regid=%1"_s.arg(id),
            u"--clear-groups"_s,
            u"--inh-caps="_s + kept,
            u"--ambient-caps="_s + kept,
            u"--bounding-set="_s + kept,
            u"--securebits=+noroot,+noroot_locked"_s,
            u"--"_s};
}

QStringList ProgramUser::capabilities()
{
    QStringList names = {u"CAP_SETUID"_s, u"CAP_SETGID"_s, u"CAP_SETPCAP"_s};
    if (hasCapability(CAP_DAC_READ_SEARCH))
        names += u"CAP_DAC_READ_SEARCH"_s;
    if (hasCapability(CAP_DAC_OVERRIDE))
        names += u"CAP_DAC_OVERRIDE"_s;
    return names;
}

} // namespace pixelplumb
