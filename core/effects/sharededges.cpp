// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/sharededges.h"

#include "core/effects/edgepixels.h"

#include <algorithm>
#include <array>
#include <compare>
#include <numeric>
#include <optional>
#include <vector>

namespace pixelplumb {

namespace {

struct SharedEdge {
    LatticePoint from, to; ///< in the order of points
    Antialiasing antialiasing; ///< of the triangles that have it

    friend auto operator<=>(const SharedEdge &, const SharedEdge &) = default;
};

/// The samples on an edge, evenly spaced: first, first + step, …
struct SamplesOnEdge {
    SamplePlace first;
    SamplePlace step;
    std::int64_t count = 0;
    std::int64_t place = 0; ///< the number of their place in a pixel
};

/// The inverse of an odd number modulo 2^64, by Newton's method: each turn doubles the right bits.
std::uint64_t inverseOfOdd(std::uint64_t odd)
{
    std::uint64_t inverse = odd;
    for (int rightBits = 3; rightBits < 64; rightBits *= 2)
        inverse *= 2 - odd * inverse;
    return inverse;
}

/// The places t of a range [first, last] at which start + t·step lies within [least, most].
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
    // The lattice points of the edge are from + t·(x, y) with 0 <= t <= parts, x and y prime to
    // each other; a sample is one at which both coordinates are multiples of a pixel's units. One
    // of x and y is odd: t is known modulo a pixel by its equation.
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

/// Calls function(samples) for those of the edge in the frame: the centres of pixels, or where they
/// have several samples one call for each place in a pixel.
template <class Function>
void forEachPlaceOn(const SharedEdge &edge, const FrameView &frame, const Function &function)
{
    std::int64_t place = 0;
    const auto seenFrom = [&](const LatticePoint &sample) {
        SamplesOnEdge samples = samplesOn({{edge.from.x - sample.x, edge.from.y - sample.y},
                                           {edge.to.x - sample.x, edge.to.y - sample.y},
                                           edge.antialiasing},
                                          frame);
        samples.place = place++;
        if (samples.count > 0)
            function(samples);
    };
    const std::span<const LatticePoint> pattern = samplePattern(edge.antialiasing);
    if (pattern.empty())
        seenFrom({});
    std::ranges::for_each(pattern, seenFrom);
}

std::int64_t countOn(const SharedEdge &edge, const FrameView &frame)
{
    std::int64_t count = 0;
    forEachPlaceOn(edge, frame, [&](const SamplesOnEdge &samples) { count += samples.count; });
    return count;
}

/// The edges with samples, in order.
std::vector<SharedEdge> edgesOf(std::span<const Triangle *const> triangles,
                                const SampledFrame &where)
{
    std::vector<SharedEdge> edges;
    for (const Triangle *triangle : triangles) {
        const auto first = std::ptrdiff_t(edges.size());
        for (std::size_t i = 0; i < 3; ++i) {
            const LatticePoint &a = triangle->vertices[i].position;
            const LatticePoint &b = triangle->vertices[(i + 1) % 3].position;
            const SharedEdge edge{std::min(a, b), std::max(a, b), where.antialiasingOf(*triangle)};
            // A segment that goes there and back has one edge twice.
            const bool isKnown = std::find(edges.begin() + first, edges.end(), edge) != edges.end();
            if (!isKnown && countOn(edge, where.frame) > 0)
                edges.push_back(edge);
        }
    }
    std::ranges::sort(edges);
    return edges;
}

/// Those that a blended triangle has with another one of either kind, once each.
std::vector<SharedEdge> sharedEdgesOf(const std::vector<SharedEdge> &ofBlended,
                                      const std::vector<SharedEdge> &ofOthers)
{
    std::vector<SharedEdge> shared;
    for (std::size_t i = 0; i < ofBlended.size(); ++i) {
        const SharedEdge &edge = ofBlended[i];
        const bool isTwice = i > 0 && ofBlended[i - 1] == edge;
        if ((isTwice || std::ranges::binary_search(ofOthers, edge))
            && (shared.empty() || shared.back() != edge))
            shared.push_back(edge);
    }
    return shared;
}

/// Samples of several edges count once. Those at other places in their pixels are others.
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
    const std::vector<SharedEdge> edges
        = sharedEdgesOf(edgesOf(blended, where), edgesOf(others, where));
    SharedSamples shared;
    shared.edges = std::int64_t(edges.size());
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
