// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/edgerefusal.h"
#include "widgets/look/corewords.h"
#include "widgets/look/numberformat.h"
#include "widgets/model/pixelhistorymodel.h"

#include <QColor>

#include <algorithm>

/// The texts of the rows.
namespace pixelplumb {

namespace {

/// A primitive's name: "△ 2", "line 0".
QString nameText(const PixelAttempt &attempt)
{
    const QString kind
        = attempt.kind == PrimitiveKind::Triangle ? u"△"_s : coreWord(nameOf(attempt.kind));
    return u"%1 %2"_s.arg(kind, QString::number(attempt.primitive));
}

QColor opaque(QRgb colour) { return QColor::fromRgb(colour); }

/// Whether effects have changed the bytes of the sample's colour.
bool isOfBase(const PixelAttempt &attempt)
{
    const Colour written = unpacked(attempt.change.after);
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::clamp<std::int64_t>(attempt.sample->level[i], 0, 255) != written.channels[i])
            return true;
    }
    return false;
}

} // namespace

QString PixelHistoryModel::attemptText(const PixelAttempt &attempt, int column) const
{
    switch (column) {
    case WhatColumn:
        if (attempt.written)
            return (attempt.step < m_position ? tr("%1 wrote it") : tr("%1 will write it"))
                .arg(nameText(attempt));
        if (attempt.verdict.covered && attempt.sample && m_traced->shading())
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
    if (!attempt.written)
        return {};
    const bool isInPart = m_traced->antialiasing() != Antialiasing::None;
    if (isInPart && attempt.isCentreRefused())
        return tr("covered in part");
    return attempt.verdict.covered ? QString() : tr("not covered");
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
        // The reason and the Formula panel show what happens to it afterwards.
        return (isOfBase(attempt) ? tr("base %1") : u"%1"_s).arg(u"RGB"_s.at(qsizetype(channel)));
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
        return {}; // a shape's truth is only its pixels
    return besideText(tr("truth %1, error %2"), used, exact);
}

/// The truth, or the number of the same run in exact arithmetic, and the error, in the pattern; in
/// exact arithmetic, where both are one number, its decimals.
QString PixelHistoryModel::besideText(const QString &pattern, const Quantity &used,
                                      const Quantity &exact) const
{
    if (m_traced->scene.settings.arithmetic == Arithmetic::Exact
        && (exact.isNone() || used == exact))
        return decimalBeside(used);
    return exact.isNone() ? QString() : pattern.arg(displayText(exact), displayError(used, exact));
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
    return besideText(tr("exact %1, error %2"), number.used, number.exact);
}

QString PixelHistoryModel::edgeText(const PixelAttempt &attempt, std::size_t index,
                                    int column) const
{
    const oracle::EdgeVerdict &edge = attempt.verdict.edges[index];
    switch (column) {
    case WhatColumn:
        return (mayDecideOtherwise(*m_traced) ? tr("in truth, edge %1") : tr("edge %1"))
            .arg(attempt.edgeNames[index]);
    case UsedColumn:
        if (const ScanDistance distance = scanDistance(edge, *m_traced->trace);
            !distance.exact.isNone())
            return (distance.axis == SpanAxis::Column ? tr("%1 px along column")
                                                      : tr("%1 px along row"))
                .arg(displayText(distance.exact));
        return {};
    case ByteColumn:
        // A verdict on the sample; with several samples per pixel or area coverage, the centre
        // decides nothing.
        if (m_traced->antialiasing() != Antialiasing::None)
            return edge.accepts ? tr("the centre inside") : tr("the centre outside");
        if (edge.edgeFunction == 0)
            return edge.accepts ? tr("on it: accepts") : tr("on it: refuses");
        return edge.accepts ? tr("accepts") : tr("refuses");
    default:
        break;
    }
    return tr("%1 px from the edge").arg(withMinus(QString::number(edge.distance, 'g', 4)));
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

} // namespace pixelplumb
