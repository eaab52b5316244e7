// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labrun.h"

#include "widgets/model/job.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

namespace pixelplumb {

namespace {

using namespace std::chrono_literals;

constexpr auto betweenNews = 250ms; ///< copying a study disturbs the measurement

/// Whether a family (any, where the study lacks it) has times, or never will.
bool hasTimes(const Study &study, const QString &family)
{
    const bool isThere = study.family(family) != nullptr;
    return study.isComplete || std::ranges::any_of(study.rows, [&](const LabRow &row) {
               return (!isThere || row.family == family) && row.cost && row.cost->rounds > 0;
           });
}

} // namespace

/// Where the worker leaves its results.
class LabRun::Board {
public:
    /// Copies the study so far, unless the last copy is recent.
    void offer(const Study &study)
    {
        const TimeLeft::Clock::time_point now = TimeLeft::Clock::now();
        if (now - m_lastOffer < betweenNews)
            return;
        m_lastOffer = now;
        post([&](Study &results) { results = study; });
    }

    template <class Change>
    void post(const Change &change)
    {
        const std::lock_guard lock(m_mutex);
        change(m_results);
        m_isNews = true;
    }

    /// Null where nothing is new.
    std::shared_ptr<const Study> takeNews()
    {
        const std::lock_guard lock(m_mutex);
        if (!std::exchange(m_isNews, false))
            return nullptr;
        return std::make_shared<const Study>(m_results);
    }

    void stop() { m_isStopped = true; }
    bool isStopped() const { return m_isStopped; }

private:
    std::atomic<bool> m_isStopped = false;
    std::mutex m_mutex;
    Study m_results;
    bool m_isNews = false;
    TimeLeft::Clock::time_point m_lastOffer; ///< used by the worker only
};

LabRun::LabRun(QObject *parent)
    : QObject(parent)
    , m_job(nullptr, measuringPool())
{
    connect(&m_job, &Job::progressChanged, this, [this](const JobProgress &progress) {
        m_timeLeft.tell(progress, TimeLeft::Clock::now());
        takeNews();
        emit progressed();
    });
}

void LabRun::start(const StudySettings &settings)
{
    m_timeLeft = TimeLeft(expectedSeconds(settings));
    m_board = std::make_shared<Board>();
    const auto work = [settings, board = m_board](const ProgressListener &job) {
        const ProgressListener listener
            = [&](const JobProgress &progress) { return job(progress) && !board->isStopped(); };
        StudyListener hears;
        hears.progress = listener;
        hears.rowChanged = [&board](const Study &study, std::size_t) { board->offer(study); };
        hears.roundDone = [&board](const Study &study) { board->offer(study); };
        const Study study = runStudy(settings, hears);
        board->post([&](Study &results) { results = study; });
        return study.isComplete;
    };
    m_job.start(work, [this](bool) {
        takeNews();
        emit ended();
    });
}

void LabRun::cancel()
{
    if (isRunning())
        m_board->stop();
}

void LabRun::drop()
{
    m_board = nullptr;
    m_job.cancel();
}

void LabRun::takeNews()
{
    if (!m_board)
        return;
    if (const auto news = m_board->takeNews())
        emit resultsChanged(news);
}

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
    m_results = std::exchange(m_news, nullptr);
    m_areOfRun = true;
    return true;
}

} // namespace pixelplumb
