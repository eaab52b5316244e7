// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/accuracylab.h"

#include "widgets/lab/labcharts.h"
#include "widgets/lab/labcontrols.h"
#include "widgets/lab/labfiles.h"
#include "widgets/lab/labrun.h"
#include "widgets/lab/labtext.h"
#include "widgets/look/labels.h"
#include "widgets/look/parts.h"
#include "widgets/model/playhead.h"

namespace pixelplumb {

namespace {

constexpr int lowPanel = 340; ///< logical pixels

} // namespace

AccuracyLab::AccuracyLab(Playhead *playhead, QWidget *parent)
    : QWidget(parent)
    , m_playhead(playhead)
    , m_run(new LabRun(this))
    , m_files(new LabFiles(this))
    , m_controls(new LabControls(m_run, this))
    , m_charts(new LabCharts(this))
    , m_invitation(new QLabel(this))
    , m_warnings(new ElidedLabel(this))
    , m_conditions(new ElidedLabel(this))
    , m_lastLine(new QStackedWidget(this))
{
    named(this, "accuracyLab", tr("Accuracy lab"));
    m_invitation->setObjectName(u"labInvitation"_s);
    m_invitation->setWordWrap(true);
    m_invitation->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    named(m_warnings, "labWarnings", tr("Warnings"));
    named(m_conditions, "labConditions", tr("Machine, compiler and command to reproduce this"));
    auto *layout
        = withParts(new QVBoxLayout(this), {m_controls, {m_invitation, 1}, {m_charts, 1}}, 4);
    layout->setContentsMargins(8, 4, 8, 4);
    m_foot = new QBoxLayout(QBoxLayout::TopToBottom);
    m_foot->setSpacing(4);
    m_foot->addWidget(m_warnings, 1);
    m_lastLine->addWidget(m_conditions);
    m_lastLine->addWidget(m_controls->progress());
    m_lastLine->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_foot->addWidget(m_lastLine, 1);
    layout->addLayout(m_foot);
    connect(m_run, &LabRun::resultsChanged, this, &AccuracyLab::takeNews);
    connect(m_run, &LabRun::ended, this, &AccuracyLab::endRun);
    connect(m_charts, &LabCharts::missRequested, this, &AccuracyLab::openMiss);
    connect(m_files, &LabFiles::complaint, this, &AccuracyLab::complaint);
    connect(m_files, &LabFiles::notice, this, &AccuracyLab::notice);
    connectControls();
    // In a low panel the foot has one line, which leaves the charts the other. Warnings that come
    // or go never resize a chart.
    onEvents(this, {QEvent::Resize}, [this] {
        const bool isLow = height() < lowPanel;
        m_foot->setDirection(isLow ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
        QSizePolicy policy = m_warnings->sizePolicy();
        policy.setRetainSizeWhenHidden(!isLow);
        m_warnings->setSizePolicy(policy);
    });
    showState();
}

void AccuracyLab::connectControls()
{
    connect(m_controls, &LabControls::runRequested, this, &AccuracyLab::run);
    connect(m_controls, &LabControls::cancelRequested, this, &AccuracyLab::cancel);
    connect(m_controls, &LabControls::extentChanged, this, &AccuracyLab::showState);
    connect(m_controls, &LabControls::choiceChanged, this, &AccuracyLab::showChoice);
    connect(m_controls, &LabControls::openRequested, this, [this] {
        if (const QString path = m_files->askForInput(tr("Open Results")); !path.isEmpty())
            openResults(path);
    });
    connect(m_controls, &LabControls::saveRequested, this, [this] {
        const QString path = m_files->askForOutput(tr("Save the Results"),
                                                   tr("Results of the lab (*.json)"), u"json"_s);
        if (!path.isEmpty())
            m_files->writeResults(path, *results());
    });
    connect(m_controls, &LabControls::saveTableRequested, this, [this] {
        const QString path
            = m_files->askForOutput(tr("Save the Table"), tr("CSV tables (*.csv)"), u"csv"_s);
        if (!path.isEmpty())
            m_files->writeTable(path, *results());
    });
    connect(m_controls, &LabControls::saveChartRequested, this, &AccuracyLab::saveChart);
    connect(m_controls, &LabControls::copyCommandRequested, this, [this] {
        if (results()->command.isEmpty()) {
            emit complaint(tr("There is no command because the scene was not saved when it was "
                              "measured. Save it and run the lab again."));
            return;
        }
        QApplication::clipboard()->setText(results()->command);
        emit notice(tr("The command is on the clipboard."));
    });
}

bool AccuracyLab::isRunning() const { return m_run->isRunning(); }

QSize AccuracyLab::sizeHint() const { return {960, results() ? 600 : minimumSizeHint().height()}; }

void AccuracyLab::setScenePath(const QString &path) { m_scenePath = path; }

StudySettings AccuracyLab::settings() const
{
    StudySettings settings = m_request;
    settings.extent = m_controls->extent();
    if (const auto traced = m_playhead->sharedTraced())
        settings.ownScene = {traced, &traced->scene};
    settings.ownSceneName = m_isSceneModified ? QString() : m_scenePath;
    return settings;
}

void AccuracyLab::run()
{
    StudySettings asked = settings();
    if (asked.hardCases.empty()) {
        if (auto cases = builtInHardCases())
            asked.hardCases = std::move(*cases);
    }
    m_shown.beginRun();
    m_run->start(asked);
    showState();
}

void AccuracyLab::cancel() { m_run->cancel(); }

void AccuracyLab::takeNews(const SharedResults &news)
{
    if (m_shown.takeNews(news, m_controls->family()))
        showResults();
}

void AccuracyLab::endRun()
{
    if (m_shown.endRun())
        showResults();
    if (results() && !m_shown.areOfRun())
        emit notice(tr("Cancelled before anything was timed; the earlier results stay."));
    showState();
}

void AccuracyLab::showResults()
{
    m_controls->setFamilies(results()->families);
    showChoice();
    showState();
    emit resultsChanged();
}

void AccuracyLab::showChoice()
{
    if (results())
        m_charts->show(results(), m_controls->family(), m_controls->errorAxis());
}

void AccuracyLab::showState()
{
    m_controls->showRunning();
    m_controls->setHasResults(results() != nullptr);
    const bool hadCharts = m_charts->isVisibleTo(this);
    m_charts->setVisible(results() != nullptr);
    m_lastLine->setCurrentWidget(isRunning() ? m_controls->progress() : m_conditions);
    m_invitation->setVisible(!results());
    m_invitation->setText(isRunning()
                              ? tr("The first pictures are being judged.")
                              : invitationText(m_controls->extent(), expectedSeconds(settings())));
    QStringList warnings;
    if (results() && !isRunning())
        warnings = warningsOf(*results());
    else if (results() && !m_shown.areOfRun())
        warnings = {tr("These are the results of the previous run, until this run has "
                       "times for this family.")};
    m_warnings->setVisible(!warnings.isEmpty());
    m_warnings->setWholeText(u"⚠ "_s + warnings.join(u" ⚠ "_s));
    if (results())
        m_conditions->setWholeText(originOf(*results()).join(u" · "_s));
    if (hadCharts != m_charts->isVisibleTo(this)) {
        updateGeometry();
        emit neededHeightChanged();
    }
}

void AccuracyLab::openMiss(const QString &contender)
{
    const LabRow *row = results() ? results()->row(contender, m_controls->family()) : nullptr;
    if (!row)
        return;
    if (row->firstMiss)
        emit missRequested(*row->firstMiss);
    else
        emit notice(tr("There is no wrong pixel to look at here."));
}

void AccuracyLab::saveChart()
{
    LabPlot *chart = m_charts->chartInFront();
    if (!chart) {
        emit complaint(tr("The table is in front: choose the tab of a chart."));
        return;
    }
    const QString path = m_files->askForOutput(
        tr("Save the Chart"), tr("SVG drawings (*.svg);;PNG pictures (*.png)"), u"svg"_s);
    if (!path.isEmpty())
        m_files->writeChart(path, *chart, *results());
}

bool AccuracyLab::openResults(const QString &path)
{
    std::optional<Study> study = m_files->read(path);
    if (!study)
        return false;
    m_run->drop();
    m_shown.replaceBy(std::make_shared<const Study>(std::move(*study)));
    showResults();
    return true;
}

} // namespace pixelplumb
