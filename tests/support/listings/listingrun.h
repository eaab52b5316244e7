// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/words/pseudocode.h"
#include "tests/support/listings/listingstate.h"

namespace pixelplumb {

/// Runs a method's listing as printed: what a student gets who types it in.
/// It knows the statements of listingstate.h and
///   box ← the whole frame
///   box ← x from A to B, y likewise, clipped to the frame     x_min and y_min are its first
///   for each x of the box:                    the box's samples, ascending
///   for each column x from A to B:            "column" may be another word or missing
///   for each row y from A down to B:
///   for each column x of the frame from A to B:     those that the frame has; x_first is A
///   for each sample k from A to B:            names that a round brings are its own
///   for each t = i/N from A to B:             i = 0, 1, 2 …
///   for each edge L_ij of L₀₁, L₁₂, L₀₂: …    statements, or a block, in which i and j are the
///                                             edge's digits
///   for each column x of the outline:         those for which y_low[x] has a value
///   for each value v of R, G, B: …            statements with R, G and B for v
///   for each arc (a, b) of (A, B) and, if C ≠ D, (B, A):
///   for each point (x, y):     for each edge from (x₀, y₀) to (x₁, y₁):     of the primitive
///   for each edge k from (x₀, y₀) to (x₁, y₁) with A < y ≤ B:     those where that holds
///   for each triangle, with its three edges:     loops over edges go through these
///   for each edge k of them with x_k ≤ A: …   statements; "them" are those of the loop above;
///                                             min x_k and max x_k are of them, too
///   while A > 0: …                            statements, or a block
///   the first: …    else if A > 0: …    else: …     in a loop: in its first round, or else
///   where it begins: …                        if what is assigned first has no value yet
///   if A > 0, or A = 0 and B > 0; C and D likewise:     a block, or "…: statements"
/// Text after " — " is a remark for the reader; one with the word "exact" makes a condition or a
/// loop read values that were never rounded.
class ListingRun {
public:
    using Number = BigRational;
    using Pixels = ListingState::Pixels;
    /// The coordinates of a point or of an edge's two ends.
    using Item = std::vector<Number>;

    /// names: the numbers of the primitive itself, and what the listing says is given. The set-up
    /// is run like all else.
    ListingRun(Pseudocode code, ListingNames names, const SampleBox &frame)
        : m_code(std::move(code))
        , m_state(std::move(names), frame)
        , m_frame(frame)
    {
    }
    /// Runs the listing in these numbers: exact, float32 or float64.
    void computeIn(Arithmetic arithmetic);
    /// The points or edges of a primitive that has many.
    void setItems(std::vector<Item> items)
    {
        m_items = std::move(items);
        m_end = m_items.size();
    }

    ListingState &state() { return m_state; }

    /// Throws ListingFault.
    void run();
    /// The lines that were run for a pixel, from the begin of its loop's round on, ascending.
    using Lines = std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>>;
    const Lines &linesOfPixels() const { return m_linesOfPixels; }
    /// The pixels that were drawn.
    const Pixels &pixels() const { return m_state.pixels(); }

private:
    std::size_t endOfBlock(std::size_t line) const;
    void runBlock(std::size_t first, std::size_t end);
    void runLine(std::size_t line);
    bool runLoop(std::size_t line, const QString &text);
    bool setBox(const QString &text);
    bool runBox(std::size_t line, const QString &text);
    bool runRange(std::size_t line, const QString &text);
    bool runColumns(std::size_t line, const QString &text);
    bool runEdges(std::size_t line, const QString &text);
    bool runArcs(std::size_t line, const QString &text);
    bool runItems(std::size_t line, const QString &text);
    bool runTriangles(std::size_t line, const QString &text);
    bool runMetItems(const QString &text);
    void enterItem(std::size_t item, const QStringList &names);
    void runRound(std::size_t line);
    bool runCase(std::size_t line, const QString &text);

    Pseudocode m_code;
    ListingState m_state;
    SampleBox m_frame, m_box; ///< the box is empty until a line sets it
    std::vector<Item> m_items;
    std::size_t m_first = 0, m_end = 0; ///< those that loops go through: all, or a triangle's
    std::vector<std::size_t> m_met; ///< those that met the last loop's condition
    QStringList m_ends; ///< the names of their coordinates
    std::vector<std::size_t> m_ran; ///< the lines of the current round
    Lines m_linesOfPixels;
    bool m_isFirst = false; ///< whether this is the first round of the current loop
    bool m_hasCase = false; ///< whether a case was taken in the current round
};

} // namespace pixelplumb
