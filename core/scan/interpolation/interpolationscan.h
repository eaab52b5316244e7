// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/attributes.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/interpolation/interpolationfill.h"
#include "core/scan/interpolation/interpolationnumbers.h"
#include "core/scan/rowwalk.h"
#include "core/scan/scanobserver.h"
#include "core/scan/walks/columnwalk.h"

#include <type_traits>

/// Interpolation during scan conversion (Scan Conversion slides, "Interpolation During Scan
/// Conversion"): forms that are equal in exact numbers. Coverage is decided exactly, column by
/// column, whatever the channels are computed in, so that forms and arithmetics differ only in
/// their values. A list of stages (core/shade) without effects draws the same bytes, with about
/// eight times the instructions in exact numbers and over twice in floats: so plain triangles keep
/// this kernel.
namespace pixelplumb {

template <InterpolationForm form>
using ViewOfForm = std::conditional_t<axisOf(form) == SpanAxis::Row, TurnedView, FrameView>;

/// What a form reports to: the observer itself where nothing is turned or nobody listens.
template <InterpolationForm form, class Observer>
auto listenerFor(Observer observer)
{
    if constexpr (axisOf(form) == SpanAxis::Column || std::is_same_v<Observer, NullObserver>)
        return observer;
    else
        return AxisListener<SpanAxis::Row, Observer>(observer);
}

/// A triangle as a form scans it, with its attributes. If two vertices coincide, the turned
/// triangle lies between the same two extremes as the original.
template <InterpolationForm form>
struct FormTriangle {
    FormTriangle(const Triangle &of, const TriangleAttributes *carried)
        : triangle(of)
    {
        if (carried)
            attributes = *carried;
        if (axisOf(form) == SpanAxis::Column)
            return;
        const auto &at = [&](std::size_t i) { return of.vertices[i].position; };
        if (at(0) == at(1) || at(1) == at(2) || at(0) == at(2)) {
            const std::array<int, 3> order = sortedByColumn(of);
            triangle = betweenExtremes(of);
            attributes.vertices[std::size_t(order[1])] = attributes.vertices[std::size_t(order[2])];
        }
        triangle = turned(triangle);
    }

    Triangle triangle;
    TriangleAttributes attributes;
};

/// Scans one triangle, turned if the form goes by rows, into one frame. Coverage is decided in
/// `Integer`: std::int64_t up to 2^15 px, Int128 beyond.
template <InterpolationForm Form, class Number, class Integer, std::size_t channelsInAll,
          ScanObserver<InterpolationNumbers<Number, channelsInAll>> Observer>
class InterpolationScan {
    using View = ViewOfForm<Form>;
    using Exact = ExactArithmetic<Integer>;
    using Column = InterpolationColumn<Number, channelsInAll>;

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

public:
    InterpolationScan(const Triangle &triangle, const TriangleAttributes *attributes,
                      const CarriedChannels &carried, const ScanSettings &settings, FrameView frame,
                      Observer observer)
        : m_triangle(triangle)
        , m_settings(settings)
        , m_rule(settings, frame)
        , m_intervals(axisOf(Form) == SpanAxis::Row ? rowIntervals(m_rule)
                                                    : columnIntervals(settings.fillRule))
        , m_range(columnRangeOf(triangle, m_intervals.columns))
        , m_frame(frame)
        , m_observer(observer)
    {
        for (std::size_t i = 0; i < 3; ++i)
            m_setUp.vertices[i] = channelVertex<channelsInAll>(
                triangle.vertices[i], attributes ? &attributes->vertices[i] : nullptr, carried);
        m_setUp.order = m_range.order;
        m_setUp.longEdge = m_range.longEdge;
        m_setUp.zeroArea = m_range.zeroArea;
        m_area = absolute(doubledArea(triangle));
    }

    [[gnu::always_inline]] void run()
    {
        if (!m_setUp.zeroArea)
            computeCoefficients();
        m_observer.primitiveBegun(m_setUp);
        walkTriangle(*this, m_range, m_intervals.columns, corners(), m_frame, m_observer);
    }

    /// What the walk asks for (columnwalk.h).
    static constexpr bool skipsEmptyHalf = true;
    [[gnu::always_inline]] Walker walkerOn(const SortedEnds &edge, std::int64_t column) const
    {
        const Vertex &a = m_triangle.vertices[indexAt(edge[0])];
        const Vertex &b = m_triangle.vertices[indexAt(edge[1])];
        const MixedNumber<Integer> slope = Exact::edgeSlope(a, b);
        return {Exact::edgeOrdinate(a, b, Exact::runTo(column, a), slope),
                slope,
                {at(edge[0]), at(edge[1]), column}};
    }
    Interval rowsOf(const SortedEnds &shortEdge) const
    {
        return axisOf(Form) == SpanAxis::Row
            ? m_intervals.rows
            : rowsBeside(m_rule, m_setUp.longEdge, corners(), shortEdge);
    }
    [[gnu::always_inline]] void scanColumn(ColumnHalf half, Interval rows, std::int64_t x,
                                           const Walker &shortEdge, const Walker &longEdge)
    {
        const bool longAbove = m_setUp.longEdge == LongEdge::Above;
        scanBetween(half, rows, x, longAbove ? shortEdge : longEdge,
                    longAbove ? longEdge : shortEdge, [this](const Column &column) {
                        fillInterpolated<Form>(m_setUp, column, m_settings.rounding, m_frame,
                                               m_observer);
                    });
    }

    [[gnu::noinline]] static void scanSegment(InterpolationScan scan, const WalkedColumns &columns)
    {
        const auto fill = [&](const Column &column) {
            fillSegment(scan.m_setUp, column, scan.m_settings.rounding, scan.m_frame,
                        scan.m_observer);
        };
        walkSegment(
            scan.corners(), columns, scan.m_observer,
            [&](const SortedEnds &ends, std::int64_t column) {
                return scan.walkerOn(ends, column);
            },
            [&](ColumnHalf half, std::int64_t x, const Walker &lower, const Walker &upper) {
                scan.scanBetween(half, scan.m_intervals.rows, x, lower, upper, fill);
            });
    }

private:
    std::size_t indexAt(std::size_t corner) const { return std::size_t(m_setUp.order[corner]); }
    const VertexOfChannels<channelsInAll> &at(std::size_t corner) const
    {
        return m_setUp.vertices[indexAt(corner)];
    }

    SortedCorners corners() const { return {at(0).position, at(1).position, at(2).position}; }

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

    template <class Fill>
    [[gnu::always_inline]] void scanBetween(ColumnHalf half, Interval rows, std::int64_t x,
                                            const Walker &bottom, const Walker &top,
                                            const Fill &fill)
    {
        Column column;
        column.x = x;
        column.half = half;
        coverRows<Exact>(column, rows, bottom.y, top.y, m_frame);
        if constexpr (isBilinear(Form)) {
            if (!m_setUp.zeroArea)
                interpolateColumn(bottom.channels, top.channels, m_area, column);
        }
        if constexpr (readsNumbers<Observer>)
            showEdges(bottom, top, column);
        m_observer.spanEntered(column);
        fill(column);
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
    ColumnRange m_range;
    View m_frame;
    Observer m_observer;
    InterpolationSetUp<Number, channelsInAll> m_setUp;
    Int128 m_area = 0; ///< doubled, without sign, in square lattice units
};

} // namespace pixelplumb
