// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/redrawing.h"

#include "core/frame/framebuffer.h"
#include "core/grade/arithmeticbound.h"
#include "core/grade/programwalk.h"
#include "core/number/commonfraction.h"
#include "core/oracle/oracle.h"
#include "core/runs/sceneplan.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

Triangle exchanged(Triangle triangle)
{
    for (Vertex &vertex : triangle.vertices)
        std::swap(vertex.position.x, vertex.position.y);
    return triangle;
}

SpanAxis spanAxisOf(const Scene &scene)
{
    return methodNamed(QString::fromStdString(scene.method))->spanAxis;
}

ArithmeticBound boundOn(const RoundingSide &side, const Triangle &triangle)
{
    const bool isExact = side.arithmetic == Arithmetic::Exact;
    return {triangle, isExact ? Arithmetic::Float64 : side.arithmetic};
}

ByteRounding roundingOf(const LevelBytes &bytes, const ScanSettings &settings)
{
    return bytes.rounding.value_or(settings.rounding);
}

/// R G B of the plane on a side of what rounding may do, as bytes become of them before they are
/// clamped.
WholeLevels levelsOn(const RoundingSide &side, const ArithmeticBound &bound,
                     const Triangle &triangle, const ScanSettings &settings,
                     const LevelBytes &bytes, std::int64_t x, std::int64_t y)
{
    constexpr double any = 1024; // levels: beyond all bytes
    const bool isExact = side.arithmetic == Arithmetic::Exact;
    const auto exact = oracle::colourAt(triangle, x, y);
    WholeLevels levels;
    for (std::size_t i = 0; i < 3; ++i) {
        const double error = isExact ? 0 : bound.levelError(x, y, i).value_or(any);
        const double level
            = (exact[i].toDouble() + (side.isUpward ? error : -error)) * bytes.full / 255;
        const bool isNearest = roundingOf(bytes, settings) == ByteRounding::Nearest;
        levels[i] = std::int64_t(std::floor(level + (isNearest ? 0.5 : 0)));
    }
    return levels;
}

/// A triangle's samples in the order in which its method goes through them.
class RedrawnTriangle {
public:
    /// Of what is right, on a side of what rounding may do, if it is on one.
    RedrawnTriangle(const Scene &alone, const Redrawing &redrawing, Picture right,
                    const std::optional<RoundingSide> &side = {})
        : m_frame(alone.frame)
        , m_overflow(redrawing.overflow)
        , m_bytes(redrawing.bytes)
        , m_right(std::move(right))
    {
        const SpanAxis axis = spanAxisOf(alone);
        m_goesByRows = axis != SpanAxis::Column;
        const Triangle triangle = primitivesOnSamples(alone).triangles.front();
        m_runs.triangle = m_goesByRows ? exchanged(triangle) : triangle;
        m_runs.firstSample = m_goesByRows ? m_frame.firstColumn : m_frame.firstRow;
        m_runs.endSample = m_runs.firstSample + (m_goesByRows ? m_frame.width : m_frame.height);
        m_runs.firstSpan = m_goesByRows ? m_frame.firstRow : m_frame.firstColumn;
        m_runs.endSpan = m_runs.firstSpan + (m_goesByRows ? m_frame.height : m_frame.width);
        m_runs.settings = alone.settings;
        m_runs.side = side;
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
        const bool isOwn = run.levels.empty() && m_right.covered[index] != 0;
        if (isOwn && m_bytes.isRight())
            return m_right.colours[index];
        const bool isOfPlane = m_runs.settings.variants.isEmpty();
        const WholeLevels levels = !run.levels.empty() ? run.levels[std::size_t(place - run.first)]
            : isOwn && !isOfPlane                      ? levelsOf(m_right.colours[index])
                                                       : planeAt(run.span, place);
        Colour colour;
        for (std::size_t i = 0; i < 3; ++i)
            colour.channels[i] = byteOf(levels[i]);
        return colour;
    }

    /// Of a byte that was right: what is nearest to the level is all that is known of it.
    WholeLevels levelsOf(const Colour &colour) const
    {
        WholeLevels levels;
        for (std::size_t i = 0; i < 3; ++i)
            levels[i] = wholeLevelOf({colour.channels[i], 1});
        return levels;
    }

