// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/pixelreport.h"

#include "core/export/rowwriter.h"
#include "core/scene/colourtext.h"

#include <QJsonArray>

#include <cmath>

namespace pixelplumb::cli {

namespace {

constexpr std::array<char16_t, 3> channelNames = {u'R', u'G', u'B'};

QString nameOfDifference(Difference difference)
{
    switch (difference) {
    case Difference::None:
        return QStringLiteral("none");
    case Difference::Missing:
        return QStringLiteral("missing");
    case Difference::Extra:
        return QStringLiteral("extra");
    case Difference::Colour:
        return QStringLiteral("colour");
    }
    return {};
}

/// The pixel's colour in the finished picture.
Colour finalColour(const PixelReport &report)
{
    Colour colour = report.traced.scene.frame.background;
    for (const PixelAttempt &attempt : report.attempts) {
        if (attempt.written)
            colour = unpacked(attempt.change.after);
    }
    return colour;
}

Colour trueColour(const PixelReport &report)
{
    return unpacked(*report.traced.truth.view().at(report.x, report.y));
}

QString edgeText(const oracle::EdgeVerdict &edge)
{
    QStringList distances;
    if (!edge.distanceAlongColumn.isNone())
        distances.append(toText(edge.distanceAlongColumn) + QStringLiteral(" px along the column"));
    if (!edge.distanceAlongRow.isNone())
        distances.append(toText(edge.distanceAlongRow) + QStringLiteral(" px along the row"));
    return QStringLiteral("    edge %1–%2 %3: %4")
        .arg(edge.from)
        .arg(edge.to)
        .arg(edge.accepts ? QStringLiteral("accepts") : QStringLiteral("refuses"),
             distances.isEmpty() ? QStringLiteral("a point")
                                 : distances.join(QStringLiteral(", ")));
}

QString columnText(const ColumnRecord &column)
{
    return QStringLiteral("    column %1, %2 half: y_B = %3, y_T = %4, rows %5 … %6")
        .arg(column.x)
        .arg(column.half == ColumnHalf::First ? QStringLiteral("first") : QStringLiteral("second"),
             toText(column.yBottom), toText(column.yTop))
        .arg(column.firstRow)
        .arg(column.endRow - 1);
}

QString channelText(const PixelAttempt &attempt, std::size_t channel)
{
    const Quantity &used = attempt.fragment.colour[channel];
    const Quantity &exact = attempt.exactColour[channel];
    return QStringLiteral("    %1 = %2 → %3; exact %4, error %5")
        .arg(QChar(channelNames[channel]))
        .arg(toText(used))
        .arg(int(unpacked(attempt.change.after).channels[channel]))
        .arg(toText(exact), realText(errorOf(used, exact)));
}

/// A double that JSON can hold, or its name.
QJsonValue jsonOf(double value)
{
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue(realText(value));
}

QJsonValue jsonOf(const Quantity &quantity)
{
    return quantity.isNone() ? QJsonValue() : QJsonValue(toText(quantity));
}

QJsonObject jsonOf(const ColumnRecord &column)
{
    return {{QStringLiteral("x"), qint64(column.x)},
            {QStringLiteral("half"), column.half == ColumnHalf::First ? 1 : 2},
            {QStringLiteral("y_B"), toText(column.yBottom)},
            {QStringLiteral("y_T"), toText(column.yTop)},
            {QStringLiteral("first_row"), qint64(column.firstRow)},
            {QStringLiteral("last_row"), qint64(column.endRow - 1)}};
}

QJsonObject jsonOf(const oracle::EdgeVerdict &edge)
{
    return {{QStringLiteral("from"), edge.from},
            {QStringLiteral("to"), edge.to},
            {QStringLiteral("accepts"), edge.accepts},
            {QStringLiteral("edgeFunction"), toText(edge.edgeFunction)},
            {QStringLiteral("alongColumn"), jsonOf(edge.distanceAlongColumn)},
            {QStringLiteral("alongRow"), jsonOf(edge.distanceAlongRow)},
            {QStringLiteral("distance"), jsonOf(edge.distance)}};
}

QJsonObject jsonOf(const PixelAttempt &attempt)
{
    QJsonObject json{{QStringLiteral("triangle"), qint64(attempt.triangle)},
                     {QStringLiteral("written"), attempt.written},
                     {QStringLiteral("covered"), attempt.verdict.covered},
                     {QStringLiteral("reason"), attempt.reason}};
    if (attempt.column)
        json[QStringLiteral("column")] = jsonOf(*attempt.column);
    if (!attempt.verdict.zeroArea) {
        QJsonArray edges;
        for (const oracle::EdgeVerdict &edge : attempt.verdict.edges)
            edges.append(jsonOf(edge));
        json[QStringLiteral("edges")] = edges;
    }
    if (!attempt.written)
        return json;
    json[QStringLiteral("step")] = qint64(attempt.step + 1);
    json[QStringLiteral("before")] = colourText(unpacked(attempt.change.before));
    json[QStringLiteral("after")] = colourText(unpacked(attempt.change.after));
    json[QStringLiteral("clamped")] = attempt.fragment.clamped;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Quantity &used = attempt.fragment.colour[channel];
        const Quantity &exact = attempt.exactColour[channel];
        json[QString(QChar(channelNames[channel]))] = QJsonObject{
            {QStringLiteral("used"), jsonOf(used)},
            {QStringLiteral("exact"), jsonOf(exact)},
            {QStringLiteral("error"), jsonOf(errorOf(used, exact))},
            {QStringLiteral("level"), qint64(attempt.fragment.level[channel])},
            {QStringLiteral("byte"), int(unpacked(attempt.change.after).channels[channel])}};
    }
    return json;
}

} // namespace

