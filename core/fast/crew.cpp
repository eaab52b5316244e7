// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/crew.h"

#include <system_error>

namespace pixelplumb {

Crew::Crew(int threads)
{
    m_others.reserve(std::size_t(threads - 1));
    try {
        while (int(m_others.size()) < threads - 1)
            m_others.emplace_back([this] { workUntilDismissed(); });
    } catch (const std::system_error &) {
        // Those that started, or the caller alone, do the work.
    }
}

Crew::~Crew()
{
    m_isDismissed = true;
    m_begun.release(std::ptrdiff_t(m_others.size()));
}

void Crew::share(int count, const std::function<void(int job)> &job)
{
    m_job = &job;
    m_count = count;
    m_next = 0;
    m_begun.release(std::ptrdiff_t(m_others.size()));
    takeJobs();
    for (std::size_t i = 0; i < m_others.size(); ++i)
        m_finished.acquire();
}

void Crew::workUntilDismissed()
{
    while (true) {
        m_begun.acquire();
        if (m_isDismissed)
            return;
        takeJobs();
        m_finished.release();
    }
}

void Crew::takeJobs()
{
    for (int mine = m_next++; mine < m_count; mine = m_next++)
        (*m_job)(mine);
}

} // namespace pixelplumb
