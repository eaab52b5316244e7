// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/tracerows.h"

#include "core/scene/colourtext.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::array<char16_t, 3> channelNames = {u'R', u'G', u'B'};

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

std::vector<Field> columnFields(const Method &method)
{
    std::vector<Field> fields = {{QStringLiteral("step"), Field::Kind::Integer}};
    for (const TraceColumn &column : method.traceColumns) {
        if (column.exact == nullptr) {
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

QStringList columnCells(const TracedScene &traced, std::size_t column)
{
    const ScanTrace &trace = *traced.trace;
    const ColumnRecord record = trace.column(column);
    const auto exact
        = oracle::columnAt(traced.triangles[record.triangle], trace.settings().fillRule, record.x);
    QStringList cells = {stepNumber(trace.indexOfColumn(column))};
    for (const TraceColumn &description : traced.method->traceColumns) {
        const Quantity used = description.used(record);
        cells.append(toText(used));
        if (description.exact != nullptr)
            appendComparison(cells, used, exact ? description.exact(*exact) : Quantity());
    }
    return cells;
}

std::vector<Field> pixelFields()
{
    std::vector<Field> fields = {{QStringLiteral("step"), Field::Kind::Integer},
                                 {QStringLiteral("triangle"), Field::Kind::Integer},
                                 {QStringLiteral("x"), Field::Kind::Integer},
                                 {QStringLiteral("y"), Field::Kind::Integer}};
    for (const char16_t channel : channelNames) {
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
    return fields;
}

void forEachPixelRow(const TracedScene &traced, std::size_t column,
                     const std::function<void(const QStringList &cells)> &write)
{
    const ScanTrace &trace = *traced.trace;
    const std::size_t first = trace.firstPixelOf(column);
    const std::size_t end = trace.endPixelOf(column);
    if (first == end)
        return;
    const std::size_t triangle = trace.triangleOf(column);
    const std::vector<FragmentRecord> fragments = trace.fragments(column);
    // A trace that was cut may hold fewer pixels than its last column has fragments.
    const std::size_t count = std::min(end - first, fragments.size());
    for (std::size_t index = 0; index < count; ++index) {
        const FragmentRecord &fragment = fragments[index];
        const PixelChange &change = trace.changes()[first + index];
        const Colour after = unpacked(change.after);
        const auto exact = oracle::colourAt(traced.triangles[triangle], fragment.x, fragment.y);
        QStringList cells
            = {stepNumber(trace.indexOfPixel(first + index)), QString::number(triangle),
               QString::number(fragment.x), QString::number(fragment.y)};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            cells.append(toText(fragment.colour[channel]));
            appendComparison(cells, fragment.colour[channel], exact[channel]);
            cells.append(QString::number(fragment.level[channel]));
            cells.append(QString::number(int(after.channels[channel])));
        }
        cells.append(fragment.clamped ? QStringLiteral("true") : QStringLiteral("false"));
        cells.append(colourText(unpacked(change.before)));
        cells.append(colourText(after));
        write(cells);
    }
}

} // namespace pixelplumb
