// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/number/jobprogress.h"
#include "core/shade/effectplan.h"
#include "core/trace/tracerecorder.h"

#include <memory>
#include <optional>

namespace pixelplumb {

struct Method;

/// Which kernels draw untraced pictures. The bytes do not depend on it.
enum class Kernels : std::uint8_t {
    Fastest, ///< core/fast on all threads, where the method has it
    FastestOnOneThread,
    Plain, ///< those that a trace steps through, without an observer: to measure and to compare
};

/// What is drawn, by which method and under which settings, and the plan of what that calls for:
/// made once for a frame, then drawn and traced as often as is wanted.
struct Run {
    Run(const Method *drawnBy, Primitives all, const ScanSettings &under, const FrameView &frame,
        Kernels drawnWith = Kernels::Fastest);

    const Method *method; ///< null: the truth
    Primitives primitives; ///< in sample coordinates; the method skips kinds that it does not draw
    ScanSettings settings;
    Kernels kernels;
    /// For what the method draws; none where that carries nothing that may call for more than
    /// colours.
    std::optional<EffectPlan> plan;

    bool drawsAll() const; ///< of the primitives

    /// The plan where triangles call for more than one colour or three interpolated ones, painted
    /// over the frame; else null.
    const EffectPlan *shading() const;
    /// How the pixels of triangles are sampled, and those of lines and curves.
    Antialiasing antialiasing() const;
    Antialiasing strokeAntialiasing() const;

    /// Draws the primitives of the method's kinds in order, or the truth. False if the listener,
    /// which receives the number drawn, ended it.
    bool draw(FrameView frame, const ProgressListener &listener = {}) const;
    /// Draws and records. Null when options.progress cancelled it.
    std::unique_ptr<ScanTrace> trace(FrameView frame, const TraceOptions &options = {}) const;
    /// The oracle's picture of what the method draws. The frame may be a part of the run's.
    void drawTruth(FrameView frame) const;

    /// Asks the listener before a primitive whether to go on: before each shape, and before every
    /// 1024th triangle, some milliseconds each.
    bool goesOnAt(std::size_t primitive, const ProgressListener &listener) const
    {
        constexpr std::size_t between = 1024;
        return (primitives.isTriangle(primitive) && primitive % between != 0)
            || goesOn(
                   listener,
                   {JobPhase::Drawing, std::int64_t(primitive), std::int64_t(primitives.size())});
    }
};

/// The run's plan with all its reasons, also where nothing may call for more than colours.
EffectPlan planOf(const Run &run, const FrameView &frame);

/// Those of the primitives that a method draws; all for the truth (null).
Primitives drawnBy(const Method *method, Primitives primitives);

} // namespace pixelplumb
