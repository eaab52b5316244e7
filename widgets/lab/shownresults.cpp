// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/shownresults.h"

#include <algorithm>
#include <utility>

namespace pixelplumb {

namespace {

/// Whether a family (any, where the study lacks it) has times, or never will.
bool hasTimes(const Study &study, const QString &family)
{
    const bool isThere = study.family(family) != nullptr;
    return study.isComplete || std::ranges::any_of(study.rows, [&](const LabRow &row) {
               return (!isThere || row.family == family) && row.cost && row.cost->rounds > 0;
           });
}

} // namespace

void ShownResults::beginRun()
{
    m_news = nullptr;
    m_areOfRun = false;
}

bool ShownResults::takeNews(const SharedResults &news, const QString &family)
{
    m_news = news;
    return (m_areOfRun || !m_results || hasTimes(*news, family)) && showNews();
}

bool ShownResults::endRun()
{
    const bool isShown = m_news && hasTimes(*m_news, {}) && showNews();
    m_news = nullptr;
    return isShown;
}

bool ShownResults::showNews()
{
    if (m_areOfRun)
        m_results = std::exchange(m_news, nullptr);
    else
        replaceBy(std::exchange(m_news, nullptr));
    m_areOfRun = true;
    return true;
}

void ShownResults::replaceBy(SharedResults results)
{
    if (m_results)
        m_earlier = m_results;
    m_results = std::move(results);
}

} // namespace pixelplumb
