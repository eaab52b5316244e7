// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/interpolationfill.h"
#include "core/scan/interpolationturn.h"
#include "core/scan/interval.h"
#include "core/scan/scanobserver.h"
#include "core/scan/workstage.h"

#include <type_traits>

/// Interpolation during scan conversion (Scan Conversion slides, "Interpolation During Scan
/// Conversion"): forms that are equal in exact numbers. Coverage is decided exactly, column by
/// column, whatever the channels are computed in, so that forms and arithmetics differ only in
/// their values.
namespace pixelplumb {

/// Scans one triangle, turned if the form goes by rows, into one frame. Coverage is decided in
/// `Integer`: std::int64_t up to 2^15 px, Int128 beyond.
template <InterpolationForm Form, class Number, class Integer, std::size_t channelsInAll,
          ScanObserver<InterpolationNumbers<Number, channelsInAll>> Observer>
class InterpolationScan {
    using View = ViewOfForm<Form>;

public:
    InterpolationScan(const Triangle &triangle, const TriangleAttributes *attributes,
                      const CarriedChannels &carried, const ScanSettings &settings, FrameView frame,
                      Observer observer)
        : m_triangle(triangle)
        , m_settings(settings)
        , m_rule(settings, frame)
        , m_intervals(axisOf(Form) == SpanAxis::Row ? rowIntervals(m_rule)
                                                    : columnIntervals(settings.fillRule))
        , m_frame(frame)
        , m_observer(observer)
    {
        for (std::size_t i = 0; i < 3; ++i)
            m_setUp.vertices[i] = channelVertex<channelsInAll>(
                triangle.vertices[i], attributes ? &attributes->vertices[i] : nullptr, carried);
        m_setUp.order = sortedByColumn(triangle);
        m_area = doubledArea(at(0).position, at(1).position, at(2).position);
        m_setUp.longEdge = m_area >= 0 ? LongEdge::Above : LongEdge::Below;
        m_setUp.zeroArea = m_area == 0;
        m_area = absolute(m_area);
    }

    [[gnu::always_inline]] void run()
    {
        if (!m_setUp.zeroArea)
            computeCoefficients();
        m_observer.primitiveBegun(m_setUp);
        if (m_setUp.zeroArea && m_intervals.columns != Interval::Closed) {
            m_observer.primitiveRejected(PrimitiveRejection::ZeroArea);
            return;
        }
        const std::int64_t end
            = std::min(endSampleAt(at(2).position.x, m_intervals.columns), m_frame.endColumn());
        const std::int64_t first = std::max<std::int64_t>(
            firstSampleFrom(at(0).position.x, m_intervals.columns), m_frame.firstColumn);
        if (first >= end || isAboveOrBelowFrame()) {
            m_observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
            return;
        }
        if (m_setUp.zeroArea) {
            scanSegment(*this, first, end);
            return;
        }
        const std::int64_t middle = std::clamp(ceilPixel(at(1).position.x), first, end);
        Walker longEdge = walkerOn({0, 2}, first);
        scanHalf(ColumnHalf::First, first, middle, {0, 1}, longEdge);
        // L₀₂ goes on from where it is.
        scanHalf(ColumnHalf::Second, middle, end, {1, 2}, longEdge);
    }

private:
    using Corners = std::array<std::size_t, 2>; ///< of an edge, in column order
    using Exact = ExactArithmetic<Integer>;
    using Column = InterpolationColumn<Number, channelsInAll>;

    std::size_t indexAt(std::size_t corner) const { return std::size_t(m_setUp.order[corner]); }
    const VertexOfChannels<channelsInAll> &at(std::size_t corner) const
    {
        return m_setUp.vertices[indexAt(corner)];
    }

    /// Tests one vertex after another: usually the first one decides.
    bool isAboveOrBelowFrame() const
    {
        const auto all
            = [&](const auto &isThere) { return isThere(0) && isThere(1) && isThere(2); };
        return all([&](std::size_t i) {
                   return m_setUp.vertices[i].position.y > (m_frame.endRow() - 1) * unitsPerPixel;
               })
            || all([&](std::size_t i) {
                   return m_setUp.vertices[i].position.y < m_frame.firstRow * unitsPerPixel;
               });
    }

    void computeCoefficients()
    {
        if constexpr (Form == InterpolationForm::Plane) {
            for (std::size_t channel = 0; channel < m_setUp.carried(); ++channel)
                setPlane(m_setUp, channel);
        } else if constexpr (Form == InterpolationForm::Barycentric) {
            for (std::size_t vertex = 0; vertex < 3; ++vertex) {
                setWeight(m_setUp, vertex);
                setWeighted(m_setUp, vertex);
            }
        }
    }

    /// Replaces ChannelEdge in forms that walk no channels along edges.
    struct NoChannels {
        template <class Corner>
        NoChannels(const Corner &, const Corner &, std::int64_t)
        {
        }
        void stepToNextColumn() { }
    };

    /// An edge's exact y, which decides coverage, and its channels.
    struct Walker {
        MixedNumber<Integer> y, slope;
        std::conditional_t<isBilinear(Form), ChannelEdge<Number, channelsInAll>, NoChannels>
            channels;

