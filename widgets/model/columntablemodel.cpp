// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/columntablemodel.h"

#include "core/export/numbertext.h"
#include "core/runs/spanheadings.h"
#include "widgets/look/numberformat.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/playhead.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr int cachedRows = 256; // several screens

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
    m_spans.clear();
    if (m_traced && m_filter != RowFilter::All)
        m_spans = spansOf(*m_traced, m_filter);
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

void ColumnTableModel::setFilter(RowFilter filter)
{
    m_filter = filter;
    takeTrace();
}

std::size_t ColumnTableModel::spanAt(int row) const
{
    return m_filter == RowFilter::All ? std::size_t(row) : m_spans[std::size_t(row)];
}

int ColumnTableModel::rowAt(std::size_t span) const
{
    return m_filter == RowFilter::All
        ? int(span)
        : int(std::ranges::lower_bound(m_spans, span) - m_spans.begin());
}

void ColumnTableModel::followPosition()
{
    m_position = m_playhead->position();
    // Numbers that were hidden ahead may be visible now.
    const QList<int> roles
        = m_playhead->isAheadHidden() ? QList<int>() : QList<int>{IsAheadRole, IsCurrentRole};
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
    if (parent.isValid() || !m_traced)
        return 0;
    return int(m_filter == RowFilter::All ? m_traced->trace->spanCount() : m_spans.size());
}

int ColumnTableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : int(m_entries.size());
}

const NumberDescription &ColumnTableModel::number(int column) const
{
    return m_numbers[m_entries[std::size_t(column)].number];
}

const ColumnTableModel::RowNumbers &ColumnTableModel::numbersOf(std::size_t span) const
{
    if (const RowNumbers *known = m_cache.object(span))
        return *known;
    const ScanTrace &trace = *m_traced->trace;
    auto *numbers = new RowNumbers{trace.span(span), {}, std::nullopt};
    const std::size_t primitive = trace.primitiveOf(span);
    if (isRounding())
        numbers->exact = exactSpanCells(*m_traced, span);
    if (span > trace.firstSpanOf(primitive))
        numbers->previous = trace.span(span - 1);
    m_cache.insert(span, numbers); // the cache takes ownership
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

QString ColumnTableModel::toolTip(std::size_t span, const Entry &entry) const
{
    const StepWords words = m_traced->trace->spanWords(span);
    const RowNumbers &numbers = numbersOf(span);
    return numberToolTip(words.numbers[entry.number], usedNumber(numbers, entry),
                         exactNumber(numbers, entry), m_traced->scene.settings.arithmetic);
}

QVariant ColumnTableModel::numberData(const RowNumbers &numbers, const Entry &entry, int role) const
{
    const Quantity used = usedNumber(numbers, entry);
    const auto exact = [&] { return exactNumber(numbers, entry); };
    switch (role) {
    case Qt::DisplayRole:
    case MeasuredTextRole:
        return entry.face == NumberFace::Used ? usedText(used)
                                              : faceText(used, exact(), entry.face);
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

RowMark ColumnTableModel::markOf(std::size_t span) const
{
    const ScanTrace &trace = *m_traced->trace;
    if (!trace.beginsPart(span))
        return RowMark::None;
    return span == trace.firstSpanOf(trace.primitiveOf(span)) ? RowMark::PrimitiveBegins
                                                              : RowMark::PartBegins;
}

/// Whether data may be shown ahead: the row's identity and appearance may, the results of its
/// formulas may not.
bool ColumnTableModel::isToldAhead(int column, int role) const
{
    switch (role) {
    case Qt::TextAlignmentRole:
    case IsAheadRole:
    case IsCurrentRole:
    case PrimitiveRole:
    case RowMarkRole:
    case MeasuredTextRole:
        return true;
    default:
        return number(column).group == NumberGroup::Position;
    }
}

QVariant ColumnTableModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || !checkIndex(index))
        return {};
    const std::size_t span = spanAt(index.row());
    const bool isAhead = m_traced->trace->indexOfSpan(span) >= m_position;
    if (isAhead && m_playhead->isAheadHidden() && !isToldAhead(index.column(), role))
        return role == Qt::DisplayRole ? QVariant(QStringLiteral("?"))
            : role == MarkedDigitRole  ? QVariant(-1)
                                       : QVariant();
    switch (role) {
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    case IsAheadRole:
        return isAhead;
    case IsCurrentRole:
        return m_playhead->currentSpan() == span;
    case PrimitiveRole:
        return int(m_traced->trace->primitiveOf(span));
    case RowMarkRole:
        return int(markOf(span));
    case Qt::ToolTipRole:
        return toolTip(span, m_entries[std::size_t(index.column())]);
    default:
        return numberData(numbersOf(span), m_entries[std::size_t(index.column())], role);
    }
}

} // namespace pixelplumb
