// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/cellnumber.h"
#include "core/layers/layers.h"
#include "core/plan/requirements.h"
#include "core/scan/curves/pointaddress.h"
#include "core/shade/edgepixels.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

namespace pixelplumb {

namespace {

constexpr double leastSampleCell = 10; ///< logical px

void forEachSeen(const LayerMoment &moment,
                 const std::function<void(std::int64_t x, std::int64_t y)> &visit)
{
    const SampleBox seen = moment.seen();
    for (std::int64_t y = seen.firstY; y < seen.endY; ++y) {
        for (std::int64_t x = seen.firstX; x < seen.endX; ++x)
            visit(x, y);
    }
}

void drawSamples(const LayerMoment &moment, LayerDrawing &drawing)
{
    if (moment.view.cell < leastSampleCell)
        return drawing.notes.append(
            u"Samples are shown in cells of %1 pixels and more: enlarge the picture"_s.arg(
                leastSampleCell));
    const auto pattern = samplePattern(antialiasingOf(moment.view.traced->scene.appearance));
    forEachSeen(moment, [&](std::int64_t x, std::int64_t y) {
        const QPointF place{double(x), double(y)};
        drawing.samples.push_back({place, LayerInk::Mark});
        for (const LatticePoint &offset : pattern)
            drawing.samples.push_back({place + placeOf(offset), LayerInk::First});
    });
}

/// Whether the method computes addresses, which a question may ask for.
bool computesAddresses(const ScanTrace &trace) { return hasNumber(trace.numbers().span, "addr"); }

/// The pixels that the run has visited.
std::set<std::pair<std::int64_t, std::int64_t>> visitedPixels(const LayerMoment &moment)
{
    std::set<std::pair<std::int64_t, std::int64_t>> pixels;
    const std::size_t done = moment.trace().samplesDoneAt(moment.view.position);
    for (std::size_t sample = 0; sample < done; ++sample) {
        const PixelChange change = moment.trace().changes()[sample];
        pixels.emplace(change.x, change.y);
    }
    return pixels;
}

/// The addresses that plotPoints() writes to.
void drawMemory(const LayerMoment &moment, LayerDrawing &drawing)
{
    if (moment.view.cell < leastNumberCell)
        return drawing.notes.append(smallCellNote());
    drawing.cellNames.append(u"address"_s);
    const FrameView frame = windowOf(moment.frame());
    const ScanTrace &trace = moment.trace();
    const bool isAsked = moment.view.ahead == Ahead::Hidden
        && moment.view.position < trace.stepCount() && computesAddresses(trace);
    const auto told = isAsked ? visitedPixels(moment) : decltype(visitedPixels(moment))();
    forEachSeen(moment, [&](std::int64_t x, std::int64_t y) {
        if (isAsked && !told.contains({x, y}))
            return;
        drawing.cells.push_back(
            {x, y, QString::number(addressOf<std::int64_t>(x, y, frame)), LayerInk::Mark});
    });
}

} // namespace

Layer samplesLayer()
{
    return {.id = "samples",
            .title = QT_TRANSLATE_NOOP("core", "Sampling points"),
            .toolTip
            = "Where each pixel is sampled, and with antialiasing the 4 or 16 samples around it.",
            .source = "Triangle Rasterization slides, “Rasterization of triangles”",
            .draw = drawSamples};
}

Layer memoryLayer()
{
    return {.id = "memory",
            .title = QT_TRANSLATE_NOOP("core", "Addresses in memory"),
            .toolTip = "The address of each pixel, y·width + x, counted in pixels from the frame's "
                       "first one; the same under every method.",
            .source = "Rasterization slides, “Point Plotting”",
            .draw = drawMemory};
}

} // namespace pixelplumb
