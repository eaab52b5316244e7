// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labcontrols.h"

#include "widgets/lab/labrun.h"
#include "widgets/look/corewords.h"
#include "widgets/look/labels.h"
#include "widgets/look/parts.h"

namespace pixelplumb {

namespace {

constexpr int progressSteps = 1000;

} // namespace

LabControls::LabControls(const LabRun *run, QWidget *parent)
    : QWidget(parent)
    , m_run(run)
{
    auto *layout = withParts(new QVBoxLayout(this), {}, 4, 0);
    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    m_start = named(new QPushButton(tr("&Run"), this), "labRun", {},
                    tr("Judge and time every contender"));
    row->addWidget(m_start);
    m_extent = addBox(row, "labExtent", tr("Extent of the study"),
                      tr("Quick: fifteen contenders, 20 seconds. Full: every method in every "
                         "arithmetic, five minutes"));
    m_extent->addItem(tr("quick"), int(StudyExtent::Quick));
    m_extent->addItem(tr("full"), int(StudyExtent::Full));
    m_family = addBox(row, "labFamily", tr("Family of triangles"),
                      tr("Which triangles: each kind ranks the methods differently, so they are "
                         "never averaged"));
    m_family->setPlaceholderText(m_family->accessibleName()); // shown before the first run
    m_error = addBox(row, "labError", tr("Error"), tr("Which error the chart shows"));
    for (const ErrorAxis &axis : errorAxes())
        m_error->addItem(coreWord(std::string_view(axis.title)), QString::fromUtf8(axis.id));
    row->setStretch(row->indexOf(m_family), 3);
    row->setStretch(row->indexOf(m_error), 2);
    addFileMenu(row);
    layout->addLayout(row);
    makeProgress();
    connect(m_start, &QPushButton::clicked, this, &LabControls::runRequested);
    connect(m_extent, &QComboBox::currentIndexChanged, this, &LabControls::extentChanged);
    connect(m_family, &QComboBox::currentIndexChanged, this, &LabControls::choiceChanged);
    connect(m_error, &QComboBox::currentIndexChanged, this, &LabControls::choiceChanged);
    connect(run, &LabRun::progressed, this, &LabControls::tellProgress);
    setHasResults(false);
    showRunning();
}

QComboBox *LabControls::addBox(QBoxLayout *row, const char *name, const QString &accessibleName,
                               const QString &toolTip)
{
    auto *box = named(new ElidingBox(this), name, accessibleName, toolTip);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(5);
    row->addWidget(box);
    return box;
}

void LabControls::addFileMenu(QBoxLayout *row)
{
    auto *button = named(new QToolButton(this), "labFiles");
    button->setText(tr("Files"));
    button->setAccessibleName(tr("Files of the lab"));
    button->setToolTip(tr("Save and open results; charts as figures"));
    button->setPopupMode(QToolButton::InstantPopup);
    auto *menu = new QMenu(button);
    const auto add = [this, menu](const char *name, const QString &text, auto signal) {
        QAction *action = menu->addAction(text);
        action->setObjectName(QLatin1String(name));
        connect(action, &QAction::triggered, this, signal);
        return action;
    };
    add("labOpen", tr("&Open results …"), &LabControls::openRequested);
    m_outputs += add("labSave", tr("&Save results …"), &LabControls::saveRequested);
    m_outputs
        += add("labSaveTable", tr("Save as a &table, CSV …"), &LabControls::saveTableRequested);
    menu->addSeparator();
    m_outputs += add("labSaveChart", tr("Save the chart, SVG or &PNG …"),
                     &LabControls::saveChartRequested);
    m_outputs += add("labCopyCommand", tr("Copy the co&mmand that does it again"),
                     &LabControls::copyCommandRequested);
    button->setMenu(menu);
    row->addWidget(button);
}

void LabControls::makeProgress()
{
    m_running = new QWidget(this);
    m_progress = named(new QProgressBar(m_running), "labProgress", tr("Progress of the study"));
    auto *cancel = named(new QPushButton(tr("Cancel"), m_running), "labCancel", {},
                         tr("End the study and keep what it has"));
    withParts(new QHBoxLayout(m_running), {{m_progress, 1}, cancel}, 8, 0);
    // No higher than the line of text in whose place it appears.
    const int lineHeight = fontMetrics().height() + 4;
    m_progress->setFixedHeight(lineHeight);
    cancel->setFixedHeight(lineHeight);
    connect(cancel, &QPushButton::clicked, this, &LabControls::cancelRequested);
}

StudyExtent LabControls::extent() const { return StudyExtent(m_extent->currentData().toInt()); }

QString LabControls::family() const { return m_family->currentData().toString(); }

const ErrorAxis &LabControls::errorAxis() const
{
    const ErrorAxis *axis = errorAxisNamed(m_error->currentData().toString());
    return axis ? *axis : errorAxes().front();
}

void LabControls::setFamilies(const std::vector<StudyFamily> &families)
{
    bool isSame = m_family->count() == int(families.size());
    for (int i = 0; isSame && i < m_family->count(); ++i)
        isSame = m_family->itemData(i).toString() == families[std::size_t(i)].id;
    if (isSame)
        return;
    const QString kept = family();
    const QSignalBlocker blocker(m_family);
    m_family->clear();
    for (const StudyFamily &each : families) {
        m_family->addItem(coreWord(each.title), each.id);
        m_family->setItemData(m_family->count() - 1, each.stresses, Qt::ToolTipRole);
    }
    m_family->setCurrentIndex(std::max(0, m_family->findData(kept)));
}

void LabControls::setHasResults(bool hasResults)
{
    for (QAction *action : std::as_const(m_outputs))
        action->setEnabled(hasResults);
    m_family->setEnabled(hasResults);
    m_error->setEnabled(hasResults);
}

void LabControls::showRunning()
{
    const bool isRunning = m_run->isRunning();
    if (m_start->isEnabled() != isRunning)
        return;
    m_start->setEnabled(!isRunning);
    m_extent->setEnabled(!isRunning);
    tellProgress();
}

void LabControls::tellProgress()
{
    const TimeLeft &left = m_run->timeLeft();
    m_progress->setRange(0, progressSteps);
    m_progress->setValue(int(left.share() * progressSteps));
    const QString text = coreWords(left.text(), u": "_s);
    m_progress->setFormat(text);
    m_progress->setToolTip(text);
}

} // namespace pixelplumb
