// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/effectstudy.h"

#include "core/frame/framebuffer.h"
#include "core/lab/contenders/effectloop.h"
#include "core/lab/study/drawsample.h"
#include "core/lab/study/effectscenes.h"
#include "core/runs/tracedscene.h"

#include <cmath>
#include <functional>
#include <memory>

namespace pixelplumb {

namespace {

constexpr double sampleNanoseconds = 1e6;
constexpr std::array arithmetics = {Arithmetic::Exact, Arithmetic::Float32};

const QString kernelGroup = "kernel of ";
const QString kernelWay = "kernel";

/// A way with its row, and what it is timed by.
struct Entry {
    EffectRow row;
    std::size_t first = 0; ///< the row that it is compared with
    std::unique_ptr<FrameBuffer> frame;
    std::function<void(FrameView)> draw;
    int draws = 0; ///< per sample; 0: not yet known
    std::vector<double> samples; ///< ns a draw

    Entry(const QString &group, const QString &way, Arithmetic arithmetic, const FrameSpec &spec,
          std::function<void(FrameView)> drawing)
        : frame(std::make_unique<FrameBuffer>(spec))
        , draw(std::move(drawing))
    {
        row.group = group;
        row.way = way;
        row.arithmetic = arithmetic;
        draw(frame->view());
    }
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
            entry.draw(entry.frame->view());
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

/// Adds the ways of a scene, in each arithmetic that its method supports.
void addWays(const effectscenes::Group &group, std::vector<Entry> &entries)
{
    const FrameBuffer truth = truthOf(group.truth);
    for (const Arithmetic arithmetic : arithmetics) {
        const std::size_t first = entries.size();
        for (const effectscenes::Way &way : group.ways) {
            const Method *method = methodNamed(QString::fromStdString(way.scene.method));
            if (!method->supports(arithmetic))
                continue;
            ScanSettings settings = way.scene.settings;
            settings.arithmetic = arithmetic;
            Entry &entry
                = entries.emplace_back(group.name, way.name, arithmetic, way.scene.frame,
                                       [run = Run(method, primitivesOnSamples(way.scene), settings,
                                                  windowOf(way.scene.frame), Kernels::Plain)](
                                           FrameView frame) { run.draw(frame); });
            entry.first = first;
            entry.row.distance = way.distance;
            entry.row.brightness = way.brightness;
            if (way.truth)
                judge(entry.row, *entry.frame, truthOf(*way.truth));
            else
                judge(entry.row, *entry.frame, truth);
        }
    }
}

/// Adds a straight loop and the kernel of its effects, whose picture judges both.
void addKernel(const EffectLoop &loop, std::vector<Entry> &entries)
{
    const QString group = kernelGroup + QString::fromLatin1(loop.name);
    const EffectLoopScene scene(loop);
    const auto add = [&](const QString &way, const std::function<void(FrameView)> &draw) {
        entries.emplace_back(group, way, Arithmetic::Float32, scene.frame, draw);
    };
    add("straight loop",
        [scene, loop](FrameView frame) { loop.draw(scene.run.primitives, frame); });
    add(kernelWay, [scene](FrameView frame) { scene.run.draw(frame); });
    for (std::size_t i = entries.size() - 2; i < entries.size(); ++i) {
        entries[i].first = entries.size() - 2;
        judge(entries[i].row, *entries[i].frame, *entries.back().frame);
    }
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

bool EffectRow::isTooSlow() const
{
    return timesFirst && timesFirst->median > mostTimesLoop && way == kernelWay
        && group.startsWith(kernelGroup);
}

std::optional<std::vector<EffectRow>> runEffectStudy(int rounds, const ProgressListener &listener)
{
    const std::vector<effectscenes::Group> groups = effectscenes::all();
    std::vector<Entry> entries;
    std::int64_t done = 0;
    const std::int64_t steps = std::int64_t(groups.size()) + 1 + rounds;
    for (const effectscenes::Group &group : groups) {
        if (!goesOn(listener, {JobPhase::Judging, done++, steps}))
            return std::nullopt;
        addWays(group, entries);
    }
    if (!goesOn(listener, {JobPhase::Judging, done++, steps}))
        return std::nullopt;
    for (const EffectLoop &loop : effectLoops())
        addKernel(loop, entries);
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
