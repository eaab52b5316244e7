// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cost/effectspanel.h"

#include "core/methods/method.h"
#include "core/runs/scenerun.h"
#include "core/scan/choicenames.h"
#include "core/scene/appearancenames.h"
#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"
#include "widgets/model/effectswitches.h"
#include "widgets/model/job.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"
#include "widgets/studies/cost/effectstext.h"

namespace pixelplumb {

namespace {

enum EffectColumn {
    EffectName,
    EffectJudgement,
    EffectSwitch,
    EffectPrimitives,
    EffectPixels,
    EffectPerPixel,
    EffectOperations,
    EffectRatio,
    EffectReason,
};

QString objectNameOf(Effect effect)
{
    return nameText(nameOf(effect)).replace(u' ', u'-') + u"-switch"_s;
}

} // namespace

EffectsPanel::EffectsPanel(SceneDocument *document, EffectSwitches *switches, QWidget *parent)
    : StudyPanel("effectsPanel", tr("Effects"), parent)
    , m_document(document)
    , m_switches(switches)
    , m_table(new QTableView(this))
    , m_measureJob(nullptr, measuringPool())
{
    m_summary = readingLabel("effectsSummary", tr("What is forced, and what that changes"), this);
    makeTable();
    withParts(new QVBoxLayout(this), {controls(), {m_table, 1}}, 8, 8);
    connect(document, &SceneDocument::sceneChanged, this, &EffectsPanel::forget);
    connect(document, &SceneDocument::currentFrameChanged, this, &EffectsPanel::forget);
    connect(switches, &EffectSwitches::changed, this, &EffectsPanel::forget);
    forget();
}

/// The table's columns read the panel.
EffectsPanel::~EffectsPanel() { m_table->setModel(nullptr); }

void EffectsPanel::makeTable()
{
    named(m_table, "effectsTable", tr("Effects"));
    m_rows = new RowsModel<Effect>(columns(), this);
    m_rows->setRows({allEffects.begin(), allEffects.end()});
    m_table->setModel(m_rows);
    readByRows(m_table);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(EffectReason, QHeaderView::Stretch);
    // All of the reason, next to the verdict.
    m_table->horizontalHeader()->moveSection(EffectReason, EffectSwitch);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    for (int row = 0; row < m_rows->rowCount(); ++row) {
        if (const Effect effect = m_rows->rows()[std::size_t(row)]; effect != Effect::Clipping)
            addSwitch(row, effect);
    }
}

/// In the order of EffectColumn.
std::vector<RowsColumn<Effect>> EffectsPanel::columns() const
{
    const auto told = [this](auto text) {
        return [this, text](Effect effect) {
            return m_plan ? text(m_plan->verdicts[effect]) : QString();
        };
    };
    const auto timed = [this](auto text) {
        return [this, text](Effect effect) {
            const auto cost = m_timing ? m_timing->costs[effect] : std::nullopt;
            return cost ? text(*m_timing, *cost) : QString();
        };
    };
    return {
        {tr("effect"), {}, [](Effect effect) { return coreWord(nameOf(effect)); }, Qt::AlignLeft},
        {tr("verdict"),
         {},
         told([](const EffectVerdict &verdict) { return verdictText(verdict.verdict); }),
         Qt::AlignLeft},
        {tr("switch"),
         {},
         [](Effect effect) { return effect == Effect::Clipping ? tr("none") : QString(); },
         Qt::AlignLeft,
         [](Effect, int role) {
             return role == Qt::ToolTipRole
                 ? QVariant(tr("The frame's border limits every loop, at no cost; what lies in "
                               "front of the near plane cannot be drawn"))
                 : QVariant();
         }},
        {tr("primitives"), {}, told([](const EffectVerdict &verdict) {
             return QString::number(verdict.primitives);
         })},
        {tr("pixels at most"), {}, told([](const EffectVerdict &verdict) {
             return QString::number(verdict.pixels);
         })},
        {tr("ns a pixel"),
         tr("How much longer drawing takes with the effect than without it, "
            "for each pixel written"),
         timed([](const EffectTiming &timing, const EffectCost &cost) {
             return QString::number(timing.perPixel(cost), 'f', 2);
         })},
        {tr("operations a pixel"),
         tr("With the effect on, for each pixel written: depths read and "
            "written, divisions by 1/w, texels read, normals made unit "
            "length, blends, samples"),
         timed([](const EffectTiming &timing, const EffectCost &cost) {
             const std::optional<double> each = timing.operationsPerPixel(cost);
             return each ? QString::number(*each, 'f', 2) : QString();
         })},
        {tr("times as long"), tr("Time with ÷ time without; interquartile range"),
         timed([](const EffectTiming &, const EffectCost &cost) { return ratioText(cost.ratio); })},
        {tr("reason"),
         {},
         told([](const EffectVerdict &verdict) { return coreSentences(verdict.reason); }),
         Qt::AlignLeft}};
}

void EffectsPanel::addSwitch(int row, Effect effect)
{
    auto *box = new QComboBox(m_table);
    box->setObjectName(objectNameOf(effect));
    box->setAccessibleName(tr("Switch of %1").arg(coreWord(nameOf(effect))));
    box->addItems({tr("as called for"), tr("on"), tr("off")}); // in the order of Forcing
    m_table->setIndexWidget(m_rows->index(row, EffectSwitch), box);
    m_boxes[effect] = box;
    connect(box, &QComboBox::activated, this,
            [this, effect](int index) { m_switches->force(effect, Forcing(index)); });
}

std::shared_ptr<const Scene> EffectsPanel::drawnScene() const
{
    return m_switches->applied(m_document->currentSnapshot());
}

void EffectsPanel::forget()
{
    m_measureJob.cancel();
    m_timing.reset();
    m_switches->setChanges(nullptr);
    m_samples->setCurrentIndex(
        m_samples->findData(int(m_document->scene().appearance.antialiasing)));
    showSwitches();
    showTiming();
    restart();
}

EffectsPanel::Finding EffectsPanel::findingOf(const Scene &scene)
{
    const SceneRun run(scene);
    Finding finding{planOf(run), objectionTo(run), nullptr};
    if (scene.appearance.forced != EffectForcing{} && finding.objection.isEmpty())
        finding.changes = std::make_shared<DifferenceMap>(changesByForcing(run));
    return finding;
}

bool EffectsPanel::beginStudy()
{
    m_job.start([scene = drawnScene()](
                    const ProgressListener &) { return std::optional<Finding>(findingOf(*scene)); },
                [this](const std::optional<Finding> &finding) { take(finding); });
    return true;
}

void EffectsPanel::take(const std::optional<Finding> &finding)
{
    m_plan = finding ? std::optional(finding->plan) : std::nullopt;
    m_objection = finding ? finding->objection : QString();
    m_measure->setEnabled(m_objection.isEmpty() && m_plan && !m_measureJob.isRunning());
    if (!finding) {
        m_summary->setText(tr("The plan does not fit into memory."));
    } else if (!m_objection.isEmpty()) {
        const Method *method = methodNamed(QString::fromStdString(m_document->scene().method));
        m_summary->setText(objectionNote(*method, m_objection));
    } else {
        m_summary->setText(forcingText(*m_plan, drawnScene()->appearance,
                                       drawnScene()->settings.arithmetic,
                                       finding->changes ? finding->changes->total() : 0));
        m_switches->setChanges(finding->changes);
    }
    m_rows->refresh();
    emit planned();
}

void EffectsPanel::showTiming()
{
    // While empty they would take the reasons' room.
    for (const EffectColumn column : {EffectPerPixel, EffectOperations, EffectRatio})
        m_table->setColumnHidden(column, !m_timing);
    m_rows->refresh();
}

void EffectsPanel::showSwitches()
{
    for (const Effect effect : allEffects) {
        if (QComboBox *box = m_boxes[effect])
            box->setCurrentIndex(int(m_switches->forced()[effect]));
    }
}

void EffectsPanel::measure()
{
    if (!m_plan || !m_objection.isEmpty())
        return;
    m_timing.reset();
    showTiming();
    m_measureJob.start(
        [scene = m_document->currentSnapshot()](const ProgressListener &listener) {
            TimingOptions options;
            options.progress = listener;
            return timeEffects(*scene, options);
        },
        [this](const std::optional<EffectTiming> &timing) {
            m_timing = timing;
            showTiming();
            emit measured();
        });
}

void EffectsPanel::cancel() { m_measureJob.cancel(); }

QBoxLayout *EffectsPanel::controls()
{
    m_measure = named(new QPushButton(tr("Measure"), this), "effectsMeasure", {},
                      tr("Draw the scene repeatedly with each effect on and off, while "
                         "all other effects are as called for; by the plain kernels"));
    auto *progress
        = new JobBar(m_measureJob, u"effects"_s, tr("Progress of the measurement"), 64, this);
    auto *row = withParts(new QHBoxLayout, {m_measure, progress}, 8);
    addSamples(row);
    row->addWidget(m_summary, 1);
    connect(m_measure, &QPushButton::clicked, this, &EffectsPanel::measure);
    connect(progress, &JobBar::cancelled, this, &EffectsPanel::cancel);
    const auto showState = [this] { m_measure->setEnabled(!m_measureJob.isRunning()); };
    connect(&m_measureJob, &Job::started, this, showState);
    connect(&m_measureJob, &Job::ended, this, showState);
    return row;
}

/// The samples that the scene itself asks for; the switch of antialiasing is next to its verdict.
void EffectsPanel::addSamples(QBoxLayout *row)
{
    m_samples
        = named(new QComboBox(this), "effectsSamples", tr("Antialiasing that the scene asks for"),
                tr("The antialiasing that the scene asks for: samples per pixel, or "
                   "the exact area. Only pixels that an edge crosses have more than "
                   "one sample"));
    for (const Antialiasing each : {Antialiasing::None, Antialiasing::Samples4,
                                    Antialiasing::Samples16, Antialiasing::Area}) {
        const QString samples = QString::fromUtf8(nameOf(each));
        m_samples->addItem(each == Antialiasing::Area       ? tr("exact area")
                               : each == Antialiasing::None ? tr("1 sample")
                                                            : tr("%1 samples").arg(samples),
                           int(each));
    }
    row->addWidget(m_samples);
    connect(m_samples, &QComboBox::activated, this, [this](int index) {
        Appearance appearance = m_document->scene().appearance;
        appearance.antialiasing = Antialiasing(m_samples->itemData(index).toInt());
        m_document->setAppearance(appearance);
    });
}

} // namespace pixelplumb
