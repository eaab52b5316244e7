// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/tracerows.h"

#include "core/scene/colourtext.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The exact value and the error in their cells; both empty where there is no exact value.
void appendComparison(QStringList &cells, const Quantity &used, const Quantity &exact)
{
    const bool comparable = !used.isNone() && !exact.isNone();
    cells.append(toText(exact));
    cells.append(comparable ? realText(errorOf(used, exact)) : QString());
}

/// Positions and counts are whole numbers in every arithmetic.
bool isCount(const TraceColumn &column)
{
    return column.group == TraceColumnGroup::Position || column.unit.isEmpty();
}

/// As the window counts: 1 for the first step.
QString stepNumber(std::size_t index) { return QString::number(index + 1); }

} // namespace

std::vector<Field> spanFields(const Method &method)
{
    std::vector<Field> fields = {{QStringLiteral("step"), Field::Kind::Integer}};
    for (const TraceColumn &column : method.spanColumns) {
        if (column.comparison == Comparison::None) {
            fields.push_back(
                {column.id, isCount(column) ? Field::Kind::Integer : Field::Kind::Text});
            continue;
        }
        fields.push_back({column.id, Field::Kind::Text});
        fields.push_back({column.id + QStringLiteral("_exact"), Field::Kind::Text});
        fields.push_back({column.id + QStringLiteral("_error"), Field::Kind::Real});
    }
    return fields;
}

QStringList spanCells(const TracedScene &traced, std::size_t span)
{
    const ScanTrace &trace = *traced.trace;
    const std::vector<Quantity> used = trace.span(span).cells;
    const std::vector<Quantity> exact = exactSpanCells(traced, span);
    QStringList cells = {stepNumber(trace.indexOfSpan(span))};
    const std::vector<TraceColumn> &columns = traced.method->spanColumns;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        cells.append(toText(used[i]));
        if (columns[i].comparison == Comparison::WithExact)
            appendComparison(cells, used[i], exact[i]);
    }
    return cells;
}

std::vector<Field> sampleFields(const Method &method)
{
    std::vector<Field> fields = {{QStringLiteral("step"), Field::Kind::Integer},
                                 {QStringLiteral("primitive"), Field::Kind::Integer},
                                 {QStringLiteral("x"), Field::Kind::Integer},
                                 {QStringLiteral("y"), Field::Kind::Integer}};
    for (const QChar channel : channelLetters) {
        const QString name = QChar(channel);
        fields.push_back({name, Field::Kind::Text});
        fields.push_back({name + QStringLiteral("_exact"), Field::Kind::Text});
        fields.push_back({name + QStringLiteral("_error"), Field::Kind::Real});
        fields.push_back({name + QStringLiteral("_level"), Field::Kind::Integer});
        fields.push_back({name + QStringLiteral("_byte"), Field::Kind::Integer});
    }
    fields.push_back({QStringLiteral("clamped"), Field::Kind::Boolean});
    fields.push_back({QStringLiteral("before"), Field::Kind::Text});
    fields.push_back({QStringLiteral("after"), Field::Kind::Text});
    fields.push_back({QStringLiteral("fate"), Field::Kind::Text});
    for (const TraceColumn &column : method.sampleColumns) {
        fields.push_back({column.id, Field::Kind::Text});
        if (column.comparison == Comparison::None)
            continue;
        fields.push_back({column.id + QStringLiteral("_exact"), Field::Kind::Text});
        fields.push_back({column.id + QStringLiteral("_error"), Field::Kind::Real});
    }
    return fields;
}

void forEachSampleRow(const TracedScene &traced, std::size_t span,
                      const std::function<void(const QStringList &cells)> &write)
{
    const ScanTrace &trace = *traced.trace;
    const std::size_t first = trace.firstSampleOf(span);
    const std::size_t end = trace.endSampleOf(span);
    if (first == end)
        return;
    const std::vector<SampleRecord> samples = trace.samples(span);
    const std::vector<TraceColumn> &columns = traced.method->sampleColumns;
    // A trace that was cut may hold fewer samples than its last span has.
    const std::size_t count = std::min(end - first, samples.size());
    for (std::size_t index = 0; index < count; ++index) {
        const SampleRecord &sample = samples[index];
        const PixelChange &change = trace.changes()[first + index];
        const bool isWritten = change.isWritten();
        const Colour after = unpacked(isWritten ? change.after : change.before);
        const ExactSample exact = exactSampleOf(traced, span, sample);
        QStringList cells = {stepNumber(trace.indexOfSample(first + index)),
                             QString::number(trace.primitiveOf(span)), QString::number(sample.x),
                             QString::number(sample.y)};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            cells.append(toText(sample.colour[channel]));
            appendComparison(cells, sample.colour[channel], exact.colour[channel]);
            cells.append(isWritten ? QString::number(sample.level[channel]) : QString());
            cells.append(isWritten ? QString::number(int(after.channels[channel])) : QString());
        }
        cells.append(sample.clamped ? QStringLiteral("true") : QStringLiteral("false"));
        cells.append(colourText(unpacked(change.before)));
        cells.append(colourText(after));
        cells.append(isWritten ? QStringLiteral("written") : QStringLiteral("refused"));
        for (std::size_t i = 0; i < columns.size(); ++i) {
            cells.append(toText(sample.cells[i]));
            if (columns[i].comparison == Comparison::WithExact)
                appendComparison(cells, sample.cells[i], exact.cells[i]);
        }
        write(cells);
    }
}

} // namespace pixelplumb
