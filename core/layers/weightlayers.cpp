// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/layermoment.h"
#include "core/layers/layers.h"
#include "core/oracle/planeweights.h"

#include <algorithm>
#include <array>
#include <functional>

namespace pixelplumb {

namespace {

bool mayBeSeen(const SpanPlace &place, const SampleBox &seen)
{
    switch (place.axis) {
    case SpanAxis::Column:
        return place.coordinate >= seen.firstX && place.coordinate < seen.endX;
    case SpanAxis::Row:
        return place.coordinate >= seen.firstY && place.coordinate < seen.endY;
    case SpanAxis::Free:
        break;
    }
    return true;
}

/// Passes to a function the samples in view that the method has visited for the primitive, up to
/// the current step, with the numbers that it used there.
void visitSamples(const LayerMoment &moment, const std::function<void(const SampleRecord &)> &visit)
{
    const ScanTrace &trace = moment.trace();
    const SampleBox seen = moment.seen();
    const std::size_t done = trace.samplesDoneAt(moment.view.position);
    const std::size_t end = trace.endSpanOf(moment.primitive);
    for (std::size_t span = trace.firstSpanOf(moment.primitive); span < end; ++span) {
        const std::size_t first = trace.firstSampleOf(span);
        if (first >= done)
            break;
        if (!mayBeSeen(trace.placeOf(span), seen))
            continue;
        std::size_t left = done - first;
        for (const SampleRecord &sample : trace.samples(span)) {
            if (left-- == 0)
                break;
            if (sample.x >= seen.firstX && sample.x < seen.endX && sample.y >= seen.firstY
                && sample.y < seen.endY)
                visit(sample);
        }
    }
}

using NumberIds = std::array<QString, 3>;

/// The numbers that decide a sample, by family; the first that a method has.
const std::array<NumberIds, 3> &decisionIds()
{
    static const std::array<NumberIds, 3> ids
        = {NumberIds{"alpha", "beta", "gamma"}, NumberIds{"u", "v", "w"},
           NumberIds{"E_0", "E_1", "E_2"}};
    return ids;
}

const NumberIds *decisionsOf(const ScanTrace &trace)
{
    const auto &described = trace.numbers().sample;
    const auto isThere = [&](const QString &id) { return hasNumber(described, id); };
    const auto found = std::ranges::find_if(
        decisionIds(), [&](const NumberIds &ids) { return std::ranges::all_of(ids, isThere); });
    return found == decisionIds().end() ? nullptr : &*found;
}

void appendNumber(std::int64_t x, std::int64_t y, const Quantity &number, LayerDrawing &drawing)
{
    if (!number.isNone())
        drawing.cells.push_back({x, y, cellNumber(number), inkOf(number)});
}

void appendExactWeights(const LayerMoment &moment, LayerDrawing &drawing)
{
    const Triangle &triangle = moment.triangle();
    if (doubledArea(triangle) == 0)
        return drawing.notes.append(
            u"Weights: the triangle has no area, so that no point has any"_s);
    visitSamples(moment, [&](const SampleRecord &sample) {
        const oracle::PlaneWeights weights
            = oracle::barycentricWeights(triangle, sample.x, sample.y);
        for (const BigInteger &part : weights.parts)
            appendNumber(
                sample.x, sample.y,
                Quantity::of(part.convert_to<double>() / weights.whole.convert_to<double>()),
                drawing);
    });
    drawing.cellNames += {"α", "β", "γ"};
    drawing.notes.append(
        u"α, β, γ belong to a, b, c, the vertices 0, 1, 2, and are "
        "exact, since “%1” computes none"_s.arg(moment.view.traced->method->title));
}

void drawWeights(const LayerMoment &moment, LayerDrawing &drawing)
{
    if (moment.view.cell < leastNumberCell)
        return drawing.notes.append(smallCellNote());
    const NumberIds *ids = decisionsOf(moment.trace());
    if (!ids)
        return appendExactWeights(moment, drawing);
    for (const NumberDescription &number : moment.trace().numbers().sample) {
        if (std::ranges::count(*ids, number.id) > 0)
            drawing.cellNames.append(number.title);
    }
    visitSamples(moment, [&](const SampleRecord &sample) {
        const NamedNumbers numbers(moment.trace().numbers().sample, sample.cells);
        for (const QString &id : *ids)
            appendNumber(sample.x, sample.y, numbers[id], drawing);
    });
}

void drawLevels(const LayerMoment &moment, LayerDrawing &drawing)
{
    if (moment.view.cell < leastNumberCell)
        return drawing.notes.append(smallCellNote());
    drawing.cellNames += {"R", "G", "B"};
    visitSamples(moment, [&](const SampleRecord &sample) {
        for (const Quantity &level : sample.colour)
            appendNumber(sample.x, sample.y, level, drawing);
    });
}

} // namespace

Layer weightsLayer()
{
    return {.id = "weights",
            .title = QT_TRANSLATE_NOOP("core", "Weights in the cells"),
            .toolTip
            = "What decides each sample that the method has visited: α β γ, u v w or E₀ E₁ E₂, one "
              "below the other, as it computed them; exact α β γ where it has none. α β γ belong "
              "to the vertices 0, 1, 2 of the scene, whatever the method sorts.",
            .source = "Rasterization slides, “BC – Inside Triangle Test”",
            .kinds = {PrimitiveKind::Triangle},
            .draw = drawWeights};
}

Layer levelsLayer()
{
    return {.id = "levels",
            .title = QT_TRANSLATE_NOOP("core", "R G B in the cells"),
            .toolTip = "The levels of each sample, one below the other, before they are rounded to "
                       "a byte, as the method computed them.",
            .source = "Scan Conversion slides, “Interpolation During Scan Conversion”",
            .kinds = {PrimitiveKind::Triangle},
            .draw = drawLevels};
}

} // namespace pixelplumb
