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

template <auto Part>
Figure costPart(const Study &study, const LabRow &row)
{
    const std::optional<CostParts> parts = costPartsOf(study, row);
    return parts ? Figure((*parts).*Part) : std::nullopt;
}

enum class Shown { AsFigure, AsCount };

struct FigureColumn {
    const char *title;
    const char *meaning;
    Figure (*read)(const Study &study, const LabRow &row);
    Shown shown;
};

constexpr FigureColumn figureColumns[] = {
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "wrong per million"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable",
                       "wrong pixels per million: those that differ from the truth"),
     wrongPerMillion, Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "ns a pixel"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable", "the median of all rounds"), perPixel,
     Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "times assignment's"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable",
                       "time relative to the assignment's method, the column scan in "
                       "float32"),
     timesReference, Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "times straight loop"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable",
                       "time relative to the shortest hand-written loop that draws the "
                       "same pixels; up to 1.3 is fair"),
     timesStraight, Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "spread, %"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable",
                       "the middle half of all rounds, relative to their median"),
     spreadShare, Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "set-up, ns"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable",
                       "the time before a triangle's first column, divided among its "
                       "pixels; fitted over all families"),
     costPart<&CostParts::setUp>, Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "columns, ns"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable",
                       "the time of a column or a row, divided among its pixels; fitted "
                       "over all families"),
     costPart<&CostParts::columns>, Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "pixel, ns"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable",
                       "the time of a pixel by itself; fitted over all families"),
     costPart<&CostParts::pixels>, Shown::AsFigure},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "missing ?"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable", "samples inside that are not painted"),
     countOf<&AccuracyFigures::missing>, Shown::AsCount},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "extra !"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable", "samples outside that are painted"),
     countOf<&AccuracyFigures::extra>, Shown::AsCount},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "ties ="),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable",
                       "samples exactly on the boundary that are missing or extra"),
     ties, Shown::AsCount},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "colours c"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable", "pixels that are there in another colour"),
     countOf<&AccuracyFigures::wrongBytes>, Shown::AsCount},
    {QT_TRANSLATE_NOOP("pixelplumb::LabTable", "levels off"),
     QT_TRANSLATE_NOOP("pixelplumb::LabTable", "the largest error of a byte"),
     countOf<&AccuracyFigures::largestByteError>, Shown::AsCount},
};

constexpr int costColumn = 2; ///< ns a pixel, after the contender

QString labelOfContender(const Study &study, const QString &id)
{
    const StudyContender *contender = study.contender(id);
    return contender ? contender->label : id;
}

std::vector<RowsColumn<LabTableRow>> columns()
{
    std::vector<RowsColumn<LabTableRow>> all;
    all.push_back(
        {LabTable::tr("method, arithmetic, kernel"),
         {},
         [](const LabTableRow &of) { return labelOfContender(*of.study, of.row->contender); },
         Qt::AlignLeft});
    for (const FigureColumn &column : figureColumns)
        all.push_back({LabTable::tr(column.title), LabTable::tr(column.meaning),
                       [&column](const LabTableRow &of) {
                           const Figure figure = column.read(*of.study, *of.row);
                           if (!figure)
                               return QString();
                           return column.shown == Shown::AsCount ? QString::number(*figure, 'f', 0)
                                                                 : figureText(*figure);
                       },
                       Qt::AlignRight,
                       [&column](const LabTableRow &of, int role) {
                           const Figure figure = column.read(*of.study, *of.row);
                           const double last = std::numeric_limits<double>::infinity();
                           return role == RowsModel<LabTableRow>::SortRole
                               ? QVariant(figure.value_or(last))
                               : QVariant();
                       }});
    all.push_back({LabTable::tr("remark"),
                   {},
                   [](const LabTableRow &of) { return outcomeText(*of.row); },
                   Qt::AlignLeft});
    return all;
}

} // namespace

std::optional<CostParts> costPartsOf(const Study &study, const LabRow &row)
{
    const StudyContender *contender = study.contender(row.contender);
    const StudyFamily *family = study.family(row.family);
    if (!contender || !contender->fit || !family || family->timedPixels == 0)
        return std::nullopt;
    const CostFit &fit = *contender->fit;
    const auto pixels = double(family->timedPixels);
    return CostParts{fit.perTriangle * double(family->timedTriangles) / pixels,
                     fit.perColumn * double(family->timedSpans(row.contender)) / pixels,
                     fit.perPixel};
}

LabTable::LabTable(QWidget *parent)
    : QTableView(parent)
    , m_model(new RowsModel<LabTableRow>(columns(), this))
    , m_sorted(new QSortFilterProxyModel(this))
{
    named(this, "labTable", tr("Contenders"));
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(RowsModel<LabTableRow>::SortRole);
    setModel(m_sorted);
    setSortingEnabled(true);
    sortByColumn(costColumn, Qt::AscendingOrder);
    readByRows(this);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
    setAlternatingRowColors(true);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    connect(this, &QTableView::activated, this,
            [this](const QModelIndex &index) { emit contenderActivated(contenderAt(index)); });
}

void LabTable::show(const std::shared_ptr<const Study> &results, const QString &family)
{
    const QString kept = selected();
    {
        const QScopedValueRollback filling(m_isFilling, true);
        std::vector<LabTableRow> rows;
        for (std::size_t i = 0; results && i < results->rows.size(); ++i) {
            if (results->rows[i].family == family)
                rows.push_back({results, &results->rows[i]});
        }
        m_model->setRows(std::move(rows));
    }
    resizeColumnsToContents();
    select(kept);
}

void LabTable::select(const QString &contender)
{
    const std::vector<LabTableRow> &rows = m_model->rows();
    const auto found = std::ranges::find_if(
        rows, [&contender](const LabTableRow &each) { return each.row->contender == contender; });
    const QScopedValueRollback filling(m_isFilling, true);
    setCurrentIndex(m_sorted->mapFromSource(m_model->index(int(found - rows.begin()), 0)));
}

QString LabTable::selected() const { return contenderAt(currentIndex()); }

QString LabTable::contenderAt(const QModelIndex &index) const
{
    const int row = m_sorted->mapToSource(index).row();
    return row < 0 ? QString() : m_model->rows()[std::size_t(row)].row->contender;
}

void LabTable::currentChanged(const QModelIndex &current, const QModelIndex &previous)
{
    QTableView::currentChanged(current, previous);
    if (!m_isFilling && current.isValid() && current.row() != previous.row())
        emit contenderSelected(contenderAt(current));
}

} // namespace pixelplumb
