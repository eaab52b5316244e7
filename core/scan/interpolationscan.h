// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/frame/levelpixel.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/interpolationcoefficients.h"
#include "core/scan/interpolationedge.h"
#include "core/scan/interval.h"
#include "core/scan/scanobserver.h"
#include "core/scan/workstage.h"

/// Interpolation during scan conversion (Scan Conversion slides, "Interpolation During Scan
/// Conversion"): three forms that are the same in exact numbers. What is covered is decided
/// exactly, column by column, whatever the channels are computed in, so that forms and arithmetics
/// differ in their values alone.
namespace pixelplumb {

enum class InterpolationForm {
    Bilinear, ///< along both edges, then along the column, by adding rates
    Plane, ///< v = a·x + b·y + c at each sample
    Barycentric, ///< α·v0 + β·v1 + γ·v2 at each sample
};

/// The values of a triangle of zero area at a sample: along L₀₂, the only line that it has.
template <class Number>
Number alongSegment(const InterpolationSetUp<Number> &setUp, std::size_t channel, std::int64_t x,
                    std::int64_t y)
{
    const ChannelVertex &a = setUp.vertices[std::size_t(setUp.order[0])];
    const ChannelVertex &b = setUp.vertices[std::size_t(setUp.order[2])];
    const bool isVertical = a.position.x == b.position.x;
    // ChannelEdge walks along x; a vertical segment is mirrored.
    const auto along = [&](const ChannelVertex &vertex) {
        ChannelVertex result;
        result.position.x = isVertical ? vertex.position.y : vertex.position.x;
        result.channels[channel] = vertex.channels[channel];
        return result;
    };
    return ChannelEdge<Number>(along(a), along(b), isVertical ? y : x).channel[channel];
}

/// Computes a sample's channels from its place. The bilinear ones are added up instead.
template <InterpolationForm Form, class Number>
void evaluate(const InterpolationSetUp<Number> &setUp, std::int64_t x, std::int64_t y,
              InterpolationSample<Number> &sample)
{
    if constexpr (Form == InterpolationForm::Plane) {
        for (std::size_t channel = 0; channel < channelCount; ++channel)
            sample.value[channel] = linearAt(setUp.plane[channel], x, y);
    } else if constexpr (Form == InterpolationForm::Barycentric) {
        for (std::size_t i = 0; i < 3; ++i)
            sample.weight[i] = linearAt(setUp.weight[i], x, y);
        for (std::size_t channel = 0; channel < channelCount; ++channel)
            sample.value[channel] = weighted(sample.weight,
                                             {setUp.vertices[0].channels[channel],
                                              setUp.vertices[1].channels[channel],
                                              setUp.vertices[2].channels[channel]});
    }
}

/// Colours the rows of one column, bottom to top. The set-up and the column are all it reads.
template <InterpolationForm Form, class Number, class Observer>
void fillInterpolated(const InterpolationSetUp<Number> &setUp,
                      const InterpolationColumn<Number> &column, ByteRounding rounding,
                      FrameView frame, Observer observer)
{
    [[maybe_unused]] const WorkScope samples(observer, WorkStage::Pixel);
    InterpolationSample<Number> sample;
    sample.value = column.first;
    for (std::int64_t y = column.firstDrawn; y < column.endDrawn; ++y) {
        if (setUp.zeroArea) {
            for (std::size_t channel = 0; channel < channelCount; ++channel)
                sample.value[channel] = alongSegment(setUp, channel, column.x, y);
        } else {
            evaluate<Form>(setUp, column.x, y, sample);
        }
        for (std::size_t i = 0; i < 3; ++i)
            sample.level[i] = levelOf(sample.value[i], rounding);
        QRgb *pixel = frame.at(column.x, y);
        const QRgb after = pixelOfLevels(sample.level);
        observer.pixelWritten(column.x, y, *pixel, after, sample);
        *pixel = after;
        if (Form == InterpolationForm::Bilinear && !setUp.zeroArea) {
            for (std::size_t channel = 0; channel < channelCount; ++channel)
                advance(sample.value[channel], column.rate[channel]);
        }
    }
}

/// The scan of one triangle into one frame.
template <InterpolationForm Form, class Number, ScanObserver<InterpolationNumbers<Number>> Observer>
class InterpolationScan {
public:
    InterpolationScan(const Triangle &triangle, const std::array<VertexAttributes, 3> &attributes,
                      const ScanSettings &settings, FrameView frame, Observer observer)
        : m_triangle(triangle)
        , m_settings(settings)
        , m_intervals(columnIntervals(settings.fillRule))
        , m_frame(frame)
        , m_observer(observer)
    {
        for (std::size_t i = 0; i < 3; ++i)
            m_setUp.vertices[i] = channelVertex(triangle.vertices[i], attributes[i]);
        m_setUp.order = sortedByColumn(triangle);
        m_area = doubledArea(at(0).position, at(1).position, at(2).position);
        m_setUp.longEdge = m_area >= 0 ? LongEdge::Above : LongEdge::Below;
        m_setUp.zeroArea = m_area == 0;
        m_area = absolute(m_area);
    }

