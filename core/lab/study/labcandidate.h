// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/judging/levelprobe.h"
#include "core/lab/judging/meshcover.h"
#include "core/lab/judging/picturejudge.h"
#include "core/lab/study/familyaccuracy.h"

#include <map>

namespace pixelplumb {

/// Triangles of one picture, with their true pictures under each rule that a contender claims.
struct LabChunk {
    const LabPicture *picture = nullptr;
    std::vector<std::map<FillRule, TruePicture>> truths;
};

/// One contender on its way through a family.
class LabCandidate {
public:
    LabCandidate(const LabContender &contender, const LabFamily &family,
                 const AccuracyOptions &options);

    const FamilyVerdict &verdict() const { return m_verdict; }
    const ScanSettings &settings() const { return m_verdict.settings; }
    bool isRunning() const { return m_verdict.outcome == LabOutcome::Pending; }

    /// Draws the triangles of a chunk one by one on a frame that is transparent before and after.
    void takeChunk(const LabChunk &chunk, const FrameView &frame);
    /// Call after the last chunk. `trueCover`: of a mesh under the candidate's rule, else null.
    void finish(const MeshCover *trueCover);

private:
    enum class Look { Near, Everywhere };

    void drawAll(const LabChunk &chunk, const FrameView &frame, Look look);
    void lookClosely(const LabChunk &chunk, const FrameView &frame);
    void addFlicker();
    void countOperationsOfFirst();
    void findFirstMiss();
    void fail(const QString &why);
    void giveUp(const QString &why);

    const LabContender &m_contender;
    const LabFamily &m_family;
    const AccuracyOptions &m_options;
    FamilyVerdict m_verdict;
    PictureJudge m_judge;
    LevelTally m_levels;
    std::optional<MeshCover> m_cover; ///< of a mesh
    std::optional<FrameSpec> m_frameOfMiss; ///< of the first miss
    bool m_visitsFrame = false; ///< for each triangle, not only its box
    std::int64_t m_samples = 0; ///< visited so far
    std::int64_t m_probedPixels = 0;
    std::int64_t m_movedPixels = 0;
};

} // namespace pixelplumb
