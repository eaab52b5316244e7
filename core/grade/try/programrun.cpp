// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/programrun.h"

#include "core/grade/descriptor.h"
#include "core/grade/try/processtime.h"
#include "core/grade/try/programclock.h"
#include "core/grade/try/programcommand.h"
#include "core/grade/try/programstart.h"
#include "core/grade/try/workingfolder.h"

#include <poll.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <memory>
#include <optional>

namespace pixelplumb {

namespace {

using Clock = ProgramClock::Clock;
using namespace std::chrono_literals;

constexpr qsizetype longestMessages = qsizetype(64) << 10;
constexpr int stopLookedFor = 50; // ms
constexpr auto longestEnding = std::chrono::seconds(10);

QString sentenceOf(const StudentRun &run, const ProgramLimits &limits)
{
    switch (run.end) {
    case ProgramEnd::Finished:
        return u"it finished"_s;
    case ProgramEnd::Failed:
        return u"it ended with exit code %1"_s.arg(run.code);
    case ProgramEnd::Crashed:
        return u"it crashed: %1 (signal %2)"_s.arg(QString::fromLatin1(sigdescr_np(run.code)),
                                                   QString::number(run.code));
    case ProgramEnd::TimedOut:
        return u"it was ended after %1 s of computing: a loop does not end, or takes far too long"_s
            .arg(limits.wholeSeconds());
    case ProgramEnd::Flooded:
        return u"it was ended when it had written more than %1 bytes"_s.arg(limits.output);
    case ProgramEnd::NotStarted:
        return u"it could not be started"_s;
    case ProgramEnd::Cancelled:
        break;
    }
    return u"it was cancelled"_s;
}

/// One program, from its start to the end of all its descendants.
class RunningProgram {
public:
    RunningProgram(const ProgramLimits &limits, std::stop_token stop, Confinement confinement)
        : m_limits(limits)
        , m_stop(std::move(stop))
    {
        if (confinement == Confinement::Sandbox)
            return;
        m_folder = std::make_unique<WorkingFolder>();
        m_run.sandboxLack = sandboxLack().isEmpty() ? u"none was asked for"_s : sandboxLack();
    }

    StudentRun run(const StudentProgram &student, const QByteArray &input)
    {
        const ProgramStart program(student, input, m_limits, m_folder.get());
        if (!program.isReady() || !m_output.isOpen() || !m_messages.isOpen() || !m_control.isOpen()
            || !m_report.isOpen())
            return notStarted(errorText(errno));
        if (const int error = start(program.plan()))
            return notStarted(errorText(error));
        follow();
        conclude();
        return std::move(m_run);
    }

private:
    static QString errorText(int error) { return QString::fromLatin1(strerrordesc_np(error)); }

    StudentRun notStarted(const QString &why)
    {
        m_run.end = ProgramEnd::NotStarted;
        m_run.told = u"it could not be started: "_s + why;
        return std::move(m_run);
    }

    /// Returns the error, or 0.
    int start(SupervisedStart plan)
    {
        plan.output = m_output.write.number();
        plan.messages = m_messages.write.number();
        plan.control = m_control.read.number();
        plan.report = m_report.write.number();
        m_clock.emplace(m_limits, Clock::now());
        m_deadline = m_clock->nextLook();
        m_supervisor = fork();
        if (m_supervisor == 0)
            supervise(plan);
        const int error = m_supervisor < 0 ? errno : 0;
        m_output.write.close();
        m_messages.write.close();
        m_control.read.close();
        m_report.write.close();
        for (const Descriptor *end : {&m_output.read, &m_messages.read, &m_report.read})
            fcntl(end->number(), F_SETFL, O_NONBLOCK);
        return error;
    }

    /// Reads what the program writes until its supervisor is gone.
    void follow()
    {
        while (m_report.read.isOpen()) {
            std::array<pollfd, 3> awaited = {{{m_report.read.number(), POLLIN, 0},
                                              {m_output.read.number(), POLLIN, 0},
                                              {m_messages.read.number(), POLLIN, 0}}};
            poll(awaited.data(), awaited.size(), waitingTime());
            readAll();
            readReport();
            const bool isLate = Clock::now() >= m_deadline;
            if (isLate && m_isEnding) {
                // Once all processes are gone, it goes on removing the folder by itself.
                m_isRemoving = m_computed.has_value();
                m_isGivenUp = !m_isRemoving;
                if (m_isGivenUp)
                    kill(m_supervisor, SIGKILL);
                m_report.read.close();
            } else if (!m_isEnding && m_read > m_limits.output) {
                endBecause(ProgramEnd::Flooded);
            } else if (!m_isEnding && m_stop.stop_requested()) {
                endBecause(ProgramEnd::Cancelled);
            } else if (!m_isEnding && isLate) {
                m_lateEnd = m_clock->look(computedBy(m_supervisor), Clock::now());
                m_deadline = m_clock->nextLook();
                if (m_lateEnd)
                    endBecause(ProgramEnd::TimedOut);
            }
        }
        readAll(); // the last bytes in the pipes
        if (m_isRemoving) {
            if (m_folder)
                m_folder->leaveToSupervisor();
            return;
        }
        int status = 0;
        while (waitpid(m_supervisor, &status, 0) < 0 && errno == EINTR) { }
        m_isUnwatched = WIFSIGNALED(status);
        if (m_isUnwatched && m_folder)
            m_folder->endProcesses();
    }

