// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/redrawing.h"

#include "core/frame/framebuffer.h"
#include "core/number/commonfraction.h"
#include "core/oracle/oracle.h"

#include <algorithm>

namespace pixelplumb {

namespace {

Triangle exchanged(Triangle triangle)
{
    for (Vertex &vertex : triangle.vertices)
        std::swap(vertex.position.x, vertex.position.y);
    return triangle;
}

/// A triangle's samples in the order in which its method goes through them.
class RedrawnTriangle {
public:
    RedrawnTriangle(const Scene &alone, const Redrawing &redrawing, SpanAxis axis)
        : m_frame(alone.frame)
        , m_overflow(redrawing.overflow)
        , m_goesByRows(axis != SpanAxis::Column)
        , m_right(pictureOf(alone))
    {
        const Triangle triangle = primitivesOnSamples(alone).triangles.front();
        m_runs.triangle = m_goesByRows ? exchanged(triangle) : triangle;
        m_runs.firstSample = m_goesByRows ? m_frame.firstColumn : m_frame.firstRow;
        m_runs.endSample = m_runs.firstSample + (m_goesByRows ? m_frame.width : m_frame.height);
        m_runs.firstSpan = m_goesByRows ? m_frame.firstRow : m_frame.firstColumn;
        m_runs.endSpan = m_runs.firstSpan + (m_goesByRows ? m_frame.height : m_frame.width);
        m_runs.settings = alone.settings;
        const BoundaryRule rule = boundaryRuleOf(alone);
        m_runs.intervals = columnIntervals(rule.rule);
        if (axis == SpanAxis::Row) {
            m_runs.order = WalkOrder::Descending;
            m_runs.intervals = {reversed(rowIntervals(rule).columns), rowIntervals(rule).rows};
        }
        readRuns();
        redrawing.change(m_runs);
    }

    void paintOn(Picture &picture, Repainting repainting, const Colour &background) const
    {
        for (const SampleRun &run : m_runs.runs) {
            const std::int64_t end = std::min(run.end, m_runs.endSample);
            for (std::int64_t place = std::max(run.first, m_runs.firstSample); place < end;
                 ++place) {
                const auto index = indexOf(run.span, place);
                if (!index)
                    continue;
                const bool isErased
                    = repainting == Repainting::Toggles && picture.covered[*index] != 0;
                picture.colours[*index] = isErased ? background : colourAt(run, place, *index);
                picture.covered[*index] = isErased ? 0 : 1;
            }
        }
    }

private:
    std::optional<std::size_t> indexOf(std::int64_t span, std::int64_t place) const
    {
        const std::int64_t column = (m_goesByRows ? place : span) - m_frame.firstColumn;
        const std::int64_t row = m_goesByRows ? span : place;
        const bool isInside = column >= 0 && column < m_frame.width && row >= m_frame.firstRow
            && row - m_frame.firstRow < m_frame.height;
        if (!isInside)
            return std::nullopt;
        return m_right.placeOf(int(column), int(pictureLine(m_frame, row)));
    }

    void readRuns()
    {
        for (std::int64_t span = m_runs.firstSpan; span < m_runs.endSpan; ++span) {
            std::optional<SampleRun> run;
            for (std::int64_t place = m_runs.firstSample; place < m_runs.endSample; ++place) {
                if (m_right.covered[*indexOf(span, place)] == 0)
                    continue;
                if (!run)
                    run = SampleRun{span, place, place};
                run->end = place + 1;
            }
            if (run)
                m_runs.runs.push_back(*run);
        }
    }

    std::uint8_t byteOf(std::int64_t level) const
    {
        if (m_overflow == LevelOverflow::Wraps)
            return std::uint8_t(level);
        return std::uint8_t(std::clamp<std::int64_t>(level, 0, 255));
    }

    Colour colourAt(const SampleRun &run, std::int64_t place, std::size_t index) const
    {
        if (run.levels.empty() && m_right.covered[index] != 0)
            return m_right.colours[index];
        const WholeLevels levels = run.levels.empty() ? planeAt(run.span, place)
                                                      : run.levels[std::size_t(place - run.first)];
        Colour colour;
        for (std::size_t i = 0; i < 3; ++i)
            colour.channels[i] = byteOf(levels[i]);
        return colour;
    }

    WholeLevels planeAt(std::int64_t span, std::int64_t place) const
    {
        const auto exact = oracle::colourAt(m_runs.triangle, span, place);
        WholeLevels levels;
        for (std::size_t i = 0; i < 3; ++i) {
            const CommonFraction level{exact[i].numerator(), exact[i].denominator()};
            const bool isNearest = m_runs.settings.rounding == ByteRounding::Nearest;
            levels[i] = std::int64_t(isNearest ? level.nearest() : level.floor());
        }
        return levels;
    }

    FrameSpec m_frame;
    LevelOverflow m_overflow;
    bool m_goesByRows;
    Picture m_right;
    TriangleRuns m_runs;
};

} // namespace

Scene triangleAlone(const Scene &scene, std::size_t triangle)
{
    Scene alone = scene;
    alone.triangles = {scene.triangles[triangle]};
    alone.shapes.clear();
    return alone;
}

Scene shapeAlone(const Scene &scene, std::size_t shape)
{
    Scene alone = scene;
    alone.triangles.clear();
    alone.shapes = {scene.shapes[shape]};
    return alone;
}

Picture redrawn(const Scene &scene, const Redrawing &redrawing)
{
    Scene empty = scene;
    empty.triangles.clear();
    Picture picture = pictureOf(empty);
    const SpanAxis axis = methodNamed(QString::fromStdString(scene.method))->spanAxis;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i)
        RedrawnTriangle(triangleAlone(scene, i), redrawing, axis)
            .paintOn(picture, redrawing.repainting, scene.frame.background);
    return picture;
}

} // namespace pixelplumb
