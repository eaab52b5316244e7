// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/compare/comparepanel.h"

#include "core/lab/study/scenecost.h"
#include "core/runs/scenerun.h"
#include "widgets/look/parts.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/playhead.h"
#include "widgets/model/runnotes.h"
#include "widgets/studies/compare/comparelink.h"
#include "widgets/studies/compare/comparepane.h"
#include "widgets/studies/compare/comparetext.h"
#include "widgets/studies/compare/compareview.h"

namespace pixelplumb {

namespace {

// Shares of the width: a pane's; those of the map and the reason, side by side or not.
constexpr int paneShare = 8;
constexpr int besideShare = 18;
constexpr int stackedShare = 11;

constexpr int besideWidth = 800; ///< logical pixels, of the panel with the two side by side
constexpr int leastReason = 2; ///< lines

} // namespace

ComparePanel::ComparePanel(Playhead *playhead, QWidget *parent)
    : StudyPanel("compare", {}, parent)
    , m_playhead(playhead)
    , m_link(new CompareLink(this))
    , m_timing(nullptr, measuringPool())
{
    auto *layout = withParts(new QVBoxLayout(this), {}, 8, 8);
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
    m_reason = readingLabel("compareReason", tr("Why the picked pixel differs"), this);
    m_reason->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto *reason = columnScroll(this);
    reason->setFocusPolicy(Qt::NoFocus);
    reason->setWidget(m_reason);
    reason->setMinimumHeight(leastReason * fontMetrics().lineSpacing());
    // Not below the pictures, which need the height.
    m_mapAndReason = withParts(new QBoxLayout(QBoxLayout::LeftToRight), {{map, 4}, {reason, 5}}, 8);
    m_row->addLayout(m_mapAndReason, besideShare);
    onEvents(this, {QEvent::Resize}, [this] {
        const bool isBeside = width() >= besideWidth;
        m_mapAndReason->setDirection(isBeside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
        m_row->setStretchFactor(m_mapAndReason, isBeside ? besideShare : stackedShare);
    });

    connect(playhead, &Playhead::tracedChanged, this, &ComparePanel::compareAnew);
    connect(playhead, &Playhead::pickedPixelChanged, this, &ComparePanel::tellPixel);
    addPane();
    addPane();
    m_reason->setText(tr("Nothing is compared yet."));
}

void ComparePanel::addControls(QBoxLayout *layout)
{
    m_fewer = namedButton("compareFewer", u"−"_s, tr("Take the last pane away"), this);
    m_more = namedButton("compareMore", u"+"_s, tr("Add a pane, four at most"), this);
    QToolButton *fit
        = namedButton("compareFit", tr("Fit"), tr("Show the whole frame in every pane"), this);
    auto *progress = new JobBar(m_job, u"compare"_s, tr("Progress of the comparison"), 64, this);
    connect(&m_job, &Job::started, progress, &QWidget::hide); // for a moment it would flicker
    auto *finished = new QLabel(tr("Finished"), this);
    finished->setToolTip(tr("Where the finished pictures agree"));
    auto *row = withParts(new QHBoxLayout, {finished, Room(), m_fewer, m_more, fit, progress}, 4);
    layout->addLayout(row);
    connect(m_more, &QToolButton::clicked, this, [this] {
        const Contender last = m_panes.back()->contender();
        addPane();
        m_panes.back()->setContender(last);
        compareAnew();
    });
    connect(m_fewer, &QToolButton::clicked, this, [this] {
        removePane();
        compareAnew();
    });
    connect(fit, &QToolButton::clicked, m_link, &CompareLink::fit);
    connect(progress, &JobBar::cancelled, this, &ComparePanel::cancel);
}

void ComparePanel::addPane()
{
    auto *pane = new ComparePane(int(m_panes.size()) + 1, m_link, m_playhead, this);
    m_row->insertWidget(int(m_panes.size()), pane, paneShare);
    m_panes.push_back(pane);
    connect(pane, &ComparePane::contenderChanged, this, &ComparePanel::compareAnew);
    connect(pane, &ComparePane::roomChanged, this, &ComparePanel::alignSettings);
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

/// Side by side where they fit in every pane, so that the pictures stand in line.
void ComparePanel::alignSettings()
{
    const bool fit = std::ranges::all_of(m_panes, &ComparePane::fitsSettingsInARow);
    for (ComparePane *pane : m_panes)
        pane->setSettingsDirection(fit ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
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
    compareAnew();
}

void ComparePanel::lookAt(const QPoint &pixel)
{
    if (m_job.isRunning() || isStale())
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

void ComparePanel::cancel()
{
    m_job.cancel();
    m_reason->setText(tr("The comparison was cancelled. Change a pane or the scene to start it "
                         "again."));
}

void ComparePanel::compareAnew()
{
    m_timing.cancel();
    restart();
}

bool ComparePanel::beginStudy()
{
    const std::shared_ptr<const TracedScene> traced = m_playhead->sharedTraced();
    if (!traced) {
        m_contest.reset();
        for (ComparePane *pane : m_panes)
            pane->clear(tr("The scene is being drawn."));
        m_agreement->setContest(nullptr);
        return false;
    }
    if (!m_isChosen) {
        choosePanes(); // and compares these
        return true;
    }
    std::vector<Contender> chosen = contenders();
    for (Contender &contender : chosen)
        contender.settings.rounding = traced->scene.settings.rounding;
    if (!canAllDraw(traced->scene, chosen))
        return true;
    m_job.start(
        [scene = traced->scene, chosen](const ProgressListener &listener) {
            ContestOptions options;
            options.recorded = Recorded::All;
            options.progress = listener;
            return compareContenders(scene, chosen, options);
        },
        [this](const std::shared_ptr<const Contest> &contest) { take(contest); });
    return true;
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
    m_legend->setText(agreementLegend(contest->agreement, palette()));
    tellPixel();
    measure();
}

/// Measures what each contender costs, now that their pictures are drawn. The truth is not timed.
void ComparePanel::measure()
{
    std::vector<std::shared_ptr<const Scene>> scenes; ///< null for the truth
    for (const ContenderRun &run : m_contest->runs)
        scenes.push_back(run.contender.isTruth() ? nullptr
                                                 : std::make_shared<const Scene>(
                                                     sceneFor(m_contest->scene, run.contender)));
    using Costs = std::vector<std::optional<SceneCost>>;
    m_timing.start(
        [scenes](const ProgressListener &listener) {
            Costs costs;
            for (const auto &scene : scenes)
                costs.push_back(scene ? costOf(scene, listener) : std::nullopt);
            return costs;
        },
        [this](const Costs &costs) {
            for (std::size_t run = 0; run < std::min(costs.size(), m_panes.size()); ++run) {
                if (costs[run])
                    m_panes[run]->showCost(*costs[run]);
            }
        });
}

void ComparePanel::tellPixel()
{
    if (!m_contest)
        return;
    const QString carried = carriedText(*m_contest);
    const QString text = pixelText(*m_contest, m_playhead->pickedPixel())
        + (carried.isEmpty() ? QString() : u'\n' + carried);
    m_reason->setText(u"<qt>%1</qt>"_s.arg(typesetHtml(text).replace(u'\n', u"<br>"_s)));
}

} // namespace pixelplumb
