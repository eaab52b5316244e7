// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/rowoptions.h"

#include "app/cli/wholenumber.h"

namespace pixelplumb::cli {

namespace {

constexpr QLatin1String triangleOption("triangle");
constexpr QLatin1String xOption("x");
constexpr QLatin1String yOption("y");

bool hasSpansAlong(const ScanTrace &trace, SpanAxis axis)
{
    for (std::size_t i = 0; i < trace.spanCount(); ++i) {
        if (trace.span(i).place.axis == axis)
            return true;
    }
    return trace.spanCount() == 0;
}

/// The error for a coordinate that the table lacks.
InputError objectionTo(const QString &option, const TracedScene &traced, TraceLevel level)
{
    const QString place = QStringLiteral("--") + option;
    if (level == TraceLevel::Stage)
        return {place, QStringLiteral("a stage has no place in the frame"),
                QStringLiteral("--level column or --level pixel")};
    if (level == TraceLevel::SetUp)
        return {place, QStringLiteral("a primitive's set-up has no place"),
                QStringLiteral("--level column or --level pixel")};
    const SpanAxis axis = option == xOption ? SpanAxis::Column : SpanAxis::Row;
    if (level == TraceLevel::Column && !hasSpansAlong(*traced.trace, axis))
        return {
            place,
            QStringLiteral("“%1” walks along no such %2")
                .arg(traced.method->id,
                     axis == SpanAxis::Column ? QStringLiteral("columns") : QStringLiteral("rows")),
            QStringLiteral("--level pixel, or the other coordinate")};
    return {};
}

Result<std::optional<std::int64_t>> coordinate(const CommandLine &line, const QString &option,
                                               const TracedScene &traced, TraceLevel level)
{
    if (!line.isSet(option))
        return std::optional<std::int64_t>();
    if (InputError objection = objectionTo(option, traced, level); !objection.found.isEmpty())
        return objection;
    const FrameSpec &frame = traced.scene.frame;
    const std::int64_t first = option == xOption ? frame.firstColumn : frame.firstRow;
    const std::int64_t size = option == xOption ? frame.width : frame.height;
    return wholeNumberOf(line, option,
                         {first, first + size - 1, QStringLiteral("outside the frame")});
}

} // namespace

void addRowOptions(CommandLine &line)
{
    const QString number = QStringLiteral("number");
    line.addOption({triangleOption,
                    QStringLiteral("Print the rows of this primitive alone, counted from 0."),
                    number});
    line.addOption(
        {xOption, QStringLiteral("Print the rows of this column of the frame alone."), number});
    line.addOption(
        {yOption, QStringLiteral("Print the rows of this row of the frame alone."), number});
}

WholeRange primitivesOf(const ScanTrace &trace)
{
    return {0, std::int64_t(trace.primitiveCount()) - 1,
            QStringLiteral("no primitive of the scene")};
}

Result<RowChoice> chosenRows(const CommandLine &line, const TracedScene &traced, TraceLevel level)
{
    const auto primitive = wholeNumberOf(line, triangleOption, primitivesOf(*traced.trace));
    if (!primitive)
        return primitive.error();
    const auto x = coordinate(line, xOption, traced, level);
    if (!x)
        return x.error();
    const auto y = coordinate(line, yOption, traced, level);
    if (!y)
        return y.error();
    RowChoice rows{std::nullopt, *x, *y};
    if (*primitive)
        rows.primitive = std::size_t(**primitive);
    return rows;
}

} // namespace pixelplumb::cli
