// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/pixelfacts.h"
#include "core/export/numbertext.h"
#include "core/scene/colourtext.h"

#include <QJsonArray>

#include <cmath>

namespace pixelplumb::cli {

namespace {

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

QJsonObject spanJson(const PixelAttempt &attempt)
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

QJsonObject jsonOf(const PixelAttempt &attempt)
{
    QJsonObject json{{QStringLiteral("kind"), nameOf(attempt.kind)},
                     {QStringLiteral("primitive"), qint64(attempt.primitive)},
                     {QStringLiteral("written"), attempt.written},
                     {QStringLiteral("covered"), attempt.verdict.covered},
                     {QStringLiteral("reason"), attempt.reason}};
    if (attempt.span)
        json[QStringLiteral("span")] = spanJson(attempt);
    if (attempt.hasEdges()) {
        QJsonArray edges;
        for (std::size_t edge = 0; edge < attempt.edgeNames.size(); ++edge)
            edges.append(jsonOf(attempt.edgeNames[edge], attempt.verdict.edges[edge]));
        json[QStringLiteral("edges")] = edges;
    }
    QJsonArray carried;
    for (const PixelAttempt::Carried &number : attempt.carried)
        carried.append(QJsonObject{
            {QStringLiteral("number"), number.title},
            {QStringLiteral("used"), jsonOf(number.used)},
            {QStringLiteral("exact"), jsonOf(number.exact)},
            {QStringLiteral("error"),
             number.exact.isNone() ? QJsonValue() : jsonOf(errorOf(number.used, number.exact))}});
    if (!carried.isEmpty())
        json[QStringLiteral("carried")] = carried;
    if (!attempt.written)
        return json;
    json[QStringLiteral("step")] = qint64(attempt.step + 1);
    json[QStringLiteral("before")] = colourText(unpacked(attempt.change.before));
    json[QStringLiteral("after")] = colourText(unpacked(attempt.change.after));
    json[QStringLiteral("clamped")] = attempt.sample->clamped;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const Quantity &used = attempt.sample->colour[channel];
        const Quantity &exact = attempt.exactColour[channel];
        json[QString(channelLetters[channel])] = QJsonObject{
            {QStringLiteral("used"), jsonOf(used)},
            {QStringLiteral("exact"), jsonOf(exact)},
            {QStringLiteral("error"), exact.isNone() ? QJsonValue() : jsonOf(errorOf(used, exact))},
            {QStringLiteral("level"), qint64(attempt.sample->level[channel])},
            {QStringLiteral("byte"), int(unpacked(attempt.change.after).channels[channel])}};
    }
    return json;
}

} // namespace

QJsonObject jsonOf(const PixelReport &report)
{
    QJsonArray attempts;
    for (const PixelAttempt &attempt : report.attempts)
        attempts.append(jsonOf(attempt));
    return {
        {QStringLiteral("x"), qint64(report.x)},
        {QStringLiteral("y"), qint64(report.y)},
        {QStringLiteral("colour"), colourText(finalColour(report))},
        {QStringLiteral("truth"), colourText(trueColourOfAll(report))},
        {QStringLiteral("truthOfWhatIsDrawn"), colourText(trueColour(report))},
        {QStringLiteral("difference"), nameOf(report.traced.differences.at(report.x, report.y))},
        {QStringLiteral("notDrawn"), QJsonArray::fromStringList(undrawnAt(report))},
        {QStringLiteral("attempts"), attempts}};
}

} // namespace pixelplumb::cli
