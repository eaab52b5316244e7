// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/familyaccuracy.h"

#include "core/frame/writtenframe.h"
#include "core/lab/study/labcandidate.h"

#include <algorithm>
#include <set>

namespace pixelplumb {

namespace {

constexpr std::int64_t mostTruePixels = 16'000'000; ///< kept at a time: 64 MB

/// The true pictures of a family, a batch at a time.
class TrueFamily {
public:
    TrueFamily(const LabFamily &family, const std::vector<LabCandidate> &candidates)
        : m_family(family)
    {
        for (const LabCandidate &candidate : candidates) {
            if (candidate.isRunning())
                m_rules.insert(candidate.settings().fillRule);
        }
    }

    /// The triangles from `first` on, as many as memory allows; advances `first`.
    LabChunk nextChunk(const LabPicture &picture, const FrameView &frame, std::size_t &first)
    {
        LabChunk chunk{&picture, {}};
        for (std::int64_t pixels = 0; first < picture.triangles.size() && pixels < mostTruePixels;
             ++first) {
            auto &byRule = chunk.truths.emplace_back();
            for (const FillRule rule : m_rules) {
                const auto added
                    = byRule
                          .try_emplace(rule, picture.triangles[first],
                                       BoundaryRule(rule, frame.origin, frame.offScreenPoint),
                                       m_family.settings.rounding, frame)
                          .first;
                const FrameView view = added->second.window.view();
                pixels += std::int64_t(view.width) * view.height;
                if (m_family.isMesh)
                    m_covers.try_emplace(rule, picture.frame)
                        .first->second.add(view, samplesOf(view));
            }
        }
        return chunk;
    }

    const MeshCover *cover(FillRule rule) const
    {
        const auto found = m_covers.find(rule);
        return found == m_covers.end() ? nullptr : &found->second;
    }

private:
    const LabFamily &m_family;
    std::set<FillRule> m_rules; ///< the rules that contenders claim
    std::map<FillRule, MeshCover> m_covers;
};

bool isPixelOf(const FrameSpec &frame, const LatticePoint &point)
{
    return point == latticePixel(floorPixel(point.x), floorPixel(point.y)) && point.x >= 0
        && point.y >= 0 && floorPixel(point.x) < frame.width && floorPixel(point.y) < frame.height;
}

/// Whether a family is one picture on a frame that begins at (0, 0), with vertices on its pixels.
bool isForPeers(const LabFamily &family)
{
    const LabPicture &picture = family.pictures.front();
    const auto isInside = [&](const Triangle &triangle) {
        return std::ranges::all_of(triangle.vertices, [&](const Vertex &vertex) {
            return isPixelOf(picture.frame, vertex.position);
        });
    };
    return family.pictures.size() == 1 && picture.frame.firstColumn == 0
        && picture.frame.firstRow == 0 && std::ranges::all_of(picture.triangles, isInside);
}

} // namespace

std::optional<ScanSettings> settingsFor(const LabContender &contender, const LabFamily &family)
{
    if (contender.kernel == LabKernel::Peer && !isForPeers(family))
        return std::nullopt;
    ScanSettings settings = contender.settingsUnder(family.settings.fillRule);
    settings.rounding = family.settings.rounding;
    if (family.isMesh) {
        const auto rule = contender.watertightRule();
        if (!rule)
            return std::nullopt;
        settings.fillRule = *rule;
    }
    return settings;
}

bool judgeFamily(const LabFamily &family, const std::vector<LabContender> &contenders,
                 const AccuracyOptions &options,
                 const std::function<void(std::size_t contender, const FamilyVerdict &)> &tell,
                 const ProgressListener &listener)
{
    std::vector<LabCandidate> candidates;
    candidates.reserve(contenders.size());
    for (const LabContender &contender : contenders)
        candidates.emplace_back(contender, family, options);
    TrueFamily truth(family, candidates);
    const auto all = std::int64_t(family.triangleCount() * contenders.size());
    std::int64_t done = 0;
    const auto conclude = [&](std::size_t index) {
        candidates[index].finish(truth.cover(candidates[index].settings().fillRule));
        tell(index, candidates[index].verdict());
    };
    for (const LabPicture &picture : family.pictures) {
        const WrittenFrame frame(picture.frame);
        const bool isLastPicture = &picture == &family.pictures.back();
        for (std::size_t first = 0; first < picture.triangles.size();) {
            const LabChunk chunk = truth.nextChunk(picture, frame.view(), first);
            for (std::size_t index = 0; index < candidates.size(); ++index) {
                if (!goesOn(listener, {JobPhase::Judging, done, all}))
                    return false;
                if (candidates[index].isRunning())
                    candidates[index].takeChunk(chunk, frame.view());
                done += std::int64_t(chunk.truths.size());
                if (isLastPicture && first == picture.triangles.size())
                    conclude(index);
            }
        }
    }
    return true;
}

} // namespace pixelplumb
