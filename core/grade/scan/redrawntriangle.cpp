// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/scan/redrawntriangle.h"

#include "core/frame/framebuffer.h"
#include "core/grade/scan/planelevels.h"
#include "core/grade/scan/programwalk.h"
#include "core/oracle/oracle.h"
#include "core/runs/scenerun.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The samples at which the edges are tested.
SampleBox boxOf(const Triangle &triangle, const Scene &scene, VisitedBox box)
{
    if (box == VisitedBox::Outward) {
        const auto [least, greatest] = boundingCornersOf(triangle);
        return {floorPixel(least.x), ceilPixel(greatest.x) + 1, floorPixel(least.y),
                ceilPixel(greatest.y) + 1};
    }
    if (!scene.settings.variants.contains(Variant::RoundedBox))
        return boundingBoxOf(triangle);
    const auto [least, greatest] = boundingCornersOf(triangle);
    return roundedSamplesIn(least, greatest, scene.frame.pixelCentre);
}

} // namespace

RedrawnTriangle::RedrawnTriangle(const SeenTriangles &seen, std::size_t triangle,
                                 const Redrawing &redrawing, std::function<Picture()> drawRight,
                                 const std::optional<RoundingSide> &side)
    : m_frame(seen.scene.frame)
    , m_overflow(redrawing.overflow)
    , m_bytes(redrawing.bytes)
    , m_drawRight(std::move(drawRight))
{
    m_runs.side = side;
    see(seen, triangle, redrawing.box);
    const bool isWalked = redrawing.walk && walkAs(m_runs, *redrawing.walk);
    if (isWalked)
        return;
    m_runs.readRight = [this] { readRuns(); };
    if (!redrawing.findsSamples)
        readRuns();
    redrawing.change(m_runs);
}

RedrawnTriangle::RedrawnTriangle(const SeenTriangles &seen, std::size_t triangle,
                                 const Redrawing &redrawing, const Picture &found,
                                 std::int64_t limit)
    : m_frame(seen.scene.frame)
    , m_overflow(redrawing.overflow)
    , m_bytes(redrawing.bytes)
{
    see(seen, triangle, redrawing.box);
    m_runs.mayBe = [&, left = limit](const SampleRun &run) mutable {
        left -= differingIn(found, run);
        return left > 0;
    };
    if (redrawing.walk)
        walkAs(m_runs, *redrawing.walk);
}

void RedrawnTriangle::see(const SeenTriangles &seen, std::size_t place, VisitedBox box)
{
    const Scene &scene = seen.scene;
    m_goesByRows = seen.axis != SpanAxis::Column;
    const Triangle &triangle = seen.onSamples[place];
    m_runs.triangle = m_goesByRows ? exchanged(triangle) : triangle;
    m_runs.firstSample = m_goesByRows ? m_frame.firstColumn : m_frame.firstRow;
    m_runs.endSample = m_runs.firstSample + (m_goesByRows ? m_frame.width : m_frame.height);
    m_runs.firstSpan = m_goesByRows ? m_frame.firstRow : m_frame.firstColumn;
    m_runs.endSpan = m_runs.firstSpan + (m_goesByRows ? m_frame.height : m_frame.width);
    m_runs.chosen = seen.chosen;
    if (seen.chosen) {
        m_runs.firstSpan = seen.chosen->spans().front();
        m_runs.endSpan = seen.chosen->spans().back() + 1;
    }
    m_runs.settings = scene.settings;
    const BoundaryRule rule = boundaryRuleOf(scene);
    m_runs.rule = rule;
    m_runs.visited = boxOf(triangle, scene, box);
    m_runs.intervals = columnIntervals(rule.rule);
    if (seen.axis == SpanAxis::Row) {
        m_runs.order = SpanOrder::Descending;
        m_runs.intervals = {reversed(rowIntervals(rule).columns), rowIntervals(rule).rows};
    }
}

RedrawnTriangle::RunPlaces RedrawnTriangle::placesOf(const SampleRun &run) const
{
    RunPlaces places{std::max(run.first, m_runs.firstSample), std::min(run.end, m_runs.endSample)};
    const auto index = places.first < places.end ? indexOf(run.span, places.first) : std::nullopt;
    if (!index)
        return {};
    places.index = *index;
    if (const auto next = indexOf(run.span, places.first + 1))
        places.stride = *next - *index;
    return places;
}

