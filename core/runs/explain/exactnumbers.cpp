// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/exactsample.h"
#include "core/oracle/oracle.h"
#include "core/runs/tracedscene.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace pixelplumb {

namespace {

/// The span of the exact run at the same place as a span of the trace.
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

/// A row of another run, with the descriptions of its cells.
struct CellsOfRun {
    const std::vector<NumberDescription> &numbers;
    const std::vector<Quantity> &cells;

    /// The number with this id, which is usually at the same place.
    Quantity numberAt(std::size_t place, const QString &id) const
    {
        if (place >= numbers.size() || numbers[place].id != id)
            place = std::size_t(std::ranges::find(numbers, id, &NumberDescription::id)
                                - numbers.begin());
        return place < cells.size() ? cells[place] : Quantity();
    }
};

/// The exact cells that are shown next to rounded ones. What another arithmetic draws may call for
/// other effects, and so have other numbers.
std::vector<Quantity> compared(const std::vector<NumberDescription> &numbers,
                               const CellsOfRun &exact)
{
    std::vector<Quantity> cells(numbers.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (numbers[i].comparison == Comparison::WithExact)
            cells[i] = exact.numberAt(i, numbers[i].id);
    }
    return cells;
}

/// Like compared(), for an exact run's own cells: what it had to round, a root or a power, has no
/// exact number in it.
std::vector<Quantity> comparedOfItself(const std::vector<NumberDescription> &numbers,
                                       const std::vector<Quantity> &own)
{
    std::vector<Quantity> cells = compared(numbers, {numbers, own});
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

/// The exact run walks the span once, however many of its samples are needed.
SamplesByPixel twinSamples(const TracedScene &traced, std::size_t span)
{
    SamplesByPixel samples;
    if (const std::optional<std::size_t> twin = twinOf(traced, span)) {
        for (SampleRecord &sample : traced.exactTrace->samples(*twin))
            samples[keyOf(sample)] = std::move(sample);
    }
    return samples;
}

/// Copies the levels to their places among a sample's numbers.
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
    if (!traced.shading())
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
    if (!hasTwin)
        return std::vector<Quantity>(numbers.size());
    const SetUpRecord exact = traced.exactTrace->setUp(primitive);
    return compared(numbers, {traced.exactTrace->numbers().setUp, exact.cells});
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
    std::vector<Quantity> cells
        = compared(numbers, {traced.exactTrace->numbers().span, exact.cells});
    // The levels of two first samples can be compared only if the samples are the same.
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
        if (isExact(traced))
            exact[i].cells = comparedOfItself(numbers, sample.cells);
        else if (twin)
            exact[i].cells = compared(numbers, {traced.exactTrace->numbers().sample, twin->cells});
        else
            exact[i].cells.resize(numbers.size());
        // A mean of samples, or a sample refused by depth, has no levels of its own.
        if (!traced.shading() || !sample.colour[0].isNone())
            exact[i].colour = exactLevelsAt(traced, primitive, sample.x, sample.y);
        if (traced.shading())
            showLevels(exact[i], numbers);
    }
    return exact;
}

} // namespace pixelplumb
