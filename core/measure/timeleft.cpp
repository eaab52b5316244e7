// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measure/timeleft.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

constexpr double secondsOfTrust = 2; ///< that the job would have to go on otherwise to be believed

} // namespace

QString aboutText(double seconds)
{
    if (seconds < 120)
        return QStringLiteral(QT_TRANSLATE_NOOP("core", "about %1 s"))
            .arg(std::max(1L, std::lround(std::ceil(seconds))));
    return QStringLiteral(QT_TRANSLATE_NOOP("core", "about %1 min")).arg(std::lround(seconds / 60));
}

void TimeLeft::tell(const JobProgress &progress, Clock::time_point now)
{
    if (!m_progress)
        m_begin = now;
    m_now = now;
    m_progress = progress;
}

double TimeLeft::share() const
{
    if (!m_progress || m_progress->total <= 0)
        return 0;
    return std::min(1.0, double(m_progress->done) / double(m_progress->total));
}

double TimeLeft::seconds() const
{
    const double passed = std::chrono::duration<double>(m_now - m_begin).count();
    const double done = share() * m_expected;
    return (m_expected - done) * (passed + secondsOfTrust) / (done + secondsOfTrust);
}

QString TimeLeft::text() const
{
    const std::string_view phase = m_progress
        ? nameOf(m_progress->phase)
        : std::string_view(QT_TRANSLATE_NOOP("core", "waiting"));
    return u"%1: %2 %, %3 left"_s.arg(QString::fromUtf8(phase.data(), qsizetype(phase.size())))
        .arg(std::lround(100 * share()))
        .arg(aboutText(seconds()));
}

} // namespace pixelplumb
