// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/cost/effectspanel.h"

#include "core/methods/method.h"
#include "core/runs/scenerun.h"
#include "core/scan/choicenames.h"
#include "core/scene/appearancenames.h"
#include "widgets/look/corewords.h"
#include "widgets/look/numberlayout.h"
#include "widgets/look/parts.h"
#include "widgets/model/effectswitches.h"
#include "widgets/model/job.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"
#include "widgets/studies/cost/effectstext.h"

#include <QtWidgets>

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
    EffectColumnCount
};

int tableRowOf(Effect effect) { return int(effect); }

QString objectNameOf(Effect effect)
{
    return nameText(nameOf(effect)).replace(u' ', u'-') + QStringLiteral("-switch");
}

} // namespace

EffectsPanel::EffectsPanel(SceneDocument *document, EffectSwitches *switches, QWidget *parent)
    : StudyPanel("effectsPanel", tr("Effects"), parent)
    , m_document(document)
    , m_switches(switches)
    , m_table(new QTableWidget(this))
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

void EffectsPanel::makeTable()
{
    named(m_table, "effectsTable", tr("Effects"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setFont(tabularFont(font()));
    m_table->setRowCount(int(allEffects.size()));
    m_table->setColumnCount(EffectColumnCount);
    m_table->setHorizontalHeaderLabels(
        {tr("effect"), tr("verdict"), tr("switch"), tr("primitives"), tr("pixels at most"),
         tr("ns a pixel"), tr("operations a pixel"), tr("times as long"), tr("reason")});
    m_table->horizontalHeaderItem(EffectPerPixel)
        ->setToolTip(
            tr("How much longer drawing takes with it than without it, for each pixel written"));
    m_table->horizontalHeaderItem(EffectOperations)
        ->setToolTip(tr("With it on, for each pixel written: depths read and written, divisions by "
                        "1/w, texels read, normals made unit length, blends, samples"));
    m_table->horizontalHeaderItem(EffectRatio)
        ->setToolTip(tr("Time with ÷ time without; interquartile range"));
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(EffectReason, QHeaderView::Stretch);
    // All of the reason, next to the verdict.
    m_table->horizontalHeader()->moveSection(EffectReason, EffectSwitch);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    for (const Effect effect : allEffects) {
        const int row = tableRowOf(effect);
        for (int column = 0; column < EffectColumnCount; ++column) {
            auto *item = new QTableWidgetItem;
            if (column >= EffectPrimitives && column <= EffectRatio)
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_table->setItem(row, column, item);
        }
        m_table->item(row, EffectName)->setText(coreWord(nameOf(effect)));
        addSwitch(row, effect);
    }
}

void EffectsPanel::addSwitch(int row, Effect effect)
{
    if (effect == Effect::Clipping) {
        m_table->item(row, EffectSwitch)->setText(tr("none"));
        m_table->item(row, EffectSwitch)
            ->setToolTip(
                tr("The frame's border bounds every loop, at no cost; what lies before the "
                   "near plane has no place in the frame"));
        return;
    }
    auto *box = new QComboBox(m_table);
    box->setObjectName(objectNameOf(effect));
    box->setAccessibleName(tr("Switch of %1").arg(coreWord(nameOf(effect))));
    box->addItems({tr("as called for"), tr("on"), tr("off")}); // in the order of Forcing
    m_table->setCellWidget(row, EffectSwitch, box);
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
    showPlan();
    emit planned();
}

void EffectsPanel::showPlan()
{
    for (const Effect effect : allEffects) {
        const auto show = [&](EffectColumn column, const QString &text) {
            m_table->item(tableRowOf(effect), column)->setText(text);
        };
        const EffectVerdict verdict = m_plan ? m_plan->verdicts[effect] : EffectVerdict{};
        show(EffectJudgement, m_plan ? verdictText(verdict.verdict) : QString());
        show(EffectPrimitives, m_plan ? QString::number(verdict.primitives) : QString());
        show(EffectPixels, m_plan ? QString::number(verdict.pixels) : QString());
        show(EffectReason, verdict.reason);
        m_table->item(tableRowOf(effect), EffectReason)->setToolTip(verdict.reason);
    }
}

void EffectsPanel::showTiming()
{
    // While empty they would take the reasons' room.
    for (const EffectColumn column : {EffectPerPixel, EffectOperations, EffectRatio})
        m_table->setColumnHidden(column, !m_timing);
    for (const Effect effect : allEffects) {
        const std::optional<EffectCost> cost
            = m_timing ? m_timing->costs[effect] : std::optional<EffectCost>();
        m_table->item(tableRowOf(effect), EffectPerPixel)
            ->setText(cost ? QString::number(m_timing->perPixel(*cost), 'f', 2) : QString());
        const std::optional<double> operations
            = cost ? m_timing->operationsPerPixel(*cost) : std::nullopt;
        m_table->item(tableRowOf(effect), EffectOperations)
            ->setText(operations ? QString::number(*operations, 'f', 2) : QString());
        m_table->item(tableRowOf(effect), EffectRatio)
            ->setText(cost ? ratioText(cost->ratio) : QString());
    }
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
                      tr("Draw the scene again and again with each effect on and off, all "
                         "others as called for, by the plain kernels"));
    auto *progress = new JobBar(m_measureJob, QStringLiteral("effects"),
                                tr("Progress of the measurement"), 64, this);
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
                tr("Antialiasing that the scene asks for: samples of a pixel, or the "
                   "exact area; only pixels that an edge passes have more than one"));
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
