// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/columntablemodel.h"

#include "core/export/numbertext.h"
#include "core/export/tracetable.h"
#include "core/runs/spanheadings.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/numbertooltip.h"
#include "widgets/model/playhead.h"

namespace pixelplumb {

namespace {

constexpr int cachedRows = 256; // several screens

/// "△ 2", "line 0": where a primitive's rows begin.
QString markText(const TracedScene &traced, std::size_t span)
{
    const std::size_t primitive = traced.trace->primitiveOf(span);
    const QString kind = traced.primitives.isTriangle(primitive)
        ? QStringLiteral("△")
        : nameOf(traced.primitives.kindOf(primitive));
    return QStringLiteral("%1 %2").arg(kind).arg(primitive);
}

/// The edge that is switched in where a sorted triangle's second part begins, else the part's
/// number.
QString partText(const TracedScene &traced, std::size_t span)
{
    if (traced.primitives.isTriangle(traced.trace->primitiveOf(span)))
        return QStringLiteral("L₁₂");
    return ColumnTableModel::tr("part %1").arg(traced.trace->placeOf(span).part + 1);
}

} // namespace

ColumnTableModel::ColumnTableModel(Playhead *playhead, QObject *parent)
    : QAbstractTableModel(parent)
    , m_playhead(playhead)
    , m_cache(cachedRows)
{
    connect(playhead, &Playhead::tracedChanged, this, &ColumnTableModel::takeTrace);
    connect(playhead, &Playhead::positionChanged, this, &ColumnTableModel::followPosition);
    connect(playhead, &Playhead::aheadHiddenChanged, this, &ColumnTableModel::takeTrace);
    takeTrace();
}

ColumnTableModel::~ColumnTableModel() = default;

void ColumnTableModel::takeTrace()
{
    beginResetModel();
    m_traced = m_playhead->sharedTraced();
    m_position = m_playhead->position();
    m_cache.clear();
    m_entries.clear();
    if (m_traced) {
        m_numbers = spanHeadings(*m_traced);
        for (std::size_t i = 0; i < m_numbers.size(); ++i) {
            m_entries.push_back({i, NumberFace::Used});
            if (m_numbers[i].comparison == Comparison::WithExact && isRounding()) {
                m_entries.push_back({i, NumberFace::Exact});
                m_entries.push_back({i, NumberFace::Error});
            }
        }
    }
    endResetModel();
}

void ColumnTableModel::followPosition()
{
    m_position = m_playhead->position();
    // Numbers that were hidden ahead may be seen now.
    const QList<int> roles
        = m_playhead->isAheadHidden() ? QList<int>() : QList<int>{IsAheadRole, IsInHandRole};
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1), roles);
}

bool ColumnTableModel::isRounding() const
{
    return m_traced && m_traced->scene.settings.arithmetic != Arithmetic::Exact;
}

bool ColumnTableModel::hasSeveralPrimitives() const
{
    return m_traced && m_traced->trace->primitiveCount() > 1;
}

int ColumnTableModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() || !m_traced ? 0 : int(m_traced->trace->spanCount());
}

int ColumnTableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : int(m_entries.size());
}

const NumberDescription &ColumnTableModel::number(int column) const
{
    return m_numbers[m_entries[std::size_t(column)].number];
}

QString ColumnTableModel::fileName(int column) const
{
    switch (face(column)) {
    case NumberFace::Used:
        break;
    case NumberFace::Exact:
        return exactName(number(column).id);
    case NumberFace::Error:
        return errorName(number(column).id);
    }
    return number(column).id;
}

const ColumnTableModel::RowNumbers &ColumnTableModel::numbersOf(int row) const
{
    if (const RowNumbers *known = m_cache.object(row))
        return *known;
    const ScanTrace &trace = *m_traced->trace;
    auto *numbers = new RowNumbers{trace.span(std::size_t(row)), {}, std::nullopt};
    const std::size_t primitive = trace.primitiveOf(std::size_t(row));
    if (isRounding())
        numbers->exact = exactSpanCells(*m_traced, std::size_t(row));
    if (std::size_t(row) > trace.firstSpanOf(primitive))
        numbers->previous = trace.span(std::size_t(row) - 1);
    m_cache.insert(row, numbers); // the cache owns it
    return *numbers;
}

Quantity ColumnTableModel::usedNumber(const RowNumbers &numbers, const Entry &entry) const
{
    return numbers.used.cells[entry.number];
}

Quantity ColumnTableModel::exactNumber(const RowNumbers &numbers, const Entry &entry) const
{
    return entry.number < numbers.exact.size() ? numbers.exact[entry.number] : Quantity();
}

QString ColumnTableModel::usedText(const Quantity &used) const
{
    return displayText(used, m_traced->scene.settings.arithmetic);
}

