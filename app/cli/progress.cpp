// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/progress.h"

#include "core/grade/showntext.h"
#include "core/scene/shortened.h"

#include <unistd.h>

#include <cstdio>

namespace pixelplumb::cli {

namespace {

constexpr qint64 betweenShows = 100; // ms
constexpr const char *eraseLine = "\r\033[K";

/// "recording: 512", "writing: 40 of 512".
QString stateText(const JobProgress &progress)
{
    const std::string_view name = nameOf(progress.phase);
    QString text = QLatin1String(name.data(), qsizetype(name.size()));
    text += QStringLiteral(": %1").arg(progress.done);
    if (progress.total > 0)
        text += QStringLiteral(" of %1").arg(progress.total);
    return text;
}

} // namespace

Progress::Progress()
    : m_onTerminal(isatty(STDERR_FILENO) != 0)
{
    m_sinceStart.start();
}

Progress::~Progress() { clear(); }

void Progress::clear()
{
    if (m_shown)
        std::fputs(eraseLine, stderr);
    m_shown = false;
}

bool Progress::isDue() const { return m_onTerminal && m_sinceStart.elapsed() >= m_nextShow; }

void Progress::show(const QString &state)
{
    if (!isDue())
        return;
    std::fputs((eraseLine + escapedControls(shortened(state)).toUtf8()).constData(), stderr);
    m_shown = true;
    m_nextShow = m_sinceStart.elapsed() + betweenShows;
}

ProgressListener Progress::listener()
{
    return [this](const JobProgress &progress) {
        if (isDue())
            show(stateText(progress));
        return true;
    };
}

} // namespace pixelplumb::cli
