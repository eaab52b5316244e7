// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/depthwitness.h"
#include "core/shade/effectplan.h"

namespace pixelplumb {

/// Whether drawing order alone shows the nearest triangles: at no sample of the frame does a
/// triangle lie behind one drawn before it.
struct DepthAnswer {
    /// What settled the question.
    enum class Ground : std::uint8_t {
        FewTriangles, ///< at most one is drawn in the frame
        SameDepth, ///< all z are equal
        InOrder, ///< each is at least as near as all before it
        Apart, ///< no two overlap
        NotBehind, ///< where they overlap, the later one is at least as near
        NoSample, ///< that holds at the samples, though not at all points
        Witness, ///< it fails at a sample
        NoWitness, ///< it fails at some point, but no such sample was found
        TooMany, ///< not all could be compared in the available time
    };

    Ground ground = Ground::FewTriangles;
    Verdict verdict = Verdict::NotCalledFor;
    std::size_t earlier = 0, later = 0; ///< the triangles of the witness, or of the pair without
                                        ///< one
    SamplePlace place; ///< of the witness
    std::int64_t overlaps = 0; ///< pairs of triangles whose planes were compared where they overlap
    /// By triangle: whether it lies, or may lie, behind an earlier one or in front of a later one
    /// somewhere. All others may be drawn without depth. Empty where there are none in question.
    std::vector<bool> inQuestion;
    /// How many of those in question do so at a sample; the others were only not ruled out.
    std::size_t shown = 0;
    std::int64_t operations = 0; ///< approximate; comparing two boxes counts as one

    std::size_t countInQuestion() const;
};

/// The answer is exact except for NoWitness and TooMany, and depends only on the scene: comparisons
/// are limited by a count of operations. The question is not examined where the scene itself
/// switches depth on or off. Sample coordinates.
DepthAnswer depthQuestion(const Primitives &primitives, const ScanSettings &settings,
                          const FrameView &frame, Antialiasing antialiasing);

} // namespace pixelplumb
