// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/traceexport.h"

#include "core/export/tracerows.h"
#include "core/runs/explain/runformulas.h"
#include "core/runs/spanheadings.h"
#include "core/scan/choicenames.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pixelplumb {

namespace {

constexpr QLatin1String motionFrameColumn("frame");

QByteArray jsonName(std::string_view name) { return jsonString(nameText(name)); }

QString nameOf(TraceLevel level)
{
    static constexpr std::array names = {"setup", "column", "pixel", "stage"};
    return QLatin1String(names[std::size_t(level)]);
}

/// The numbers that a level's table describes, and how the run computed each.
std::pair<std::vector<NumberDescription>, QStringList> describedNumbers(
    const TracedScene &traced, const TraceExportOptions &options)
{
    switch (options.level) {
    case TraceLevel::SetUp:
        return {traced.trace->numbers().setUp, setUpFormulas(traced)};
    case TraceLevel::Column:
        return {spanHeadings(traced), spanFormulas(traced, options.progress)};
    case TraceLevel::Pixel:
        return {traced.trace->numbers().sample, sampleFormulas(traced, options.progress)};
    case TraceLevel::Stage:
        break;
    }
    return {};
}

/// A kernel sees pixel (x, y) as the point (x, y), wherever the scene puts the pixel's centre.
QString coordinatesText(const TracedScene &traced)
{
    return traced.scene.frame.pixelCentre == PixelCentre::Half
        ? u"counted from the centre of pixel (0, 0): 1/2 px less than the scene's"_s
        : u"the scene's"_s;
}

/// Whether the number, its exact value or its error is written.
bool isWritten(const NumberDescription &number, const QStringList &columns)
{
    return columns.isEmpty() || columns.contains(number.id)
        || columns.contains(exactName(number.id)) || columns.contains(errorName(number.id));
}

QByteArray variantsJson(VariantSet variants)
{
    QByteArray names;
    for (const Variant variant : variantsIn(variants))
        names += (names.isEmpty() ? "" : ", ") + jsonName(nameOf(variant));
    return '[' + names + ']';
}

/// What a reader must know about the table: how it was drawn, and what the columns mean.
std::vector<PreambleMember> preambleOf(const TracedScene &traced, const TraceExportOptions &options)
{
    const ScanSettings &settings = traced.trace->settings();
    QByteArray columns = "[";
    const auto [numbers, formulas] = describedNumbers(traced, options);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const NumberDescription &number = numbers[i];
        if (!isWritten(number, options.columns))
            continue;
        columns += columns.size() == 1 ? "\n" : ",\n";
        columns += "    {\"id\": " + jsonString(number.id) + ", \"unit\": "
            + jsonString(number.unit) + ", \"formula\": " + jsonString(formulas[qsizetype(i)])
            + ", \"meaning\": " + jsonString(number.toolTip) + '}';
    }
    std::vector<PreambleMember> members
        = {{"pixelplumbTrace", "2"},
           {"level", jsonString(nameOf(options.level))},
           {"method", jsonString(traced.method->id)},
           {"arithmetic", jsonName(nameOf(settings.arithmetic))},
           {"fillRule", jsonName(nameOf(settings.fillRule))},
           {"rounding", jsonName(nameOf(settings.rounding))},
           {"variants", variantsJson(settings.variants)},
           {"coordinates", jsonString(coordinatesText(traced))},
           {"cut", traced.trace->isCut() ? "true" : "false"},
           {"columns", columns + (columns.size() == 1 ? "]" : "\n  ]")}};
    if (options.frame)
        members.insert(members.begin() + 1,
                       {motionFrameColumn, QByteArray::number(*options.frame)});
    return members;
}

std::unique_ptr<RowWriter> writerFor(const TracedScene &traced, const TraceExportOptions &options,
                                     QIODevice &device)
{
    switch (options.format) {
    case TableFormat::Text:
        return makeTextWriter(device, options.textNumbers);
    case TableFormat::Csv:
        return makeCsvWriter(device);
    case TableFormat::Json:
        break;
    }
    return makeJsonWriter(device, preambleOf(traced, options));
}

template <class Row>
TraceTable<Row> chosenColumns(const TraceTable<Row> &whole, const TraceExportOptions &options)
{
    if (!options.columns.isEmpty())
        return whole.only(options.columns);
    const TraceTable<Row> chosen
        = options.format == TableFormat::Text ? whole.withoutComparisons() : whole;
    return options.frame
        ? chosen.behind({motionFrameColumn, Field::Kind::Number},
                        [frame = *options.frame](const Row &) { return Quantity::integer(frame); })
        : chosen;
}

