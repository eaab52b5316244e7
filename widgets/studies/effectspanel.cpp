// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/effectspanel.h"

#include "core/methods/method.h"
#include "core/runs/sceneplan.h"
#include "core/scan/choicenames.h"
#include "widgets/look/corewords.h"
#include "widgets/look/numberlayout.h"
#include "widgets/model/effectswitches.h"
#include "widgets/model/measuringpool.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"
#include "widgets/studies/effectstext.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

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
    : QWidget(parent)
    , m_document(document)
    , m_switches(switches)
    , m_summary(new QLabel(this))
    , m_table(new QTableWidget(this))
    , m_measureJob(nullptr, measuringPool())
{
    setObjectName(QStringLiteral("effectsPanel"));
    setAccessibleName(tr("Effects"));
    m_summary->setObjectName(QStringLiteral("effectsSummary"));
    m_summary->setAccessibleName(tr("What is forced, and what that changes"));
    m_summary->setWordWrap(true);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    makeTable();
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    layout->addLayout(controls());
    layout->addWidget(m_table, 1);
    connect(document, &SceneDocument::sceneChanged, this, &EffectsPanel::forget);
    connect(document, &SceneDocument::currentFrameChanged, this, &EffectsPanel::forget);
    connect(switches, &EffectSwitches::changed, this, &EffectsPanel::forget);
    forget();
}

void EffectsPanel::makeTable()
{
    m_table->setObjectName(QStringLiteral("effectsTable"));
    m_table->setAccessibleName(tr("Effects"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setFont(tabularFont(font()));
    m_table->setRowCount(int(allEffects.size()));
    m_table->setColumnCount(EffectColumnCount);
    m_table->setHorizontalHeaderLabels({tr("effect"), tr("verdict"), tr("switch"), tr("primitives"),
                                        tr("pixels ≤"), tr("ns a pixel"), tr("operations a pixel"),
                                        tr("times as long"), tr("reason")});
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
    m_planJob.cancel();
    m_measureJob.cancel();
    m_timing.reset();
    m_switches->setChanges(nullptr);
    m_isStale = true;
    m_samples->setCurrentIndex(
        m_samples->findData(int(m_document->scene().appearance.antialiasing)));
    showSwitches();
    showTiming();
    follow();
}

EffectsPanel::Finding EffectsPanel::findingOf(const Scene &scene)
{
    Finding finding{planOf(scene), objectionTo(scene), nullptr};
    if (scene.appearance.forced != EffectForcing{} && finding.objection.isEmpty())
        finding.changes = std::make_shared<DifferenceMap>(changesByForcing(scene));
    return finding;
}

/// During a drag newer plans cancel older ones.
void EffectsPanel::follow()
{
    if (!isVisible() || !m_isStale)
        return;
    m_isStale = false;
    m_planJob.start(
        [scene = drawnScene()](const ProgressListener &) {
            return std::optional<Finding>(findingOf(*scene));
        },
        [this](const std::optional<Finding> &finding) { take(finding); });
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

void EffectsPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    follow();
}

} // namespace pixelplumb
