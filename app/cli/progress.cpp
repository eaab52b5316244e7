// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/progress.h"

#include <unistd.h>

#include <cstdio>

namespace pixelplumb::cli {

namespace {

constexpr qint64 betweenShows = 100; // ms
constexpr const char *eraseLine = "\r\033[K";

} // namespace

Progress::Progress()
    : m_onTerminal(isatty(STDERR_FILENO) != 0)
{
    m_sinceStart.start();
}

Progress::~Progress()
{
    if (m_shown)
        std::fputs(eraseLine, stderr);
}

void Progress::show(const QString &state)
{
    if (!m_onTerminal || m_sinceStart.elapsed() < m_nextShow)
        return;
    std::fputs((eraseLine + state.toUtf8()).constData(), stderr);
    m_shown = true;
    m_nextShow = m_sinceStart.elapsed() + betweenShows;
}

} // namespace pixelplumb::cli
