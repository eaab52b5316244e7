// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/pseudocode.h"
#include "core/scan/edgeteststate.h"
#include "tests/support/listinglanguage.h"

#include <QRgb>

namespace pixelplumb {

/// Runs a method's listing as printed, in exact numbers: what a student gets who types it in.
/// It knows
///   for each x of the box:                    the box's samples, ascending
///   for each column x from A to B:            "column" may be another word or missing
///   for each row y from A down to B:
///   for each t = i/N from A to B:             i = 0, 1, 2 …
///   for each edge L_ij of L₀₁, L₁₂, L₀₂: …    statements in which i and j are the edge's digits
///   L_ij ← L₀₁ if x < x₁, else L₁₂            the edge whose digits i and j are from here on
///   where it begins: …                        if what is assigned first has no value yet
///   sort the vertices by x: P₀, P₁, P₂        or "by y, the largest first"
///   the first: …    else if A > 0: …    else: …     in a loop: in its first round, or else
///   if A > 0, or A = 0 and B > 0; C and D likewise:     a block, or "…: statements"
///   A, B ← C, D        add A, B to C, D        A ← B; C and D likewise
///   A ← 1 if B > 0, else −1        A, B ← C, D if E > 0, else D, C
///   pixel (A, B) ← the bytes of R, G, B       or "colour"; writes nothing outside the frame
/// with the expressions of listinglanguage.h. Text after " — " is a remark for the reader.
class ListingRun {
public:
    using Number = BigRational;
    using Pixels = std::map<std::pair<std::int64_t, std::int64_t>, QRgb>; ///< by (x, y)
    /// For a steep line, x and y are swapped when a pixel is written.
    enum class Exchange { None, Axes };
    /// Given: names are the set-up's results, by the titles of its numbers; only choices of names
    /// that have no value yet are run. Run: the whole set-up is run, from the numbers of the
    /// primitive itself.
    enum class SetUp { Given, Run };

    /// box: the samples to visit; for listings without a box, those of the frame.
    ListingRun(Pseudocode code, ListingNames names, const SampleBox &box,
               SetUp setUp = SetUp::Given, Exchange exchange = Exchange::None)
        : m_code(std::move(code))
        , m_names(std::move(names))
        , m_box(box)
        , m_setUp(setUp)
        , m_exchange(exchange)
    {
    }

    /// Throws ListingFault.
    void run();
    /// The pixels that were drawn.
    const Pixels &pixels() const { return m_pixels; }

private:
    std::size_t endOfBlock(std::size_t line) const;
    void runBlock(std::size_t first, std::size_t end);
    void runLine(std::size_t line);
    void runSetUp(std::size_t end);
    void sortVertices(const QString &text);
    bool runEdges(const QString &text);
    QString ofEdge(QString text) const;
    bool runLoop(std::size_t line, const QString &text);
    void runBlockWith(std::size_t line, const QString &name, const Number &value);
    bool runCase(std::size_t line, const QString &text);
    void runStatements(const QString &text);
    void runStatement(const QString &text);
    void assign(const QString &statement);
    void add(const QString &statement);
    void draw(const QString &place);
    bool holds(const QString &condition) const;
    QString chosen(const QString &expression) const;
    Number valueOf(const QString &expression) const;

    Pseudocode m_code;
    ListingNames m_names;
    SampleBox m_box;
    SetUp m_setUp;
    Exchange m_exchange;
    QString m_edge; ///< the digits that i and j stand for
    bool m_isFirst = false; ///< whether this is the first round of the current loop
    bool m_hasCase = false; ///< whether a case was taken in the current round
    std::map<QString, QStringList> m_spelledOut; ///< the statements of the texts that were run
    Pixels m_pixels;
};

} // namespace pixelplumb
