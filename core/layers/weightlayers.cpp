// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/layers.h"
#include "core/layers/visitedsamples.h"
#include "core/oracle/planeweights.h"

#include <algorithm>
#include <array>

namespace pixelplumb {

namespace {

using NumberIds = std::array<QString, 3>;

/// The numbers that decide a sample, by family; the first that a method has.
const std::array<NumberIds, 3> &decisionIds()
{
    static const std::array<NumberIds, 3> ids
        = {NumberIds{QStringLiteral("alpha"), QStringLiteral("beta"), QStringLiteral("gamma")},
           NumberIds{QStringLiteral("u"), QStringLiteral("v"), QStringLiteral("w")},
           NumberIds{QStringLiteral("E_0"), QStringLiteral("E_1"), QStringLiteral("E_2")}};
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
            QStringLiteral("Weights: the triangle has no area, so that no point has any"));
    visitSamples(moment, [&](const SampleRecord &sample) {
        const oracle::PlaneWeights weights
            = oracle::barycentricWeights(triangle, sample.x, sample.y);
        for (const BigInteger &part : weights.parts)
            appendNumber(
                sample.x, sample.y,
                Quantity::of(part.convert_to<double>() / weights.whole.convert_to<double>()),
                drawing);
    });
    drawing.cellNames += {QStringLiteral("α"), QStringLiteral("β"), QStringLiteral("γ")};
    drawing.notes.append(QStringLiteral("α, β, γ belong to a, b, c, the vertices 0, 1, 2, and are "
                                        "exact, since “%1” computes none")
                             .arg(moment.view.traced->method->title));
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
    drawing.cellNames += {QStringLiteral("R"), QStringLiteral("G"), QStringLiteral("B")};
    visitSamples(moment, [&](const SampleRecord &sample) {
        for (const Quantity &level : sample.colour)
            appendNumber(sample.x, sample.y, level, drawing);
    });
}

} // namespace

Layer weightsLayer()
{
    return {.id = QStringLiteral("weights"),
            .title = QStringLiteral(QT_TRANSLATE_NOOP("core", "Weights in the cells")),
            .toolTip = QStringLiteral(
                "What decides each sample that the method has visited: α β γ, u v w or E₀ E₁ E₂, "
                "one below the other, as it computed them; exact α β γ where it has none. α β γ "
                "belong to the vertices 0, 1, 2 of the scene, whatever the method sorts."),
            .source = QStringLiteral("Rasterization slides, “BC – Inside Triangle Test”"),
            .kinds = {PrimitiveKind::Triangle},
            .draw = drawWeights};
}

Layer levelsLayer()
{
    return {.id = QStringLiteral("levels"),
            .title = QStringLiteral(QT_TRANSLATE_NOOP("core", "R G B in the cells")),
            .toolTip = QStringLiteral("The levels of each sample, one below the other, before they "
                                      "are rounded to a byte, as the method computed them."),
            .source
            = QStringLiteral("Scan Conversion slides, “Interpolation During Scan Conversion”"),
            .kinds = {PrimitiveKind::Triangle},
            .draw = drawLevels};
}

} // namespace pixelplumb
