// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/traceexport.h"

#include "core/export/tracerows.h"
#include "core/scan/choicenames.h"

namespace pixelplumb {

namespace {

QByteArray jsonName(std::string_view name) { return jsonString(nameText(name)); }

/// What a reader has to know about the table: how it was drawn, and what the columns mean.
std::vector<PreambleMember> preambleOf(const TracedScene &traced, TraceLevel level)
{
    const ScanSettings &settings = traced.trace->settings();
    std::vector<PreambleMember> members
        = {{QStringLiteral("pixelplumbTrace"), "1"},
           {QStringLiteral("level"), level == TraceLevel::Column ? "\"column\"" : "\"pixel\""},
           {QStringLiteral("method"), jsonString(traced.method->id)},
           {QStringLiteral("arithmetic"), jsonName(nameOf(settings.arithmetic))},
           {QStringLiteral("fillRule"), jsonName(nameOf(settings.fillRule))},
           {QStringLiteral("rounding"), jsonName(nameOf(settings.rounding))},
           {QStringLiteral("cut"), traced.trace->isCut() ? "true" : "false"}};
    if (level == TraceLevel::Pixel)
        return members;
    QByteArray columns = "[";
    for (const TraceColumn &column : traced.method->spanColumns) {
        columns += columns.size() == 1 ? "\n" : ",\n";
        columns += "    {\"id\": " + jsonString(column.id) + ", \"unit\": "
            + jsonString(column.unit) + ", \"formula\": " + jsonString(column.formula)
            + ", \"meaning\": " + jsonString(column.toolTip) + '}';
    }
    members.push_back({QStringLiteral("columns"), columns + "\n  ]"});
    return members;
}

} // namespace

bool exportTrace(const TracedScene &traced, const TraceExportOptions &options, QIODevice &device)
{
    const auto writer = makeRowWriter(options.format, device, preambleOf(traced, options.level));
    const bool byPixel = options.level == TraceLevel::Pixel;
    writer->begin(byPixel ? sampleFields(*traced.method) : spanFields(*traced.method));
    const std::size_t spanCount = traced.trace->spanCount();
    for (std::size_t span = 0; span < spanCount; ++span) {
        if (options.progress && !options.progress(double(span) / double(spanCount)))
            return false;
        if (byPixel) {
            forEachSampleRow(traced, span,
                             [&](const QStringList &cells) { writer->writeRow(cells); });
        } else {
            writer->writeRow(spanCells(traced, span));
        }
        if (!writer->isOk())
            return false;
    }
    writer->end();
    return writer->isOk();
}

} // namespace pixelplumb
