// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labrun.h"

#include "core/lab/studystages.h"
#include "widgets/model/measuringpool.h"

#include <atomic>
#include <mutex>

namespace pixelplumb {

namespace {

using namespace std::chrono_literals;

constexpr auto betweenNews = 250ms; ///< a copy of a study takes time from what is measured
constexpr std::int64_t driftColumns = 2003;

/// Those whose growth is worth a curve: the column scan in every arithmetic, its fast kernel, and
/// the walk over rows.
constexpr const char *scalingContenders[]
    = {"column-scan:exact",   "column-scan:exact:fast", "column-scan:float32",
       "column-scan:float64", "column-scan:fixed16.16", "column-scan:fixed32.32",
       "row-walk:float32"};

std::vector<LabContender> contendersOfSizes(const StudySettings &settings)
{
    if (!settings.contenders.empty())
        return settings.contenders;
    std::vector<LabContender> contenders;
    for (const char *id : scalingContenders) {
        if (auto contender = labContenderNamed(QLatin1String(id)))
            contenders.push_back(std::move(*contender));
    }
    return contenders;
}

int roundsOfSizes(const StudySettings &settings)
{
    return settings.extent == StudyExtent::Quick ? 3 : 7;
}

/// Of a study and of how times grow, which follows it.
std::vector<JobStage> stagesOfRun(const StudySettings &settings)
{
    std::vector<JobStage> stages = stagesOf(settings);
    if (settings.rounds != 0)
        stages.push_back(
            sizeStudyStage(contendersOfSizes(settings).size(), roundsOfSizes(settings)));
    return stages;
}

} // namespace

/// Where the worker leaves what it has.
class LabRun::Board {
public:
    /// The study so far, unless the last one was left there just now.
    void offer(const Study &study)
    {
        const TimeLeft::Clock::time_point now = TimeLeft::Clock::now();
        if (now - m_lastOffer < betweenNews)
            return;
        m_lastOffer = now;
        post([&](LabResults &results) { results.study = study; });
    }

    template <class Change>
    void post(const Change &change)
    {
        const std::lock_guard lock(m_mutex);
        change(m_results);
        m_isNews = true;
    }

    /// Null where nothing is new.
    std::shared_ptr<const LabResults> takeNews()
    {
        const std::lock_guard lock(m_mutex);
        if (!std::exchange(m_isNews, false))
            return nullptr;
        return std::make_shared<const LabResults>(m_results);
    }

    void stop() { m_isStopped = true; }
    bool isStopped() const { return m_isStopped; }

private:
    std::atomic<bool> m_isStopped = false;
    std::mutex m_mutex;
    LabResults m_results;
    bool m_isNews = false;
    TimeLeft::Clock::time_point m_lastOffer; ///< the worker's
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

LabRun::~LabRun() = default;

double LabRun::expectedSeconds(const StudySettings &settings)
{
    return TimeLeft(stagesOfRun(settings)).seconds();
}

void LabRun::start(const StudySettings &settings)
{
    m_timeLeft = TimeLeft(stagesOfRun(settings));
    m_board = std::make_shared<Board>();
    const auto work = [settings, board = m_board](const ProgressListener &job) {
        const ProgressListener listener
            = [&](const JobProgress &progress) { return job(progress) && !board->isStopped(); };
        StudyListener hears;
        hears.progress = listener;
        hears.rowChanged = [&board](const Study &study, std::size_t) { board->offer(study); };
        hears.roundDone = [&board](const Study &study) { board->offer(study); };
        const Study study = runStudy(settings, hears);
        board->post([&](LabResults &results) { results.study = study; });
        if (!study.isComplete)
            return false;
        auto drift = driftOver(driftColumns, listener);
        if (!drift)
            return false;
        board->post([&](LabResults &results) { results.drift = std::move(*drift); });
        if (study.rounds == 0)
            return true;
        auto sizes = runSizeStudy(contendersOfSizes(settings), roundsOfSizes(settings), listener);
        if (sizes)
            board->post([&](LabResults &results) { results.sizes = std::move(*sizes); });
        return sizes.has_value();
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

} // namespace pixelplumb
