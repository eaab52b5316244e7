// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/sharededges.h"

#include "core/shade/edgepixels.h"

#include <algorithm>
#include <array>
#include <compare>
#include <numeric>
#include <optional>
#include <vector>

namespace pixelplumb {

namespace {

struct SharedEdge {
    LatticePoint from, to; ///< ordered as points
    Antialiasing antialiasing; ///< of the triangles that share it
    /// Whether one of these has no area and so paints the pixels whose centre is on it: whole ones,
    /// where pixels have several samples.
    bool isSegmentsToo = false;

    friend auto operator<=>(const SharedEdge &, const SharedEdge &) = default;
};

/// The samples on an edge, evenly spaced: first, first + step, …
struct SamplesOnEdge {
    SamplePlace first;
    SamplePlace step;
    std::int64_t count = 0;
    std::int64_t place = 0; ///< the index of their place in a pixel
};

/// The inverse of an odd number modulo 2^64, by Newton's method: each round doubles the correct
/// bits.
std::uint64_t inverseOfOdd(std::uint64_t odd)
{
    std::uint64_t inverse = odd;
    for (int rightBits = 3; rightBits < 64; rightBits *= 2)
        inverse *= 2 - odd * inverse;
    return inverse;
}

/// Narrows [first, last] to the t at which start + t·step lies within [least, most].
void keepWithin(std::int64_t &first, std::int64_t &last, Lattice start, Lattice step, Lattice least,
                Lattice most)
{
    if (step == 0) {
        if (start < least || start > most)
            last = first - 1;
        return;
    }
    const Lattice low = step > 0 ? least - start : start - most;
    const Lattice high = step > 0 ? most - start : start - least;
    first = std::max(first, ceilDivide(low, absolute(step)));
    last = std::min(last, floorDivide(high, absolute(step)));
}

SamplesOnEdge samplesOn(const SharedEdge &edge, const FrameView &frame)
{
    const Lattice width = edge.to.x - edge.from.x;
    const Lattice height = edge.to.y - edge.from.y;
    const Lattice parts = std::gcd(width, height);
    if (parts == 0)
        return {};
    // The lattice points of the edge are from + t·(x, y) with 0 <= t <= parts, x and y coprime; a
    // sample has both coordinates multiples of a pixel's units. One of x and y is odd, so its
    // equation gives t modulo a pixel.
    const LatticePoint step = {width / parts, height / parts};
    const bool isXOdd = step.x % 2 != 0;
    const auto odd = std::uint64_t(isXOdd ? step.x : step.y);
    const auto start = std::uint64_t(isXOdd ? edge.from.x : edge.from.y);
    const auto t = std::int64_t((0 - start) * inverseOfOdd(odd) % std::uint64_t(unitsPerPixel));
    const LatticePoint at = {edge.from.x + t * step.x, edge.from.y + t * step.y};
    if (at.x % unitsPerPixel != 0 || at.y % unitsPerPixel != 0)
        return {};
    std::int64_t first = 0;
    std::int64_t last = floorDivide<std::int64_t>(parts - t, unitsPerPixel);
    const LatticePoint pixel = {at.x / unitsPerPixel, at.y / unitsPerPixel};
    keepWithin(first, last, pixel.x, step.x, frame.firstColumn, frame.endColumn() - 1);
    keepWithin(first, last, pixel.y, step.y, frame.firstRow, frame.endRow() - 1);
    if (last < first)
        return {};
    return {
        {pixel.x + first * step.x, pixel.y + first * step.y}, {step.x, step.y}, last - first + 1};
}

/// The samples that lie in the pixels of others on the same edge.
SamplesOnEdge inPixelsOf(const SamplesOnEdge &others, SamplesOnEdge samples)
{
    const SamplePlace &step = samples.step;
    const SamplePlace from = {samples.first.x - others.first.x, samples.first.y - others.first.y};
    const std::int64_t steps = step.x != 0 ? from.x / step.x : from.y / step.y;
    const bool isSame = steps * step.x == from.x && steps * step.y == from.y;
    const std::int64_t first = std::max<std::int64_t>(0, -steps);
    const std::int64_t end = std::min(samples.count, others.count - steps);
    samples.count = isSame ? std::max<std::int64_t>(0, end - first) : 0;
    samples.first = {samples.first.x + first * step.x, samples.first.y + first * step.y};
    return samples;
}

/// Calls function(samples) for the edge's samples in the frame: the pixel centres or, where pixels
/// have several samples, once for each place in a pixel.
template <class Function>
void forEachPlaceOn(const SharedEdge &edge, const FrameView &frame, const Function &function)
{
    const SamplesOnEdge centres = samplesOn(edge, frame);
    const std::span<const LatticePoint> pattern = samplePattern(edge.antialiasing);
    if (pattern.empty() && centres.count > 0)
        function(centres);
    for (std::size_t place = 0; place < pattern.size(); ++place) {
        const LatticePoint &at = pattern[place];
        SharedEdge seen = edge;
        seen.from = {edge.from.x - at.x, edge.from.y - at.y};
        seen.to = {edge.to.x - at.x, edge.to.y - at.y};
        SamplesOnEdge samples = samplesOn(seen, frame);
        if (edge.isSegmentsToo && samples.count > 0)
            samples = centres.count > 0 ? inPixelsOf(centres, samples) : SamplesOnEdge();
        samples.place = std::int64_t(place);
        if (samples.count > 0)
            function(samples);
    }
}

std::int64_t countOn(const SharedEdge &edge, const FrameView &frame)
{
    std::int64_t count = 0;
    forEachPlaceOn(edge, frame, [&](const SamplesOnEdge &samples) { count += samples.count; });
    return count;
}

struct TriangleEdge {
    SharedEdge edge;
    bool isBlended = false; ///< its triangle
};

/// Appends the edges with samples.
void appendEdges(std::span<const Triangle *const> triangles, const SampledFrame &where,
                 bool areBlended, std::vector<TriangleEdge> &edges)
{
    for (const Triangle *triangle : triangles) {
        const auto first = std::ptrdiff_t(edges.size());
        for (std::size_t i = 0; i < 3; ++i) {
            const LatticePoint &a = triangle->vertices[i].position;
            const LatticePoint &b = triangle->vertices[(i + 1) % 3].position;
            const SharedEdge edge{std::min(a, b), std::max(a, b), where.antialiasingOf(*triangle)};
            // A segment that runs there and back has one edge twice.
            const auto isIt = [&edge](const TriangleEdge &known) { return known.edge == edge; };
            const bool isKnown = std::any_of(edges.begin() + first, edges.end(), isIt);
            if (!isKnown && countOn(edge, where.frame) > 0)
                edges.push_back({edge, areBlended});
        }
    }
}

/// The edge that these triangles' edges, with both ends in common, share with a blended one.
std::optional<SharedEdge> sharedOf(std::span<const TriangleEdge> same)
{
    const auto hasArea = [&same](const TriangleEdge &known) {
        return known.edge.antialiasing == same.back().edge.antialiasing;
    };
    const auto isBlended = [](const TriangleEdge &known) { return known.isBlended; };
    // Sorted: segments come first.
    const auto segments = std::size_t(std::ranges::find_if(same, hasArea) - same.begin());
    const std::span<const TriangleEdge> others = same.subspan(segments);
    SharedEdge shared = same.back().edge;
    if (others.size() > 1 && std::ranges::any_of(others, isBlended))
        return shared;
    if (segments > 1 && std::ranges::any_of(same.first(segments), isBlended))
        return same.front().edge;
    if (segments == 0 || same.size() < 2 || std::ranges::none_of(same, isBlended))
        return std::nullopt;
    shared.isSegmentsToo = true;
    return shared;
}

/// The shared edges, each once.
std::vector<SharedEdge> sharedEdgesOf(std::vector<TriangleEdge> edges)
{
    std::ranges::sort(edges, {}, &TriangleEdge::edge);
    const auto ends
        = [](const TriangleEdge &known) { return std::pair(known.edge.from, known.edge.to); };
    std::vector<SharedEdge> shared;
    for (auto first = edges.begin(); first != edges.end();) {
        const auto end = std::find_if(first, edges.end(), [&](const TriangleEdge &known) {
            return ends(known) != ends(*first);
        });
        if (const auto edge = sharedOf(std::span(first, end)))
            shared.push_back(*edge);
        first = end;
    }
    return shared;
}

/// Counts samples on several edges once. Those at other places in their pixels are different
/// samples.
std::int64_t countOnce(std::span<const SharedEdge> edges, const FrameView &frame)
{
    std::vector<std::array<std::int64_t, 3>> places;
    for (const SharedEdge &edge : edges) {
        forEachPlaceOn(edge, frame, [&](const SamplesOnEdge &samples) {
            for (std::int64_t i = 0; i < samples.count; ++i)
                places.push_back({samples.first.x + i * samples.step.x,
                                  samples.first.y + i * samples.step.y, samples.place});
        });
    }
    std::ranges::sort(places);
    return std::unique(places.begin(), places.end()) - places.begin();
}

} // namespace

SharedSamples sharedSamplesOf(std::span<const Triangle *const> blended,
                              std::span<const Triangle *const> others, const SampledFrame &where)
{
    std::vector<TriangleEdge> known;
    appendEdges(blended, where, true, known);
    appendEdges(others, where, false, known);
    const std::vector<SharedEdge> edges = sharedEdgesOf(std::move(known));
    SharedSamples shared;
    for (const SharedEdge &edge : edges) {
        forEachPlaceOn(edge, where.frame, [&](const SamplesOnEdge &samples) {
            if (shared.samples == 0)
                shared.first = samples.first;
            shared.samples += samples.count;
        });
    }
    constexpr std::int64_t mostCountedOnce = 100'000;
    shared.isExact = shared.samples <= mostCountedOnce;
    if (shared.isExact)
        shared.samples = countOnce(edges, where.frame);
    return shared;
}

} // namespace pixelplumb