QStringList textOf(const PixelReport &report)
{
    const Difference difference = report.traced.differences.at(report.x, report.y);
    QString heading = QStringLiteral("pixel (%1, %2) %3")
                          .arg(report.x)
                          .arg(report.y)
                          .arg(colourText(finalColour(report)));
    heading += difference == Difference::None
        ? QStringLiteral(", as the truth")
        : QStringLiteral(", differs from the truth %1: %2")
              .arg(colourText(trueColour(report)), nameOfDifference(difference));
    QStringList lines = {heading};
    if (report.attempts.empty())
        lines.append(QStringLiteral("the scene has no triangles"));
    for (const PixelAttempt &attempt : report.attempts) {
        QString line = QStringLiteral("triangle %1: %2").arg(attempt.triangle).arg(attempt.reason);
        if (attempt.written)
            line.insert(line.indexOf(u':'), QStringLiteral(", step %1").arg(attempt.step + 1));
        lines.append(line);
        if (attempt.column)
            lines.append(columnText(*attempt.column));
        for (std::size_t channel = 0; attempt.written && channel < 3; ++channel)
            lines.append(channelText(attempt, channel));
        if (attempt.verdict.zeroArea)
            continue;
        for (const oracle::EdgeVerdict &edge : attempt.verdict.edges)
            lines.append(edgeText(edge));
    }
    return lines;
}

QJsonObject jsonOf(const PixelReport &report)
{
    QJsonArray attempts;
    for (const PixelAttempt &attempt : report.attempts)
        attempts.append(jsonOf(attempt));
    return {{QStringLiteral("x"), qint64(report.x)},
            {QStringLiteral("y"), qint64(report.y)},
            {QStringLiteral("colour"), colourText(finalColour(report))},
            {QStringLiteral("truth"), colourText(trueColour(report))},
            {QStringLiteral("difference"),
             nameOfDifference(report.traced.differences.at(report.x, report.y))},
            {QStringLiteral("attempts"), attempts}};
}

} // namespace pixelplumb::cli
