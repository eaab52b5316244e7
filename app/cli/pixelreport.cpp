// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "core/export/numbertext.h"
#include "core/runs/explain/edgerefusal.h"
#include "core/runs/explain/pixelhistory.h"
#include "core/scene/text/colourtext.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace pixelplumb::cli {

namespace {

/// What a method calls the bounds of its spans, and the samples along them.
struct SpanWords {
    QString place, lower, upper, samples;
};

SpanWords wordsFor(SpanAxis axis)
{
    switch (axis) {
    case SpanAxis::Column:
        return {QStringLiteral("column"), QStringLiteral("y_B"), QStringLiteral("y_T"),
                QStringLiteral("rows")};
    case SpanAxis::Row:
        return {QStringLiteral("row"), QStringLiteral("x_L"), QStringLiteral("x_R"),
                QStringLiteral("columns")};
    case SpanAxis::Free:
        break;
    }
    return {QStringLiteral("step"), {}, {}, QStringLiteral("samples")};
}

/// The place in the window's words: "column 27, second half".
QString spanPlaceText(const PixelAttempt &attempt)
{
    return attempt.spanHeading.left(1).toLower() + attempt.spanHeading.sliced(1);
}

/// The edge's verdict on the sample. With several samples per pixel or area coverage, the centre
/// decides nothing and only its place is given.
QString placeText(const oracle::EdgeVerdict &edge, Antialiasing antialiasing)
{
    if (antialiasing == Antialiasing::None)
        return edge.accepts ? QStringLiteral(" accepts") : QStringLiteral(" refuses");
    return edge.accepts ? QStringLiteral(", the centre inside")
                        : QStringLiteral(", the centre outside");
}

QString edgeText(const QString &name, const oracle::EdgeVerdict &edge, const TracedScene &traced)
{
    QStringList distances;
    if (!edge.distanceAlongColumn.isNone())
        distances.append(toText(edge.distanceAlongColumn) + QStringLiteral(" px along the column"));
    if (!edge.distanceAlongRow.isNone())
        distances.append(toText(edge.distanceAlongRow) + QStringLiteral(" px along the row"));
    return (mayDecideOtherwise(traced) ? QStringLiteral("    in truth, edge %1%2: %3")
                                       : QStringLiteral("    edge %1%2: %3"))
        .arg(name, placeText(edge, traced.antialiasing()),
             distances.isEmpty() ? QStringLiteral("a point")
                                 : distances.join(QStringLiteral(", ")));
}

QString spanText(const PixelAttempt &attempt, const TracedScene &traced)
{
    const SpanRecord &span = *attempt.span;
    const SpanWords words = wordsFor(span.place.axis);
    const bool isByArea = traced.antialiasing() == Antialiasing::Area;
    QString text = QStringLiteral("    ") + spanPlaceText(attempt);
    if (span.lower.isNone())
        return text;
    const std::int64_t first = isByArea ? span.firstDrawn : span.firstSample;
    const std::int64_t end = isByArea ? span.endDrawn : span.endSample;
    const QString exact = hasExactBounds(span, traced.scene.settings.arithmetic)
        ? QStringLiteral("exact ")
        : QString();
    text += QStringLiteral(": %1%2 = %3, %1%4 = %5, ")
                .arg(exact, words.lower, toText(span.lower), words.upper, toText(span.upper));
    if (first >= end)
        return text + QStringLiteral("no ") + words.samples;
    text += QStringLiteral("%1%2 %3 … %4")
                .arg(isByArea ? QStringLiteral("areas on the ") : QString(), words.samples)
                .arg(first)
                .arg(end - 1);
    return text;
}

/// "; exact 277/54, error 0", where there is an exact number.
QString exactText(const Quantity &used, const Quantity &exact)
{
    if (exact.isNone())
        return {};
    return QStringLiteral("; exact %1, error %2")
        .arg(toText(exact), realText(errorOf(used, exact)));
}

/// The level and the byte written. The exact level is a triangle's; for a shape only the pixels are
/// true. A mean of samples has no level.
QString channelText(const PixelAttempt &attempt, std::size_t channel)
{
    const Quantity &used = attempt.sample->colour[channel];
    const Quantity &exact = attempt.exactColour[channel];
    const std::int64_t level = std::clamp<std::int64_t>(attempt.sample->level[channel], 0, 255);
    const int byte = unpacked(attempt.change.after).channels[channel];
    QString text = QStringLiteral("    ") + channelLetters[channel];
    if (!used.isNone())
        text += QStringLiteral(" = %1 → %2").arg(toText(used), QString::number(level));
    if (used.isNone() || level != byte)
        text += QStringLiteral(" → %1").arg(byte);
    return text + exactText(used, exact);
}

QString carriedText(const PixelAttempt::Carried &number)
{
    return QStringLiteral("    %1 = %2").arg(number.title, toText(number.used))
        + exactText(number.used, number.exact);
}

/// A double that JSON can hold, or its name.
QJsonValue jsonOf(double value)
{
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue(realText(value));
}

/// A quantity as a number and exactly: {"decimal": 5.129…, "fraction": "277/54"}.
QJsonValue jsonOf(const Quantity &quantity)
{
    if (quantity.isNone())
        return {};
    return QJsonObject{{QStringLiteral("decimal"), jsonOf(quantity.toDouble())},
                       {QStringLiteral("fraction"), fractionText(quantity)}};
}

/// A number beside the exact one: its value, the exact one, the error.
QJsonObject jsonOf(const Quantity &used, const Quantity &exact)
{
    return {
        {QStringLiteral("used"), jsonOf(used)},
        {QStringLiteral("exact"), jsonOf(exact)},
        {QStringLiteral("error"), exact.isNone() ? QJsonValue() : jsonOf(errorOf(used, exact))}};
}

QJsonObject spanJson(const PixelAttempt &attempt, Arithmetic arithmetic)
{
    const SpanRecord &span = *attempt.span;
    const SpanWords words = wordsFor(span.place.axis);
    QJsonObject json{{QStringLiteral("along"), words.place},
                     {QStringLiteral("at"), qint64(span.place.coordinate)},
                     {QStringLiteral("part"), span.place.part + 1},
                     {QStringLiteral("place"), spanPlaceText(attempt)}};
    if (span.lower.isNone())
        return json;
    json[words.lower] = jsonOf(span.lower);
    json[words.upper] = jsonOf(span.upper);
    json[QStringLiteral("boundsAreExact")]
        = arithmetic == Arithmetic::Exact || hasExactBounds(span, arithmetic);
    json[QStringLiteral("first")] = qint64(span.firstSample);
    json[QStringLiteral("last")] = qint64(span.endSample - 1);
    return json;
}

QJsonObject jsonOf(const QString &name, const oracle::EdgeVerdict &edge)
{
    return {{QStringLiteral("edge"), name},
            {QStringLiteral("from"), edge.from},
            {QStringLiteral("to"), edge.to},
            {QStringLiteral("accepts"), edge.accepts},
            {QStringLiteral("edgeFunction"), toText(edge.edgeFunction)},
            {QStringLiteral("alongColumn"), jsonOf(edge.distanceAlongColumn)},
            {QStringLiteral("alongRow"), jsonOf(edge.distanceAlongRow)},
            {QStringLiteral("distance"), jsonOf(edge.distance)}};
}

QJsonObject jsonOf(const PixelAttempt &attempt, Arithmetic arithmetic)
{
    QJsonObject json{{QStringLiteral("kind"), nameOf(attempt.kind)},
                     {QStringLiteral("primitive"), qint64(attempt.primitive)},
                     {QStringLiteral("written"), attempt.written},
                     {QStringLiteral("covered"), attempt.verdict.covered},
                     {QStringLiteral("reason"), attempt.reason}};
    if (attempt.span)
        json[QStringLiteral("span")] = spanJson(attempt, arithmetic);
    if (attempt.hasEdges()) {
        QJsonArray edges;
        for (std::size_t edge = 0; edge < attempt.edgeNames.size(); ++edge)
            edges.append(jsonOf(attempt.edgeNames[edge], attempt.verdict.edges[edge]));
        json[QStringLiteral("edges")] = edges;
    }
    QJsonArray carried;
    for (const PixelAttempt::Carried &number : attempt.carried) {
        QJsonObject entry = jsonOf(number.used, number.exact);
        entry[QStringLiteral("number")] = number.title;
        carried.append(entry);
    }
    if (!carried.isEmpty())
        json[QStringLiteral("carried")] = carried;
    if (!attempt.written)
        return json;
    json[QStringLiteral("step")] = qint64(attempt.step + 1);
    json[QStringLiteral("before")] = colourText(unpacked(attempt.change.before));
    json[QStringLiteral("after")] = colourText(unpacked(attempt.change.after));
    json[QStringLiteral("clamped")] = attempt.sample->clamped;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        QJsonObject entry = jsonOf(attempt.sample->colour[channel], attempt.exactColour[channel]);
        entry[QStringLiteral("level")] = qint64(attempt.sample->level[channel]);
        entry[QStringLiteral("byte")] = int(unpacked(attempt.change.after).channels[channel]);
        json[QString(channelLetters[channel])] = entry;
    }
    return json;
}

} // namespace

