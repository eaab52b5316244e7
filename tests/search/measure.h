// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/check/casepicture.h"
#include "core/check/hardcase.h"
#include "tests/search/canvaspicture.h"

#include <functional>
#include <span>

/// How wrong a drawing of a hard case is, in numbers that a search can climb and a record can keep.
/// The oracle is always the truth.
namespace pixelplumb::search {

/// All zero if the drawing is right.
struct Shortfall {
    std::int64_t missing = 0; ///< pixels, summed over triangles, frames or places
    std::int64_t extra = 0;
    std::int64_t wrongBytes = 0; ///< pixels that both cover, in another colour
    std::int64_t clamped = 0; ///< written pixels whose levels were outside 0 … 255
    std::int64_t gaps = 0; ///< mesh: pixels that no drawn triangle covers, but one of the truth's
                           ///< does
    std::int64_t overdraw = 0; ///< mesh: how many times too often pixels are covered
    std::int64_t extraToggles = 0; ///< sequence: flicker, changed pixels beyond the true changes
    std::int64_t extraPictures = 0; ///< translation: number of different pictures beyond one

    bool isNone() const { return *this == Shortfall{}; }
    friend bool operator==(const Shortfall &, const Shortfall &) = default;
};

/// A triangle and the canvas that it is drawn on.
struct CaseScene {
    Triangle triangle;
    FrameSpec canvas;
};

/// The true pictures of any case with triangles, under one rule: one per triangle, frame or place.
/// Under the top-left rule all are mirrored, because there the case's y points down.
class CaseTruth {
public:
    CaseTruth(const HardCase &hardCase, FillRule rule);

    std::span<const CanvasPicture> pictures() const { return m_pictures; }
    /// What a drawing gets wrong, except for clamped pixels, which are unknown.
    Shortfall shortfallOf(const Drawing &drawing, const ScanSettings &settings) const;
    /// What the column scan gets wrong; the rule is Closed or HalfOpenColumn.
    Shortfall shortfallOfScan(const ScanSettings &settings) const;

private:
    /// Draws a triangle on an empty canvas and returns the number of clamped pixels.
    using Draw = std::function<std::int64_t(const Triangle &, CanvasPicture &)>;
    Shortfall shortfallOf(const Draw &draw) const;

    HardCaseKind m_kind;
    std::vector<CaseScene> m_scenes;
    std::vector<CanvasPicture> m_pictures; ///< of m_scenes
};

/// What the column scan gets wrong in a case with triangles; the rule is Closed or HalfOpenColumn.
Shortfall measure(const HardCase &hardCase, const ScanSettings &settings);

/// Fills in the case's facts under the closed, half-open-column and top-left rules, by the oracle.
void deriveFacts(HardCase &hardCase);

/// Whether a mesh can be covered exactly once: its triangles turn the same way and the half-open
/// rule covers no pixel of its canvas twice.
bool isProperMesh(const HardCase &hardCase);

} // namespace pixelplumb::search
