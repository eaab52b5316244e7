// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labtable.h"

#include "widgets/lab/labtext.h"
#include "widgets/look/numberlayout.h"
#include "widgets/look/parts.h"

#include <QtWidgets>

#include <algorithm>
#include <limits>

namespace pixelplumb {

namespace {

using Figure = std::optional<double>;

template <auto Member>
Figure countOf(const Study &, const LabRow &row)
{
    return row.accuracy ? Figure(double((*row.accuracy).*Member)) : std::nullopt;
}

Figure wrongPerMillion(const Study &, const LabRow &row)
{
    return row.accuracy ? Figure(row.accuracy->wrongPerMillion()) : std::nullopt;
}

Figure ties(const Study &, const LabRow &row)
{
    return row.accuracy ? Figure(double(row.accuracy->tiesMissing + row.accuracy->tiesExtra))
                        : std::nullopt;
}

Figure perPixel(const Study &study, const LabRow &row) { return study.perPixel(row); }

/// The middle half as a percentage of the median.
Figure spreadShare(const Study &, const LabRow &row)
{
    if (!row.cost || row.cost->perDraw.median <= 0)
        return std::nullopt;
    const Spread &time = row.cost->perDraw;
    return 100 * (time.upper - time.lower) / time.median;
}

Figure timesReference(const Study &study, const LabRow &row)
{
    const LabRow *reference = study.row(QString::fromLatin1(referenceContenderId), row.family);
    if (!row.cost || !reference || !reference->cost || reference->cost->perDraw.median <= 0)
        return std::nullopt;
    return row.cost->perDraw.median / reference->cost->perDraw.median;
}

Figure timesStraight(const Study &, const LabRow &row)
{
    return row.cost && row.cost->timesStraight ? Figure(row.cost->timesStraight->median)
                                               : std::nullopt;
}

enum class Shown { AsFigure, AsCount };

struct FigureColumn {
    const char *title;
    const char *meaning;
    Figure (*read)(const Study &study, const LabRow &row);
    Shown shown;
};

constexpr FigureColumn figureColumns[] = {
    {QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "wrong of a million"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTableModel",
                       "wrong pixels of a million: those that differ from the truth"),
     wrongPerMillion, Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "ns a pixel"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "the median of all rounds"), perPixel,
     Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "times assignment's"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTableModel",
                       "how many times what the assignment's method takes, the "
                       "column scan in float32"),
     timesReference, Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "times straight loop"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTableModel",
                       "how many times what the shortest loop takes that is written out "
                       "by hand for the same pixels; up to 1.3 is fair"),
     timesStraight, Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "spread, %"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTableModel",
                       "the middle half of all rounds, of their median"),
     spreadShare, Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "missing ?"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "samples inside that are not painted"),
     countOf<&AccuracyFigures::missing>, Shown::AsCount},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "extra !"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "samples outside that are painted"),
     countOf<&AccuracyFigures::extra>, Shown::AsCount},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "ties ="),
     QT_TRANSLATE_NOOP("pixelplumb::LabTableModel",
                       "samples exactly on the boundary that are missing or extra"),
     ties, Shown::AsCount},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "colours c"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "pixels that are there in another colour"),
     countOf<&AccuracyFigures::wrongBytes>, Shown::AsCount},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "levels off"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTableModel", "the largest error of a byte"),
     countOf<&AccuracyFigures::largestByteError>, Shown::AsCount},
};

constexpr int firstFigure = 1; ///< after the contender
constexpr int outcomeColumn = firstFigure + int(std::size(figureColumns));

QString labelOfContender(const Study &study, const QString &id)
{
    const StudyContender *contender = study.contender(id);
    return contender ? contender->label : id;
}

} // namespace

void LabTableModel::show(const std::shared_ptr<const Study> &results, const QString &family)
{
    beginResetModel();
    m_results = results;
    m_rows.clear();
    if (results) {
        for (const LabRow &row : results->rows) {
            if (row.family == family)
                m_rows.push_back(&row);
        }
    }
    endResetModel();
}

int LabTableModel::rowOf(const QString &contender) const
{
    const auto row = std::ranges::find(m_rows, contender, &LabRow::contender);
    return row == m_rows.end() ? -1 : int(row - m_rows.begin());
}

int LabTableModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : int(m_rows.size());
}

int LabTableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : outcomeColumn + 1;
}

QVariant LabTableModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const LabRow &row = rowAt(index.row());
    const int column = index.column();
    if (role == ContenderRole)
        return row.contender;
    if (column == 0 || column == outcomeColumn) {
        if (role == Qt::DisplayRole || role == Qt::ToolTipRole || role == SortRole)
            return column == 0 ? labelOfContender(*m_results, row.contender) : outcomeText(row);
        return {};
    }
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    const FigureColumn &shown = figureColumns[column - firstFigure];
    const Figure figure = shown.read(*m_results, row);
    if (role == SortRole)
        return figure.value_or(std::numeric_limits<double>::infinity());
    if (role == Qt::DisplayRole && figure)
        return shown.shown == Shown::AsCount ? QString::number(*figure, 'f', 0)
                                             : figureText(*figure);
    return {};
}

QVariant LabTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section > outcomeColumn)
        return {};
    const bool isFigure = section >= firstFigure && section < outcomeColumn;
    if (role == Qt::TextAlignmentRole)
        return int((isFigure ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && isFigure)
        return tr(figureColumns[section - firstFigure].meaning);
    if (role != Qt::DisplayRole)
        return {};
    if (isFigure)
        return tr(figureColumns[section - firstFigure].title);
    return section == 0 ? tr("method, arithmetic, kernel") : tr("remark");
}

LabTable::LabTable(QWidget *parent)
    : QTableView(parent)
    , m_model(new LabTableModel(this))
    , m_sorted(new QSortFilterProxyModel(this))
{
    named(this, "labTable", tr("Contenders"));
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(LabTableModel::SortRole);
    setModel(m_sorted);
    setSortingEnabled(true);
    sortByColumn(LabTableModel::costColumn, Qt::AscendingOrder);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setFrameShape(QFrame::NoFrame);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    horizontalHeader()->setHighlightSections(false);
    setFont(tabularFont(font()));
    connect(this, &QTableView::activated, this, [this](const QModelIndex &index) {
        emit contenderActivated(index.data(LabTableModel::ContenderRole).toString());
    });
}

void LabTable::show(const std::shared_ptr<const Study> &results, const QString &family)
{
    const QString kept = selected();
    {
        const QScopedValueRollback filling(m_isFilling, true);
        m_model->show(results, family);
    }
    resizeColumnsToContents();
    select(kept);
}

void LabTable::select(const QString &contender)
{
    const int row = m_model->rowOf(contender);
    const QScopedValueRollback filling(m_isFilling, true);
    if (row < 0)
        setCurrentIndex({});
    else
        setCurrentIndex(m_sorted->mapFromSource(m_model->index(row, 0)));
}

QString LabTable::selected() const
{
    return currentIndex().data(LabTableModel::ContenderRole).toString();
}

void LabTable::currentChanged(const QModelIndex &current, const QModelIndex &previous)
{
    QTableView::currentChanged(current, previous);
    if (!m_isFilling && current.isValid() && current.row() != previous.row())
        emit contenderSelected(current.data(LabTableModel::ContenderRole).toString());
}

} // namespace pixelplumb
