// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/labrace.h"

#include "core/lab/study/drawsample.h"
#include "core/number/failure.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The straight loop that draws the triangles in the contender's place; null if none may.
StraightDraw straightDrawOf(const LabContender &contender, const ScanSettings &settings,
                            std::span<const Triangle> triangles, const FrameView &frame)
{
    const auto mayDraw = [&](const Triangle &triangle) {
        return mayDrawStraight(*contender.straight, triangle, frame);
    };
    if (!contender.straight || settings.rounding != ByteRounding::Nearest
        || !std::ranges::all_of(triangles, mayDraw))
        return nullptr;
    return contender.straight->drawUnder(settings.fillRule, frame.origin);
}

} // namespace

LabRace::Part &LabRace::partFor(const TimedFamily &part)
{
    const auto found
        = std::ranges::find_if(m_parts, [&](const Part &each) { return each.of == &part; });
    if (found != m_parts.end())
        return *found;
    Part &made = m_parts.emplace_back(Part{&part, {}});
    for (const TimedPicture &timed : part.pictures) {
        const auto first = timed.first();
        made.pictures.push_back(
            {{{first.begin(), first.end()}, {}}, FrameBuffer(timed.picture->frame)});
    }
    return made;
}

bool LabRace::enter(std::size_t row, const LabContender &contender, const TimedFamily &part,
                    const ScanSettings &settings, double expected)
{
    if (!part.isTimed() || expected > m_options.longestDraw)
        return false;
    Entry entry;
    entry.row = row;
    entry.contender = &contender;
    entry.settings = settings;
    entry.part = &partFor(part);
    for (const Picture &picture : entry.part->pictures) {
        const std::vector<Triangle> &triangles = picture.primitives.triangles;
        StraightPicture straight;
        straight.draw = straightDrawOf(contender, settings, triangles, picture.frame.view());
        if (!straight.draw) {
            entry.straight.clear();
            break;
        }
        for (const Triangle &triangle : triangles)
            straight.triangles.push_back(triangleFor(*contender.straight, triangle));
        entry.straight.push_back(std::move(straight));
    }
    m_entries.push_back(std::move(entry));
    return true;
}

void LabRace::sample(Entry &entry) const
{
    const LabContender &contender = *entry.contender;
    std::vector<Run> runs;
    for (const Picture &picture : entry.part->pictures)
        runs.push_back(contender.runOf(picture.primitives, entry.settings, picture.frame.view()));
    std::function<void()> draw = [&] {
        auto run = runs.begin();
        for (const Picture &picture : entry.part->pictures)
            contender.draw(*run++, picture.frame.view());
    };
    if (contender.loaded) { // only in families of one picture
        const Picture &picture = entry.part->pictures.front();
        contender.loaded->load(picture.primitives, picture.frame.view());
        draw = contender.loaded->draw;
    }
    entry.samples.push_back(sampleDraw(draw, entry.drawsPerSample, m_options.sampleNanoseconds));
    if (entry.straight.empty())
        return;
    const auto drawStraight = [&] {
        auto straight = entry.straight.begin();
        for (const Picture &picture : entry.part->pictures) {
            const RawFrame raw = rawFrameFor(*contender.straight, picture.frame.view());
            for (const Triangle &triangle : straight->triangles)
                straight->draw(triangle, raw);
            ++straight;
        }
    };
    entry.straightSamples.push_back(
        sampleDraw(drawStraight, entry.straightDrawsPerSample, m_options.sampleNanoseconds));
}

bool LabRace::runRound(int round, const ProgressListener &listener, std::size_t firstEntry)
{
    const std::size_t count = m_entries.size() - firstEntry;
    for (std::size_t turn = 0; turn < count; ++turn) {
        if (!goesOn(listener, {JobPhase::Measuring, std::int64_t(turn), std::int64_t(count)}))
            return false;
        // Each round begins with another entry, so that none always follows the same neighbour.
        Entry &entry = m_entries[firstEntry + (turn + std::size_t(round)) % count];
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
