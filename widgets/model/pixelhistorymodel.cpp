// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/pixelhistorymodel.h"

#include <QColor>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr quintptr topLevel = 0; // internal ids: 0 for attempts, 1 + the attempt's row for details
constexpr int edgeRows = 3;

} // namespace

void PixelHistoryModel::setPixel(std::shared_ptr<const TracedScene> traced,
                                 const std::optional<QPoint> &pixel, Ahead ahead)
{
    beginResetModel();
    m_traced = std::move(traced);
    m_attempts.clear();
    m_unlisted = 0;
    m_isSomethingHidden = false;
    if (m_traced && pixel) {
        BriefPixelHistory history = briefPixelHistory(*m_traced, pixel->x(), pixel->y());
        m_isSomethingHidden = ahead == Ahead::Hidden && leaveOutAhead(history, m_position);
        m_attempts = std::move(history.attempts);
        m_unlisted = history.furtherRefusals;
    }
    endResetModel();
}

void PixelHistoryModel::setPosition(std::size_t position)
{
    if (m_position == position)
        return;
    m_position = position;
    if (m_attempts.empty())
        return;
    emit dataChanged(index(0, 0), index(int(m_attempts.size()) - 1, columnTotal - 1));
    // The channels of a write are grey until it happens.
    for (int row = 0; row < int(m_attempts.size()); ++row) {
        const QModelIndex attempt = index(row, 0);
        if (m_attempts[std::size_t(row)].written)
            emit dataChanged(index(0, 0, attempt), index(channelRows - 1, columnTotal - 1, attempt),
                             {IsAheadRole});
    }
}

QModelIndex PixelHistoryModel::decisiveRow() const
{
    if (m_attempts.empty())
        return {};
    if (const QModelIndex current = currentRow(); current.isValid())
        return current;
    int decisive = -1;
    for (int row = 0; row < int(m_attempts.size()); ++row) {
        const PixelAttempt &attempt = m_attempts[std::size_t(row)];
        if (!attempt.written)
            continue;
        if (attempt.step < m_position || decisive < 0)
            decisive = row;
    }
    return index(std::max(0, decisive), 0);
}

QModelIndex PixelHistoryModel::currentRow() const
{
    const auto current = std::ranges::find_if(m_attempts, [this](const PixelAttempt &attempt) {
        return attempt.sample && attempt.step + 1 == m_position;
    });
    return current == m_attempts.end() ? QModelIndex()
                                       : index(int(current - m_attempts.begin()), 0);
}

bool PixelHistoryModel::isCountRow(const QModelIndex &index) const
{
    return index.internalId() == topLevel && index.row() == int(m_attempts.size());
}

QModelIndex PixelHistoryModel::index(int row, int column, const QModelIndex &parent) const
{
    if (!hasIndex(row, column, parent))
        return {};
    return createIndex(row, column, parent.isValid() ? quintptr(parent.row()) + 1 : topLevel);
}

QModelIndex PixelHistoryModel::parent(const QModelIndex &child) const
{
    if (!child.isValid() || child.internalId() == topLevel)
        return {};
    return createIndex(int(child.internalId() - 1), 0, topLevel);
}

int PixelHistoryModel::rowCount(const QModelIndex &parent) const
{
    if (!parent.isValid())
        return int(m_attempts.size()) + int(m_unlisted > 0);
    const bool hasDetails
        = parent.internalId() == topLevel && parent.column() == 0 && !isCountRow(parent);
    if (!hasDetails)
        return 0;
    const PixelAttempt &attempt = m_attempts[std::size_t(parent.row())];
    return (attempt.written ? channelRows : 0) + int(attempt.carried.size())
        + (attempt.hasEdges() ? edgeRows : 0);
}

int PixelHistoryModel::columnCount(const QModelIndex &) const { return columnTotal; }

QVariant PixelHistoryModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || !checkIndex(index))
        return {};
    if (isCountRow(index)) {
        if (role != Qt::DisplayRole || index.column() != WhatColumn)
            return {};
        return tr("and %n more that refuse it", nullptr, int(m_unlisted));
    }
    const bool isDetail = index.internalId() != topLevel;
    const std::size_t row
        = isDetail ? std::size_t(index.internalId() - 1) : std::size_t(index.row());
    const PixelAttempt &attempt = m_attempts[row];
    const bool isSwatch = !isDetail && attempt.written && index.column() == UsedColumn;
    switch (role) {
    case Qt::DisplayRole:
        if (!isDetail)
            return attemptText(attempt, index.column());
        return detailText(attempt, std::size_t(index.row()), index.column());
    case Qt::ToolTipRole:
    case ReasonRole:
        return attempt.reason;
    case StepRole:
        return attempt.written ? QVariant(qulonglong(attempt.step)) : QVariant();
    case IsAheadRole: // an edge's verdict is shown at any time
        return attempt.written && attempt.step >= m_position
            && !(isDetail && index.row() >= channelRows + int(attempt.carried.size()));
    case BeforeColourRole:
        return isSwatch ? QVariant(QColor::fromRgb(attempt.change.before)) : QVariant();
    case AfterColourRole:
        return isSwatch ? QVariant(QColor::fromRgb(attempt.change.after)) : QVariant();
    default:
        return {};
    }
}

} // namespace pixelplumb
