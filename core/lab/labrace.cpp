// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/labrace.h"

#include "core/lab/contenderfailure.h"
#include "core/lab/drawsample.h"
#include "core/lab/pixelwindow.h"
#include "core/measure/writecount.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::size_t fewestTimed = 3; ///< triangles, where a family has them
constexpr std::int64_t cacheLineBytes = 64;

std::int64_t pixelsIn(const SampleBox &box)
{
    return box.isEmpty() ? 0 : (box.endX - box.firstX) * (box.endY - box.firstY);
}

/// px of the triangle's area, no more than its box within the frame.
std::int64_t aboutPixels(const Triangle &triangle, const SampleBox &box)
{
    const auto area
        = std::int64_t(absolute(doubledArea(triangle)) / (2 * unitsPerPixel * unitsPerPixel));
    return std::min(area, pixelsIn(box));
}

/// Of the cache lines that a picture writes to.
std::int64_t bytesOfLines(const FrameView &frame)
{
    constexpr auto perLine = cacheLineBytes / std::int64_t(sizeof(QRgb));
    std::int64_t lines = 0;
    for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
        const QRgb *const row = frame.at(frame.firstColumn, y);
        for (std::int64_t x = 0; x < frame.width; x += perLine) {
            const auto end = std::min<std::int64_t>(x + perLine, frame.width);
            lines += std::any_of(row + x, row + end, [](QRgb pixel) { return pixel != 0; }) ? 1 : 0;
        }
    }
    return lines * cacheLineBytes;
}

bool mayDrawStraight(const LabContender &contender, const LabFamily &family,
                     const ScanSettings &settings)
{
    // 16.16 wraps on slopes that steep sub-pixel edges have, and a straight loop clips nothing.
    const bool fits = settings.arithmetic != Arithmetic::Fixed16 || family.isOnWholePixels;
    return contender.straight && family.staysInside && fits && settings.fillRule == FillRule::Closed
        && settings.rounding == ByteRounding::Nearest;
}

} // namespace

TimedFamily timedPartOf(const LabFamily &family, const RaceOptions &options)
{
    TimedFamily part;
    part.family = &family;
    part.described.id = family.id;
    part.described.title = family.title;
    if (const LabFamilyInfo *info = labFamilyNamed(family.id))
        part.described.stresses = QString::fromUtf8(info->stresses);
    part.described.triangles = std::int64_t(family.triangleCount());
    if (family.pictures.size() != 1)
        return part;
    const LabPicture &picture = family.pictures.front();
    FrameSpec black = picture.frame;
    black.background = {};
    const FrameBuffer frame(black);
    std::int64_t pixels = 0, boxPixels = 0;
    for (const Triangle &triangle : picture.triangles) {
        if (part.triangles >= fewestTimed
            && (pixels > options.timedPixels || boxPixels > options.timedBoxPixels))
            break;
        ++part.triangles;
        const SampleBox box = windowAround(triangle, 0, frame.view());
        pixels += aboutPixels(triangle, box);
        boxPixels += pixelsIn(box);
        part.described.timedColumns += std::max<std::int64_t>(0, box.endX - box.firstX);
        part.described.timedRows += std::max<std::int64_t>(0, box.endY - box.firstY);
    }
    const auto first = std::span(picture.triangles).first(part.triangles);
    const Method &scan = *methodNamed(u"column-scan");
    const ScanSettings exact
        = scan.adapted({Arithmetic::Exact, family.settings.fillRule, ByteRounding::Nearest});
    part.described.timedTriangles = std::int64_t(part.triangles);
    part.described.timedPixels
        = std::int64_t(countWrites(first, exact.fillRule, black, {}).value_or(0));
    std::vector<Triangle> white(first.begin(), first.end());
    for (Triangle &triangle : white) {
        for (Vertex &vertex : triangle.vertices)
            vertex.colour = {{255, 255, 255}};
    }
    FrameView transparent = frame.view();
    for (std::int64_t y = transparent.firstRow; y < transparent.endRow(); ++y)
        std::fill_n(transparent.at(transparent.firstColumn, y), transparent.width, 0U);
    scan.drawFastest({white, {}}, exact, transparent);
    part.described.timedBytes = bytesOfLines(transparent);
    if (part.described.timedPixels == 0)
        part.triangles = 0;
    return part;
}

