// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/strokeoracle.h"

#include "core/oracle/effectoracle.h"
#include "core/oracle/exactsample.h"
#include "core/oracle/shapeoracle.h"
#include "core/oracle/strokeoutline.h"
#include "core/oracle/truepixel.h"

#include <algorithm>

namespace pixelplumb::oracle {

namespace {

/// The byte colour of a line at a point, by the foot of the perpendicular; a curve has one colour.
Colour strokeColourAt(const Shape &stroke, const OutlinePoint &point, ByteRounding rounding)
{
    const Vertex &first = stroke.vertices.front();
    const Vertex &last = stroke.vertices.back();
    const BigInteger dx = last.position.x - first.position.x;
    const BigInteger dy = last.position.y - first.position.y;
    if (stroke.kind != PrimitiveKind::Line || (dx == 0 && dy == 0))
        return first.colour;
    const BigRational along = (BigRational(point.x, outlineLattice) - first.position.x) * dx
        + (BigRational(point.y, outlineLattice) - first.position.y) * dy;
    const BigRational t = std::clamp<BigRational>(along / (dx * dx + dy * dy), 0, 1);
    Colour colour;
    for (std::size_t i = 0; i < 3; ++i) {
        const int from = first.colour.channels[i];
        BigRational level = from + t * (last.colour.channels[i] - from);
        if (rounding == ByteRounding::Nearest)
            level += BigRational(1, 2);
        colour.channels[i] = std::uint8_t(BigInteger(numerator(level) / denominator(level)));
    }
    return colour;
}

/// The strokes of one frame, column by column.
class StrokePainter {
public:
    StrokePainter(const ScanSettings &settings, Antialiasing antialiasing, const FrameView &frame)
        : m_settings(settings)
        , m_frame(frame)
        , m_isByArea(antialiasing == Antialiasing::Area)
        , m_offsets(sampleOffsets(antialiasing))
    {
        if (m_isByArea)
            return;
        for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
            for (std::int64_t x = frame.firstColumn; x < frame.endColumn(); ++x)
                m_samples.insert(m_samples.end(), m_offsets.size(), unpacked(*frame.at(x, y)));
        }
    }

    void draw(const Shape &stroke)
    {
        const std::vector<OutlineEdge> all = strokeOutline(stroke, m_frame);
        for (std::int64_t x = m_frame.firstColumn; x < m_frame.endColumn(); ++x) {
            std::vector<OutlineEdge> edges;
            std::int64_t low = m_frame.endRow() * outlinePixel;
            std::int64_t high = (m_frame.firstRow - std::int64_t(1)) * outlinePixel;
            for (const OutlineEdge &edge : all) {
                if (std::max(edge.from.x, edge.to.x) < x * outlinePixel - outlinePixel / 2
                    || std::min(edge.from.x, edge.to.x) > x * outlinePixel + outlinePixel / 2)
                    continue;
                edges.push_back(edge);
                low = std::min({low, edge.from.y, edge.to.y});
                high = std::max({high, edge.from.y, edge.to.y});
            }
            const std::int64_t first
                = std::max<std::int64_t>(floorDivide(low, outlinePixel), m_frame.firstRow);
            const std::int64_t end = std::min(ceilDivide(high, outlinePixel) + 1, m_frame.endRow());
            for (std::int64_t y = first; y < end && !edges.empty(); ++y)
                drawPixel(stroke, edges, x, y);
        }
    }

private:
    void drawPixel(const Shape &stroke, const std::vector<OutlineEdge> &edges, std::int64_t x,
                   std::int64_t y)
    {
        const OutlinePoint centre = {x * outlinePixel, y * outlinePixel};
        if (!m_isByArea) {
            drawSamples(stroke, edges, x, y);
            return;
        }
        const BigRational area = strokeArea(edges, centre);
        if (area <= 0)
            return;
        const std::uint8_t alpha = sharedAlpha(255, area > 1 ? BigRational(1) : area);
        writeTruePixel(m_frame, x, y,
                       blended(strokeColourAt(stroke, centre, m_settings.rounding), alpha,
                               unpacked(*m_frame.at(x, y))));
    }

    void drawSamples(const Shape &stroke, const std::vector<OutlineEdge> &edges, std::int64_t x,
                     std::int64_t y)
    {
        Colour *samples = &m_samples[std::size_t((y - m_frame.firstRow) * m_frame.width + x
                                                 - m_frame.firstColumn)
                                     * m_offsets.size()];
        bool isCovered = false;
        std::array<int, 3> sums = {};
        for (std::size_t i = 0; i < m_offsets.size(); ++i) {
            const OutlinePoint point = {x * outlinePixel + m_offsets[i].x * outlineLattice,
                                        y * outlinePixel + m_offsets[i].y * outlineLattice};
            if (strokeWinding(edges, point) > 0) {
                samples[i] = strokeColourAt(stroke, point, m_settings.rounding);
                isCovered = true;
            }
            for (std::size_t channel = 0; channel < 3; ++channel)
                sums[channel] += samples[i].channels[channel];
        }
        if (!isCovered)
            return;
        const int count = int(m_offsets.size());
        Colour mean;
        for (std::size_t channel = 0; channel < 3; ++channel)
            mean.channels[channel] = std::uint8_t((2 * sums[channel] + count) / (2 * count));
        writeTruePixel(m_frame, x, y, mean);
    }

    ScanSettings m_settings;
    FrameView m_frame;
    bool m_isByArea;
    std::vector<LatticePoint> m_offsets;
    std::vector<Colour> m_samples; ///< pixel by pixel
};

} // namespace

bool isStroke(const Shape &shape)
{
    const bool isCurve = shape.kind == PrimitiveKind::Circle || shape.kind == PrimitiveKind::Ellipse
        || shape.kind == PrimitiveKind::Bezier;
    return shape.kind == PrimitiveKind::Line || (isCurve && shape.fill == ShapeFill::Outline);
}

void drawStrokes(const Primitives &primitives, const ScanSettings &settings,
                 Antialiasing antialiasing, FrameView frame)
{
    StrokePainter painter(settings, antialiasing, frame);
    for (const Shape &shape : primitives.shapes) {
        if (isStroke(shape))
            painter.draw(shape);
    }
}

bool covers(const Shape &shape, const Appearance &appearance, StrokeTruth strokes,
            FrameOrigin origin, std::int64_t x, std::int64_t y)
{
    const Antialiasing antialiasing = truthOf(appearance).antialiasing;
    const bool isNearest
        = antialiasing == Antialiasing::None && strokes == StrokeTruth::NearestPixels;
    if (isNearest || !isStroke(shape))
        return covers(shape, origin, x, y);
    const OutlinePoint centre = {x * outlinePixel, y * outlinePixel};
    FrameView pixel;
    pixel.firstColumn = std::int32_t(x);
    pixel.firstRow = std::int32_t(y);
    pixel.width = 1;
    pixel.height = 1;
    const std::vector<OutlineEdge> edges = strokeOutline(shape, pixel);
    if (antialiasing == Antialiasing::Area)
        return strokeArea(edges, centre) > 0;
    return std::ranges::any_of(sampleOffsets(antialiasing), [&](const LatticePoint &offset) {
        return strokeWinding(
                   edges,
                   {centre.x + offset.x * outlineLattice, centre.y + offset.y * outlineLattice})
            > 0;
    });
}

} // namespace pixelplumb::oracle
