// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/timeleft.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr double secondsOfTrust = 2; ///< that the job would have to go on otherwise to be believed

} // namespace

QString aboutText(double seconds)
{
    if (seconds < 120)
        return QStringLiteral("about %1 s").arg(std::max(1L, std::lround(std::ceil(seconds))));
    return QStringLiteral("about %1 min").arg(std::lround(seconds / 60));
}

TimeLeft::TimeLeft(std::vector<JobStage> stages)
    : m_stages(std::move(stages))
{
}

void TimeLeft::tell(const JobProgress &progress, Clock::time_point now)
{
    if (!m_progress)
        m_begin = now;
    m_now = now;
    const bool goesOn
        = m_progress && m_progress->phase == progress.phase && m_progress->done <= progress.done;
    const auto from = m_stages.begin() + std::ptrdiff_t(m_stage + (m_progress && !goesOn ? 1 : 0));
    const auto stage = std::ranges::find(from, m_stages.end(), progress.phase, &JobStage::phase);
    if (stage == m_stages.end())
        return;
    m_stage = std::size_t(stage - m_stages.begin());
    m_progress = progress;
}

double TimeLeft::expected() const
{
    double seconds = 0;
    for (const JobStage &stage : m_stages)
        seconds += stage.seconds;
    return seconds;
}

double TimeLeft::share() const
{
    if (!m_progress)
        return 0;
    double done = 0;
    for (std::size_t i = 0; i < m_stage; ++i)
        done += m_stages[i].seconds;
    if (m_progress->total > 0)
        done += m_stages[m_stage].seconds
            * std::min(1.0, double(m_progress->done) / double(m_progress->total));
    return done / expected();
}

double TimeLeft::seconds() const
{
    const double passed = std::chrono::duration<double>(m_now - m_begin).count();
    const double done = share() * expected();
    return (expected() - done) * (passed + secondsOfTrust) / (done + secondsOfTrust);
}

QString TimeLeft::text() const
{
    const std::string_view phase
        = m_progress ? nameOf(m_progress->phase) : std::string_view("waiting");
    return QStringLiteral("%1: %2 %, %3 left")
        .arg(QString::fromUtf8(phase.data(), qsizetype(phase.size())))
        .arg(std::lround(100 * share()))
        .arg(aboutText(seconds()));
}

} // namespace pixelplumb
