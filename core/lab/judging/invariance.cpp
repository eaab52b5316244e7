// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/judging/invariance.h"

#include "core/oracle/oracle.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::int64_t beyondBox = 3; ///< px that a window shows around a triangle's box
constexpr LatticePoint wayOfMove = latticePixel(5003, 3001);

Triangle reordered(const Triangle &triangle, const std::array<std::size_t, 3> &order)
{
    return {
        {triangle.vertices[order[0]], triangle.vertices[order[1]], triangle.vertices[order[2]]}};
}

Triangle moved(Triangle triangle)
{
    for (Vertex &vertex : triangle.vertices) {
        vertex.position.x += wayOfMove.x;
        vertex.position.y += wayOfMove.y;
    }
    return triangle;
}

FrameView movedView(FrameView frame)
{
    frame.firstColumn += std::int32_t(wayOfMove.x / unitsPerPixel);
    frame.firstRow += std::int32_t(wayOfMove.y / unitsPerPixel);
    frame.offScreenPoint.x += wayOfMove.x;
    frame.offScreenPoint.y += wayOfMove.y;
    return frame;
}

std::int64_t coverageChanges(const std::vector<QRgb> &before, const std::vector<QRgb> &after)
{
    std::int64_t changes = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
        changes += (before[i] == 0) != (after[i] == 0) ? 1 : 0;
    return changes;
}

} // namespace

void addInvariance(const LabContender &contender, const ScanSettings &settings,
                   const Triangle &triangle, const FrameView &frame, AccuracyFigures &figures)
{
    PixelWindow window(windowAround(triangle, beyondBox, frame), frame);
    if (window.isEmpty())
        return;
    const auto pictureOf = [&](const Triangle &one, const FrameView &view) {
        window.clear();
        contender.draw(contender.runOf({{one}, {}}, settings, view), view);
        return window.pixels();
    };
    const std::vector<QRgb> asGiven = pictureOf(triangle, window.view());
    constexpr std::array<std::array<std::size_t, 3>, 2> orders = {{{1, 2, 0}, {2, 1, 0}}};
    const bool dependsOnOrder = std::ranges::any_of(orders, [&](const auto &order) {
        return pictureOf(reordered(triangle, order), window.view()) != asGiven;
    });
    const bool dependsOnPlace = pictureOf(moved(triangle), movedView(window.view())) != asGiven;
    const auto count = [](std::optional<LabShare> &share, bool fails) {
        if (!share)
            share.emplace();
        share->count += fails ? 1 : 0;
        ++share->of;
    };
    count(figures.orderFailures, dependsOnOrder);
    count(figures.translationFailures, dependsOnPlace);
}

Toggles togglesOf(const LabContender &contender, const ScanSettings &settings,
                  const std::vector<Triangle> &motion, const FrameView &frame)
{
    Toggles toggles;
    if (motion.empty())
        return toggles;
    SampleBox box = windowAround(motion.front(), beyondBox, frame);
    for (const Triangle &triangle : motion) {
        const SampleBox other = windowAround(triangle, beyondBox, frame);
        box = {std::min(box.firstX, other.firstX), std::max(box.endX, other.endX),
               std::min(box.firstY, other.firstY), std::max(box.endY, other.endY)};
    }
    PixelWindow drawn(box, frame), truth(box, frame);
    std::vector<QRgb> drawnBefore, truthBefore;
    for (const Triangle &triangle : motion) {
        drawn.clear();
        truth.clear();
        contender.draw(contender.runOf({{triangle}, {}}, settings, drawn.view()), drawn.view());
        oracle::draw(triangle, {settings, frame}, settings.rounding, truth.view());
        toggles.drawn += coverageChanges(drawnBefore, drawn.pixels());
        toggles.ofTruth += coverageChanges(truthBefore, truth.pixels());
        drawnBefore = drawn.pixels();
        truthBefore = truth.pixels();
    }
    return toggles;
}

} // namespace pixelplumb
