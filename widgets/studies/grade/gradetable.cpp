// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/gradetable.h"

#include "widgets/look/corewords.h"
#include "widgets/look/parts.h"
#include "widgets/studies/grade/gradebook.h"

#include <QHeaderView>
#include <QKeyEvent>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr QChar tick(0x2713);

// Logical pixels.
constexpr int leastForComments = 120; ///< below this, comments are not worth a column
constexpr int leastForVerdicts = 400; ///< table width below which verdicts are elided

} // namespace

GradeTableModel::GradeTableModel(const Gradebook *book, QObject *parent)
    : QAbstractTableModel(parent)
    , m_book(book)
{
    connect(book, &Gradebook::opened, this, [this] {
        beginResetModel();
        endResetModel();
    });
    connect(book, &Gradebook::reviewed, this, [this] {
        if (rowCount() > 0)
            emit dataChanged(index(0, State), index(rowCount() - 1, Comment));
    });
}

int GradeTableModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : int(m_book->report().submissions.size());
}

int GradeTableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : int(ColumnCount);
}

QVariant GradeTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && role == Qt::ToolTipRole && section == State)
        return tr("accepted");
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Name:
        return tr("name");
    case Points:
        return tr("points");
    case Verdict:
        return tr("verdict");
    case Cause:
        return tr("defects");
    case State:
        return QString(tick);
    default:
        return tr("comment");
    }
}

QString GradeTableModel::textOf(std::size_t row, int column) const
{
    const GradedSubmission &submission = m_book->report().submissions[row];
    switch (column) {
    case Name:
        return submission.name;
    case Points:
        return QStringLiteral("%L1 / %L2")
            .arg(submission.points())
            .arg(m_book->report().assignment.points());
    case Verdict:
        return coreWord(verdictText(submission));
    case Cause:
        return m_book->clusters()[m_book->clusterOf(row)].title;
    case State:
        return submission.review.isAccepted ? tr("accepted") : tr("open");
    default:
        return submission.review.comment.simplified();
    }
}

QVariant GradeTableModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const auto row = std::size_t(index.row());
    const bool isPoints = index.column() == Points;
    switch (role) {
    case Qt::DisplayRole:
        if (index.column() == State)
            return m_book->report().submissions[row].review.isAccepted ? QString(tick) : QString();
        return textOf(row, index.column());
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return textOf(row, index.column());
    case Qt::TextAlignmentRole:
        return isPoints ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
    case SortRole:
        return isPoints ? QVariant(m_book->report().submissions[row].points())
                        : QVariant(textOf(row, index.column()));
    case ClusterRole:
        return int(m_book->clusterOf(row));
    default:
        return {};
    }
}

GradeFilter::GradeFilter(QObject *parent)
    : QSortFilterProxyModel(parent)
{
    setSortRole(GradeTableModel::SortRole);
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
    if (m_cluster != allClusters && first.data(GradeTableModel::ClusterRole).toInt() != m_cluster)
        return false;
    QString text;
    for (int column = 0; column < model->columnCount(parent); ++column)
        text += first.siblingAtColumn(column).data(Qt::ToolTipRole).toString() + u'\n';
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
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSortingEnabled(true);
    sortByColumn(GradeTableModel::Name, Qt::AscendingOrder);
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
    int rest = width - contentWidth(GradeTableModel::Points) - contentWidth(GradeTableModel::State);
    const int verdicts = width < leastForVerdicts
        ? header->sectionSizeHint(GradeTableModel::Verdict)
        : contentWidth(GradeTableModel::Verdict);
    header->resizeSection(GradeTableModel::Verdict, verdicts);
    rest -= verdicts;
    const int causes = contentWidth(GradeTableModel::Cause);
    const int names = std::min(
        {contentWidth(GradeTableModel::Name),
         std::max({rest - causes, rest / 3, header->sectionSizeHint(GradeTableModel::Name)}),
         rest - header->sectionSizeHint(GradeTableModel::Cause)});
    rest -= names;
    header->resizeSection(GradeTableModel::Name, names);
    const bool hasComments = rest - causes >= leastForComments;
    setColumnHidden(GradeTableModel::Comment, !hasComments);
    header->resizeSection(GradeTableModel::Cause, hasComments ? causes : rest);
    if (hasComments)
        header->resizeSection(GradeTableModel::Comment, rest - causes);
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