    void run()
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
        const auto [low, high]
            = std::minmax({at(0).position.y, at(1).position.y, at(2).position.y});
        if (first >= end || ceilPixel(low) >= m_frame.endRow()
            || floorPixel(high) < m_frame.firstRow) {
            m_observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
            return;
        }
        const bool isVertical = at(0).position.x == at(2).position.x;
        if (m_setUp.zeroArea) {
            // Both bounds are L₀₂; a vertical segment goes from P0 to P2 in one column.
            const ColumnHalf half
                = at(0).position.x == at(1).position.x ? ColumnHalf::Second : ColumnHalf::First;
            scanHalf(half, first, end, {0, 2}, {std::size_t(isVertical ? 2 : 0), 2});
            return;
        }
        const std::int64_t middle = std::clamp(ceilPixel(at(1).position.x), first, end);
        scanHalf(ColumnHalf::First, first, middle, {0, 1}, {0, 2});
        // L₀₂ goes on from where it is.
        scanHalf(ColumnHalf::Second, middle, end, {1, 2}, {0, 2});
    }

private:
    using Corners = std::array<std::size_t, 2>; ///< of an edge, in column order
    using Integer = WideBeside<Number>;
    using Exact = ExactArithmetic<Integer>;

    std::size_t indexAt(std::size_t corner) const { return std::size_t(m_setUp.order[corner]); }
    const ChannelVertex &at(std::size_t corner) const { return m_setUp.vertices[indexAt(corner)]; }

    void computeCoefficients()
    {
        if constexpr (Form == InterpolationForm::Plane) {
            for (std::size_t channel = 0; channel < channelCount; ++channel)
                setPlane(m_setUp, channel);
        } else if constexpr (Form == InterpolationForm::Barycentric) {
            for (std::size_t vertex = 0; vertex < 3; ++vertex)
                setWeight(m_setUp, vertex);
        }
    }

    /// An edge's exact y, which decides what is covered, and its channels.
    struct Walker {
        MixedNumber<Integer> y, slope;
        ChannelEdge<Number> channels;

        void stepToNextColumn()
        {
            y.advance(slope);
            if constexpr (Form == InterpolationForm::Bilinear)
                channels.stepToNextColumn();
        }
    };

    Walker walkerOn(const Corners &edge, std::int64_t column) const
    {
        const Vertex &a = m_triangle.vertices[indexAt(edge[0])];
        const Vertex &b = m_triangle.vertices[indexAt(edge[1])];
        return {Exact::edgeOrdinate(a, b, column), Exact::edgeSlope(a, b),
                ChannelEdge<Number>(at(edge[0]), at(edge[1]), column)};
    }

    void scanHalf(ColumnHalf half, std::int64_t first, std::int64_t end, const Corners &shortEdge,
                  const Corners &longEdge)
    {
        if (first >= end)
            return;
        Walker shortWalker = walkerOn(shortEdge, first);
        if (half == ColumnHalf::First || !m_longWalker)
            m_longWalker = walkerOn(longEdge, first);
        const bool longAbove = m_setUp.longEdge == LongEdge::Above;
        for (std::int64_t x = first; x < end; ++x) {
            [[maybe_unused]] const WorkScope span(m_observer, WorkStage::Span);
            scanColumn(half, x, longAbove ? shortWalker : *m_longWalker,
                       longAbove ? *m_longWalker : shortWalker);
            shortWalker.stepToNextColumn();
            m_longWalker->stepToNextColumn();
        }
    }

    void scanColumn(ColumnHalf half, std::int64_t x, const Walker &bottom, const Walker &top)
    {
        InterpolationColumn<Number> column;
        column.x = x;
        column.half = half;
        column.lower = bottom.y;
        column.upper = top.y;
        column.firstRow = ownsFirst(m_intervals.rows) ? bottom.y.ceil() : bottom.y.floor() + 1;
        column.endRow = ownsLast(m_intervals.rows) ? top.y.floor() + 1 : top.y.ceil();
        column.firstDrawn = std::max<std::int64_t>(column.firstRow, m_frame.firstRow);
        column.endDrawn = std::min(column.endRow, m_frame.endRow());
        if constexpr (Form == InterpolationForm::Bilinear) {
            column.yBottom = bottom.channels.y;
            column.yTop = top.channels.y;
            column.bottom = bottom.channels.channel;
            column.top = top.channels.channel;
            if (!m_setUp.zeroArea)
                interpolateColumn(bottom.channels, top.channels, m_area, column);
        }
        m_observer.spanEntered(column);
        fillInterpolated<Form>(m_setUp, column, m_settings.rounding, m_frame, m_observer);
    }

    const Triangle &m_triangle;
    ScanSettings m_settings;
    ScanIntervals m_intervals;
    FrameView m_frame;
    Observer m_observer;
    InterpolationSetUp<Number> m_setUp;
    Int128 m_area = 0; ///< doubled, without sign, in square lattice units
    std::optional<Walker> m_longWalker;
};

} // namespace pixelplumb
