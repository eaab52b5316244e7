// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/comparepanel.h"

#include "core/runs/scenerun.h"
#include "widgets/look/scrolledlabel.h"
#include "widgets/model/playhead.h"
#include "widgets/model/runnotes.h"
#include "widgets/studies/agreementview.h"
#include "widgets/studies/comparelink.h"
#include "widgets/studies/comparepane.h"
#include "widgets/studies/comparetext.h"

#include <QBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>

namespace pixelplumb {

ComparePanel::ComparePanel(Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_link(new CompareLink(this))
{
    setObjectName(QStringLiteral("compare"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    m_row = new QHBoxLayout;
    m_row->setSpacing(8);
    layout->addLayout(m_row, 1);
    auto *map = new QVBoxLayout;
    map->setSpacing(4);
    m_legend = new QLabel(this);
    m_legend->setTextFormat(Qt::RichText);
    m_legend->setWordWrap(true);
    m_agreement = new AgreementView(m_link, playhead, this);
    addControls(map);
    map->addWidget(m_agreement, 1);
    map->addWidget(m_legend);
    m_row->addLayout(map, 1);
    m_reason = new ScrolledLabel(QStringLiteral("compareReason"),
                                 tr("Why the picked pixel differs"), this);
    layout->addWidget(m_reason);

    connect(&m_job, &Job::progressChanged, this, &ComparePanel::tellProgress);
    connect(&m_job, &Job::ended, m_progress, &QWidget::hide);
    connect(&m_job, &Job::ended, m_cancel, &QWidget::hide);
    connect(&m_timing, &ContestTiming::measured, this,
            [this](std::size_t run, const SceneCost &cost) {
                if (run < m_panes.size())
                    m_panes[run]->showCost(cost);
            });
    connect(playhead, &Playhead::tracedChanged, this, &ComparePanel::restart);
    connect(playhead, &Playhead::pickedPixelChanged, this, &ComparePanel::tellPixel);
    connect(playhead, &Playhead::aheadHiddenChanged, this, &ComparePanel::tellAgreement);
    connect(playhead, &Playhead::positionChanged, this, [this] {
        if (m_playhead->isAheadHidden())
            tellPixel(); // it may be decided now
    });
    addPane();
    addPane();
    m_reason->setText(tr("Nothing is compared yet."));
}

ComparePanel::~ComparePanel() = default;

void ComparePanel::addControls(QBoxLayout *layout)
{
    const auto button = [this](const char *name, const QString &text, const QString &tip) {
        auto *result = new QToolButton(this);
        result->setObjectName(QLatin1String(name));
        result->setText(text);
        result->setAccessibleName(tip);
        result->setToolTip(tip);
        return result;
    };
    m_fewer = button("compareFewer", QStringLiteral("−"), tr("Take the last pane away"));
    m_more = button("compareMore", QStringLiteral("+"), tr("Add a pane, four at most"));
    QToolButton *fit = button("compareFit", tr("Fit"), tr("Show the whole frame in every pane"));
    m_progress = new QProgressBar(this);
    m_progress->setRange(0, 0);
    m_progress->setMaximumWidth(64);
    m_progress->setTextVisible(false);
    m_progress->hide();
    m_cancel = new QPushButton(tr("Cancel"), this);
    m_cancel->setObjectName(QStringLiteral("compareCancel"));
    m_cancel->hide();
    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(new QLabel(tr("Agreement"), this));
    row->addStretch();
    row->addWidget(m_fewer);
    row->addWidget(m_more);
    row->addWidget(fit);
    row->addWidget(m_progress);
    row->addWidget(m_cancel);
    layout->addLayout(row);
    connect(m_more, &QToolButton::clicked, this, [this] {
        const Contender last = m_panes.back()->contender();
        addPane();
        m_panes.back()->setContender(last);
        restart();
    });
    connect(m_fewer, &QToolButton::clicked, this, [this] {
        removePane();
        restart();
    });
    connect(fit, &QToolButton::clicked, m_link, &CompareLink::fit);
    connect(m_cancel, &QPushButton::clicked, this, &ComparePanel::cancel);
}

void ComparePanel::addPane()
{
    auto *pane = new ComparePane(int(m_panes.size()) + 1, m_link, m_playhead, this);
    m_row->insertWidget(int(m_panes.size()), pane, 1);
    m_panes.push_back(pane);
    connect(pane, &ComparePane::contenderChanged, this, &ComparePanel::restart);
    m_more->setEnabled(m_panes.size() < mostContenders);
    m_fewer->setEnabled(m_panes.size() > fewestContenders);
}

void ComparePanel::removePane()
{
    delete m_panes.back();
    m_panes.pop_back();
    m_more->setEnabled(m_panes.size() < mostContenders);
    m_fewer->setEnabled(m_panes.size() > fewestContenders);
}

std::vector<Contender> ComparePanel::contenders() const
{
    std::vector<Contender> all;
    for (const ComparePane *pane : m_panes)
        all.push_back(pane->contender());
    return all;
}

void ComparePanel::setContenders(const std::vector<Contender> &contenders)
{
    Q_ASSERT(contenders.size() >= fewestContenders && contenders.size() <= mostContenders);
    m_isChosen = true;
    while (m_panes.size() < contenders.size())
        addPane();
    while (m_panes.size() > contenders.size())
        removePane();
    for (std::size_t i = 0; i < contenders.size(); ++i)
        m_panes[i]->setContender(contenders[i]);
    restart();
}

void ComparePanel::lookAt(const QPoint &pixel)
{
    if (m_job.isRunning() || m_isStale)
        m_lookedAt = pixel;
    else
        m_link->lookAt(pixel);
}

/// The current method beside its rounding arithmetics, or beside the truth where it has none.
void ComparePanel::choosePanes()
{
    const Scene &scene = m_playhead->traced()->scene;
    const Method &method = *m_playhead->traced()->method;
    std::vector<Contender> chosen = {{&method, scene.settings}};
    for (const Arithmetic arithmetic :
         {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64}) {
        Contender rounding{&method, scene.settings};
        rounding.settings.arithmetic = arithmetic;
        if (arithmetic != scene.settings.arithmetic && chosen.size() < 3
            && objectionTo(sceneFor(scene, rounding)).isEmpty())
            chosen.push_back(rounding);
    }
    if (chosen.size() < fewestContenders)
        chosen.push_back({nullptr, scene.settings});
    setContenders(chosen);
}

void ComparePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (m_isStale)
        restart();
}

void ComparePanel::cancel()
{
    m_job.cancel();
    m_reason->setText(tr("The comparison was cancelled. Change a pane or the scene to start it "
                         "again."));
}

void ComparePanel::restart()
{
    m_isStale = true;
    m_timing.cancel();
    const std::shared_ptr<const TracedScene> traced = m_playhead->sharedTraced();
    if (!isVisible())
        return;
    if (!traced) {
        m_job.cancel();
        m_contest.reset();
        for (ComparePane *pane : m_panes)
            pane->clear(tr("The scene is being drawn."));
        m_agreement->setContest(nullptr);
        return;
    }
    if (!m_isChosen)
        return choosePanes();
    m_isStale = false;
    std::vector<Contender> chosen = contenders();
    for (Contender &contender : chosen)
        contender.settings.rounding = traced->scene.settings.rounding;
    if (!canAllDraw(traced->scene, chosen))
        return;
    m_job.start(
        [scene = traced->scene, chosen](const ProgressListener &listener) {
            ContestOptions options;
            options.recorded = Recorded::All;
            options.progress = listener;
            return compareContenders(scene, chosen, options);
        },
        [this](const std::shared_ptr<const Contest> &contest) { take(contest); });
}

/// Otherwise says which contender cannot, and why.
bool ComparePanel::canAllDraw(const Scene &scene, const std::vector<Contender> &contenders)
{
    for (const Contender &contender : contenders) {
        const QString objection
            = contender.isTruth() ? QString() : objectionTo(sceneFor(scene, contender));
        if (objection.isEmpty())
            continue;
        const QString text = objectionNote(*contender.method, objection);
        m_job.cancel();
        m_contest.reset();
        for (ComparePane *pane : m_panes)
            pane->clear(text);
        m_agreement->setContest(nullptr);
        m_reason->setText(text);
        return false;
    }
    return true;
}

void ComparePanel::take(const std::shared_ptr<const Contest> &contest)
{
    if (!contest) {
        m_reason->setText(tr("The comparison does not fit into memory. Make the frame smaller."));
        return;
    }
    if (contest->runs.size() != m_panes.size())
        return; // a pane was added or removed; the next contest is running
    m_link->setFrame(contest->scene.frame);
    if (const auto pixel = std::exchange(m_lookedAt, std::nullopt))
        m_link->lookAt(*pixel);
    for (std::size_t i = 0; i < m_panes.size(); ++i)
        m_panes[i]->show(contest, i);
    m_agreement->setContest(contest);
    m_contest = contest;
    tellAgreement();
    m_timing.measure(contest);
    emit contestChanged();
}

/// Shown only when it takes longer than a moment.
void ComparePanel::tellProgress(const JobProgress &progress)
{
    m_progress->setRange(0, int(progress.total));
    m_progress->setValue(int(progress.done));
    m_progress->show();
    m_cancel->show();
}

void ComparePanel::tellAgreement()
{
    if (!m_contest)
        return;
    m_legend->setText(agreementLegend(m_contest->agreement, palette(), m_playhead->ahead()));
    tellPixel();
}

void ComparePanel::tellPixel()
{
    if (!m_contest)
        return;
    const auto picked = m_playhead->pickedPixel();
    const bool isHidden = m_playhead->isAheadHidden();
    if (isHidden && !(picked && m_playhead->mayTell(picked->x(), picked->y())))
        return m_reason->setText(tr("What lies ahead is hidden while Predict asks."));
    const QString carried = isHidden ? QString() : carriedText(*m_contest);
    m_reason->setText(pixelText(*m_contest, picked, m_playhead->ahead())
                      + (carried.isEmpty() ? QString() : u'\n' + carried));
}

} // namespace pixelplumb
