// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/scan/scansettings.h"

#include <QString>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

/// What a scene needs, and what is run for it: values found in one pass and shown with their
/// reasons.
namespace pixelplumb {

enum class Verdict : std::uint8_t {
    NotCalledFor, ///< proved: the picture is the same without it
    CalledFor,
    NotRuledOut, ///< no cheap proof was found; it runs
};

/// "not called for", "called for", "not ruled out".
std::string_view nameOf(Verdict verdict);

/// Whether a scene needs one effect, and why, in words that a student understands.
struct EffectVerdict {
    Verdict verdict = Verdict::NotCalledFor;
    QString reason; ///< "the three vertex colours are equal", "2 of 3 triangles have an alpha …"
    std::size_t primitives = 0; ///< that call for it
    std::int64_t pixels = 0; ///< upper bound for the frame's pixels that it may touch
};

/// How the depths of a batch's samples are compared.
enum class DepthTest : std::uint8_t {
    None,
    Number, ///< the kernel's own number is stored
    Levels, ///< an integer of the format's bits is stored
};

/// What is done at each sample of a batch; it selects the batch's stages. Values that need no
/// different code (a light's direction, an alpha) are left out.
struct EffectSet {
    bool smooth = false;
    bool perspective = false;
    bool texture = false;
    bool light = false;
    bool blending = false;
    DepthTest depth = DepthTest::None;

    /// Whether the plain kernels suffice: one colour or three interpolated ones, painted over.
    constexpr bool isPlain() const
    {
        return !perspective && !texture && !light && !blending && depth == DepthTest::None;
    }
    friend constexpr bool operator==(const EffectSet &, const EffectSet &) = default;
};

/// Whether the effect is among them; false for clipping and antialiasing, which no stage does.
bool contains(const EffectSet &effects, Effect effect);
/// "smooth colour, depth"; "one colour" if there are none.
QString namesOf(const EffectSet &effects);

/// A run of triangles with the same needs, in drawing order.
struct EffectBatch {
    std::size_t first = 0;
    std::size_t count = 0;
    EffectSet effects;
    std::size_t unseen = 0; ///< of these: triangles that reach no pixel and so join a neighbouring
                            ///< batch

    friend bool operator==(const EffectBatch &, const EffectBatch &) = default;
};

/// What is run for a scene.
struct EffectPlan {
    PerEffect<EffectVerdict> verdicts;
    std::vector<EffectBatch> batches; ///< of the triangles; together all of them, in order
    Antialiasing antialiasing = Antialiasing::None; ///< for triangles
    Antialiasing strokeAntialiasing = Antialiasing::None; ///< for lines and curves
    bool smoothLines = false; ///< lines change from one end's colour to the other's
    bool vertexLight = false; ///< light is computed into the vertex colours in set-up

    /// Whether the effect runs anywhere.
    bool runs(Effect effect) const
    {
        return runsOnTriangles(effect) || (effect == Effect::SmoothColour && smoothLines)
            || (effect == Effect::Light && vertexLight)
            || (effect == Effect::Antialiasing && strokeAntialiasing != Antialiasing::None);
    }
    /// Whether the effect runs on triangles.
    bool runsOnTriangles(Effect effect) const;
    /// Whether the same is run, whatever the verdicts say.
    bool runsAs(const EffectPlan &other) const
    {
        return batches == other.batches && antialiasing == other.antialiasing
            && strokeAntialiasing == other.strokeAntialiasing && smoothLines == other.smoothLines
            && vertexLight == other.vertexLight;
    }
    /// True where the plain kernels draw all triangles.
    bool isPlain() const
    {
        return antialiasing == Antialiasing::None
            && std::ranges::all_of(
                   batches, [](const EffectBatch &batch) { return batch.effects.isPlain(); });
    }
};

/// What the primitives (sample coordinates) need in the frame, effect by effect, ignoring forcing.
PerEffect<EffectVerdict> requirementsOf(const Primitives &primitives, const ScanSettings &settings,
                                        const FrameView &frame);

/// What is run: the requirements, with effects forced on or off.
EffectPlan planFor(const Primitives &primitives, const ScanSettings &settings,
                   const FrameView &frame);

} // namespace pixelplumb
