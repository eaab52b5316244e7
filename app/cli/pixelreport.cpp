// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
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
        return {u"column"_s, u"y_B"_s, u"y_T"_s, u"rows"_s};
    case SpanAxis::Row:
        return {u"row"_s, u"x_L"_s, u"x_R"_s, u"columns"_s};
    case SpanAxis::Free:
        break;
    }
    return {u"step"_s, {}, {}, u"samples"_s};
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
        return edge.accepts ? u" accepts"_s : u" refuses"_s;
    return edge.accepts ? u", the centre inside"_s : u", the centre outside"_s;
}

QString edgeText(const QString &name, const oracle::EdgeVerdict &edge, const TracedScene &traced)
{
    QStringList distances;
    if (!edge.distanceAlongColumn.isNone())
        distances.append(toText(edge.distanceAlongColumn) + u" px along the column"_s);
    if (!edge.distanceAlongRow.isNone())
        distances.append(toText(edge.distanceAlongRow) + u" px along the row"_s);
    return (mayDecideOtherwise(traced) ? u"    in truth, edge %1%2: %3"_s : u"    edge %1%2: %3"_s)
        .arg(name, placeText(edge, traced.antialiasing()),
             distances.isEmpty() ? u"a point"_s : distances.join(u", "_s));
}

QString spanText(const PixelAttempt &attempt, const TracedScene &traced)
{
    const SpanRecord &span = *attempt.span;
    const SpanWords words = wordsFor(span.place.axis);
    const bool isByArea = traced.antialiasing() == Antialiasing::Area;
    QString text = u"    "_s + spanPlaceText(attempt);
    if (span.lower.isNone())
        return text;
    const std::int64_t first = isByArea ? span.firstDrawn : span.firstSample;
    const std::int64_t end = isByArea ? span.endDrawn : span.endSample;
    const QString exact
        = hasExactBounds(span, traced.scene.settings.arithmetic) ? u"exact "_s : QString();
    text += u": %1%2 = %3, %1%4 = %5, "_s.arg(exact, words.lower, toText(span.lower), words.upper,
                                              toText(span.upper));
    if (first >= end)
        return text + u"no "_s + words.samples;
    text += u"%1%2 %3 … %4"_s.arg(isByArea ? u"areas on the "_s : QString(), words.samples)
                .arg(first)
                .arg(end - 1);
    return text;
}

/// "; truth 277/54, error 0", where there is a number to compare with: the truth, or that of the
/// same run in exact arithmetic.
QString besideText(const QString &what, const Quantity &used, const Quantity &other)
{
    if (other.isNone())
        return {};
    return u"; %1 %2, error %3"_s.arg(what, toText(other), realText(errorOf(used, other)));
}

/// The level and the byte written. The true level is a triangle's; for a shape only the pixels are
/// true. A mean of samples has no level.
QString channelText(const PixelAttempt &attempt, std::size_t channel)
{
    const Quantity &used = attempt.sample->colour[channel];
    const std::int64_t level = std::clamp<std::int64_t>(attempt.sample->level[channel], 0, 255);
    const int byte = unpacked(attempt.change.after).channels[channel];
    QString text = u"    "_s + channelLetters[channel];
    if (!used.isNone())
        text += u" = %1 → %2"_s.arg(toText(used), QString::number(level));
    if (used.isNone() || level != byte)
        text += u" → %1"_s.arg(byte);
    return text + besideText(u"truth"_s, used, attempt.exactColour[channel]);
}

QString carriedText(const PixelAttempt::Carried &number)
{
    return u"    %1 = %2"_s.arg(number.title, toText(number.used))
        + besideText(u"exact"_s, number.used, number.exact);
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
    return QJsonObject{{u"decimal"_s, jsonOf(quantity.toDouble())},
                       {u"fraction"_s, fractionText(quantity)}};
}

/// A number beside the exact one: its value, the exact one, the error.
QJsonObject jsonOf(const Quantity &used, const Quantity &exact)
{
    return {{u"used"_s, jsonOf(used)},
            {u"exact"_s, jsonOf(exact)},
            {u"error"_s, exact.isNone() ? QJsonValue() : jsonOf(errorOf(used, exact))}};
}

QJsonObject spanJson(const PixelAttempt &attempt, Arithmetic arithmetic)
{
    const SpanRecord &span = *attempt.span;
    const SpanWords words = wordsFor(span.place.axis);
    QJsonObject json{{u"along"_s, words.place},
                     {u"at"_s, qint64(span.place.coordinate)},
                     {u"part"_s, span.place.part + 1},
                     {u"place"_s, spanPlaceText(attempt)}};
    if (span.lower.isNone())
        return json;
    json[words.lower] = jsonOf(span.lower);
    json[words.upper] = jsonOf(span.upper);
    json[u"boundsAreExact"_s] = arithmetic == Arithmetic::Exact || hasExactBounds(span, arithmetic);
    json[u"first"_s] = qint64(span.firstSample);
    json[u"last"_s] = qint64(span.endSample - 1);
    return json;
}

