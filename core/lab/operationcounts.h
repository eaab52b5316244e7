// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/operation.h"
#include "core/methods/method.h"
#include "core/number/jobprogress.h"

#include <QString>

#include <optional>

namespace pixelplumb {

/// How many operations of each kind, by Operation.
using OperationRow = std::array<std::int64_t, allOperations.size()>;

/// The résumé of one run: the operations that a kernel's numbers carried out, to the last one, and
/// for what. They are counted as the code says them: a compiler may drop some that are the same.
/// Not counted: whole sample coordinates (loop counters, addresses, clipping to the frame, the
/// clamp of a level to a byte), and the order of a triangle's vertices and the side of its long
/// edge; they are the same in every arithmetic.
struct OperationCounts {
    std::array<OperationRow, allWorkStages.size()> stages = {}; ///< by WorkStage
    std::int64_t primitives = 0; ///< begun, whether or not the frame shows them
    std::int64_t spans = 0;
    std::int64_t pixels = 0; ///< written
    std::int64_t refused = 0; ///< samples that were tested and not written
    /// Edges that the rows of polygons looked at, by an edge table, and that they would have looked
    /// at without one, all edges on every row; 0 where there is no such table.
    std::int64_t edgesLookedAt = 0, edgesOfRows = 0;

    const OperationRow &of(WorkStage stage) const { return stages[std::size_t(stage)]; }
    std::int64_t of(WorkStage stage, Operation operation) const
    {
        return of(stage)[std::size_t(operation)];
    }
    /// All stages together.
    OperationRow totals() const;
    /// All kinds together.
    std::int64_t total(WorkStage stage) const;
    std::int64_t total() const;
    /// What a stage's counts are shared out over: primitives, spans, samples (written or not).
    std::int64_t timesOf(WorkStage stage) const;
    /// A stage's operations each time, on the average; 0 where it never came.
    double perTime(WorkStage stage, Operation operation) const;
    /// The part of all operations that the set-up has, 0 … 1; 0 where there are none.
    double setUpShare() const;

    friend bool operator==(const OperationCounts &, const OperationCounts &) = default;
};

/// What the résumé of a method leaves out, or why it has none, or which of its operations are
/// whose, in words; empty where there is nothing to add.
QString countingGap(const Method &method, Arithmetic arithmetic);
/// Whether the operations of a method can be counted at all.
bool isCounted(const Method &method);

/// Draws the primitives (sample coordinates) as method.draw() does, the same picture bit for bit,
/// and counts. None when isCounted() is false, or when the listener ended it. A counted run takes
/// some ten times as long as a drawing.
std::optional<OperationCounts> countOperations(const Method &method, const ScanSettings &settings,
                                               const Primitives &primitives, FrameView frame,
                                               const ProgressListener &progress = {});

} // namespace pixelplumb
