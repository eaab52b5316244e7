// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/scan/scansettings.h"

#include <QString>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

/// What a scene needs, and what is run for it: values, found in one pass, shown with their reasons.
namespace pixelplumb {

enum class Verdict : std::uint8_t {
    NotCalledFor, ///< proved: the picture is the same without it
    CalledFor,
    NotRuledOut, ///< no cheap proof was found; it runs
};

/// "not called for", "called for", "not ruled out".
std::string_view nameOf(Verdict verdict);

/// What a scene needs of one effect, and why, in words that a student understands.
struct EffectVerdict {
    Verdict verdict = Verdict::NotCalledFor;
    QString reason; ///< "the three vertex colours are equal", "2 of 3 triangles have an alpha …"
    std::size_t primitives = 0; ///< that call for it
    std::int64_t pixels = 0; ///< of the frame that it may touch, at most: an upper bound
};

/// How samples of a batch are compared in depth.
enum class DepthTest : std::uint8_t {
    None,
    Number, ///< the kernel's own number is kept
    Levels, ///< an integer of so many bits is kept
};

/// What is done at each sample of a batch, which its stages are chosen by. Values that need no
/// other code (a light's direction, an alpha) stay out of it.
struct EffectSet {
    bool smooth = false;
    bool perspective = false;
    bool texture = false;
    bool light = false;
    bool blending = false;
    DepthTest depth = DepthTest::None;

    /// Today's plain kernels suffice: one colour or three interpolated ones, painted over.
    constexpr bool isPlain() const
    {
        return !perspective && !texture && !light && !blending && depth == DepthTest::None;
    }
    friend constexpr bool operator==(const EffectSet &, const EffectSet &) = default;
};

/// Whether it is among them; of clipping and antialiasing, which no stage does, false.
bool contains(const EffectSet &effects, Effect effect);
/// "smooth colour, depth"; "one colour" where there are none.
QString namesOf(const EffectSet &effects);

/// A run of triangles of the same needs, in drawing order.
struct EffectBatch {
    std::size_t first = 0;
    std::size_t count = 0;
    EffectSet effects;
    std::size_t unseen = 0; ///< of them: what reaches no pixel joins what stands beside it

    friend bool operator==(const EffectBatch &, const EffectBatch &) = default;
};

/// What runs.
struct EffectPlan {
    PerEffect<EffectVerdict> verdicts;
    std::vector<EffectBatch> batches; ///< of the triangles; together all of them, in order
    Antialiasing antialiasing = Antialiasing::None; ///< of the triangles
    Antialiasing strokeAntialiasing = Antialiasing::None; ///< of lines and curves
    bool smoothLines = false; ///< lines go from the one end's colour to the other's
    bool vertexLight = false; ///< light is in the vertices' colours, from set-up on

    /// Whether it is done anywhere.
    bool runs(Effect effect) const
    {
        return runsOnTriangles(effect) || (effect == Effect::SmoothColour && smoothLines)
            || (effect == Effect::Light && vertexLight)
            || (effect == Effect::Antialiasing && strokeAntialiasing != Antialiasing::None);
    }
    /// The same of what a kernel of triangles does at their samples.
    bool runsOnTriangles(Effect effect) const;
    /// Whether the same is done, whatever the verdicts say.
    bool runsAs(const EffectPlan &other) const
    {
        return batches == other.batches && antialiasing == other.antialiasing
            && strokeAntialiasing == other.strokeAntialiasing && smoothLines == other.smoothLines
            && vertexLight == other.vertexLight;
    }
    /// True where today's plain kernels draw all triangles.
    bool isPlain() const
    {
        return antialiasing == Antialiasing::None
            && std::ranges::all_of(
                   batches, [](const EffectBatch &batch) { return batch.effects.isPlain(); });
    }
};

/// What the primitives (sample coordinates) need in the frame, each effect by itself. Forcing is
/// not looked at.
PerEffect<EffectVerdict> requirementsOf(const Primitives &primitives, const ScanSettings &settings,
                                        const FrameView &frame);

/// What is run: that, with what was forced on or off.
EffectPlan planFor(const Primitives &primitives, const ScanSettings &settings,
                   const FrameView &frame);

/// The plan of a scene that calls for more than colour; none where one colour a triangle, or three
/// interpolated ones, painted over what stands, are all of it.
std::optional<EffectPlan> planBeyondColour(const Primitives &primitives,
                                           const ScanSettings &settings, const FrameView &frame);

} // namespace pixelplumb