QJsonObject jsonOf(const QString &name, const oracle::EdgeVerdict &edge)
{
    return {{u"edge"_s, name},
            {u"from"_s, edge.from},
            {u"to"_s, edge.to},
            {u"accepts"_s, edge.accepts},
            {u"edgeFunction"_s, toText(edge.edgeFunction)},
            {u"alongColumn"_s, jsonOf(edge.distanceAlongColumn)},
            {u"alongRow"_s, jsonOf(edge.distanceAlongRow)},
            {u"distance"_s, jsonOf(edge.distance)}};
}

QJsonObject jsonOf(const PixelAttempt &attempt, Arithmetic arithmetic)
{
    QJsonObject json{{u"kind"_s, nameOf(attempt.kind)},
                     {u"primitive"_s, qint64(attempt.primitive)},
                     {u"written"_s, attempt.written},
                     {u"covered"_s, attempt.verdict.covered},
                     {u"reason"_s, attempt.reason}};
    if (attempt.span)
        json[u"span"_s] = spanJson(attempt, arithmetic);
    if (attempt.hasEdges()) {
        QJsonArray edges;
        for (std::size_t edge = 0; edge < attempt.edgeNames.size(); ++edge)
            edges.append(jsonOf(attempt.edgeNames[edge], attempt.verdict.edges[edge]));
        json[u"edges"_s] = edges;
    }
    QJsonArray carried;
    for (const PixelAttempt::Carried &number : attempt.carried) {
        QJsonObject entry = jsonOf(number.used, number.exact);
        entry[u"number"_s] = number.title;
        carried.append(entry);
    }
    if (!carried.isEmpty())
        json[u"carried"_s] = carried;
    if (!attempt.written)
        return json;
    json[u"step"_s] = qint64(attempt.step + 1);
    json[u"before"_s] = colourText(unpacked(attempt.change.before));
    json[u"after"_s] = colourText(unpacked(attempt.change.after));
    json[u"clamped"_s] = attempt.sample->clamped;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        QJsonObject entry = jsonOf(attempt.sample->colour[channel], attempt.exactColour[channel]);
        entry[u"level"_s] = qint64(attempt.sample->level[channel]);
        entry[u"byte"_s] = int(unpacked(attempt.change.after).channels[channel]);
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
        ? u"the truth"_s
        : u"the truth of what %1 draws"_s.arg(traced.method->id);
    QString heading = u"pixel (%1, %2) "_s.arg(report.x).arg(report.y);
    heading += u"%1 by %2"_s.arg(colourText(report.colour), traced.method->id);
    if (traced.trace->isCut())
        heading += u", as recorded; the truth is "_s + colourText(report.truth);
    else
        heading += difference == Difference::None
            ? u", the same as %1"_s.arg(truth)
            : u", differs from %1, %2: %3"_s.arg(truth, colourText(report.truth),
                                                 nameOf(difference));
    if (!report.undrawn.isEmpty())
        heading += u"; the truth of the scene, with %1, is %2"_s.arg(report.undrawn.join(u", "_s),
                                                                     colourText(report.truthOfAll));
    QStringList lines = {heading};
    if (report.history.attempts.empty() && report.history.furtherRefusals == 0)
        lines += u"the scene has nothing that the method draws"_s;
    for (const PixelAttempt &attempt : report.history.attempts) {
        QString line = u"%1 %2: %3"_s.arg(nameOf(attempt.kind), QString::number(attempt.primitive),
                                          attempt.reason);
        if (attempt.written)
            line.insert(line.indexOf(u':'), u", step %1"_s.arg(attempt.step + 1));
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
        lines.append(
            (report.history.attempts.empty() ? u"%1 primitives"_s : u"%1 other primitives"_s)
                .arg(further)
            + u" leave it alone: it lies outside of their boxes"_s);
    for (QString &line : lines)
        line = withMinus(line);
    return lines;
}

QJsonObject pixelJson(const PixelReport &report)
{
    QJsonArray attempts;
    for (const PixelAttempt &attempt : report.history.attempts)
        attempts.append(jsonOf(attempt, report.traced.scene.settings.arithmetic));
    return {{u"x"_s, qint64(report.x)},
            {u"y"_s, qint64(report.y)},
            {u"colour"_s, colourText(report.colour)},
            {u"truth"_s, colourText(report.truthOfAll)},
            {u"truthOfWhatIsDrawn"_s, colourText(report.truth)},
            {u"difference"_s, nameOf(report.traced.differences.at(report.x, report.y))},
            {u"notDrawn"_s, QJsonArray::fromStringList(report.undrawn)},
            {u"attempts"_s, attempts}};
}

} // namespace pixelplumb::cli
