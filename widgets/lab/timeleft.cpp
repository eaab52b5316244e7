// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/timeleft.h"

#include <QCoreApplication>

#include <cmath>

namespace pixelplumb {

namespace {

constexpr double leastSeconds = 0.5; ///< of a phase, before it tells anything
constexpr double leastShare = 0.02;

double secondsBetween(TimeLeft::Clock::time_point begin, TimeLeft::Clock::time_point end)
{
    return std::chrono::duration<double>(end - begin).count();
}

} // namespace

void TimeLeft::tell(const JobProgress &progress, Clock::time_point now)
{
    if (!m_hasBegun || progress.phase != m_progress.phase || progress.done < m_progress.done)
        m_begin = now;
    m_hasBegun = true;
    m_progress = progress;
    m_now = now;
}

std::optional<double> TimeLeft::share() const
{
    if (!m_hasBegun || m_progress.total <= 0)
        return std::nullopt;
    return std::min(1.0, double(m_progress.done) / double(m_progress.total));
}

std::optional<std::chrono::seconds> TimeLeft::left() const
{
    const std::optional<double> done = share();
    const double passed = secondsBetween(m_begin, m_now);
    if (!done || *done < leastShare || passed < leastSeconds)
        return std::nullopt;
    return std::chrono::seconds(std::llround(std::ceil(passed / *done * (1 - *done))));
}

QString TimeLeft::text() const
{
    const auto translated
        = [](const char *text) { return QCoreApplication::translate("AccuracyLab", text); };
    const std::string_view phase = nameOf(m_progress.phase);
    QString text = QString::fromUtf8(phase.data(), qsizetype(phase.size()));
    if (const std::optional<double> done = share())
        text += translated(": %1 %").arg(std::lround(100 * *done));
    if (const auto rest = left())
        text += translated(", about %1 s left").arg(rest->count());
    return text;
}

} // namespace pixelplumb
