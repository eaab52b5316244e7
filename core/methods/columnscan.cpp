// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/columnscan.h"

#include "core/fast/fastscan.h"
#include "core/methods/columnscanexplanation.h"
#include "core/scan/columnscan.h"
#include "core/trace/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Calls a template with the arithmetic's type: the one switch over arithmetics.
template <class Function>
decltype(auto) withArithmetic(Arithmetic arithmetic, IntegerWidth width, const Function &function)
{
    switch (arithmetic) {
    case Arithmetic::Exact:
        break;
    case Arithmetic::Float32:
        return function.template operator()<RoundedArithmetic<float>>();
    case Arithmetic::Float64:
        return function.template operator()<RoundedArithmetic<double>>();
    case Arithmetic::Fixed16:
        return function.template operator()<RoundedArithmetic<FixedPoint16>>();
    case Arithmetic::Fixed32:
        return function.template operator()<RoundedArithmetic<FixedPoint32>>();
    }
    if (width == IntegerWidth::Bits64)
        return function.template operator()<ExactArithmetic<std::int64_t>>();
    return function.template operator()<ExactArithmetic<Int128>>();
}

template <class A, class Observer>
void scan(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
          Observer observer)
{
    if (settings.fillRule == FillRule::HalfOpenColumn)
        ColumnScan<A, FillRule::HalfOpenColumn, Observer>(triangle, settings.rounding, frame,
                                                          observer)
            .run();
    else
        ColumnScan<A, FillRule::Closed, Observer>(triangle, settings.rounding, frame, observer)
            .run();
}

/// One trace has one number type: 128 bits as soon as one triangle needs them. The numbers are the
/// same.
IntegerWidth widestOf(std::span<const Triangle> triangles)
{
    const bool wide = std::ranges::any_of(triangles, [](const Triangle &triangle) {
        return integerWidthFor(triangle) == IntegerWidth::Bits128;
    });
    return wide ? IntegerWidth::Bits128 : IntegerWidth::Bits64;
}

std::unique_ptr<ScanTrace> trace(std::span<const Triangle> triangles, const ScanSettings &settings,
                                 FrameView frame, const TraceOptions &options)
{
    const auto record = [&]<class A>() -> std::unique_ptr<ScanTrace> {
        auto typed = std::make_unique<TypedTrace<A>>(settings);
        try {
            for (const Triangle &triangle : triangles)
                scan<A>(triangle, settings, frame, TraceRecorder<A>(*typed, options));
        } catch (const RecordingEnded &ended) {
            if (ended.why == RecordingEnded::Why::Cancelled)
                return nullptr;
        }
        return typed;
    };
    return withArithmetic(settings.arithmetic, widestOf(triangles), record);
}

// The table's columns, as the assignment names the numbers.

template <std::size_t Channel>
void appendChannel(std::vector<TraceColumn> &columns, char letter)
{
    const auto named = [letter](const char *pattern) {
        return QString::fromUtf8(pattern).replace(QChar(u'%'), QChar::fromLatin1(letter));
    };
    columns.push_back(
        {named("%_B"), named("%_B"), QStringLiteral("levels"),
         named("Level of % where the lower edge meets the column."),
         named("%_B ← %_B + (%₁ − %₀)/(x₁ − x₀)"), TraceColumnGroup::EdgeColours,
         [](const ColumnRecord &column) { return column.colourBottom[Channel]; },
         [](const oracle::ExactColumn &column) { return column.colourBottom[Channel]; }});
    columns.push_back(
        {named("%_T"), named("%_T"), QStringLiteral("levels"),
         named("Level of % where the upper edge meets the column."),
         named("%_T ← %_T + (%₂ − %₀)/(x₂ − x₀)"), TraceColumnGroup::EdgeColours,
         [](const ColumnRecord &column) { return column.colourTop[Channel]; },
         [](const oracle::ExactColumn &column) { return column.colourTop[Channel]; }});
    columns.push_back(
        {named("delta_%"), named("Δ%"), QStringLiteral("levels/row"),
         named("Change of % for each upward move."), named("Δ% = (%_T − %_B)/(y_T − y_B)"),
         TraceColumnGroup::ColourRates,
         [](const ColumnRecord &column) { return column.colourRate[Channel]; },
         [](const oracle::ExactColumn &column) { return column.colourRate[Channel]; }});
    columns.push_back({named("first_%"), named("first %"), QStringLiteral("levels"),
                       named("Level of % at the column's first drawn pixel."),
                       named("% = %_B + (⌈y_B⌉ − y_B)·Δ%"), TraceColumnGroup::FirstColour,
                       [](const ColumnRecord &column) {
                           return column.drawnPixels() > 0 ? column.firstColour[Channel]
                                                           : Quantity();
                       },
                       nullptr});
}

