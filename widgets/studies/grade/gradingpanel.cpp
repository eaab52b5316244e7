// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/gradingpanel.h"

#include "core/grade/showntext.h"
#include "core/scene/scenefile.h"
#include "widgets/look/labels.h"
#include "widgets/look/parts.h"
#include "widgets/model/scenedocument.h"
#include "widgets/studies/grade/gradebook.h"
#include "widgets/studies/grade/gradedialog.h"
#include "widgets/studies/grade/gradereviewpane.h"
#include "widgets/studies/grade/gradetable.h"
#include "widgets/studies/studypanel.h"

#include <algorithm>

namespace pixelplumb {

GradingPanel::GradingPanel(SceneDocument *document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_book(new Gradebook(this))
    , m_model(gradeRows(m_book, this))
    , m_filter(new GradeFilter(this))
{
    setObjectName(u"grading"_s);
    m_filter->setSourceModel(m_model);
    auto *layout = withParts(new QVBoxLayout(this), {}, 8, 8);
    addFiles(layout);
    auto *row = new QHBoxLayout;
    row->setSpacing(8);
    addTable(row);
    m_review = new GradeReviewPane(m_book, this);
    row->addWidget(m_review, 2);
    layout->addLayout(row, 1);
    setFocusProxy(m_table);
    connect(m_book, &Gradebook::opened, this, &GradingPanel::showReport);
    connect(m_book, &Gradebook::reviewed, this, &GradingPanel::showSummary);
    connect(m_review, &GradeReviewPane::sceneChosen, this, &GradingPanel::openChosen);
    connect(m_review, &GradeReviewPane::left, m_table, qOverload<>(&QWidget::setFocus));
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            [this] { m_taking.start(); });
    m_taking.setSingleShot(true); // after whatever moves the selection, before a picture is opened
    m_taking.setInterval(0);
    connect(&m_taking, &QTimer::timeout, this, &GradingPanel::takeChosen);
    connect(&m_book->job(), &Job::started, this, &GradingPanel::followJob);
    connect(&m_book->job(), &Job::ended, this, &GradingPanel::followJob);
    followJob();
    showReport();
}

GradingPanel::~GradingPanel()
{
    delete m_review; // saves what is being typed, while the book exists
}

QSize GradingPanel::sizeHint() const
{
    return {960, m_book->results().isEmpty() ? minimumSizeHint().height() : 440};
}

void GradingPanel::addFiles(QBoxLayout *layout)
{
    auto *open = namedButton("gradingOpen", tr("Open results…"),
                             tr("Open a folder of results: of this window or of pixelplumb-cli "
                                "grade"),
                             this);
    auto *grade
        = namedButton("gradingGrade", tr("Grade a folder…"),
                      tr("Grade a folder of submissions by an assignment or by this scene"), this);
    m_report = namedButton("gradingReports", tr("Write reports"),
                           tr("Write the reports again, with your comments: for Gradescope and "
                              "others, the table and the page"),
                           this);
    auto *progress
        = new JobBar(m_book->job(), u"grading"_s, tr("Submissions that are graded"), 160, this);
    m_words = explained(new QLineEdit(this), "gradingFilter",
                        tr("Show the submissions that contain these words"));
    m_words->setPlaceholderText(tr("filter"));
    m_words->setClearButtonEnabled(true);
    m_words->setMinimumWidth(72); // fits the placeholder
    m_words->setMaximumWidth(160);
    m_cluster
        = explained(new QComboBox(this), "gradingClusters", tr("Show one cause's submissions"));
    m_cluster->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_cluster->setMinimumContentsLength(8);
    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    for (QWidget *each : std::initializer_list<QWidget *>{open, grade, m_report, progress})
        row->addWidget(each);
    row->addStretch();
    row->addWidget(m_words);
    row->addWidget(m_cluster);
    layout->addLayout(row);
    connect(open, &QToolButton::clicked, this, &GradingPanel::openResults);
    connect(grade, &QToolButton::clicked, this, &GradingPanel::gradeFolder);
    connect(m_report, &QToolButton::clicked, m_book, &Gradebook::writeReports);
    connect(progress, &JobBar::cancelled, m_book, &Gradebook::cancel);
    connect(m_words, &QLineEdit::textChanged, this,
            [this](const QString &words) { narrow([&] { m_filter->setWords(words); }); });
    connect(m_cluster, &QComboBox::currentIndexChanged, this,
            [this](int index) { narrow([&] { m_filter->setCluster(index - 1); }); });
}

void GradingPanel::addTable(QBoxLayout *layout)
{
    auto *column = new QVBoxLayout;
    m_table = new GradeTable(m_filter, this);
    m_summary = named(new ElidedLabel(this), "gradingSummary");
    m_confinement = explained(new ElidedLabel(this), "gradingConfinement",
                              tr("What programs could do that ran in no sandbox"));
    column->addWidget(m_table, 1);
    column->addWidget(m_confinement);
    column->addWidget(m_summary);
    layout->addLayout(column, 3);
    for (const auto opening : {&QTableView::clicked, &QTableView::activated})
        connect(m_table, opening, this, &GradingPanel::openChosen);
    connect(m_table, &GradeTable::moved, this, &GradingPanel::openChosen);
    connect(m_table, &GradeTable::acceptAsked, this, [this] {
        takeChosen();
        m_review->toggleAccepted();
    });
    connect(m_table, &GradeTable::commentAsked, this, [this] {
        takeChosen();
        m_review->beginComment();
    });
}

void GradingPanel::openResults()
{
    QFileDialog dialog(this, tr("Open Results"));
    dialog.setObjectName(u"gradingOpenDialog"_s);
    dialog.setFileMode(QFileDialog::Directory);
    if (dialog.exec() != QDialog::Accepted)
        return;
    m_book->open(dialog.selectedFiles().constFirst());
    setFocus(); // for the keys of its table
}

void GradingPanel::gradeFolder()
{
    GradeDialog dialog(this);
    dialog.setPaths(m_paths.submissions, m_paths.assignment, m_paths.results);
    const bool isAccepted = dialog.exec() == QDialog::Accepted;
    m_paths = {dialog.submissions(), dialog.assignment(), dialog.results(), dialog.leeway()};
    if (!isAccepted)
        return;
    if (dialog.isByScene())
        m_book->gradeByScene(m_paths.submissions, m_document->scene(), tr("The window's scene"),
                             m_paths.results, m_paths.leeway);
    else if (kindOfFile(m_paths.assignment) == FileKind::Scene)
        emit sceneMet(m_paths.assignment);
    else
        m_book->grade(m_paths.submissions, m_paths.assignment, m_paths.results, m_paths.leeway);
}

void GradingPanel::gradeByScene(const QString &sceneFile)
{
    const auto reading = readSceneFile(sceneFile);
    if (reading)
        m_book->gradeByScene(m_paths.submissions, reading->scene, QFileInfo(sceneFile).baseName(),
                             m_paths.results, m_paths.leeway);
    else
        emit m_book->complaint(tr("Nothing is graded: %1").arg(reading.error().message()));
}

void GradingPanel::gradeBy(const QString &assignment)
{
    m_paths.assignment = assignment;
    gradeFolder();
}

void GradingPanel::followJob()
{
    const bool runs = m_book->job().isRunning();
    m_report->setEnabled(!runs && !m_book->results().isEmpty());
}

void GradingPanel::showReport()
{
    m_cluster->clear();
    m_cluster->addItem(tr("all causes"));
    for (const GradeCluster &cluster : m_book->clusters())
        m_cluster->addItem(
            tr("%1 (%2)").arg(cluster.title, QString::number(cluster.submissions.size())));
    m_table->fitColumns();
    m_report->setEnabled(!m_book->results().isEmpty());
    showSummary();
    updateGeometry();
    emit neededHeightChanged();
    emit closeRequested(); // it belongs to the previous report
    m_table->setCurrentIndex(m_filter->index(0, 0));
}

std::optional<std::size_t> GradingPanel::chosen() const
{
    const std::optional<int> row = m_table->chosenRow();
    return row ? std::optional(std::size_t(m_filter->mapToSource(m_filter->index(*row, 0)).row()))
               : std::nullopt;
}

void GradingPanel::showSummary()
{
    const GradeReport &report = m_book->report();
    m_review->setVisible(!m_book->results().isEmpty()); // else there is nobody to review
    const QStringList lacks = sandboxLacks(report);
    m_confinement->setVisible(!lacks.isEmpty());
    m_confinement->setWholeText(tr("No sandbox (%1): programs could use the network, read and "
                                   "change files, and end processes, as far as their user may.")
                                    .arg(lacks.join(u"; "_s)));
    const auto accepted
        = std::ranges::count_if(report.submissions, [](const GradedSubmission &submission) {
              return submission.review.isAccepted;
          });
    m_summary->setWholeText(
        m_book->results().isEmpty()
            ? tr("Open a folder of results, or grade a folder of submissions.")
            : tr("%1 of %2 accepted%3 · J, K: next, previous · A: accept · C: comment · %4")
                  .arg(QString::number(accepted), QString::number(report.submissions.size()),
                       report.missing.isEmpty()
                           ? QString()
                           : tr(", %1 more without a grade").arg(report.missing.size()),
                       escapedControls(report.assignment.name)));
}

/// Narrows the table. The view would select the neighbour of a row that is filtered out, which
/// nobody has chosen.
template <class Change>
void GradingPanel::narrow(const Change &change)
{
    const auto before = chosen();
    change();
    const QModelIndex row
        = before ? m_filter->mapFromSource(m_model->index(int(*before), 0)) : QModelIndex();
    if (row.isValid())
        m_table->setCurrentIndex(row);
    else
        putDown();
}

void GradingPanel::putDown() { m_table->selectionModel()->clear(); }

void GradingPanel::takeChosen()
{
    m_taking.stop();
    if (chosen() == m_review->submission())
        return;
    m_review->setSubmission(chosen());
    if (!chosen())
        emit closeRequested();
    else
        openCurrent();
}

void GradingPanel::openChosen()
{
    if (chosen() == m_review->submission())
        openCurrent();
    else
        takeChosen();
}

void GradingPanel::openCurrent()
{
    if (const auto picture = m_review->picture())
        emit openRequested(*picture);
}

} // namespace pixelplumb
