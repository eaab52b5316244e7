// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/search/measure.h"

#include "tests/search/canvaspicture.h"

#include <QCryptographicHash>

#include <set>

namespace pixelplumb::search {

namespace {

/// A triangle and the canvas that it is drawn on.
struct Scene {
    Triangle triangle;
    FrameSpec canvas;
};

/// The pictures that a case asks for: one a triangle, a frame or a place.
std::vector<Scene> scenesOf(const HardCase &hardCase)
{
    std::vector<Scene> scenes;
    for (const Triangle &triangle : hardCase.triangles)
        scenes.push_back({triangle, hardCase.canvas});
    if (hardCase.kind != HardCaseKind::Translation)
        return scenes;
    scenes.clear();
    for (const auto &[right, up] : hardCase.offsets) {
        Scene scene{hardCase.triangles.front(), hardCase.canvas};
        for (Vertex &vertex : scene.triangle.vertices) {
            vertex.position.x += right * unitsPerPixel;
            vertex.position.y += up * unitsPerPixel;
        }
        scene.canvas.firstColumn += std::int32_t(right);
        scene.canvas.firstRow += std::int32_t(up);
        scenes.push_back(scene);
    }
    return scenes;
}

std::int64_t togglesBetween(const CanvasPicture &before, const CanvasPicture &after)
{
    std::int64_t toggles = 0;
    for (std::size_t i = 0; i < before.pixels().size(); ++i)
        toggles += (before.pixels()[i] != 0) != (after.pixels()[i] != 0) ? 1 : 0;
    return toggles;
}

void compare(Shortfall &shortfall, const CanvasPicture &drawn, const CanvasPicture &truth)
{
    for (std::size_t i = 0; i < drawn.pixels().size(); ++i) {
        const QRgb pixel = drawn.pixels()[i];
        const QRgb expected = truth.pixels()[i];
        if (pixel == expected)
            continue;
        if (pixel == 0)
            ++shortfall.missing;
        else if (expected == 0)
            ++shortfall.extra;
        else
            ++shortfall.wrongBytes;
    }
}

void addCoverage(std::vector<int> &times, const CanvasPicture &picture)
{
    times.resize(picture.pixels().size());
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i] += picture.pixels()[i] != 0 ? 1 : 0;
}

/// Under the top-left rule a case's y points down: drawn mirrored, in a mirrored canvas.
CanvasPicture truthOf(const Scene &scene, FillRule rule)
{
    Triangle triangle = scene.triangle;
    FrameSpec canvas = scene.canvas;
    if (rule == FillRule::TopLeft) {
        canvas.firstRow = -(canvas.firstRow + canvas.height - 1);
        for (Vertex &vertex : triangle.vertices)
            vertex.position.y = -vertex.position.y;
    }
    CanvasPicture picture(canvas);
    picture.drawTruly(triangle, rule);
    return picture;
}

/// The hash that the case files define, over columns in the case's own y.
QByteArray spanHash(const CanvasPicture &picture, FillRule rule)
{
    const FrameSpec &canvas = picture.canvas();
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (std::int64_t column = 0; column < canvas.width; ++column) {
        std::optional<std::int64_t> lowest;
        std::int64_t highest = 0;
        for (std::int64_t row = 0; row < canvas.height; ++row) {
            if (picture.pixels()[std::size_t(row * canvas.width + column)] == 0)
                continue;
            if (!lowest)
                lowest = row;
            highest = row;
        }
        if (!lowest)
            continue;
        std::int64_t from = canvas.firstRow + *lowest;
        std::int64_t to = canvas.firstRow + highest;
        if (rule == FillRule::TopLeft) {
            std::swap(from, to);
            from = -from;
            to = -to;
        }
        hash.addData(QByteArray::number(qint64(canvas.firstColumn + column)) + ' '
                     + QByteArray::number(qint64(from)) + ' ' + QByteArray::number(qint64(to))
                     + '\n');
    }
    return hash.result().toHex().first(16);
}

ExpectedFacts factsUnder(const HardCase &hardCase, FillRule rule)
{
    ExpectedFacts facts;
    std::vector<CanvasPicture> pictures;
    for (const Scene &scene : scenesOf(hardCase))
        pictures.push_back(truthOf(scene, rule));
    switch (hardCase.kind) {
    case HardCaseKind::Triangle: {
        facts.pixelCount = pictures.front().count();
        facts.spanHash = spanHash(pictures.front(), rule);
        facts.channelSums.emplace();
        for (const QRgb pixel : pictures.front().pixels()) {
            const Colour colour = unpacked(pixel);
            for (std::size_t channel = 0; channel < 3; ++channel)
                (*facts.channelSums)[channel] += colour.channels[channel];
        }
        break;
    }
    case HardCaseKind::Mesh: {
        std::vector<int> times;
        for (const CanvasPicture &picture : pictures)
            addCoverage(times, picture);
        for (const int each : times) {
            if (each > 0)
                ++facts.histogram[each];
        }
        break;
    }
    case HardCaseKind::Sequence:
        facts.toggles = 0;
        for (std::size_t frame = 0; frame < pictures.size(); ++frame) {
            facts.frameCounts.push_back(pictures[frame].count());
            if (frame > 0)
                *facts.toggles += togglesBetween(pictures[frame - 1], pictures[frame]);
        }
        break;
    case HardCaseKind::Translation: {
        std::set<std::vector<QRgb>> distinct;
        for (const CanvasPicture &picture : pictures)
            distinct.insert(picture.pixels());
        facts.pixelCount = pictures.front().count();
        facts.distinctPictures = std::int64_t(distinct.size());
        break;
    }
    case HardCaseKind::Invalid:
    case HardCaseKind::Line:
        break;
    }
    return facts;
}

} // namespace

