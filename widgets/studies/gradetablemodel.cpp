// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/gradetablemodel.h"

#include "widgets/look/corewords.h"
#include "widgets/studies/gradebook.h"

namespace pixelplumb {

namespace {

constexpr QChar tick(0x2713);

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

} // namespace pixelplumb
