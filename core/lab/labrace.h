// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/lab/study.h"

#include <list>

namespace pixelplumb {

struct RaceOptions {
    double sampleNanoseconds = 1.5e6; ///< a sample draws as often as fills this
    double longestDraw = 100e6; ///< ns; who takes longer is not timed
    std::int64_t timedPixels = 400'000; ///< of a family, about
    std::int64_t timedBoxPixels = 2'500'000; ///< in the boxes of these triangles, about
};

/// What everyone draws of a family.
struct TimedFamily {
    const LabFamily *family = nullptr;
    std::size_t triangles = 0; ///< the first ones
    StudyFamily described;

    bool isTimed() const { return triangles > 0; }
};

/// Families of many pictures are not timed: their frames differ.
TimedFamily timedPartOf(const LabFamily &family, const RaceOptions &options);

/// Times rows of a study in turn, on one thread, by the thread's own processor time: what other
/// programs take does not count, and what slows the machine for a while slows all.
class LabRace {
public:
    explicit LabRace(const RaceOptions &options)
        : m_options(options)
    {
    }

    /// The contender, the family's part and its family live as long as this. `expected`: ns that a
    /// draw of the part may take. False where that is too long.
    bool enter(std::size_t row, const LabContender &contender, const TimedFamily &part,
               const ScanSettings &settings, double expected);

    /// One sample of everyone. False where the listener, who hears of each, ended it: what was
    /// sampled stays.
    bool runRound(int round, int rounds, const ProgressListener &listener);

    struct Result {
        std::size_t row = 0;
        CostFigures cost; ///< without operations; of no rounds where none was taken
        std::optional<QString> failure; ///< what was thrown
    };
    std::vector<Result> results() const;

private:
    struct Entry {
        std::size_t row = 0;
        const LabContender *contender = nullptr;
        ScanSettings settings;
        const Primitives *primitives = nullptr;
        const FrameBuffer *frame = nullptr;
        std::vector<Triangle> forStraight; ///< empty where no straight loop may draw them
        int drawsPerSample = 0; ///< 0: not yet known
        int straightDrawsPerSample = 0;
        std::vector<double> samples = {}; ///< ns a draw
        std::vector<double> straightSamples = {};
        std::optional<QString> failure = {};
    };
    struct Part {
        const TimedFamily *of;
        Primitives primitives;
        FrameBuffer frame;
    };

    void sample(Entry &entry) const;
    Part &partFor(const TimedFamily &part);

    RaceOptions m_options;
    std::list<Part> m_parts;
    std::vector<Entry> m_entries;
};

} // namespace pixelplumb