        void stepToNextColumn()
        {
            y.advance(slope);
            channels.stepToNextColumn();
        }
    };

    /// Forced inline: an edge returned or copied through memory is read in words of another size
    /// than it was stored in, and waits until every earlier pixel is stored.
    [[gnu::always_inline]] Walker walkerOn(const Corners &edge, std::int64_t column) const
    {
        const Vertex &a = m_triangle.vertices[indexAt(edge[0])];
        const Vertex &b = m_triangle.vertices[indexAt(edge[1])];
        const MixedNumber<Integer> slope = Exact::edgeSlope(a, b);
        return {Exact::edgeOrdinate(a, b, Exact::runTo(column, a), slope),
                slope,
                {at(edge[0]), at(edge[1]), column}};
    }

    /// Both bounds are L₀₂; a vertical segment goes from P0 to P2 in one column.
    [[gnu::noinline]] static void scanSegment(InterpolationScan scan, std::int64_t first,
                                              std::int64_t end)
    {
        const bool isVertical = scan.at(0).position.x == scan.at(2).position.x;
        const ColumnHalf half = scan.at(0).position.x == scan.at(1).position.x ? ColumnHalf::Second
                                                                               : ColumnHalf::First;
        Walker lower = scan.walkerOn({0, 2}, first);
        Walker upper = scan.walkerOn({std::size_t(isVertical ? 2 : 0), 2}, first);
        const auto fill = [&](const Column &column) {
            fillSegment(scan.m_setUp, column, scan.m_settings.rounding, scan.m_frame,
                        scan.m_observer);
        };
        for (std::int64_t x = first; x < end; ++x)
            scan.scanColumn(half, scan.m_intervals.rows, x, lower, upper, fill);
    }

    /// The row interval of the columns between the long edge and a short one.
    Interval rowsBeside(const Corners &shortEdge) const
    {
        if (axisOf(Form) == SpanAxis::Row)
            return m_intervals.rows;
        const auto riseOf = [this](const Corners &edge) {
            return at(edge[1]).position.y - at(edge[0]).position.y;
        };
        const Lattice shortRise = riseOf(shortEdge);
        const Lattice longRise = riseOf({0, 2});
        return m_setUp.longEdge == LongEdge::Above ? rowsBetween(m_rule, shortRise, longRise)
                                                   : rowsBetween(m_rule, longRise, shortRise);
    }

    [[gnu::always_inline]] void scanHalf(ColumnHalf half, std::int64_t first, std::int64_t end,
                                         const Corners &shortEdge, Walker &longWalker)
    {
        if (first >= end)
            return;
        Walker shortWalker = walkerOn(shortEdge, first);
        const bool longAbove = m_setUp.longEdge == LongEdge::Above;
        Walker &bottom = longAbove ? shortWalker : longWalker;
        Walker &top = longAbove ? longWalker : shortWalker;
        const Interval rows = rowsBeside(shortEdge);
        const auto fill = [&](Column &column) {
            fillInterpolated<Form>(m_setUp, column, m_settings.rounding, m_frame, m_observer);
        };
        for (std::int64_t x = first; x < end; ++x)
            scanColumn(half, rows, x, bottom, top, fill);
    }

    template <class Fill>
    [[gnu::always_inline]] void scanColumn(ColumnHalf half, Interval rows, std::int64_t x,
                                           Walker &bottom, Walker &top, const Fill &fill)
    {
        [[maybe_unused]] const WorkScope span(m_observer, WorkStage::Span);
        Column column;
        column.x = x;
        column.half = half;
        column.firstRow = ownsFirst(rows) ? bottom.y.ceil() : bottom.y.floor() + 1;
        column.endRow = ownsLast(rows) ? top.y.floor() + 1 : top.y.ceil();
        column.firstDrawn = std::max<std::int64_t>(column.firstRow, m_frame.firstRow);
        column.endDrawn = std::min(column.endRow, m_frame.endRow());
        if constexpr (isBilinear(Form)) {
            if (!m_setUp.zeroArea)
                interpolateColumn(bottom.channels, top.channels, m_area, column);
        }
        if constexpr (readsNumbers<Observer>)
            showEdges(bottom, top, column);
        m_observer.spanEntered(column);
        fill(column);
        bottom.stepToNextColumn();
        top.stepToNextColumn();
    }

    static void showEdges(const Walker &bottom, const Walker &top, Column &column)
    {
        column.lower = bottom.y;
        column.upper = top.y;
        if constexpr (isBilinear(Form)) {
            column.yBottom = bottom.channels.y;
            column.yTop = top.channels.y;
            column.bottom = bottom.channels.channel;
            column.top = top.channels.channel;
        }
    }

    const Triangle &m_triangle;
    ScanSettings m_settings;
    BoundaryRule m_rule;
    ScanIntervals m_intervals;
    View m_frame;
    Observer m_observer;
    InterpolationSetUp<Number, channelsInAll> m_setUp;
    Int128 m_area = 0; ///< doubled, without sign, in square lattice units
};

} // namespace pixelplumb