Shortfall measure(const HardCase &hardCase, const ScanSettings &settings)
{
    Shortfall shortfall;
    std::vector<int> times;
    std::vector<int> trueTimes;
    std::set<std::vector<QRgb>> distinct;
    std::optional<CanvasPicture> drawnBefore;
    std::optional<CanvasPicture> truthBefore;
    for (const Scene &scene : scenesOf(hardCase)) {
        CanvasPicture drawn(scene.canvas);
        shortfall.clamped += drawn.drawByScan(scene.triangle, settings);
        CanvasPicture truth(scene.canvas);
        truth.drawTruly(scene.triangle, settings.fillRule);
        compare(shortfall, drawn, truth);
        if (hardCase.kind == HardCaseKind::Mesh) {
            addCoverage(times, drawn);
            addCoverage(trueTimes, truth);
        }
        if (hardCase.kind == HardCaseKind::Translation)
            distinct.insert(drawn.pixels());
        if (hardCase.kind == HardCaseKind::Sequence && drawnBefore) {
            shortfall.extraToggles
                += togglesBetween(*drawnBefore, drawn) - togglesBetween(*truthBefore, truth);
        }
        drawnBefore = std::move(drawn);
        truthBefore = std::move(truth);
    }
    for (std::size_t i = 0; i < times.size(); ++i) {
        shortfall.gaps += times[i] == 0 && trueTimes[i] > 0 ? 1 : 0;
        shortfall.overdraw += std::max(0, times[i] - trueTimes[i]);
    }
    if (!distinct.empty())
        shortfall.extraPictures = std::int64_t(distinct.size()) - 1;
    return shortfall;
}

void deriveFacts(HardCase &hardCase)
{
    for (const FillRule rule : {FillRule::Closed, FillRule::HalfOpenColumn, FillRule::TopLeft})
        hardCase.facts[rule] = factsUnder(hardCase, rule);
}

bool isProperMesh(const HardCase &hardCase)
{
    std::vector<int> times;
    for (const Triangle &triangle : hardCase.triangles) {
        if (doubledArea(triangle) <= 0)
            return false;
        addCoverage(times, truthOf({triangle, hardCase.canvas}, FillRule::HalfOpenColumn));
    }
    return std::ranges::none_of(times, [](int each) { return each > 1; });
}

} // namespace pixelplumb::search