    std::int64_t wholeLevelOf(const CommonFraction &exact) const
    {
        const CommonFraction level{exact.numerator * m_bytes.full, exact.denominator * 255};
        const bool isNearest = roundingOf(m_bytes, m_runs.settings) == ByteRounding::Nearest;
        return std::int64_t(isNearest ? level.nearest() : level.floor());
    }

    WholeLevels planeAt(std::int64_t span, std::int64_t place) const
    {
        const auto exact = oracle::colourAt(m_runs.triangle, span, place);
        WholeLevels levels;
        if (m_runs.side)
            return levelsOn(*m_runs.side, boundOn(*m_runs.side, m_runs.triangle), m_runs.triangle,
                            m_runs.settings, m_bytes, span, place);
        for (std::size_t i = 0; i < 3; ++i)
            levels[i] = wholeLevelOf({exact[i].numerator(), exact[i].denominator()});
        return levels;
    }

    FrameSpec m_frame;
    LevelOverflow m_overflow;
    LevelBytes m_bytes;
    bool m_goesByRows = false;
    Picture m_right;
    TriangleRuns m_runs;
};

Picture emptyPicture(Scene scene)
{
    scene.triangles.clear();
    return pictureOf(scene);
}

/// By the bound that holds whatever the method.
Picture boundedPicture(const Scene &alone, const RoundingSide &side)
{
    const FrameSpec &frame = alone.frame;
    const Triangle triangle = primitivesOnSamples(alone).triangles.front();
    const ArithmeticBound bound = boundOn(side, triangle);
    if (!bound.isProved() || !alone.settings.variants.isEmpty())
        return pictureOf(alone);
    Picture picture = emptyPicture(alone);
    const SampleBox box = bound.reachIn(frame);
    for (std::int64_t y = box.firstY; y < box.endY; ++y) {
        for (std::int64_t x = box.firstX; x < box.endX; ++x) {
            const SamplePlace sample = bound.placeOf(x, y);
            const bool isDrawn = sample == SamplePlace::Inside
                || (sample == SamplePlace::Undecided && side.isOutward);
            if (!isDrawn)
                continue;
            const std::size_t place
                = picture.placeOf(int(x - frame.firstColumn), int(pictureLine(frame, y)));
            const WholeLevels levels = levelsOn(side, bound, triangle, alone.settings, {}, x, y);
            picture.covered[place] = 1;
            for (std::size_t i = 0; i < 3; ++i)
                picture.colours[place].channels[i]
                    = std::uint8_t(std::clamp<std::int64_t>(levels[i], 0, 255));
        }
    }
    return picture;
}

/// What is right of one triangle, on a side.
Picture rightPicture(const Scene &alone, const RoundingSide &side)
{
    const Method &method = *methodNamed(QString::fromStdString(alone.method));
    const bool walksEdges = method.supports(Variant::NoEdgePreStep);
    const bool hasArea = doubledArea(alone.triangles.front()) != 0;
    if (!hasArea)
        return pictureOf(alone);
    if (!walksEdges)
        return boundedPicture(alone, side);
    Picture picture = emptyPicture(alone);
    RedrawnTriangle(alone, {walking({})}, pictureOf(alone), side)
        .paintOn(picture, Repainting::Over, alone.frame.background);
    return picture;
}

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
    Picture picture = emptyPicture(scene);
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        const Scene alone = triangleAlone(scene, i);
        RedrawnTriangle(alone, redrawing, pictureOf(alone))
            .paintOn(picture, redrawing.repainting, scene.frame.background);
    }
    return picture;
}

PictureRange redrawnRange(const Scene &scene, const Redrawing &redrawing, Arithmetic arithmetic)
{
    PictureRange range;
    const auto sides = roundingSides(arithmetic);
    for (std::size_t side = 0; side < sides.size(); ++side) {
        range.sides[side] = emptyPicture(scene);
        for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
            const Scene alone = triangleAlone(scene, i);
            RedrawnTriangle(alone, redrawing, rightPicture(alone, sides[side]), sides[side])
                .paintOn(range.sides[side], redrawing.repainting, scene.frame.background);
        }
    }
    return range;
}

bool canBeRedrawn(const Scene &scene)
{
    constexpr std::size_t mostRedrawn = 64; // triangles: each is drawn by itself
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    return method.draws(PrimitiveKind::Triangle) && scene.shapes.empty() && !scene.triangles.empty()
        && scene.triangles.size() <= mostRedrawn && !mayCallForEffects(scene);
}

} // namespace pixelplumb
