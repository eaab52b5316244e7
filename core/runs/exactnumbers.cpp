// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/effectsample.h"
#include "core/oracle/oracle.h"
#include "core/runs/tracedscene.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace pixelplumb {

namespace {

/// Where the exact run is at the same place as a span of the trace.
std::optional<std::size_t> twinOf(const TracedScene &traced, std::size_t span)
{
    if (!traced.exactTrace)
        return std::nullopt;
    const std::size_t primitive = traced.trace->primitiveOf(span);
    if (primitive >= traced.exactTrace->primitiveCount())
        return std::nullopt;
    const SpanPlace &place = traced.trace->placeOf(span);
    return traced.exactTrace->spanOn(primitive, place.axis, place.coordinate);
}

/// Those of the exact cells that stand beside rounded ones.
std::vector<Quantity> compared(const std::vector<NumberDescription> &numbers,
                               const std::vector<Quantity> &exact)
{
    std::vector<Quantity> cells(numbers.size());
    for (std::size_t i = 0; i < std::min(exact.size(), cells.size()); ++i) {
        if (numbers[i].comparison == Comparison::WithExact)
            cells[i] = exact[i];
    }
    return cells;
}

/// The same of an exact run's own cells: what it had to round, a root or a power, has no exact
/// number in it.
std::vector<Quantity> comparedOfItself(const std::vector<NumberDescription> &numbers,
                                       const std::vector<Quantity> &own)
{
    std::vector<Quantity> cells = compared(numbers, own);
    for (Quantity &cell : cells) {
        if (!cell.isRational())
            cell = {};
    }
    return cells;
}

bool isExact(const TracedScene &traced)
{
    return traced.scene.settings.arithmetic == Arithmetic::Exact;
}

/// A span's samples by their pixels.
using SamplesByPixel = std::unordered_map<std::uint64_t, SampleRecord>;

std::uint64_t keyOf(const SampleRecord &sample)
{
    return std::uint64_t(sample.x) << 32 | std::uint32_t(sample.y);
}

/// The exact run walks the span once, however many of its samples are asked for.
SamplesByPixel twinSamples(const TracedScene &traced, std::size_t span)
{
    SamplesByPixel samples;
    if (const std::optional<std::size_t> twin = twinOf(traced, span)) {
        for (SampleRecord &sample : traced.exactTrace->samples(*twin))
            samples[keyOf(sample)] = std::move(sample);
    }
    return samples;
}

/// Where the levels stand among a sample's numbers, too.
void showLevels(ExactSample &exact, const std::vector<NumberDescription> &numbers)
{
    for (std::size_t channel = 0; channel < exact.colour.size(); ++channel) {
        const auto found
            = std::ranges::find(numbers, QString(channelLetters[channel]), &NumberDescription::id);
        if (found != numbers.end() && found->comparison == Comparison::WithExact)
            exact.cells[std::size_t(found - numbers.begin())] = exact.colour[channel];
    }
}

} // namespace

std::array<Quantity, 3> exactLevelsAt(const TracedScene &traced, std::size_t primitive,
                                      std::int64_t x, std::int64_t y)
{
    const Primitives &primitives = traced.primitives;
    if (!primitives.isTriangle(primitive))
        return {};
    if (!traced.plan)
        return oracle::colourAt(primitives.triangles[primitive], x, y);
    return oracle::colourLevelsAt(primitives, primitive, oracle::truthOf(primitives.appearance), x,
                                  y);
}

std::vector<Quantity> exactSetUpCells(const TracedScene &traced, std::size_t primitive)
{
    const std::vector<NumberDescription> &numbers = traced.trace->numbers().setUp;
    if (isExact(traced))
        return comparedOfItself(numbers, traced.trace->setUp(primitive).cells);
    const bool hasTwin = traced.exactTrace && primitive < traced.exactTrace->primitiveCount();
    return compared(numbers,
                    hasTwin ? traced.exactTrace->setUp(primitive).cells : std::vector<Quantity>());
}

std::vector<Quantity> exactSpanCells(const TracedScene &traced, std::size_t span)
{
    const std::vector<NumberDescription> &numbers = traced.trace->numbers().span;
    if (isExact(traced))
        return comparedOfItself(numbers, traced.trace->span(span).cells);
    const std::optional<std::size_t> twin = twinOf(traced, span);
    if (!twin)
        return std::vector<Quantity>(numbers.size());
    const SpanRecord exact = traced.exactTrace->span(*twin);
    std::vector<Quantity> cells = compared(numbers, exact.cells);
    // The levels of two first samples are the same level only where the samples are the same.
    if (exact.firstDrawn != traced.trace->span(span).firstDrawn) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (numbers[i].group == NumberGroup::FirstColour)
                cells[i] = {};
        }
    }
    return cells;
}

std::vector<ExactSample> exactSamplesOf(const TracedScene &traced, std::size_t span,
                                        std::span<const SampleRecord> samples)
{
    const std::size_t primitive = traced.trace->primitiveOf(span);
    const SamplesByPixel twins = twinSamples(traced, span);
    std::vector<ExactSample> exact(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const SampleRecord &sample = samples[i];
        const auto found = twins.find(keyOf(sample));
        const SampleRecord *twin = found != twins.end() ? &found->second
            : isExact(traced)                           ? &sample
                                                        : nullptr;
        const std::vector<NumberDescription> &numbers = traced.trace->numbers().sample;
        exact[i].cells = isExact(traced)
            ? comparedOfItself(numbers, sample.cells)
            : compared(numbers, twin ? twin->cells : std::vector<Quantity>());
        // A mean of samples, or what depth refused, has no levels of its own.
        if (!traced.plan || !sample.colour[0].isNone())
            exact[i].colour = exactLevelsAt(traced, primitive, sample.x, sample.y);
        if (traced.plan)
            showLevels(exact[i], numbers);
    }
    return exact;
}

} // namespace pixelplumb
