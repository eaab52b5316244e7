// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/pixelfacts.h"
#include "core/export/numbertext.h"
#include "core/runs/edgerefusal.h"
#include "core/scene/colourtext.h"

#include <algorithm>

namespace pixelplumb::cli {

namespace {

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

QString spanText(const PixelAttempt &attempt, Antialiasing antialiasing)
{
    const SpanRecord &span = *attempt.span;
    const SpanWords words = wordsFor(span.place.axis);
    const bool isByArea = antialiasing == Antialiasing::Area;
    QString text = QStringLiteral("    ") + spanPlaceText(attempt);
    if (span.lower.isNone())
        return text;
    const std::int64_t first = isByArea ? span.firstDrawn : span.firstSample;
    const std::int64_t end = isByArea ? span.endDrawn : span.endSample;
    text += QStringLiteral(": %1 = %2, %3 = %4, ")
                .arg(words.lower, toText(span.lower), words.upper, toText(span.upper));
    if (first >= end)
        return text + QStringLiteral("no ") + words.samples;
    text += QStringLiteral("%1%2 %3 … %4")
                .arg(isByArea ? QStringLiteral("areas on the ") : QString(), words.samples)
                .arg(first)
                .arg(end - 1);
    return text;
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
    if (exact.isNone())
        return text;
    return text
        + QStringLiteral("; exact %1, error %2").arg(toText(exact), realText(errorOf(used, exact)));
}

QString carriedText(const PixelAttempt::Carried &number)
{
    QString text = QStringLiteral("    %1 = %2").arg(number.title, toText(number.used));
    if (number.exact.isNone())
        return text;
    return text
        + QStringLiteral("; exact %1, error %2")
              .arg(toText(number.exact), realText(errorOf(number.used, number.exact)));
}

} // namespace

QStringList textOf(const PixelReport &report)
{
    const TracedScene &traced = report.traced;
    const Difference difference = traced.differences.at(report.x, report.y);
    const QStringList undrawn = undrawnAt(report);
    const QString truth = undrawn.isEmpty()
        ? QStringLiteral("the truth")
        : QStringLiteral("the truth of what %1 draws").arg(traced.method->id);
    QString heading = QStringLiteral("pixel (%1, %2) ").arg(report.x).arg(report.y);
    heading += colourText(finalColour(report));
    if (traced.trace->isCut())
        heading += QStringLiteral(", as recorded; the truth is ") + colourText(trueColour(report));
    else
        heading += difference == Difference::None
            ? QStringLiteral(", the same as %1").arg(truth)
            : QStringLiteral(", differs from %1, %2: %3")
                  .arg(truth, colourText(trueColour(report)), nameOf(difference));
    if (!undrawn.isEmpty())
        heading
            += QStringLiteral("; the truth of the scene, with %1, is %2")
                   .arg(undrawn.join(QStringLiteral(", ")), colourText(trueColourOfAll(report)));
    QStringList lines = {heading};
    if (report.attempts.empty())
        lines += QStringLiteral("the scene has nothing that the method draws");
    for (const PixelAttempt &attempt : report.attempts) {
        QString line
            = QStringLiteral("%1 %2: %3")
                  .arg(nameOf(attempt.kind), QString::number(attempt.primitive), attempt.reason);
        if (attempt.written)
            line.insert(line.indexOf(u':'), QStringLiteral(", step %1").arg(attempt.step + 1));
        lines.append(line);
        if (attempt.span)
            lines.append(spanText(attempt, traced.antialiasing()));
        for (std::size_t channel = 0; attempt.written && channel < 3; ++channel)
            lines.append(channelText(attempt, channel));
        for (const PixelAttempt::Carried &number : attempt.carried)
            lines.append(carriedText(number));
        if (!attempt.hasEdges())
            continue;
        for (std::size_t edge = 0; edge < attempt.edgeNames.size(); ++edge)
            lines.append(edgeText(attempt.edgeNames[edge], attempt.verdict.edges[edge], traced));
    }
    for (QString &line : lines)
        line = withMinus(line);
    return lines;
}

} // namespace pixelplumb::cli