bool isChosen(const RowChoice &choice, const SetUpRow &row)
{
    return !choice.primitive || *choice.primitive == row.record.primitive;
}

bool isChosen(const RowChoice &choice, const SpanRow &row)
{
    const SpanPlace &place = row.record.place;
    const auto lies = [&place](std::optional<std::int64_t> wanted, SpanAxis axis) {
        return !wanted || (place.axis == axis && place.coordinate == *wanted);
    };
    return (!choice.primitive || *choice.primitive == row.record.primitive)
        && lies(choice.x, SpanAxis::Column) && lies(choice.y, SpanAxis::Row);
}

bool isChosen(const RowChoice &choice, const SampleRow &row)
{
    return (!choice.primitive || *choice.primitive == row.primitive)
        && (!choice.x || *choice.x == row.record.x) && (!choice.y || *choice.y == row.record.y);
}

bool isChosen(const RowChoice &choice, const StageRow &row)
{
    return !choice.primitive || *choice.primitive == row.primitive;
}

/// Writes the rows that `rowsAt(index)` gives for each index below `count`.
template <class Row, class RowsAt>
bool writeTable(const TraceTable<Row> &table, std::size_t count, const RowsAt &rowsAt,
                const TraceExportOptions &options, RowWriter &writer)
{
    const TraceTable<Row> chosen = chosenColumns(table, options);
    writer.begin(chosen.fields());
    for (std::size_t index = 0; index < count; ++index) {
        if (!goesOn(options.progress,
                    {JobPhase::Writing, std::int64_t(index), std::int64_t(count)}))
            return false;
        for (const Row &row : rowsAt(index)) {
            const bool isDone = !options.rows.position || row.step < *options.rows.position;
            if (isDone && isChosen(options.rows, row))
                writer.writeRow(chosen.cells(row));
        }
        if (!writer.isOk())
            return false;
    }
    writer.end();
    return writer.isOk();
}

template <class Row>
QStringList namesOf(const TraceTable<Row> &table)
{
    QStringList names;
    for (const Field &field : table.fields())
        names.append(field.name);
    return names;
}

/// Names come first: a title may be another column's name.
template <class Row>
QString nameMeantBy(const QString &word, const TraceTable<Row> &table)
{
    if (table.contains(word))
        return word;
    const auto found = std::ranges::find(table.fields(), word, &Field::title);
    return found != table.fields().end() ? found->name : QString();
}

/// What `read` returns for the table of a trace at a level.
template <class Read>
auto ofTable(const TraceNumbers &numbers, TraceLevel level, const Read &read)
{
    switch (level) {
    case TraceLevel::SetUp:
        return read(setUpTable(numbers.setUp));
    case TraceLevel::Column:
        return read(spanTable(numbers.span));
    case TraceLevel::Stage:
        return read(stageTable());
    case TraceLevel::Pixel:
        break;
    }
    return read(sampleTable(numbers.sample));
}

} // namespace

QStringList traceColumnNames(const TraceNumbers &numbers, TraceLevel level)
{
    return ofTable(numbers, level, [](const auto &table) { return namesOf(table); });
}

QString traceColumnNamed(const TraceNumbers &numbers, TraceLevel level, const QString &word)
{
    return ofTable(numbers, level, [&word](const auto &table) { return nameMeantBy(word, table); });
}

bool exportTrace(const TracedScene &traced, const TraceExportOptions &options, QIODevice &device)
{
    const ScanTrace &trace = *traced.trace;
    const auto writer = writerFor(traced, options, device);
    switch (options.level) {
    case TraceLevel::SetUp:
        return writeTable(
            setUpTable(trace.numbers().setUp), trace.primitiveCount(),
            [&](std::size_t primitive) { return std::array{setUpRow(traced, primitive)}; }, options,
            *writer);
    case TraceLevel::Column:
        return writeTable(
            spanTable(spanHeadings(traced)), trace.spanCount(),
            [&](std::size_t span) { return std::array{spanRow(traced, span)}; }, options, *writer);
    case TraceLevel::Stage:
        return writeTable(
            stageTable(), trace.primitiveCount(),
            [&](std::size_t primitive) { return stageRows(traced, primitive); }, options, *writer);
    case TraceLevel::Pixel:
        break;
    }
    return writeTable(
        sampleTable(trace.numbers().sample), trace.spanCount(),
        [&](std::size_t span) { return sampleRows(traced, span); }, options, *writer);
}

} // namespace pixelplumb
