// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/agreement.h"
#include "core/compare/carriedagreement.h"
#include "core/compare/deviation.h"
#include "core/runs/contender.h"

namespace pixelplumb {

inline constexpr std::size_t fewestContenders = 2;
inline constexpr std::size_t mostContenders = 4;

/// How one contender did.
struct ContenderTally {
    std::int64_t written = 0; ///< pixels
    DifferenceCounts againstTruth; ///< under the contender's own rule
    /// Pixels where primitives that the method cannot draw change the truth.
    std::int64_t undrawn = 0;
    std::vector<std::int64_t> differsFrom; ///< pixels, by contender

    friend bool operator==(const ContenderTally &, const ContenderTally &) = default;
};

/// A contender with its finished picture and, where it was recorded, its run.
struct ContenderRun {
    ContenderRun(const Contender &of, const FrameSpec &spec)
        : contender(of)
        , picture(spec)
        , truth(spec)
    {
    }

    /// Whether primitives that the method does not draw change the truth at the pixel.
    bool isUndrawn(std::int64_t x, std::int64_t y) const
    {
        return wholeTruth && *wholeTruth->view().at(x, y) != *truth.view().at(x, y);
    }

    Contender contender;
    ContenderTally tally;
    WrittenFrame picture;
    WrittenFrame truth; ///< under its own rule, for the primitives that the method draws
    /// The truth of all primitives, where the method does not draw every kind.
    std::optional<WrittenFrame> wholeTruth;
    std::optional<WrittenFrame> inExactArithmetic; ///< see JudgedRun
    std::shared_ptr<const TracedScene> traced; ///< null for the truth, and where no recording was
                                               ///< asked for
};

/// Which contenders are recorded, not just drawn.
enum class Recorded {
    /// Those that differ from the truth, so that reasons can be given, and those that carry more
    /// than colour, which no picture shows.
    WhereNeeded,
    All, ///< every method, to be stepped through
};

struct ContestOptions {
    Recorded recorded = Recorded::WhereNeeded;
    ProgressListener progress;
};

/// One scene drawn by several contenders, and where their pictures differ. A value that views
/// receive whole and never change.
struct Contest {
    Scene scene;
    Primitives primitives; ///< in sample coordinates
    std::vector<ContenderRun> runs;
    AgreementMap agreement; ///< of the pictures
    std::vector<CarriedAgreement> carried; ///< on what no picture shows: z, u, v and N

    JudgedRun judged(std::size_t run) const;
};

/// Null when options.progress cancelled it. Each contender must accept its settings
/// (Method::refusal).
std::shared_ptr<const Contest> compareContenders(const Scene &scene,
                                                 const std::vector<Contender> &contenders,
                                                 const ContestOptions &options = {});

/// One contender's result at a pixel, in words.
struct PixelOpinion {
    bool written = false;
    Colour colour;
    Deviation deviation; ///< from the truth under its own rule
    QString words; ///< empty where the contender is right
};

/// Everything about one pixel of a contest.
struct PixelComparison {
    std::int64_t x = 0;
    std::int64_t y = 0;
    int agreeing = 0;
    Disagreement reason = Disagreement::None;
    std::vector<PixelOpinion> opinions; ///< by contender
};

/// (x, y) must lie inside the frame.
PixelComparison comparePixel(const Contest &contest, std::int64_t x, std::int64_t y);

} // namespace pixelplumb
