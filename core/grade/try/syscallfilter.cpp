// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/syscallfilter.h"

#include "core/grade/descriptor.h"

#include <QFile>

#include <linux/sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/socket.h>

#include <cerrno>
#include <memory>

namespace pixelplumb {

namespace {

class FilterRules {
public:
    bool areThere() const { return m_rules != nullptr; }

    void deny(int call, int error) { add(call, error, nullptr, 0); }
    void denyWhere(int call, int error, const scmp_arg_cmp &argument)
    {
        add(call, error, &argument, 1);
    }
    QByteArray program() const
    {
        const Descriptor made(memfd_create("filter", MFD_CLOEXEC));
        QFile file;
        const bool isWritten = !m_hasFailed && seccomp_export_bpf(m_rules.get(), made.number()) == 0
            && lseek(made.number(), 0, SEEK_SET) == 0
            && file.open(made.number(), QIODevice::ReadOnly);
        return isWritten ? file.readAll() : QByteArray();
    }

private:
    void add(int call, int error, const scmp_arg_cmp *arguments, unsigned count)
    {
        const bool isKnown = call != __NR_SCMP_ERROR; // to this libseccomp
        if (isKnown
            && seccomp_rule_add_array(m_rules.get(), SCMP_ACT_ERRNO(std::uint32_t(error)), call,
                                      count, arguments)
                != 0)
            m_hasFailed = true;
    }

    struct Release {
        void operator()(void *rules) const { seccomp_release(rules); }
    };
    std::unique_ptr<void, Release> m_rules{seccomp_init(SCMP_ACT_ALLOW)};
    bool m_hasFailed = false;
};

/// Memory outside every process's limit; programs that can do without fall back at ENOSYS.
void denySharedMemory(FilterRules &rules)
{
    for (const char *call : {"memfd_create", "memfd_secret", "io_uring_setup"})
        rules.deny(seccomp_syscall_resolve_name(call), ENOSYS);
    // A page that vmsplice() has given to a pipe keeps the huge page of which it is a part.
    for (const char *call : {"shmget", "msgget", "semget", "mq_open", "vmsplice"})
        rules.deny(seccomp_syscall_resolve_name(call), EPERM);
    // A file in memory holds megabytes of attributes, which its file system does not count.
    for (const char *call : {"setxattr", "lsetxattr", "fsetxattr"})
        rules.deny(seccomp_syscall_resolve_name(call), EOPNOTSUPP);
}

/// A condition on a call's argument, counted from 0. The macros of seccomp.h are C only.
scmp_arg_cmp argument(unsigned place, scmp_compare comparison, scmp_datum_t datum,
                      scmp_datum_t second = 0)
{
    return {place, comparison, datum, second};
}

/// Whoever makes a user namespace may mount and create network devices in it.
void denyNamespaces(FilterRules &rules)
{
    rules.deny(SCMP_SYS(clone3), ENOSYS); // its flags are in memory; clone has them in a register
    for (const int call : {SCMP_SYS(clone), SCMP_SYS(unshare)})
        rules.denyWhere(call, EPERM, argument(0, SCMP_CMP_MASKED_EQ, CLONE_NEWUSER, CLONE_NEWUSER));
    for (const char *call : {"setns", "mount", "umount2", "pivot_root", "fsopen", "move_mount",
                             "open_tree", "mount_setattr"})
        rules.deny(seccomp_syscall_resolve_name(call), EPERM);
}

/// What no namespace separates: files by number instead of by path, keys, processor counters,
/// protocols such as those between virtual machines.
void denyShared(FilterRules &rules)
{
    for (const char *call :
         {"open_by_handle_at", "name_to_handle_at", "add_key", "request_key", "keyctl",
          "perf_event_open", "bpf", "userfaultfd", "fanotify_init", "syslog", "quotactl", "acct"})
        rules.deny(seccomp_syscall_resolve_name(call), EPERM);
    constexpr int lastDomain = 63;
    for (int domain = 0; domain <= lastDomain; ++domain) {
        const bool isSeparate
            = domain == AF_UNIX || domain == AF_INET || domain == AF_INET6 || domain == AF_NETLINK;
        if (!isSeparate)
            rules.denyWhere(SCMP_SYS(socket), EAFNOSUPPORT,
                            argument(0, SCMP_CMP_EQ, unsigned(domain)));
    }
    rules.denyWhere(SCMP_SYS(socket), EAFNOSUPPORT, argument(0, SCMP_CMP_GT, unsigned(lastDomain)));
}

/// What this program does not know: a newer kernel may do by another number what is denied above.
void denyNewerCalls(FilterRules &rules)
{
    constexpr int firstUnknown = 450; // after futex_waitv, of Linux 5.16
    constexpr int lastDenied = 1023;
    for (int call = firstUnknown; call <= lastDenied; ++call)
        rules.deny(call, ENOSYS);
}

/// Without a process namespace, a signal to all would end whoever started the program.
void denyDisturbing(FilterRules &rules)
{
    rules.denyWhere(SCMP_SYS(kill), EPERM, argument(0, SCMP_CMP_EQ, ~0U));
    constexpr unsigned consoleInput = 0x541C; // TIOCLINUX: pastes into a console
    for (const unsigned request : {unsigned(TIOCSTI), consoleInput})
        rules.denyWhere(SCMP_SYS(ioctl), EPERM, argument(1, SCMP_CMP_EQ, request));
}

QByteArray makeFilter()
{
    FilterRules rules;
    if (!rules.areThere())
        return {};
    denySharedMemory(rules);
    denyNamespaces(rules);
    denyShared(rules);
    denyDisturbing(rules);
    denyNewerCalls(rules);
    return rules.program();
}

} // namespace

const QByteArray &syscallFilter()
{
    static const QByteArray filter = makeFilter();
    return filter;
}

} // namespace pixelplumb
