// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/pseudocode.h"
#include "core/scan/edgeteststate.h"
#include "tests/support/listinglanguage.h"

#include <QRgb>

namespace pixelplumb {

/// Runs a method's listing as it is printed, in exact numbers: what a student gets who types it in.
/// It knows
///   for each x of the box:            the box's samples, ascending
///   if A > 0, or A = 0 and B > 0; C and D likewise:
///   A, B ← C, D        add A, B to C, D        A ← B; C and D likewise
///   pixel (x, y) ← the bytes of R, G, B
/// with + − · / ( ) and names. "likewise" turns ₀ ₁ ₂, bc ca ab, a b c and α β γ by one, or R G B.
/// What stands behind " — " is for the reader.
class ListingRun {
public:
    using Number = BigRational;
    using Pixels = std::map<std::pair<std::int64_t, std::int64_t>, QRgb>; ///< by (x, y)

    /// names: what the set-up has worked out, by the titles of its numbers.
    ListingRun(Pseudocode code, ListingNames names, const SampleBox &box)
        : m_code(std::move(code))
        , m_names(std::move(names))
        , m_box(box)
    {
    }

    /// All lines but those of the set-up. Throws ListingFault.
    void run();
    /// The pixels that were drawn.
    const Pixels &pixels() const { return m_pixels; }

private:
    std::size_t endOfBlock(std::size_t line) const;
    void runBlock(std::size_t first, std::size_t end);
    void runLine(std::size_t line);
    void runLoop(std::size_t line, const QString &name);
    void runStatement(const QString &text);
    void assign(const QString &statement);
    void add(const QString &statement);
    void draw();
    bool holds(const QString &condition) const;
    bool holdsOne(const QString &test) const;
    bool holdsChain(const QString &comparison) const;
    Number valueOf(const QString &expression) const;

    Pseudocode m_code;
    ListingNames m_names;
    SampleBox m_box;
    Pixels m_pixels;
};

} // namespace pixelplumb
