// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/statusfigures.h"

#include "core/lab/livefigures.h"
#include "widgets/look/corewords.h"
#include "widgets/model/measuringpool.h"
#include "widgets/model/playhead.h"
#include "widgets/model/studentpicture.h"
#include "widgets/studies/submissiontext.h"

namespace pixelplumb {

namespace {

using namespace std::chrono_literals;

constexpr auto pauseBetween = 300ms; ///< a drag asks at each move

} // namespace

StatusFigures::StatusFigures(const Playhead *playhead, const StudentPicture *student,
                             QWidget *parent)
    : ElidedLabel(parent)
    , m_playhead(playhead)
    , m_student(student)
    , m_job(nullptr, measuringPool())
{
    setObjectName(QStringLiteral("statusFigures"));
    setAccessibleName(tr("Wrong pixels and time of the current method"));
    m_job.setRest(pauseBetween);
    connect(playhead, &Playhead::tracedChanged, this, [this] {
        m_isStale = true;
        measure();
    });
    connect(student, &StudentPicture::judged, this, &StatusFigures::showVerdict);
}

void StatusFigures::tell(const QString &figures, const QString &details)
{
    m_figures = figures;
    m_details = details;
    showVerdict();
}

void StatusFigures::showVerdict()
{
    if (const auto &judgement = m_student->judgement()) {
        setWholeText(tr("Submission: %1").arg(verdictText(judgement->diff)));
        setToolTip(m_details.isEmpty() ? QString() : tr("The method itself: %1").arg(m_details));
        return;
    }
    setWholeText(m_figures);
    setToolTip(m_details);
}

void StatusFigures::measure()
{
    if (!isVisible() || !m_isStale)
        return;
    const std::shared_ptr<const TracedScene> traced = m_playhead->sharedTraced();
    // A run too large to record is also too large to draw in the background.
    if (!traced || traced->trace->isCut()) {
        m_job.cancel();
        tell({}, {});
        return;
    }
    m_isStale = false;
    if (!m_job.isRunning())
        tell(measuringNote(), {});
    m_job.start(
        [traced](const ProgressListener &listener) { return liveFiguresOf(traced, listener); },
        [this, isForced = traced->scene.appearance.forced != EffectForcing{}](
            const std::optional<LiveFigures> &figures) {
            const QString separator = QStringLiteral(" · ");
            const QString text = figures ? coreWords(figures->text(), separator) : QString();
            tell(isForced ? tr("as forced: %1").arg(text) : text,
                 figures ? coreWords(figures->details(), separator) : QString());
        });
}

void StatusFigures::showEvent(QShowEvent *event)
{
    ElidedLabel::showEvent(event);
    measure();
}

} // namespace pixelplumb
