// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/gradetable.h"

#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"
#include "widgets/studies/grade/gradebook.h"

#include <QKeyEvent>

#include <algorithm>
#include <numeric>

namespace pixelplumb {

namespace {

constexpr QChar tick(0x2713);
constexpr int clusterRole = Qt::UserRole + 1; ///< index of the cluster, in the first column

// Logical pixels.
constexpr int leastForComments = 120; ///< below this, comments are not worth a column
constexpr int leastForVerdicts = 400; ///< table width below which verdicts are elided

/// An undecidable picture has full points, so the window calls it right.
QString shownVerdict(const GradedSubmission &submission)
{
    return coreWord(verdictText(submission)
                        .replace(nameOf(GradeVerdict::Undecidable), u"right within leeway"_s));
}

QString verdictToolTip(const GradedSubmission &submission)
{
    if (submission.verdict != GradeVerdict::Undecidable)
        return {};
    return GradeTable::tr("Right within the leeway: every pixel that differs is one that the "
                          "leeway leaves open.");
}

} // namespace

GradeRows *gradeRows(const Gradebook *book, QObject *parent)
{
    using Column = RowsColumn<std::size_t>;
    const auto at = [book](std::size_t row) -> const GradedSubmission & {
        return book->report().submissions[row];
    };
    auto *model = new GradeRows(
        {Column(
             GradeTable::tr("name"), {}, [at](std::size_t row) { return at(row).name; },
             Qt::AlignLeft,
             [book](std::size_t row, int role) {
                 return role == clusterRole ? QVariant(int(book->clusterOf(row))) : QVariant();
             }),
         Column(
             GradeTable::tr("points"), {},
             [book, at](std::size_t row) {
                 return u"%L1 / %L2"_s.arg(at(row).points())
                     .arg(book->report().assignment.points());
             },
             Qt::AlignRight,
             [at](std::size_t row, int role) {
                 return role == GradeRows::SortRole ? QVariant(at(row).points()) : QVariant();
             }),
         Column(
             GradeTable::tr("verdict"), {}, [at](std::size_t row) { return shownVerdict(at(row)); },
             Qt::AlignLeft,
             [at](std::size_t row, int role) {
                 return role == Qt::ToolTipRole ? QVariant(verdictToolTip(at(row))) : QVariant();
             }),
         Column(
             GradeTable::tr("defects"), {},
             [book](std::size_t row) { return book->clusters()[book->clusterOf(row)].title; },
             Qt::AlignLeft),
         Column(
             QString(tick), GradeTable::tr("accepted"),
             [at](std::size_t row) {
                 return at(row).review.isAccepted ? QString(tick) : QString();
             },
             Qt::AlignLeft,
             [at](std::size_t row, int role) {
                 const bool isWord = role == Qt::ToolTipRole || role == Qt::AccessibleTextRole
                     || role == GradeRows::SortRole;
                 if (!isWord)
                     return QVariant();
                 return QVariant(at(row).review.isAccepted ? GradeTable::tr("accepted")
                                                           : GradeTable::tr("open"));
             }),
         Column(
             GradeTable::tr("comment"), {},
             [at](std::size_t row) { return at(row).review.comment.simplified(); }, Qt::AlignLeft)},
        parent);
    const auto take = [book, model] {
        std::vector<std::size_t> rows(book->report().submissions.size());
        std::iota(rows.begin(), rows.end(), std::size_t(0));
        model->setRows(std::move(rows));
    };
    QObject::connect(book, &Gradebook::opened, model, take);
    QObject::connect(book, &Gradebook::reviewed, model, [model] { model->refresh(); });
    take();
    return model;
}

GradeFilter::GradeFilter(QObject *parent)
    : QSortFilterProxyModel(parent)
{
    setSortRole(GradeRows::SortRole);
    setSortCaseSensitivity(Qt::CaseInsensitive);
}

void GradeFilter::setWords(const QString &words)
{
    m_words = words.split(u' ', Qt::SkipEmptyParts);
    invalidateFilter();
}

void GradeFilter::setCluster(int cluster)
{
    m_cluster = cluster;
    invalidateFilter();
}

bool GradeFilter::filterAcceptsRow(int row, const QModelIndex &parent) const
{
    const QAbstractItemModel *model = sourceModel();
    const QModelIndex first = model->index(row, 0, parent);
    if (m_cluster != allClusters && first.data(clusterRole).toInt() != m_cluster)
        return false;
    QString text;
    for (int column = 0; column < model->columnCount(parent); ++column) {
        const QModelIndex cell = first.siblingAtColumn(column);
        text += cell.data(column == GradeColumn::State ? Qt::ToolTipRole : Qt::DisplayRole)
                    .toString()
            + u'\n';
    }
    return std::ranges::all_of(
        m_words, [&text](const QString &word) { return text.contains(word, Qt::CaseInsensitive); });
}

GradeTable::GradeTable(QAbstractItemModel *model, QWidget *parent)
    : QTableView(parent)
{
    named(this, "gradingTable", tr("Submissions"));
    setModel(model);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setSortingEnabled(true);
    sortByColumn(GradeColumn::Name, Qt::AscendingOrder);
    setWordWrap(false);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    horizontalHeader()->setMinimumSectionSize(24);
    horizontalHeader()->setTextElideMode(Qt::ElideRight);
}

std::optional<int> GradeTable::chosenRow() const
{
    const QModelIndexList rows = selectionModel()->selectedRows();
    return rows.isEmpty() ? std::nullopt : std::optional(rows.front().row());
}

void GradeTable::moveBy(int rows)
{
    const int count = model()->rowCount();
    if (count == 0)
        return;
    const std::optional<int> chosen = chosenRow();
    const int row = chosen ? std::clamp(*chosen + rows, 0, count - 1) : 0;
    setCurrentIndex(model()->index(row, 0));
    emit moved();
}

/// Gives the defects the width they need, before comments, which a narrow table drops: the current
/// one is shown beside it. If that is not enough, the verdict's words and long names, down to a
/// third, give way.
void GradeTable::fitColumns()
{
    QHeaderView *header = horizontalHeader();
    const auto contentWidth = [this, header](int column) {
        resizeColumnToContents(column);
        return header->sectionSize(column);
    };
    const int width = viewport()->width();
    int rest = width - contentWidth(GradeColumn::Points) - contentWidth(GradeColumn::State);
    const int verdicts = width < leastForVerdicts ? header->sectionSizeHint(GradeColumn::Verdict)
                                                  : contentWidth(GradeColumn::Verdict);
    header->resizeSection(GradeColumn::Verdict, verdicts);
    rest -= verdicts;
    const int causes = contentWidth(GradeColumn::Cause);
    const int names
        = std::min({contentWidth(GradeColumn::Name),
                    std::max({rest - causes, rest / 3, header->sectionSizeHint(GradeColumn::Name)}),
                    rest - header->sectionSizeHint(GradeColumn::Cause)});
    rest -= names;
    header->resizeSection(GradeColumn::Name, names);
    const bool hasComments = rest - causes >= leastForComments;
    setColumnHidden(GradeColumn::Comment, !hasComments);
    header->resizeSection(GradeColumn::Cause, hasComments ? causes : rest);
    if (hasComments)
        header->resizeSection(GradeColumn::Comment, rest - causes);
}

void GradeTable::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    fitColumns();
}

bool GradeTable::press(int key)
{
    switch (key) {
    case Qt::Key_J:
    case Qt::Key_Down:
        moveBy(1);
        return true;
    case Qt::Key_K:
    case Qt::Key_Up:
        moveBy(-1);
        return true;
    case Qt::Key_A:
        emit acceptAsked();
        return true;
    case Qt::Key_C:
        emit commentAsked();
        return true;
    default:
        return false;
    }
}

void GradeTable::keyPressEvent(QKeyEvent *event)
{
    const bool isPlain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    if (!isPlain || !press(event->key()))
        QTableView::keyPressEvent(event);
}

} // namespace pixelplumb
