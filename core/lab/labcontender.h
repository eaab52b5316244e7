// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/straightloop.h"
#include "core/methods/method.h"

#include <array>
#include <functional>
#include <vector>

namespace pixelplumb {

/// Which code of a method draws.
enum class LabKernel : std::uint8_t {
    Plain, ///< the kernel that a trace steps through, with nothing listening
    Fast, ///< its SIMD twin on one thread, tested to write the same bytes
    Peer, ///< no code of ours: another renderer, beside which ours is measured (tests/bench)
};
inline constexpr std::array allLabKernels = {LabKernel::Plain, LabKernel::Fast, LabKernel::Peer};
/// Those that are compared among themselves.
inline constexpr std::array ownLabKernels = {LabKernel::Plain, LabKernel::Fast};
QString nameOf(LabKernel kernel); ///< "plain", "SIMD", "peer"
/// By a contender's id alone, which may be none of today's.
LabKernel kernelOf(const QString &contender);

/// Drawing in two steps, of which the second alone is timed: of a peer, which has frames and
/// triangles of its own.
struct LoadedDrawing {
    std::function<void(const Primitives &primitives, FrameView frame)> load;
    std::function<void()> draw; ///< what was loaded last
};

/// One who takes part in a study: a method in one arithmetic by one kernel, or a peer. A value, a
/// row of a table.
struct LabContender {
    QString id; ///< "column-scan:float32", "column-scan:exact:fast", "peer:agg"
    QString label; ///< "Column scan, float32"
    const Method *method = nullptr; ///< of a peer: the one that shows its misses in a scene
    Arithmetic arithmetic = Arithmetic::Exact;
    LabKernel kernel = LabKernel::Plain;
    /// Draws triangles (sample coordinates) in order, on the calling thread. May throw: the study
    /// then shows it as failed.
    std::function<void(const Primitives &primitives, const ScanSettings &settings, FrameView frame)>
        draw;
    /// What it is measured by; null where there is no straight loop of this kind.
    const StraightLoop *straight = nullptr;
    std::optional<LoadedDrawing> loaded = {}; ///< what is timed in draw()'s place
    std::optional<FillRule> ownRule = {}; ///< of a peer, which knows no other

    /// Every picture of the plain kernel is the truth, by proof, over the whole lattice. That the
    /// fast one draws the same is tested.
    bool isProved() const { return kernel != LabKernel::Peer && method->isStableIn(arithmetic); }
    /// Where the proof holds, and what stands in beyond; empty where nothing is proved.
    QString domain() const;
    /// The rule, or the method's own first where it does not keep that; a peer's own.
    ScanSettings settingsUnder(FillRule rule) const;
    /// What the spans of its method are, as a trace of a triangle has them.
    SpanAxis spanAxis() const;
    /// The first rule of the method's under which every sample of a mesh has one owner; none where
    /// it keeps no such rule.
    std::optional<FillRule> watertightRule() const;
};

/// The assignment's method in float32: times are told in its, as ×1.
inline constexpr const char *referenceContenderId = "column-scan:float32";

LabContender contenderOf(const Method &method, Arithmetic arithmetic,
                         LabKernel kernel = LabKernel::Plain);
/// Null where there is none of this id.
std::optional<LabContender> labContenderNamed(const QString &id);

/// The fifteen of the quick study.
std::vector<LabContender> quickContenders();
/// Every method that draws triangles, in every arithmetic that it has, and the fast kernels.
std::vector<LabContender> fullContenders();

} // namespace pixelplumb
