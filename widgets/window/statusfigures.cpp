// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/statusfigures.h"

#include "core/lab/livefigures.h"
#include "widgets/look/corewords.h"
#include "widgets/model/measuringpool.h"
#include "widgets/model/playhead.h"

namespace pixelplumb {

namespace {

using namespace std::chrono_literals;

constexpr auto pauseBetween = 300ms; ///< a drag asks at each move

} // namespace

StatusFigures::StatusFigures(Playhead *playhead, QWidget *parent)
    : ElidedLabel(parent)
    , m_playhead(playhead)
    , m_job(nullptr, measuringPool())
{
    setObjectName(QStringLiteral("statusFigures"));
    setAccessibleName(tr("Wrong pixels and time of the method in hand"));
    m_job.setRest(pauseBetween);
    connect(playhead, &Playhead::tracedChanged, this, [this] {
        m_isStale = true;
        measure();
    });
}

void StatusFigures::measure()
{
    if (!isVisible() || !m_isStale)
        return;
    const std::shared_ptr<const TracedScene> traced = m_playhead->sharedTraced();
    // A run that was too large to be recorded is too large to be drawn beside the window.
    if (!traced || traced->trace->isCut()) {
        m_job.cancel();
        setWholeText({});
        return;
    }
    m_isStale = false;
    if (!m_job.isRunning())
        setWholeText(measuringNote());
    m_job.start(
        [traced](const ProgressListener &listener) { return liveFiguresOf(traced, listener); },
        [this, isForced = traced->scene.appearance.forced != EffectForcing{}](
            const std::optional<LiveFigures> &figures) {
            const QString separator = QStringLiteral(" · ");
            const QString text = figures ? coreWords(figures->text(), separator) : QString();
            setWholeText(isForced ? tr("as forced: %1").arg(text) : text);
            setToolTip(figures ? coreWords(figures->details(), separator) : QString());
        });
}

void StatusFigures::showEvent(QShowEvent *event)
{
    ElidedLabel::showEvent(event);
    measure();
}

} // namespace pixelplumb
