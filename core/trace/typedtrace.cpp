// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scan/columnscan.h"
#include "core/trace/tracerecorder.h"

namespace pixelplumb {

namespace {

template <class Number>
std::array<Quantity, 3> quantities(const std::array<Number, 3> &numbers)
{
    return {Quantity::of(numbers[0]), Quantity::of(numbers[1]), Quantity::of(numbers[2])};
}

/// Hears one column being filled and keeps its fragments.
template <class A>
struct FragmentCollector {
    std::vector<FragmentRecord> *fragments;

    void triangleBegun(const ColumnSetUp<A> &) { }
    void triangleRejected(TriangleRejection) { }
    void columnEntered(const ColumnState<A> &) { }
    void pixelWritten(std::int64_t x, std::int64_t y, QRgb, QRgb, const Fragment<A> &fragment)
    {
        fragments->push_back(
            {x, y, quantities(fragment.colour), fragment.level, fragment.isClamped()});
    }
};

} // namespace

template <class A>
SetUpRecord TypedTrace<A>::setUp(std::size_t triangle) const
{
    const TypedSetUp &typed = m_setUps[triangle];
    SetUpRecord record;
    record.triangle = triangle;
    record.order = typed.setUp.order;
    record.longEdge = typed.setUp.longEdge;
    record.zeroArea = typed.setUp.zeroArea;
    record.firstColumn = typed.setUp.firstColumn;
    record.middleColumn = typed.setUp.middleColumn;
    record.endColumn = typed.setUp.endColumn;
    record.slope = quantities(typed.setUp.slope);
    for (std::size_t edge = 0; edge < 3; ++edge)
        record.colourRate[edge] = quantities(typed.setUp.colourRate[edge]);
    record.rejection = typed.rejection;
    return record;
}

template <class A>
ColumnRecord TypedTrace<A>::column(std::size_t column) const
{
    const ColumnState<A> &state = m_states[column];
    ColumnRecord record;
    record.triangle = triangleOf(column);
    record.x = state.x;
    record.half = state.half;
    record.yBottom = Quantity::of(state.yBottom);
    record.yTop = Quantity::of(state.yTop);
    record.colourBottom = quantities(state.colourBottom);
    record.colourTop = quantities(state.colourTop);
    record.colourRate = quantities(state.colourRate);
    record.firstColour = quantities(state.firstColour);
    record.firstRow = state.firstRow;
    record.endRow = state.endRow;
    record.firstDrawnRow = state.firstDrawnRow;
    record.endDrawnRow = state.endDrawnRow;
    return record;
}

template <class A>
std::vector<FragmentRecord> TypedTrace<A>::fragments(std::size_t column) const
{
    const ColumnState<A> &state = m_states[column];
    std::vector<FragmentRecord> fragments;
    if (state.firstDrawnRow >= state.endDrawnRow)
        return fragments;
    // A frame of this one column, to be written again with the same numbers.
    const std::int64_t height = state.endDrawnRow - state.firstDrawnRow;
    std::vector<QRgb> pixels(std::size_t(height), QRgb(0));
    const FrameView frame{
        pixels.data(),       1, std::int32_t(state.x), std::int32_t(state.firstDrawnRow), 1,
        std::int32_t(height)};
    fragments.reserve(std::size_t(height));
    fillColumn(state, m_settings.rounding, frame, FragmentCollector<A>{&fragments});
    return fragments;
}

template class TypedTrace<ExactArithmetic<std::int64_t>>;
template class TypedTrace<ExactArithmetic<Int128>>;
template class TypedTrace<RoundedArithmetic<float>>;
template class TypedTrace<RoundedArithmetic<double>>;
template class TypedTrace<RoundedArithmetic<FixedPoint16>>;
template class TypedTrace<RoundedArithmetic<FixedPoint32>>;

} // namespace pixelplumb