QString ColumnTableModel::faceText(const Quantity &used, const Quantity &exact,
                                   NumberFace face) const
{
    switch (face) {
    case NumberFace::Used:
        break;
    case NumberFace::Exact:
        return displayText(exact);
    case NumberFace::Error:
        return displayError(used, exact);
    }
    return usedText(used);
}

QString ColumnTableModel::canonicalText(const Quantity &used, const Quantity &exact,
                                        NumberFace face) const
{
    switch (face) {
    case NumberFace::Used:
        break;
    case NumberFace::Exact:
        return fractionText(exact);
    case NumberFace::Error:
        return used.isNone() || exact.isNone() ? QString() : realText(errorOf(used, exact));
    }
    return decimalText(used);
}

QString ColumnTableModel::toolTip(int row, const Entry &entry) const
{
    const StepWords words = m_traced->trace->spanWords(std::size_t(row));
    const RowNumbers &numbers = numbersOf(row);
    return numberToolTip(words.numbers[entry.number], usedNumber(numbers, entry),
                         exactNumber(numbers, entry), m_traced->scene.settings.arithmetic);
}

QVariant ColumnTableModel::numberData(const RowNumbers &numbers, const Entry &entry, int role) const
{
    const Quantity used = usedNumber(numbers, entry);
    const auto exact = [&] { return exactNumber(numbers, entry); };
    switch (role) {
    case Qt::DisplayRole:
        return entry.face == NumberFace::Used ? usedText(used)
                                              : faceText(used, exact(), entry.face);
    case UsedTextRole:
        return usedText(used);
    case ExactTextRole:
        return displayText(exact());
    case ErrorTextRole:
        return displayError(used, exact());
    case CanonicalTextRole:
        return canonicalText(used, exact(), entry.face);
    case ChangedRole:
        return entry.face == NumberFace::Used && numbers.previous
            && used != numbers.previous->cells[entry.number];
    case MarkedDigitRole:
        if (entry.face != NumberFace::Used || exact().isNone())
            return -1;
        return firstDifferingDigit(usedText(used), displayDecimal(exact(), comparedPlaces));
    default:
        return {};
    }
}

RowMark ColumnTableModel::markOf(int row) const
{
    const RowNumbers &numbers = numbersOf(row);
    if (!numbers.previous)
        return RowMark::PrimitiveBegins;
    return numbers.previous->place.part != numbers.used.place.part ? RowMark::PartBegins
                                                                   : RowMark::None;
}

/// Which row it is and how it is painted is no secret; what its formulas give is.
bool ColumnTableModel::isToldAhead(int column, int role) const
{
    switch (role) {
    case Qt::TextAlignmentRole:
    case IsAheadRole:
    case IsInHandRole:
    case PrimitiveRole:
    case RowMarkRole:
        return true;
    default:
        return number(column).group == NumberGroup::Position;
    }
}

QVariant ColumnTableModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const auto row = std::size_t(index.row());
    const bool isAhead = m_traced->trace->indexOfSpan(row) >= m_position;
    if (isAhead && m_playhead->isAheadHidden() && !isToldAhead(index.column(), role))
        return role == Qt::DisplayRole ? QVariant(QStringLiteral("?"))
            : role == MarkedDigitRole  ? QVariant(-1)
                                       : QVariant();
    switch (role) {
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    case IsAheadRole:
        return isAhead;
    case IsInHandRole:
        return m_playhead->spanInHand() == row;
    case PrimitiveRole:
        return int(m_traced->trace->primitiveOf(row));
    case RowMarkRole:
        return int(markOf(index.row()));
    case Qt::ToolTipRole:
        return toolTip(index.row(), m_entries[std::size_t(index.column())]);
    default:
        return numberData(numbersOf(index.row()), m_entries[std::size_t(index.column())], role);
    }
}

QVariant ColumnTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Vertical) {
        if (role != Qt::DisplayRole || section >= rowCount())
            return {};
        switch (markOf(section)) {
        case RowMark::None:
            break;
        case RowMark::PrimitiveBegins:
            return markText(*m_traced, std::size_t(section));
        case RowMark::PartBegins:
            return partText(*m_traced, std::size_t(section));
        }
        return QString();
    }
    if (section >= columnCount())
        return {};
    const NumberDescription &shown = number(section);
    if (role == Qt::DisplayRole) {
        switch (face(section)) {
        case NumberFace::Used:
            break;
        case NumberFace::Exact:
            return tr("%1 exact").arg(shown.title);
        case NumberFace::Error:
            return tr("%1 error").arg(shown.title);
        }
        return shown.title;
    }
    if (role == Qt::ToolTipRole)
        return numberToolTip(shown);
    if (role == Qt::AccessibleTextRole)
        return withoutMarkup(headerData(section, orientation, Qt::DisplayRole).toString());
    return {};
}

} // namespace pixelplumb