/// For a raster of characters, only checks that its samples are covered.
std::int64_t RedrawnTriangle::differingIn(const Picture &found, const SampleRun &run) const
{
    std::int64_t differing = 0;
    auto [place, end, index, stride] = placesOf(run);
    for (; place < end; ++place, index += stride) {
        const bool isThere = found.hasColours
            ? isEqual(found.colours[index], colourAt(run, place, index))
            : found.covered[index] != 0;
        differing += isThere ? 0 : 1;
    }
    return differing;
}

void RedrawnTriangle::paintOn(Picture &picture, Repainting repainting,
                              const Colour &background) const
{
    for (const SampleRun &run : m_runs.runs) {
        auto [place, end, index, stride] = placesOf(run);
        for (; place < end; ++place, index += stride) {
            const bool isErased = repainting == Repainting::Toggles && picture.covered[index] != 0;
            picture.colours[index] = isErased ? background : colourAt(run, place, index);
            picture.covered[index] = isErased ? 0 : 1;
        }
    }
}

const Picture &RedrawnTriangle::right() const
{
    if (!m_right)
        m_right = m_drawRight();
    return *m_right;
}

std::optional<std::size_t> RedrawnTriangle::indexOf(std::int64_t span, std::int64_t place) const
{
    const std::int64_t column = (m_goesByRows ? place : span) - m_frame.firstColumn;
    const std::int64_t row = m_goesByRows ? span : place;
    const bool isInside = column >= 0 && column < m_frame.width && row >= m_frame.firstRow
        && row - m_frame.firstRow < m_frame.height;
    if (!isInside)
        return std::nullopt;
    if (m_runs.chosen) {
        const ChosenSpans &chosen = *m_runs.chosen;
        if (!chosen.contains(span))
            return std::nullopt;
        return m_goesByRows
            ? chosen.placeOf(span) * std::size_t(m_frame.width) + std::size_t(column)
            : std::size_t(pictureLine(m_frame, row)) * chosen.spans().size() + chosen.placeOf(span);
    }
    return std::size_t(pictureLine(m_frame, row) * m_frame.width + column);
}

void RedrawnTriangle::readRuns()
{
    for (std::int64_t span = m_runs.firstSpan; span < m_runs.endSpan; ++span) {
        if (!m_runs.isAskedFor(span))
            continue;
        std::optional<SampleRun> run;
        for (std::int64_t place = m_runs.firstSample; place < m_runs.endSample; ++place) {
            if (right().covered[*indexOf(span, place)] == 0)
                continue;
            if (!run)
                run = SampleRun{span, place, place};
            run->end = place + 1;
        }
        if (run)
            m_runs.runs.push_back(*run);
    }
}

std::uint8_t RedrawnTriangle::byteOf(std::int64_t level) const
{
    if (m_overflow == LevelOverflow::Wraps)
        return std::uint8_t(level);
    return std::uint8_t(std::clamp<std::int64_t>(level, 0, m_bytes.most));
}

Colour RedrawnTriangle::colourAt(const SampleRun &run, std::int64_t place, std::size_t index) const
{
    const auto inBytes = [this](const WholeLevels &levels) {
        Colour colour;
        for (std::size_t i = 0; i < 3; ++i)
            colour.channels[i] = byteOf(levels[i]);
        return colour;
    };
    if (!run.levels.empty())
        return inBytes(run.levels[std::size_t(place - run.firstLevelled)]);
    const bool isOwn = right().covered[index] != 0;
    if (isOwn && m_bytes.isRight())
        return right().colours[index];
    const bool isOfPlane = m_runs.settings.isRight();
    return inBytes(isOwn && !isOfPlane ? levelsOf(right().colours[index])
                                       : planeAt(run.span, place));
}

/// The levels of a right byte, of which only the nearest level is known.
WholeLevels RedrawnTriangle::levelsOf(const Colour &colour) const
{
    WholeLevels levels;
    for (std::size_t i = 0; i < 3; ++i)
        levels[i] = wholeLevelOf({colour.channels[i], 1});
    return levels;
}

std::int64_t RedrawnTriangle::wholeLevelOf(const CommonFraction &exact) const
{
    const CommonFraction level{exact.numerator * m_bytes.full, exact.denominator * m_bytes.of};
    switch (roundingOf(m_bytes, m_runs.settings)) {
    case LevelRounding::Up:
        return std::int64_t(ceilDivide<Int128>(level.numerator, level.denominator));
    case LevelRounding::Nearest:
        return std::int64_t(level.nearest());
    case LevelRounding::OfScene:
    case LevelRounding::Down:
        break;
    }
    return std::int64_t(level.floor());
}

WholeLevels RedrawnTriangle::planeAt(std::int64_t span, std::int64_t place) const
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

} // namespace pixelplumb
