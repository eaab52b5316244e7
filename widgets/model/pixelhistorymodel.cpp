// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/pixelhistorymodel.h"

#include "core/runs/pixelreason.h"
#include "widgets/look/corewords.h"
#include "widgets/look/numberformat.h"

#include <QColor>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr quintptr topLevel = 0; // internal ids: 0 for attempts, 1 + row of the attempt for details
constexpr int channelRows = 3; // that come before the edges
constexpr int edgeRows = 3;

/// "△ 2", "line 0".
QString nameText(const PixelAttempt &attempt)
{
    const QString kind = attempt.kind == PrimitiveKind::Triangle ? QStringLiteral("△")
                                                                 : coreWord(nameOf(attempt.kind));
    return QStringLiteral("%1 %2").arg(kind).arg(attempt.primitive);
}

QColor opaque(QRgb colour) { return QColor::fromRgb(colour); }

/// Whether effects have made other bytes of the colour that the sample had.
bool isOfBase(const PixelAttempt &attempt)
{
    const Colour written = unpacked(attempt.change.after);
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::clamp<std::int64_t>(attempt.sample->level[i], 0, 255) != written.channels[i])
            return true;
    }
    return false;
}

/// Why the triangle keeps the sample out: the edge that is farthest from accepting it.
std::size_t refusingEdge(const oracle::SampleVerdict &verdict)
{
    const auto refusing = std::ranges::min_element(
        verdict.edges, [](const oracle::EdgeVerdict &a, const oracle::EdgeVerdict &b) {
            return std::pair(a.accepts, a.distance) < std::pair(b.accepts, b.distance);
        });
    return std::size_t(refusing - verdict.edges.begin());
}

} // namespace