QStringList pixelLines(const PixelReport &report)
{
    const TracedScene &traced = report.traced;
    const Difference difference = traced.differences.at(report.x, report.y);
    const QString truth = report.undrawn.isEmpty()
        ? QStringLiteral("the truth")
        : QStringLiteral("the truth of what %1 draws").arg(traced.method->id);
    QString heading = QStringLiteral("pixel (%1, %2) ").arg(report.x).arg(report.y);
    heading += QStringLiteral("%1 by %2").arg(colourText(report.colour), traced.method->id);
    if (traced.trace->isCut())
        heading += QStringLiteral(", as recorded; the truth is ") + colourText(report.truth);
    else
        heading += difference == Difference::None
            ? QStringLiteral(", the same as %1").arg(truth)
            : QStringLiteral(", differs from %1, %2: %3")
                  .arg(truth, colourText(report.truth), nameOf(difference));
    if (!report.undrawn.isEmpty())
        heading
            += QStringLiteral("; the truth of the scene, with %1, is %2")
                   .arg(report.undrawn.join(QStringLiteral(", ")), colourText(report.truthOfAll));
    QStringList lines = {heading};
    if (report.history.attempts.empty() && report.history.furtherRefusals == 0)
        lines += QStringLiteral("the scene has nothing that the method draws");
    for (const PixelAttempt &attempt : report.history.attempts) {
        QString line
            = QStringLiteral("%1 %2: %3")
                  .arg(nameOf(attempt.kind), QString::number(attempt.primitive), attempt.reason);
        if (attempt.written)
            line.insert(line.indexOf(u':'), QStringLiteral(", step %1").arg(attempt.step + 1));
        lines.append(line);
        if (attempt.span)
            lines.append(spanText(attempt, traced));
        for (std::size_t channel = 0; attempt.written && channel < 3; ++channel)
            lines.append(channelText(attempt, channel));
        for (const PixelAttempt::Carried &number : attempt.carried)
            lines.append(carriedText(number));
        if (!attempt.hasEdges())
            continue;
        for (std::size_t edge = 0; edge < attempt.edgeNames.size(); ++edge)
            lines.append(edgeText(attempt.edgeNames[edge], attempt.verdict.edges[edge], traced));
    }
    if (const std::size_t further = report.history.furtherRefusals; further > 0)
        lines.append((report.history.attempts.empty() ? QStringLiteral("%1 primitives")
                                                      : QStringLiteral("%1 other primitives"))
                         .arg(further)
                     + QStringLiteral(" leave it alone: it lies outside of their boxes"));
    for (QString &line : lines)
        line = withMinus(line);
    return lines;
}

QJsonObject pixelJson(const PixelReport &report)
{
    QJsonArray attempts;
    for (const PixelAttempt &attempt : report.history.attempts)
        attempts.append(jsonOf(attempt, report.traced.scene.settings.arithmetic));
    return {
        {QStringLiteral("x"), qint64(report.x)},
        {QStringLiteral("y"), qint64(report.y)},
        {QStringLiteral("colour"), colourText(report.colour)},
        {QStringLiteral("truth"), colourText(report.truthOfAll)},
        {QStringLiteral("truthOfWhatIsDrawn"), colourText(report.truth)},
        {QStringLiteral("difference"), nameOf(report.traced.differences.at(report.x, report.y))},
        {QStringLiteral("notDrawn"), QJsonArray::fromStringList(report.undrawn)},
        {QStringLiteral("attempts"), attempts}};
}

} // namespace pixelplumb::cli
