// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/counting/operation.h"
#include "core/methods/method.h"
#include "core/number/jobprogress.h"

#include <QString>

#include <optional>

namespace pixelplumb {

/// How many operations of each kind, by Operation.
using OperationRow = std::array<std::int64_t, allOperations.size()>;

/// The résumé of one run: every operation that a kernel's numbers carried out, and for what. They
/// are counted as the code states them: a compiler may merge equal ones. Not counted: whole sample
/// coordinates (loop counters, addresses, clipping to the frame, the clamp of a level to a byte),
/// and the order of a triangle's vertices and the side of its long edge; they are the same in every
/// arithmetic.
struct OperationCounts {
    std::array<OperationRow, allWorkStages.size()> stages = {}; ///< by WorkStage
    std::int64_t primitives = 0; ///< begun, whether or not the frame shows them
    std::int64_t spans = 0;
    std::int64_t pixels = 0; ///< written
    std::int64_t refused = 0; ///< samples that were tested and not written
    /// Edges that the rows of polygons looked at by an edge table, and those that they would have
    /// looked at without one, all edges on every row; 0 if there is no such table.
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
    /// How often a stage ran: primitives, spans, samples (written or not).
    std::int64_t timesOf(WorkStage stage) const;
    /// A stage's operations per run, on average; 0 if it never ran.
    double perTime(WorkStage stage, Operation operation) const;
    /// The set-up's share of all operations, 0 … 1; 0 if there are none.
    double setUpShare() const;

    friend bool operator==(const OperationCounts &, const OperationCounts &) = default;
};

/// What a method's résumé leaves out, why it has none, or which operations belong to what, in
/// words; empty if there is nothing to add.
QString countingGap(const Method &method, Arithmetic arithmetic);
/// Whether the operations of a method can be counted at all.
bool isCounted(const Method &method);

/// Draws the primitives (sample coordinates) like method.draw(), the same picture bit for bit, and
/// counts. None if isCounted() is false, or if the listener ended it. A counted run takes some ten
/// times as long as a drawing.
std::optional<OperationCounts> countOperations(const Method &method, const ScanSettings &settings,
                                               const Primitives &primitives, FrameView frame,
                                               const ProgressListener &progress = {});

} // namespace pixelplumb
