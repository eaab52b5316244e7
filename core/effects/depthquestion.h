// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/depthwitness.h"
#include "core/effects/effectplan.h"

namespace pixelplumb {

/// Whether painting in drawing order shows what is nearest: no triangle lies behind one that was
/// drawn before it, at no sample of the frame.
struct DepthAnswer {
    /// What settled the question.
    enum class Ground : std::uint8_t {
        FewTriangles, ///< none or one is drawn in the frame
        SameDepth, ///< all z are equal
        InOrder, ///< each is nearer than all before it, or as near
        Apart, ///< no two overlap
        NotBehind, ///< where they overlap, the later one is nearer or as near
        NoSample, ///< it is so at the samples, though not at all points
        Witness, ///< it is not so at a sample
        NoWitness, ///< it is not so at all points, and no such sample was found
        TooMany, ///< not all could be compared in the time that there is
    };

    Ground ground = Ground::FewTriangles;
    Verdict verdict = Verdict::NotCalledFor;
    std::size_t earlier = 0, later = 0; ///< of a witness, or where none was found: the triangles
    SamplePlace place; ///< of a witness
    Antialiasing antialiasing = Antialiasing::None; ///< at whose samples it was asked
    std::int64_t overlaps = 0; ///< pairs of triangles whose planes were compared where they overlap
    /// Those that lie behind an earlier one somewhere, or before a later one, or may; by triangle.
    /// Any other triangle may be drawn without depth. Empty where there are none.
    std::vector<bool> inQuestion;
    std::int64_t operations = 0; ///< about; a comparison of two boxes is one

    std::size_t countInQuestion() const;
};

/// The answer is exact but for NoWitness and TooMany, and depends on nothing but the scene: what
/// can be compared is bounded by a count of operations. Not looked for where the scene itself says
/// whether depth runs. Sample coordinates.
DepthAnswer depthQuestion(const Primitives &primitives, const ScanSettings &settings,
                          const FrameView &frame, Antialiasing antialiasing);

} // namespace pixelplumb