    /// In milliseconds.
    int waitingTime() const
    {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(m_deadline - Clock::now());
        const int longest = m_stop.stop_possible() ? stopLookedFor : 60'000;
        return int(std::clamp<std::int64_t>(left.count(), 0, longest));
    }

    void endBecause(ProgramEnd end)
    {
        m_end = end;
        m_control.write.close();
        expectEnd();
    }

    void expectEnd()
    {
        m_isEnding = true;
        m_deadline = Clock::now() + longestEnding;
    }

    void readAll()
    {
        readFrom(m_output.read, m_run.output, m_limits.output);
        readFrom(m_messages.read, m_run.messages, longestMessages);
    }

    /// Keeps at most `most` bytes and counts the others. A turn is bounded, since other pipes wait.
    void readFrom(Descriptor &pipe, QByteArray &kept, qsizetype most)
    {
        std::array<char, 65536> buffer;
        for (int turn = 0; turn < 16 && pipe.isOpen(); ++turn) {
            const ssize_t length = ::read(pipe.number(), buffer.data(), buffer.size());
            if (length == 0)
                pipe.close();
            if (length <= 0)
                return;
            m_read += length;
            kept.append(buffer.data(), std::min<qsizetype>(length, most - kept.size()));
        }
    }

    void readReport()
    {
        SupervisorRecord record;
        for (;;) {
            const ssize_t length = ::read(m_report.read.number(), &record, sizeof record);
            if (length == 0 || (length < 0 && errno != EAGAIN && errno != EINTR))
                m_report.read.close();
            if (length != ssize_t(sizeof record))
                return;
            if (record.news == SupervisorNews::Computed) {
                m_computed = std::chrono::milliseconds(record.value);
                expectEnd();
                continue;
            }
            (record.news == SupervisorNews::NotStarted ? m_startError : m_status) = record.value;
            if (!m_isEnding)
                expectEnd();
        }
    }

    void conclude()
    {
        if (!m_end && m_read > m_limits.output)
            m_end = ProgramEnd::Flooded;
        const bool hasFailed = m_status && WIFEXITED(*m_status) && WEXITSTATUS(*m_status) != 0;
        const QString fault
            = hasFailed ? faultOfStart(WEXITSTATUS(*m_status), m_run.messages) : QString();
        if (m_startError || !fault.isEmpty()) {
            m_run = notStarted(m_startError ? errorText(*m_startError) : fault);
            return;
        }
        m_run.code = m_status ? signalIn(*m_status) : SIGKILL;
        if (m_end)
            m_run.end = *m_end;
        else if (m_status && hasComputedTooLong(*m_status, m_computed.value_or(0ms), m_limits))
            m_run.end = ProgramEnd::TimedOut;
        else if (m_run.code != 0)
            m_run.end = ProgramEnd::Crashed;
        else
            m_run.end = hasFailed ? ProgramEnd::Failed : ProgramEnd::Finished;
        if (m_run.end == ProgramEnd::Failed)
            m_run.code = WEXITSTATUS(*m_status);
        else if (m_run.end != ProgramEnd::Crashed)
            m_run.code = 0;
        m_run.isByClock = m_lateEnd && m_lateEnd->isByClock;
        m_run.isInAll = m_lateEnd && !m_lateEnd->isByClock;
        m_run.told = m_lateEnd ? m_lateEnd->told : sentenceOf(m_run, m_limits);
        if (m_isUnwatched)
            m_run.told += (m_isGivenUp ? u"; it could not be ended in 10 s: "_s
                                       : u"; what watched over it was killed: "_s)
                + u"processes that it started were ended as far as they were found"_s;
    }

    StudentRun m_run;
    std::unique_ptr<WorkingFolder> m_folder; ///< null in the sandbox
    ProgramLimits m_limits;
    std::stop_token m_stop;
    Pipe m_output, m_messages, m_control, m_report;
    pid_t m_supervisor = -1;
    std::optional<ProgramClock> m_clock;
    std::optional<LateEnd> m_lateEnd;
    Clock::time_point m_deadline; ///< of the program's next look, later of the supervisor
    std::int64_t m_read = 0; ///< bytes of stdout and stderr
    bool m_isEnding = false; ///< only the supervisor is awaited
    bool m_isUnwatched = false; ///< the supervisor was killed
    bool m_isGivenUp = false; ///< by us: its processes did not end
    bool m_isRemoving = false; ///< the supervisor, when nobody waits for it any more
    std::optional<ProgramEnd> m_end; ///< why we ended it; none: we did not
    std::optional<std::chrono::milliseconds> m_computed; ///< told when all processes are gone
    std::optional<int> m_status, m_startError;
};

} // namespace

QString nameOf(ProgramEnd end)
{
    switch (end) {
    case ProgramEnd::Finished:
        return u"finished"_s;
    case ProgramEnd::Failed:
        return u"failed"_s;
    case ProgramEnd::Crashed:
        return u"crashed"_s;
    case ProgramEnd::TimedOut:
        return u"timed out"_s;
    case ProgramEnd::Flooded:
        return u"flooded"_s;
    case ProgramEnd::NotStarted:
        return u"not started"_s;
    case ProgramEnd::Cancelled:
        break;
    }
    return u"cancelled"_s;
}

StudentRun runProgram(const StudentProgram &student, const QByteArray &input,
                      const ProgramLimits &limits, const std::stop_token &stop,
                      Confinement confinement)
{
    return RunningProgram(limits, stop, confinement).run(student, input);
}

} // namespace pixelplumb