std::vector<TraceColumn> traceColumns()
{
    std::vector<TraceColumn> columns;
    columns.push_back(
        {QStringLiteral("triangle"),
         QStringLiteral("tri"),
         {},
         QStringLiteral("The triangle's place in drawing order, from 0."),
         {},
         TraceColumnGroup::Position,
         [](const ColumnRecord &column) { return Quantity::integer(Int128(column.triangle)); },
         nullptr});
    columns.push_back(
        {QStringLiteral("x"), QStringLiteral("x"), QStringLiteral("px"),
         QStringLiteral("The column."), QStringLiteral("x ← x + 1"), TraceColumnGroup::Position,
         [](const ColumnRecord &column) { return Quantity::integer(column.x); }, nullptr});
    columns.push_back({QStringLiteral("half"),
                       QStringLiteral("half"),
                       {},
                       QStringLiteral("1: between L₀₁ and L₀₂; 2: between L₁₂ and L₀₂."),
                       {},
                       TraceColumnGroup::Position,
                       [](const ColumnRecord &column) {
                           return Quantity::integer(column.half == ColumnHalf::First ? 1 : 2);
                       },
                       nullptr});
    columns.push_back({QStringLiteral("y_B"), QStringLiteral("y_B"), QStringLiteral("px"),
                       QStringLiteral("Where the lower edge meets the column."),
                       QStringLiteral("y_B ← y_B + slope"), TraceColumnGroup::Span,
                       [](const ColumnRecord &column) { return column.yBottom; },
                       [](const oracle::ExactColumn &column) { return column.yBottom; }});
    columns.push_back({QStringLiteral("y_T"), QStringLiteral("y_T"), QStringLiteral("px"),
                       QStringLiteral("Where the upper edge meets the column."),
                       QStringLiteral("y_T ← y_T + slope"), TraceColumnGroup::Span,
                       [](const ColumnRecord &column) { return column.yTop; },
                       [](const oracle::ExactColumn &column) { return column.yTop; }});
    columns.push_back(
        {QStringLiteral("first_row"), QStringLiteral("⌈y_B⌉"), QStringLiteral("px"),
         QStringLiteral("The first covered row."), QStringLiteral("⌈y_B⌉"), TraceColumnGroup::Span,
         [](const ColumnRecord &column) { return Quantity::integer(column.firstRow); },
         [](const oracle::ExactColumn &column) { return Quantity::integer(column.firstRow); }});
    columns.push_back(
        {QStringLiteral("last_row"), QStringLiteral("⌊y_T⌋"), QStringLiteral("px"),
         QStringLiteral(
             "The last covered row: ⌊y_T⌋ under closed, ⌈y_T⌉ − 1 under half-open-column."),
         QStringLiteral("⌊y_T⌋"), TraceColumnGroup::Span,
         [](const ColumnRecord &column) { return Quantity::integer(column.endRow - 1); },
         [](const oracle::ExactColumn &column) { return Quantity::integer(column.endRow - 1); }});
    columns.push_back(
        {QStringLiteral("pixels"),
         QStringLiteral("px"),
         {},
         QStringLiteral("Pixels written in this column, inside the frame."),
         {},
         TraceColumnGroup::Span,
         [](const ColumnRecord &column) { return Quantity::integer(column.drawnPixels()); },
         nullptr});
    appendChannel<0>(columns, 'R');
    appendChannel<1>(columns, 'G');
    appendChannel<2>(columns, 'B');
    // R_B G_B B_B side by side, then R_T …: by group, then by quantity, then by channel.
    const auto first = columns.begin() + 8;
    std::vector<TraceColumn> colours;
    for (std::ptrdiff_t quantity = 0; quantity < 4; ++quantity) {
        for (std::ptrdiff_t channel = 0; channel < 3; ++channel)
            colours.push_back(*(first + channel * 4 + quantity));
    }
    std::ranges::move(colours, first);
    return columns;
}

Explanation explain(const TracedScene &traced, std::size_t stepIndex)
{
    const TraceStep step = traced.trace->stepAt(stepIndex);
    switch (step.kind) {
    case StepKind::SetUp:
        return explainSetUp(traced, step.triangle);
    case StepKind::Column:
        return explainColumn(traced, step);
    case StepKind::Pixel:
        return explainPixel(traced, step);
    }
    return {};
}

void drawColumnsFast(std::span<const Triangle> triangles, const ScanSettings &settings,
                     FrameView frame)
{
    drawFast(triangles, settings, frame);
}

} // namespace

void drawColumns(std::span<const Triangle> triangles, const ScanSettings &settings, FrameView frame)
{
    for (const Triangle &triangle : triangles) {
        withArithmetic(settings.arithmetic, integerWidthFor(triangle),
                       [&]<class A>() { scan<A>(triangle, settings, frame, NullObserver{}); });
    }
}

Method columnScanMethod()
{
    Method method;
    method.id = QStringLiteral("column-scan");
    method.title = QStringLiteral("Column scan");
    method.source = QStringLiteral("seed 004: the assignment, “scan by columns” and “Smoothly "
                                   "shading the triangle”");
    method.summary = QStringLiteral("Walks the columns between two edges and colours the samples "
                                    "from ⌈y_B⌉ to ⌊y_T⌋, all by adding increments.");
    method.effects = {QStringLiteral("smooth colour"), QStringLiteral("clipping to the frame")};
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.fillRules = {FillRule::Closed, FillRule::HalfOpenColumn};
    method.traceColumns = traceColumns();
    method.draw = drawColumns;
    method.drawFast = drawColumnsFast;
    method.trace = trace;
    method.explain = explain;
    return method;
}

} // namespace pixelplumb