LabRace::Part &LabRace::partFor(const TimedFamily &part)
{
    const auto found
        = std::ranges::find_if(m_parts, [&](const Part &each) { return each.of == &part; });
    if (found != m_parts.end())
        return *found;
    const LabPicture &picture = part.family->pictures.front();
    const auto first = std::span(picture.triangles).first(part.triangles);
    m_parts.push_back({&part, {{first.begin(), first.end()}, {}}, FrameBuffer(picture.frame)});
    return m_parts.back();
}

bool LabRace::enter(std::size_t row, const LabContender &contender, const TimedFamily &part,
                    const ScanSettings &settings, double expected)
{
    if (!part.isTimed() || expected > m_options.longestDraw)
        return false;
    Part &timed = partFor(part);
    Entry entry;
    entry.row = row;
    entry.contender = &contender;
    entry.settings = settings;
    entry.primitives = &timed.primitives;
    entry.frame = &timed.frame;
    if (mayDrawStraight(contender, *part.family, settings)) {
        for (const Triangle &triangle : timed.primitives.triangles)
            entry.forStraight.push_back(triangleFor(*contender.straight, triangle));
    }
    m_entries.push_back(std::move(entry));
    return true;
}

void LabRace::sample(Entry &entry) const
{
    const FrameView frame = entry.frame->view();
    const LabContender &contender = *entry.contender;
    entry.samples.push_back(
        sampleDraw([&] { contender.draw(*entry.primitives, entry.settings, frame); },
                   entry.drawsPerSample, m_options.sampleNanoseconds));
    if (entry.forStraight.empty())
        return;
    const RawFrame raw = rawFrameFor(*contender.straight, frame);
    const auto drawStraight = [&] {
        for (const Triangle &triangle : entry.forStraight)
            contender.straight->draw(triangle, raw);
    };
    entry.straightSamples.push_back(
        sampleDraw(drawStraight, entry.straightDrawsPerSample, m_options.sampleNanoseconds));
}

bool LabRace::runRound(int round, int rounds, const ProgressListener &listener)
{
    const auto count = std::int64_t(m_entries.size());
    for (std::int64_t turn = 0; turn < count; ++turn) {
        if (!goesOn(listener, {JobPhase::Measuring, round * count + turn, rounds * count}))
            return false;
        // Each round begins with another one: nobody always follows the same neighbour.
        Entry &entry = m_entries[std::size_t((turn + round) % count)];
        if (entry.failure)
            continue;
        if (const auto why = failureOf([&] { sample(entry); }))
            entry.failure = *why;
    }
    return true;
}

std::vector<LabRace::Result> LabRace::results() const
{
    std::vector<Result> results;
    for (const Entry &entry : m_entries) {
        Result &result = results.emplace_back();
        result.row = entry.row;
        result.failure = entry.failure;
        if (entry.samples.empty())
            continue;
        result.cost.perDraw = spreadOf(entry.samples);
        result.cost.rounds = int(entry.samples.size());
        const std::size_t both = std::min(entry.samples.size(), entry.straightSamples.size());
        if (both == 0)
            continue;
        result.cost.straight = spreadOf(entry.straightSamples);
        std::vector<double> ratios;
        for (std::size_t i = 0; i < both; ++i)
            ratios.push_back(entry.samples[i] / entry.straightSamples[i]);
        result.cost.timesStraight = spreadOf(ratios);
    }
    return results;
}

} // namespace pixelplumb
