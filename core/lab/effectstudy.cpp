// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/effectstudy.h"

#include "core/frame/framebuffer.h"
#include "core/lab/drawsample.h"
#include "core/lab/effectscenes.h"
#include "core/runs/tracedscene.h"

#include <cmath>

namespace pixelplumb {

namespace {

constexpr double sampleNanoseconds = 1e6;
constexpr std::array arithmetics = {Arithmetic::Exact, Arithmetic::Float32};

/// A way with its row, and what it is timed by.
struct Entry {
    EffectRow row;
    std::size_t first = 0; ///< the row that it is measured by
    const Method *method = nullptr;
    Primitives primitives;
    ScanSettings settings;
    std::unique_ptr<FrameBuffer> frame;
    int draws = 0; ///< of a sample; 0: not yet known
    std::vector<double> samples; ///< ns a draw
};

FrameBuffer truthOf(const Scene &scene)
{
    FrameBuffer frame(scene.frame);
    drawTruth(scene, frame);
    return frame;
}

void judge(EffectRow &row, const FrameBuffer &drawn, const FrameBuffer &truth)
{
    const FrameView frame = drawn.view();
    const QRgb background = packed(drawn.spec().background);
    double squares = 0;
    for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
        for (std::int64_t x = frame.firstColumn; x < frame.endColumn(); ++x) {
            const QRgb is = *frame.at(x, y);
            const QRgb wanted = *truth.view().at(x, y);
            row.pixels += is != background ? 1 : 0;
            row.wrongPixels += is != wanted ? 1 : 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double off
                    = double(unpacked(is).channels[i]) - double(unpacked(wanted).channels[i]);
                squares += off * off;
            }
        }
    }
    row.rms = std::sqrt(squares / (3.0 * frame.width * frame.height));
}

void sample(Entry &entry)
{
    const double time = sampleDraw(
        [&] {
            entry.frame->clear();
            entry.method->draw(entry.primitives, entry.settings, entry.frame->view());
        },
        entry.draws, sampleNanoseconds);
    entry.samples.push_back(time);
}

void setTimes(Entry &entry, const Entry &first)
{
    if (entry.samples.empty())
        return;
    entry.row.perPixel = scaled(spreadOf(entry.samples),
                                1.0 / double(std::max<std::int64_t>(1, entry.row.pixels)));
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(entry.samples.size(), first.samples.size()); ++i)
        ratios.push_back(entry.samples[i] / first.samples[i]);
    entry.row.timesFirst = spreadOf(ratios);
}

} // namespace

std::optional<BrightnessRange> brightnessRangeOf(const std::vector<EffectRow> &rows,
                                                 const QString &group)
{
    std::optional<BrightnessRange> range;
    for (const EffectRow &row : rows) {
        if (row.group != group || !row.brightness)
            continue;
        const double brightness = *row.brightness;
        range = range ? BrightnessRange{std::min(range->least, brightness),
                                        std::max(range->greatest, brightness)}
                      : BrightnessRange{brightness, brightness};
    }
    return range;
}

std::optional<std::vector<EffectRow>> runEffectStudy(int rounds, const ProgressListener &listener)
{
    const std::vector<effectscenes::Group> groups = effectscenes::all();
    std::vector<Entry> entries;
    std::int64_t done = 0;
    const std::int64_t steps = std::int64_t(groups.size()) + rounds;
    for (const effectscenes::Group &group : groups) {
        if (!goesOn(listener, {JobPhase::Judging, done++, steps}))
            return std::nullopt;
        const FrameBuffer truth = truthOf(group.truth);
        for (const Arithmetic arithmetic : arithmetics) {
            const std::size_t first = entries.size();
            for (const effectscenes::Way &way : group.ways) {
                const Method *method = methodNamed(QString::fromStdString(way.scene.method));
                if (!method->supports(arithmetic))
                    continue;
                Entry &entry = entries.emplace_back();
                entry.first = first;
                entry.row.group = group.name;
                entry.row.way = way.name;
                entry.row.arithmetic = arithmetic;
                entry.row.distance = way.distance;
                entry.row.brightness = way.brightness;
                entry.method = method;
                entry.primitives = primitivesOnSamples(way.scene);
                entry.settings = way.scene.settings;
                entry.settings.arithmetic = arithmetic;
                entry.frame = std::make_unique<FrameBuffer>(way.scene.frame);
                method->draw(entry.primitives, entry.settings, entry.frame->view());
                if (way.truth)
                    judge(entry.row, *entry.frame, truthOf(*way.truth));
                else
                    judge(entry.row, *entry.frame, truth);
            }
        }
    }
    for (int round = 0; round < rounds; ++round) {
        if (!goesOn(listener, {JobPhase::Measuring, done++, steps}))
            return std::nullopt;
        for (Entry &entry : entries)
            sample(entry);
    }
    std::vector<EffectRow> rows;
    for (Entry &entry : entries) {
        setTimes(entry, entries[entry.first]);
        rows.push_back(std::move(entry.row));
    }
    return rows;
}

} // namespace pixelplumb
