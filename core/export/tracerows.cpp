// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/tracerows.h"

#include "core/methods/words/rejectiontext.h"
#include "core/runs/explain/projectionstages.h"
#include "core/runs/explain/rejectedprimitives.h"
#include "core/scene/text/colourtext.h"

#include <algorithm>
#include <utility>

namespace pixelplumb {

namespace {

using Kind = Field::Kind;

/// A record has fewer cells than its method describes where nothing was computed: for a rejected
/// primitive, or a sample of a triangle without area.
Quantity cellAt(const std::vector<Quantity> &cells, std::size_t index)
{
    return index < cells.size() ? cells[index] : Quantity();
}

Quantity integer(std::int64_t value) { return Quantity::integer(value); }

/// Counted as in the window: 1 for the first step.
Quantity stepNumber(std::size_t index) { return Quantity::integer(Int128(index) + 1); }

Quantity errorCell(const Quantity &used, const Quantity &exact)
{
    const bool isComparable = !used.isNone() && !exact.isNone();
    return isComparable ? Quantity::of(errorOf(used, exact)) : Quantity();
}

/// Adds a number as it was used, the exact number and the error.
template <class Row>
void addCompared(TraceTable<Row> &table, const QString &name, const QString &title,
                 const std::function<Quantity(const Row &)> &used,
                 const std::function<Quantity(const Row &)> &exact)
{
    table.add({name, Kind::Number, title}, used);
    table.add({exactName(name), Kind::Exact, title + u" exact"_s}, exact);
    table.add({errorName(name), Kind::Error, title + u" error"_s},
              [used, exact](const Row &row) { return errorCell(used(row), exact(row)); });
}

/// Adds the numbers that a method describes. `exactCells` reads a row's exact numbers.
template <class Row, class ExactCells>
void addDescribed(TraceTable<Row> &table, const std::vector<NumberDescription> &numbers,
                  const ExactCells &exactCells)
{
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        // A number already in the table is this one: R, G and B of a sample.
        if (table.contains(numbers[i].id))
            continue;
        const auto used = [i](const Row &row) { return cellAt(row.record.cells, i); };
        if (numbers[i].comparison == Comparison::None)
            table.add({numbers[i].id, Kind::Number, numbers[i].title}, used);
        else
            addCompared<Row>(
                table, numbers[i].id, numbers[i].title, used,
                [i, exactCells](const Row &row) { return cellAt(exactCells(row), i); });
    }
}

/// A stage's number without rounding: roots and quotients as far as they are known, to 20 digits
/// followed by "…".
QString unroundedText(const Quantity &exact)
{
    constexpr qsizetype knownDigits = 20;
    constexpr int mostPlaces = 36;
    if (!exact.isRational())
        return exact.isNone() ? QString() : toText(exact);
    QString text = cutDecimal(exact, mostPlaces).digits;
    if (text.contains(u'.')) {
        while (text.endsWith(u'0'))
            text.chop(1);
        if (text.endsWith(u'.'))
            text.chop(1);
    }
    qsizetype digits = 0;
    for (const QChar each : text)
        digits += each.isDigit() && (digits > 0 || each != u'0') ? 1 : 0;
    return digits < knownDigits ? text : text + u'…';
}

} // namespace

TraceTable<SetUpRow> setUpTable(const std::vector<NumberDescription> &numbers)
{
    TraceTable<SetUpRow> table;
    table.add({"step", Kind::Number}, [](const SetUpRow &row) { return stepNumber(row.step); });
    table.add({"primitive", Kind::Number},
              [](const SetUpRow &row) { return integer(std::int64_t(row.record.primitive)); });
    table.add({"kind", Kind::Text}, [](const SetUpRow &row) { return nameOf(row.kind); });
    table.add({"zero_area", Kind::Boolean},
              [](const SetUpRow &row) { return row.record.zeroArea; });
    table.add({"rejection", Kind::Text}, [](const SetUpRow &row) {
        return row.rejection ? rejectionText(*row.rejection) : QString();
    });
    addDescribed(
        table, numbers, [](const SetUpRow &row) -> const auto & { return row.exact; });
    return table;
}

SetUpRow setUpRow(const TracedScene &traced, std::size_t primitive)
{
    const ScanTrace &trace = *traced.trace;
    SetUpRow row{trace.indexOfSetUp(primitive),
                 traced.primitives.kindOf(primitive),
                 trace.setUp(primitive),
                 rejectionOf(traced, primitive),
                 {}};
    // Where nothing was computed the cells hold only initial values.
    if (row.record.rejection)
        row.record.cells.clear();
    else
        row.exact = exactSetUpCells(traced, primitive);
    return row;
}

TraceTable<SpanRow> spanTable(const std::vector<NumberDescription> &numbers)
{
    TraceTable<SpanRow> table;
    table.add({"step", Kind::Number}, [](const SpanRow &row) { return stepNumber(row.step); });
    table.add({"primitive", Kind::Number},
              [](const SpanRow &row) { return integer(std::int64_t(row.record.primitive)); });
    addDescribed(
        table, numbers, [](const SpanRow &row) -> const auto & { return row.exact; });
    return table;
}

