// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/lab/study/timedfamily.h"

#include <list>

namespace pixelplumb {

struct RaceOptions {
    double sampleNanoseconds = 1.5e6; ///< a sample draws as often as fills this
    double longestDraw = 100e6; ///< ns; a longer draw is not timed
};

/// Times rows of a study in turn, on one thread, by that thread's processor time: other programs'
/// time does not count, and what slows the machine for a while slows all rows.
class LabRace {
public:
    explicit LabRace(const RaceOptions &options)
        : m_options(options)
    {
    }

    /// The contender, the family's part and its family must outlive this. `expected`: ns that a
    /// draw of the part may take. False if that is too long.
    bool enter(std::size_t row, const LabContender &contender, const TimedFamily &part,
               const ScanSettings &settings, double expected);

    std::size_t entries() const { return m_entries.size(); }

    /// Takes one sample of every entry from the given one on. False if the listener, called for
    /// each, ended it: samples already taken stay.
    bool runRound(int round, const ProgressListener &listener, std::size_t firstEntry = 0);

    struct Result {
        std::size_t row = 0;
        CostFigures cost; ///< without operations; of no rounds where none was taken
        std::optional<QString> failure; ///< what was thrown
    };
    std::vector<Result> results() const;

private:
    struct Picture {
        Primitives primitives;
        FrameBuffer frame;
    };
    struct Part {
        const TimedFamily *of;
        std::list<Picture> pictures;
    };
    /// A picture as the straight loop needs it.
    struct StraightPicture {
        std::vector<Triangle> triangles;
        StraightDraw draw = nullptr;
    };
    struct Entry {
        std::size_t row = 0;
        const LabContender *contender = nullptr;
        ScanSettings settings;
        const Part *part = nullptr;
        std::vector<StraightPicture> straight = {}; ///< empty if one of them may not be drawn so
        int drawsPerSample = 0; ///< 0: not yet known
        int straightDrawsPerSample = 0;
        std::vector<double> samples = {}; ///< ns a draw
        std::vector<double> straightSamples = {};
        std::optional<QString> failure = {};
    };

    void sample(Entry &entry) const;
    Part &partFor(const TimedFamily &part);

    RaceOptions m_options;
    std::list<Part> m_parts;
    std::vector<Entry> m_entries;
};

} // namespace pixelplumb
