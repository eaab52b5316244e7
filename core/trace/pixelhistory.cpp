// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/pixelhistory.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The trace's column of a triangle at an x; columns of one triangle ascend by one.
std::optional<std::size_t> columnOfTriangleAt(const ScanTrace &trace, std::size_t triangle,
                                              std::int64_t x)
{
    const std::size_t first = trace.firstColumnOf(triangle);
    const std::size_t end = trace.endColumnOf(triangle);
    if (first == end || x < trace.xOf(first) || x - trace.xOf(first) >= std::int64_t(end - first))
        return std::nullopt;
    return first + std::size_t(x - trace.xOf(first));
}

QString nameText(std::string_view name)
{
    return QString::fromUtf8(name.data(), qsizetype(name.size()));
}

QString distanceText(const oracle::EdgeVerdict &edge)
{
    const bool alongColumn = !edge.distanceAlongColumn.isNone();
    const Quantity &exact = alongColumn ? edge.distanceAlongColumn : edge.distanceAlongRow;
    if (exact.isNone())
        return QStringLiteral("at no distance: the edge is a point");
    return QStringLiteral("%1 px measured along the %2 (%3 px square to the edge)")
        .arg(toText(exact), alongColumn ? QStringLiteral("column") : QStringLiteral("row"),
             QString::number(edge.distance, 'g', 6));
}

/// Which edge keeps the sample out, by how much, under which rule.
QString refusalText(const PixelAttempt &attempt, FillRule rule)
{
    if (attempt.verdict.zeroArea) {
        return rule == FillRule::Closed
            ? QStringLiteral("The triangle has no area, and the sample is not on its segment.")
            : QStringLiteral("The triangle has no area: only the closed rule paints a segment.");
    }
    const auto refusing = std::ranges::min_element(
        attempt.verdict.edges, [](const oracle::EdgeVerdict &a, const oracle::EdgeVerdict &b) {
            return std::pair(a.accepts, a.distance) < std::pair(b.accepts, b.distance);
        });
    const QString edge = QStringLiteral("the edge from vertex %1 to vertex %2")
                             .arg(refusing->from)
                             .arg(refusing->to);
    if (refusing->edgeFunction == 0)
        return QStringLiteral(
                   "The sample lies exactly on %1, and the rule %2 gives it to the other side.")
            .arg(edge, nameText(nameOf(rule)));
    return QStringLiteral("Refused by %1: the sample is at %2, under the rule %3.")
        .arg(edge, distanceText(*refusing), nameText(nameOf(rule)));
}

QString channelText(const PixelAttempt &attempt, std::size_t channel, QChar name)
{
    return QStringLiteral("%1 = %2 → %3")
        .arg(name)
        .arg(toText(attempt.fragment.colour[channel]))
        .arg(std::clamp<std::int64_t>(attempt.fragment.level[channel], 0, 255));
}

QString writtenText(const PixelAttempt &attempt)
{
    QString text = QStringLiteral("Writes %1, %2, %3.")
                       .arg(channelText(attempt, 0, u'R'), channelText(attempt, 1, u'G'),
                            channelText(attempt, 2, u'B'));
    if (attempt.fragment.clamped)
        text += QStringLiteral(" A level left 0 … 255 and was clamped.");
    return text;
}

/// Why the kernel passed over a sample that the truth covers.
QString missedText(const PixelAttempt &attempt, const ScanTrace &trace)
{
    if (trace.isCut())
        return QStringLiteral("Not recorded: the recording ended at its limit before this pixel.");
    if (!attempt.column)
        return QStringLiteral("Missing: the truth covers it, the scan did not enter its column.");
    return QStringLiteral("Missing: the truth covers it, but the column's numbers y_B = %1 and "
                          "y_T = %2 give the rows %3 … %4.")
        .arg(toText(attempt.column->yBottom), toText(attempt.column->yTop))
        .arg(attempt.column->firstRow)
        .arg(attempt.column->endRow - 1);
}

QString reasonOf(const PixelAttempt &attempt, const TracedScene &traced)
{
    const FillRule rule = traced.scene.settings.fillRule;
    if (!attempt.written) {
        return attempt.verdict.covered ? missedText(attempt, *traced.trace)
                                       : refusalText(attempt, rule);
    }
    QString text = writtenText(attempt);
    if (!attempt.verdict.covered)
        return text + QStringLiteral(" Extra: the truth does not cover it. ")
            + refusalText(attempt, rule);
    const Colour exact = oracle::byteColourAt(traced.triangles[attempt.triangle], attempt.change.x,
                                              attempt.change.y, traced.scene.settings.rounding);
    if (packed(exact) != attempt.change.after)
        text += QStringLiteral(" The exact colour is %1, %2, %3.")
                    .arg(exact.red())
                    .arg(exact.green())
                    .arg(exact.blue());
    return text;
}

} // namespace

std::vector<PixelAttempt> pixelHistory(const TracedScene &traced, std::int64_t x, std::int64_t y,
                                       std::size_t explainedRefusals)
{
    std::vector<PixelAttempt> attempts;
    std::size_t refusals = 0;
    const ScanTrace &trace = *traced.trace;
    for (std::size_t triangle = 0; triangle < traced.triangles.size(); ++triangle) {
        PixelAttempt attempt;
        attempt.triangle = triangle;
        attempt.verdict
            = oracle::judge(traced.triangles[triangle], traced.scene.settings.fillRule, x, y);
        const std::optional<std::size_t> column = triangle < trace.triangleCount()
            ? columnOfTriangleAt(trace, triangle, x)
            : std::nullopt;
        if (column) {
            attempt.column = trace.column(*column);
            const std::int64_t offset = y - attempt.column->firstDrawnRow;
            const std::size_t pixel = trace.firstPixelOf(*column) + std::size_t(offset);
            if (offset >= 0 && pixel < trace.endPixelOf(*column)) {
                attempt.written = true;
                attempt.step = trace.indexOfPixel(pixel);
                attempt.change = trace.changes()[pixel];
                attempt.fragment = trace.fragments(*column)[std::size_t(offset)];
            }
        }
        const bool isRefusal = !attempt.written && !attempt.verdict.covered;
        if (isRefusal && ++refusals > explainedRefusals) {
            attempts.push_back(std::move(attempt));
            continue;
        }
        attempt.exactColour = oracle::colourAt(traced.triangles[triangle], x, y);
        attempt.reason = reasonOf(attempt, traced);
        attempts.push_back(std::move(attempt));
    }
    return attempts;
}

} // namespace pixelplumb