SpanRow spanRow(const TracedScene &traced, std::size_t span)
{
    return {traced.trace->indexOfSpan(span), traced.trace->span(span),
            exactSpanCells(traced, span)};
}

TraceTable<StageRow> stageTable()
{
    TraceTable<StageRow> table;
    table.add({"step", Kind::Number}, [](const StageRow &row) { return stepNumber(row.step); });
    table.add({"primitive", Kind::Number},
              [](const StageRow &row) { return integer(std::int64_t(row.primitive)); });
    table.add({"stage", Kind::Text}, [](const StageRow &row) { return row.stage; });
    table.add({"point", Kind::Text}, [](const StageRow &row) { return row.point; });
    const auto used = [](const StageRow &row) { return row.number.used; };
    table.add({"used", Kind::Number}, used);
    table.add({exactName("used"), Kind::Text, "used exact"},
              [](const StageRow &row) { return unroundedText(row.number.exact); });
    table.add({errorName("used"), Kind::Error, "used error"},
              [used](const StageRow &row) { return errorCell(used(row), row.number.exact); });
    table.add({"formula", Kind::Text}, [](const StageRow &row) { return row.number.symbols; });
    table.add({"numbers", Kind::Text}, [](const StageRow &row) { return row.number.substituted; });
    table.add({"note", Kind::Text}, [](const StageRow &row) { return row.note; });
    return table;
}

std::vector<StageRow> stageRows(const TracedScene &traced, std::size_t primitive)
{
    std::vector<StageRow> rows;
    for (const StageFormulas &stage : stageFormulas(traced, primitive)) {
        for (const FormulaLine &line : stage.lines)
            rows.push_back({traced.trace->indexOfSetUp(primitive), primitive, stage.stage,
                            stage.point, stage.note, line});
    }
    return rows;
}

TraceTable<SampleRow> sampleTable(const std::vector<NumberDescription> &numbers)
{
    using Row = SampleRow;
    TraceTable<Row> table;
    table.add({"step", Kind::Number}, [](const Row &row) { return stepNumber(row.step); });
    table.add({"primitive", Kind::Number},
              [](const Row &row) { return integer(std::int64_t(row.primitive)); });
    table.add({"x", Kind::Number}, [](const Row &row) { return integer(row.record.x); });
    table.add({"y", Kind::Number}, [](const Row &row) { return integer(row.record.y); });
    for (std::size_t channel = 0; channel < channelLetters.size(); ++channel) {
        const QString name = QChar(channelLetters[channel]);
        addCompared<Row>(
            table, name, name, [channel](const Row &row) { return row.record.colour[channel]; },
            [channel](const Row &row) { return row.exact.colour[channel]; });
        table.add({name + u"_level"_s, Kind::Number}, [channel](const Row &row) {
            return row.change.isWritten() ? integer(row.record.level[channel]) : Quantity();
        });
        table.add({name + u"_byte"_s, Kind::Number}, [channel](const Row &row) {
            return row.change.isWritten() ? integer(unpacked(row.change.after).channels[channel])
                                          : Quantity();
        });
    }
    table.add({"clamped", Kind::Boolean}, [](const Row &row) { return row.record.clamped; });
    table.add({"before", Kind::Text},
              [](const Row &row) { return colourText(unpacked(row.change.before)); });
    table.add({"after", Kind::Text}, [](const Row &row) {
        return colourText(unpacked(row.change.isWritten() ? row.change.after : row.change.before));
    });
    table.add({"fate", Kind::Text},
              [](const Row &row) { return row.change.isWritten() ? u"written"_s : u"refused"_s; });
    addDescribed(
        table, numbers, [](const Row &row) -> const auto & { return row.exact.cells; });
    return table;
}

std::vector<SampleRow> sampleRows(const TracedScene &traced, std::size_t span)
{
    const ScanTrace &trace = *traced.trace;
    const std::size_t first = trace.firstSampleOf(span);
    const std::size_t visited = trace.endSampleOf(span) - first;
    std::vector<SampleRow> rows;
    if (visited == 0)
        return rows;
    const std::vector<SampleRecord> samples = trace.samples(span);
    std::vector<ExactSample> exact = exactSamplesOf(traced, span, samples);
    // A shape has no plane of levels; those of an exact run are the exact ones.
    const bool areExact = traced.scene.settings.arithmetic == Arithmetic::Exact
        && !traced.primitives.isTriangle(trace.primitiveOf(span));
    for (std::size_t index = 0; areExact && index < samples.size(); ++index) {
        if (std::ranges::all_of(samples[index].colour, &Quantity::isRational))
            exact[index].colour = samples[index].colour;
    }
    for (std::size_t index = 0; index < std::min(visited, samples.size()); ++index) {
        const std::size_t sample = first + index;
        rows.push_back({trace.indexOfSample(sample), trace.primitiveOf(span), samples[index],
                        trace.changes()[sample], std::move(exact[index])});
    }
    return rows;
}

} // namespace pixelplumb
