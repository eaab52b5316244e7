// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/search/measure.h"

#include <QCryptographicHash>

#include <set>

namespace pixelplumb::search {

namespace {

void mirror(CaseScene &scene)
{
    scene.canvas.firstRow = -(scene.canvas.firstRow + scene.canvas.height - 1);
    for (Vertex &vertex : scene.triangle.vertices)
        vertex.position.y = -vertex.position.y;
}

std::vector<CaseScene> scenesOf(const HardCase &hardCase, FillRule rule)
{
    std::vector<CaseScene> scenes;
    if (hardCase.kind == HardCaseKind::Translation) {
        for (const auto &[right, up] : hardCase.offsets) {
            CaseScene scene{hardCase.triangles.front(), hardCase.canvas};
            for (Vertex &vertex : scene.triangle.vertices) {
                vertex.position.x += right * unitsPerPixel;
                vertex.position.y += up * unitsPerPixel;
            }
            scene.canvas.firstColumn += std::int32_t(right);
            scene.canvas.firstRow += std::int32_t(up);
            scenes.push_back(scene);
        }
    } else {
        for (const Triangle &triangle : hardCase.triangles)
            scenes.push_back({triangle, hardCase.canvas});
    }
    if (rule == FillRule::TopLeft)
        std::ranges::for_each(scenes, mirror);
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

/// The hash defined by the case files, over columns in the case's own y.
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
    const CaseTruth truth(hardCase, rule);
    const std::span<const CanvasPicture> pictures = truth.pictures();
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
    case HardCaseKind::Circle:
    case HardCaseKind::Polygon:
    case HardCaseKind::Attributes:
    case HardCaseKind::Effects:
        break;
    }
    return facts;
}

} // namespace

CaseTruth::CaseTruth(const HardCase &hardCase, FillRule rule)
    : m_kind(hardCase.kind)
    , m_scenes(scenesOf(hardCase, rule))
{
    for (const CaseScene &scene : m_scenes) {
        m_pictures.emplace_back(scene.canvas);
        m_pictures.back().drawTruly(scene.triangle, rule);
    }
}

Shortfall CaseTruth::shortfallOf(const Drawing &drawing, const ScanSettings &settings) const
{
    return shortfallOf([&](const Triangle &triangle, CanvasPicture &picture) {
        drawing(Primitives{{triangle}, {}}, settings, picture.view());
        return std::int64_t(0);
    });
}

Shortfall CaseTruth::shortfallOfScan(const ScanSettings &settings) const
{
    return shortfallOf([&](const Triangle &triangle, CanvasPicture &picture) {
        return picture.drawByScan(triangle, settings);
    });
}

Shortfall CaseTruth::shortfallOf(const Draw &draw) const
{
    Shortfall shortfall;
    std::vector<int> times;
    std::vector<int> trueTimes;
    std::set<std::vector<QRgb>> distinct;
    std::optional<CanvasPicture> drawnBefore;
    for (std::size_t i = 0; i < m_scenes.size(); ++i) {
        const CanvasPicture &truth = m_pictures[i];
        CanvasPicture drawn(m_scenes[i].canvas);
        shortfall.clamped += draw(m_scenes[i].triangle, drawn);
        compare(shortfall, drawn, truth);
        if (m_kind == HardCaseKind::Mesh) {
            addCoverage(times, drawn);
            addCoverage(trueTimes, truth);
        }
        if (m_kind == HardCaseKind::Translation)
            distinct.insert(drawn.pixels());
        if (m_kind == HardCaseKind::Sequence && drawnBefore) {
            shortfall.extraToggles
                += togglesBetween(*drawnBefore, drawn) - togglesBetween(m_pictures[i - 1], truth);
        }
        drawnBefore = std::move(drawn);
    }
    for (std::size_t i = 0; i < times.size(); ++i) {
        shortfall.gaps += times[i] == 0 && trueTimes[i] > 0 ? 1 : 0;
        shortfall.overdraw += std::max(0, times[i] - trueTimes[i]);
    }
    if (!distinct.empty())
        shortfall.extraPictures = std::int64_t(distinct.size()) - 1;
    return shortfall;
}

Shortfall measure(const HardCase &hardCase, const ScanSettings &settings)
{
    return CaseTruth(hardCase, settings.fillRule).shortfallOfScan(settings);
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
    }
    for (const CanvasPicture &picture : CaseTruth(hardCase, FillRule::HalfOpenColumn).pictures())
        addCoverage(times, picture);
    return std::ranges::none_of(times, [](int each) { return each > 1; });
}

} // namespace pixelplumb::search
