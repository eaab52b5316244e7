// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/edgetestbugs.h"
#include "core/scan/scanbugs.h"
#include "core/scan/variants.h"

#include <array>
#include <optional>
#include <string_view>

namespace pixelplumb {

/// Which triangle owns a sample that lies exactly on an edge. All rules but the closed and the open
/// one displace the sample by an infinitely small vector, so that every sample of a mesh has
/// exactly one owner. The off-screen point's rule, which displaces towards that point, ensures this
/// only where no edge's line passes through the point.
enum class FillRule {
    Closed, ///< not displaced: the boundary belongs to the triangle (the assignment)
    HalfOpenColumn, ///< (+ε², +ε): rows ⌈y_B⌉ … ⌈y_T⌉−1, columns ⌈x₀⌉ … ⌈x₂⌉−1
    TopLeft, ///< (+ε, ε² down on the screen): Direct3D, and the slides' "left or top edge"
    OffScreenPoint, ///< towards a chosen off-screen point (Triangles slides)
    Open, ///< not displaced: no triangle owns the boundary, E > 0 (the slides' printed tests)
};

/// What the increments are computed in.
enum class Arithmetic {
    Exact, ///< integer quotient and remainder; no rounding before the byte
    Float32,
    Float64,
    Fixed16, ///< 16.16, 32 bits, rounded to nearest, wraps
    Fixed32, ///< 32.32, 64 bits, rounded to nearest, wraps
};

/// How a colour level becomes a byte: ⌊v + 1/2⌋, or ⌊v⌋ to show what truncation does. Then clamped.
enum class ByteRounding { Nearest, Truncate };

inline constexpr std::array allFillRules
    = {FillRule::Closed, FillRule::HalfOpenColumn, FillRule::TopLeft, FillRule::OffScreenPoint,
       FillRule::Open};
inline constexpr std::array allArithmetics
    = {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64, Arithmetic::Fixed16,
       Arithmetic::Fixed32};
inline constexpr std::array allByteRoundings = {ByteRounding::Nearest, ByteRounding::Truncate};

/// The names in files, on the command line and in the window: "closed", "half-open-column", …
std::string_view nameOf(FillRule rule);
std::string_view nameOf(Arithmetic arithmetic);
std::string_view nameOf(ByteRounding rounding);
std::optional<FillRule> fillRuleNamed(std::string_view name);
std::optional<Arithmetic> arithmeticNamed(std::string_view name);

/// The settings under which a method draws.
struct ScanSettings {
    Arithmetic arithmetic = Arithmetic::Exact;
    FillRule fillRule = FillRule::Closed;
    ByteRounding rounding = ByteRounding::Nearest;
    VariantSet variants = {}; ///< departures that the method accepts
    ScanBugs bugs = {}; ///< of a program that walks between two edges
    EdgeTestBugs testBugs = {}; ///< of one that tests edges
    /// Whether the method's own algorithm is asked for.
    bool isRight() const { return variants.isEmpty() && bugs.isRight() && testBugs.isRight(); }

    friend bool operator==(const ScanSettings &, const ScanSettings &) = default;
};

} // namespace pixelplumb