void PixelHistoryModel::setPixel(std::shared_ptr<const TracedScene> traced,
                                 const std::optional<QPoint> &pixel)
{
    beginResetModel();
    m_traced = std::move(traced);
    m_attempts.clear();
    m_unlisted = 0;
    if (m_traced && pixel) {
        BriefPixelHistory history
            = briefPixelHistory(*m_traced, pixel->x(), pixel->y(), std::size_t(listedRefusals));
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
    // The channels of a write are grey until it is done.
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
    if (const QModelIndex inHand = rowInHand(); inHand.isValid())
        return inHand;
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

QModelIndex PixelHistoryModel::rowInHand() const
{
    const auto inHand = std::ranges::find_if(m_attempts, [this](const PixelAttempt &attempt) {
        return attempt.sample && attempt.step + 1 == m_position;
    });
    return inHand == m_attempts.end() ? QModelIndex() : index(int(inHand - m_attempts.begin()), 0);
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

QString PixelHistoryModel::attemptText(const PixelAttempt &attempt, int column) const
{
    switch (column) {
    case WhatColumn:
        if (attempt.written)
            return (attempt.step < m_position ? tr("%1 wrote it") : tr("%1 will write it"))
                .arg(nameText(attempt));
        if (attempt.verdict.covered && attempt.sample && m_traced->plan)
            return tr("%1 is hidden or refused").arg(nameText(attempt)); // as its reason says
        return (attempt.verdict.covered ? tr("%1 missed it") : tr("%1 refuses it"))
            .arg(nameText(attempt));
    case UsedColumn:
        if (attempt.written)
            return tr("%1 → %2").arg(opaque(attempt.change.before).name(),
                                     opaque(attempt.change.after).name());
        if (attempt.verdict.covered || !attempt.hasEdges())
            return {};
        return edgeText(attempt, refusingEdge(attempt.verdict), UsedColumn);
    case ByteColumn:
        return attempt.written ? tr("step %1").arg(attempt.step + 1) : QString();
    default:
        break;
    }
    if (!attempt.written || attempt.verdict.covered)
        return {};
    const bool isInPart = m_traced->plan && m_traced->plan->antialiasing != Antialiasing::None;
    return isInPart ? tr("covered in part") : tr("not covered");
}

QString PixelHistoryModel::channelText(const PixelAttempt &attempt, std::size_t channel,
                                       int column) const
{
    const Quantity &used = attempt.sample->colour[channel];
    const Quantity &exact = attempt.exactColour[channel];
    const Arithmetic arithmetic = m_traced->scene.settings.arithmetic;
    const std::int64_t level = attempt.sample->level[channel];
    switch (column) {
    case WhatColumn:
        // What is done to it afterwards stands in the reason and in the Formula panel.
        return (isOfBase(attempt) ? tr("base %1") : QStringLiteral("%1"))
            .arg(QStringLiteral("RGB").at(qsizetype(channel)));
    case UsedColumn:
        return displayText(used, arithmetic);
    case ByteColumn: {
        const std::int64_t byte = std::clamp<std::int64_t>(level, 0, 255);
        return byte == level ? tr("→ %1").arg(byte) : tr("→ %1 clamped to %2").arg(level).arg(byte);
    }
    default:
        break;
    }
    if (exact.isNone())
        return {}; // the truth of a shape is its pixels
    if (arithmetic == Arithmetic::Exact)
        return decimalBeside(exact);
    return tr("exact %1, error %2").arg(displayText(exact), displayError(used, exact));
}

QString PixelHistoryModel::carriedText(const PixelAttempt::Carried &number, int column) const
{
    const Arithmetic arithmetic = m_traced->scene.settings.arithmetic;
    switch (column) {
    case WhatColumn:
        return number.title;
    case UsedColumn:
        return displayText(number.used, arithmetic);
    case ByteColumn:
        return {};
    default:
        break;
    }
    if (arithmetic == Arithmetic::Exact)
        return decimalBeside(number.used);
    return number.exact.isNone()
        ? QString()
        : tr("exact %1, error %2")
              .arg(displayText(number.exact), displayError(number.used, number.exact));
}

QString PixelHistoryModel::edgeText(const PixelAttempt &attempt, std::size_t index,
                                    int column) const
{
    const oracle::EdgeVerdict &edge = attempt.verdict.edges[index];
    switch (column) {
    case WhatColumn:
        return tr("edge %1").arg(attempt.edgeNames[index]);
    case UsedColumn:
        if (const ScanDistance distance = scanDistance(edge, *m_traced->trace);
            !distance.exact.isNone())
            return (distance.axis == SpanAxis::Column ? tr("%1 px along column")
                                                      : tr("%1 px along row"))
                .arg(displayText(distance.exact));
        return {};
    case ByteColumn:
        if (edge.edgeFunction == 0)
            return edge.accepts ? tr("on it: accepts") : tr("on it: refuses");
        return edge.accepts ? tr("accepts") : tr("refuses");
    default:
        break;
    }
    return tr("%1 px square to it").arg(QString::number(edge.distance, 'g', 4).replace(u'-', u'−'));
}

QString PixelHistoryModel::detailText(const PixelAttempt &attempt, std::size_t row,
                                      int column) const
{
    const std::size_t channels = attempt.written ? channelRows : 0;
    const std::size_t edges = channels + attempt.carried.size();
    if (row < channels)
        return channelText(attempt, row, column);
    return row < edges ? carriedText(attempt.carried[row - channels], column)
                       : edgeText(attempt, row - edges, column);
}

QVariant PixelHistoryModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
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
    case IsAheadRole: // of an edge it is said that it accepts or refuses, at any time
        return attempt.written && attempt.step >= m_position
            && !(isDetail && index.row() >= channelRows + int(attempt.carried.size()));
    case BeforeColourRole:
        return isSwatch ? QVariant(opaque(attempt.change.before)) : QVariant();
    case AfterColourRole:
        return isSwatch ? QVariant(opaque(attempt.change.after)) : QVariant();
    default:
        return {};
    }
}

} // namespace pixelplumb
