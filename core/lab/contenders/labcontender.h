// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/contenders/straightloop.h"
#include "core/methods/method.h"

#include <array>
#include <functional>
#include <vector>

namespace pixelplumb {

/// Which code of a method draws.
enum class LabKernel : std::uint8_t {
    Plain, ///< the kernel that a trace steps through, without an observer
    Fast, ///< its SIMD twin on one thread, tested to write the same bytes
    Peer, ///< not our code: another renderer to measure ours against (tests/bench)
};
inline constexpr std::array allLabKernels = {LabKernel::Plain, LabKernel::Fast, LabKernel::Peer};
/// Those that are compared with each other.
inline constexpr std::array ownLabKernels = {LabKernel::Plain, LabKernel::Fast};
QString nameOf(LabKernel kernel); ///< "plain", "SIMD", "peer"
/// From a contender's id alone, which may be none of today's.
LabKernel kernelOf(const QString &contender);

/// Drawing in two steps, of which only the second is timed: for a peer with its own frames and
/// triangles.
struct LoadedDrawing {
    std::function<void(const Primitives &primitives, FrameView frame)> load;
    std::function<void()> draw; ///< what was loaded last
};

/// A participant in a study: a method in one arithmetic by one kernel, or a peer. A value, a row of
/// a table.
struct LabContender {
    QString id; ///< "column-scan:float32", "column-scan:exact:fast", "peer:agg"
    QString label; ///< "Column scan, float32"
    const Method *method = nullptr; ///< for a peer: the method that shows its misses in a scene
    Arithmetic arithmetic = Arithmetic::Exact;
    LabKernel kernel = LabKernel::Plain;
    /// Draws the triangles of runOf() in order, on the calling thread. May throw: the study then
    /// shows it as failed.
    std::function<void(const Run &run, FrameView frame)> draw;
    /// What it is measured against; null if it has no straight loop.
    const StraightLoop *straight = nullptr;
    std::optional<LoadedDrawing> loaded = {}; ///< timed in place of draw()
    std::optional<FillRule> ownRule = {}; ///< of a peer, which supports no other

    /// Whether every picture of the plain kernel is the truth, by proof, over the whole lattice.
    /// Tests show that the fast one draws the same.
    bool isProved() const { return kernel != LabKernel::Peer && method->isStableIn(arithmetic); }
    /// Where the proof holds, and what replaces it beyond; empty if nothing is proved.
    QString domain() const;
    /// Triangles in sample coordinates, as the contender draws them.
    Run runOf(Primitives triangles, const ScanSettings &settings, const FrameView &frame) const;
    /// Under the rule, or the method's first one if it does not support that; under a peer's own.
    ScanSettings settingsUnder(FillRule rule) const;
    /// The axis of its method's spans in a trace of a triangle.
    SpanAxis spanAxis() const;
    /// The method's first rule under which every sample of a mesh has one owner; none if it has no
    /// such rule.
    std::optional<FillRule> watertightRule() const;
};

/// The assignment's method in float32: times are shown as multiples of its time, ×1.
inline constexpr const char *referenceContenderId = "column-scan:float32";

LabContender contenderOf(const Method &method, Arithmetic arithmetic,
                         LabKernel kernel = LabKernel::Plain);
/// Null if there is none with this id.
std::optional<LabContender> labContenderNamed(const QString &id);

/// The fifteen of the quick study.
std::vector<LabContender> quickContenders();
/// Every method that draws triangles, in every arithmetic that it has, and the fast kernels.
std::vector<LabContender> fullContenders();

} // namespace pixelplumb
