// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/depthquestion.h"

#include "core/plan/depthcandidates.h"
#include "core/plan/depthtiles.h"
#include "core/plan/framereach.h"
#include "core/plan/tileboxes.h"

#include <algorithm>

namespace pixelplumb {

namespace {

// Costs in units of one comparison of two boxes, and the budget.
constexpr std::int64_t meetingCost = 6;
constexpr std::int64_t planesCost = 20;
constexpr std::int64_t behindCost = 140;
constexpr std::int64_t leastBudget = 1'000'000;
constexpr std::int64_t budgetPerTriangle = 260;
/// How many rows and samples are searched for witnesses in one pair, and in all: some milliseconds.
/// Beyond these, a pair is not ruled out.
constexpr int mostStepsOfPair = 10'000;
constexpr int mostSteps = 40'000;

/// Compares the triangles of each tile pairwise.
class PairComparison {
public:
    PairComparison(const Primitives &primitives, const SampledFrame &where,
                   const DepthCandidates &candidates)
        : m_primitives(primitives)
        , m_candidates(candidates)
        , m_where(where)
        , m_tiles(candidates.boxes, candidates.width, candidates.height)
        , m_inQuestion(candidates.boxes.size(), false)
        , m_isShown(m_inQuestion)
        , m_budget(leastBudget + budgetPerTriangle * std::int64_t(candidates.boxes.size()))
    {
    }

    DepthAnswer answer()
    {
        bool isComplete = true;
        for (std::size_t tile = 0; tile < m_tiles.count() && isComplete; ++tile)
            isComplete = compareTile(tile);
        if (!isComplete)
            m_inQuestion.assign(m_inQuestion.size(), true);
        setGround(isComplete);
        takeQuestions();
        return m_answer;
    }

private:
    /// False when the budget is used up.
    bool compareTile(std::size_t tile)
    {
        const std::span<const std::uint32_t> places = m_tiles.placesIn(tile);
        m_boxes.take(m_candidates.boxes, places, m_tiles.cornerOf(tile), m_inQuestion);
        for (std::size_t later = 1; later < places.size(); ++later) {
            const auto compareWith = [&](std::size_t earlier) {
                compare(places[earlier], places[later]);
                for (const std::size_t each : {earlier, later}) {
                    if (m_inQuestion[places[each]])
                        m_boxes.setInQuestion(each);
                }
            };
            const std::int64_t meetings
                = m_boxes.forEachMeeting(later, settledPairs(), compareWith);
            m_answer.operations += std::int64_t(later) + meetingCost * meetings;
            if (m_answer.operations > m_budget)
                return false;
        }
        return true;
    }

    /// Pairs for which depth already runs: nothing is learnt from them once it is known that it
    /// must.
    SettledPairs settledPairs() const { return {m_mayOverlap, isCalledFor()}; }

    void compare(std::size_t earlier, std::size_t later)
    {
        if (m_inQuestion[earlier] && m_inQuestion[later] && isCalledFor())
            return;
        const bool inOrder = m_candidates.farthest(later) <= m_candidates.nearest(earlier);
        if (!inOrder || !m_mayOverlap)
            compareOverlap(earlier, later, inOrder);
    }

    void compareOverlap(std::size_t earlier, std::size_t later, bool inOrder)
    {
        m_answer.operations += planesCost;
        const PlaneOrder order = orderOf(earlier, later);
        if (order == PlaneOrder::Apart)
            return;
        m_mayOverlap = true;
        ++m_answer.overlaps;
        if (order != PlaneOrder::Behind)
            return;
        m_answer.operations += behindCost;
        if (!inOrder)
            question(earlier, later);
    }

    PlaneOrder orderOf(std::size_t earlier, std::size_t later) const
    {
        // Pixels have parts of both where their boxes meet, and segments have no planes: the
        // samples decide.
        const DepthTriangle early = depthTriangle(earlier);
        const DepthTriangle late = depthTriangle(later);
        if (isByArea() || doubledArea(*early.triangle) == 0 || doubledArea(*late.triangle) == 0)
            return PlaneOrder::Behind;
        return planeOrderOf(early, late, m_where.rule);
    }

    /// Searches for a sample at which the later one, which lies behind somewhere or may, is drawn
    /// behind.
    void question(std::size_t earlier, std::size_t later)
    {
        WitnessSearch search;
        if (m_steps < mostSteps)
            search = searchWitness(
                depthTriangle(earlier), depthTriangle(later), m_where, edgePixels(),
                m_primitives.appearance.depthFormat,
                {sharedReach(earlier, later), std::min(mostStepsOfPair, mostSteps - m_steps)});
        m_steps += search.steps;
        if (search.wasComplete && !search.found) {
            m_onlyBetweenSamples = true;
            return;
        }
        if (!isCalledFor() && (search.found || m_answer.verdict == Verdict::NotCalledFor))
            keepExample(earlier, later, search.found.value_or(SamplePlace{}));
        if (search.found)
            m_answer.verdict = Verdict::CalledFor;
        else if (!isCalledFor())
            m_answer.verdict = Verdict::NotRuledOut;
        for (const std::size_t each : {earlier, later}) {
            m_inQuestion[each] = true;
            m_isShown[each] = m_isShown[each] || search.found;
        }
    }

    /// The pixels with more than one sample; computed for the first pair that needs them.
    const EdgePixels *edgePixels()
    {
        if (!m_edges && !samplePattern(m_where.antialiasing).empty())
            m_edges.emplace(m_primitives.triangles, m_where.frame);
        return m_edges ? &*m_edges : nullptr;
    }

    void keepExample(std::size_t earlier, std::size_t later, const SamplePlace &place)
    {
        m_answer.earlier = m_candidates.triangles[earlier];
        m_answer.later = m_candidates.triangles[later];
        m_answer.place = place;
    }

    void setGround(bool isComplete)
    {
        using Ground = DepthAnswer::Ground;
        if (isCalledFor()) {
            m_answer.ground = Ground::Witness;
        } else if (!isComplete) {
            m_answer.ground = Ground::TooMany;
            m_answer.verdict = Verdict::NotRuledOut;
        } else if (m_answer.verdict == Verdict::NotRuledOut) {
            m_answer.ground = Ground::NoWitness;
        } else if (m_onlyBetweenSamples) {
            m_answer.ground = Ground::NoSample;
        } else {
            m_answer.ground = m_mayOverlap ? Ground::NotBehind : Ground::Apart;
        }
    }

    void takeQuestions()
    {
        if (m_answer.verdict == Verdict::NotCalledFor)
            return;
        m_answer.inQuestion.assign(m_primitives.triangles.size(), false);
        for (std::size_t i = 0; i < m_inQuestion.size(); ++i) {
            if (m_inQuestion[i])
                m_answer.inQuestion[m_candidates.triangles[i]] = true;
        }
        m_answer.shown = std::size_t(std::ranges::count(m_isShown, true));
    }

    bool isByArea() const { return m_where.antialiasing == Antialiasing::Area; }
    bool isCalledFor() const { return m_answer.verdict == Verdict::CalledFor; }
    DepthTriangle depthTriangle(std::size_t i) const
    {
        return {&m_primitives.triangles[m_candidates.triangles[i]], m_candidates.z[i],
                m_candidates.w[i]};
    }
    SampleBox sharedReach(std::size_t a, std::size_t b) const
    {
        return intersection(reachOf(*depthTriangle(a).triangle, m_where),
                            reachOf(*depthTriangle(b).triangle, m_where));
    }

    const Primitives &m_primitives;
    const DepthCandidates &m_candidates;
    SampledFrame m_where;
    DepthTiles m_tiles;
    TileBoxes m_boxes; ///< of the current tile
    std::vector<bool> m_inQuestion; ///< by candidate
    std::vector<bool> m_isShown; ///< by candidate: in question at a sample
    std::int64_t m_budget;
    DepthAnswer m_answer;
    bool m_mayOverlap = false;
    bool m_onlyBetweenSamples = false;
    std::optional<EdgePixels> m_edges;
    int m_steps = 0; ///< of searches for witnesses
};

} // namespace

std::size_t DepthAnswer::countInQuestion() const
{
    return std::size_t(std::ranges::count(inQuestion, true));
}

DepthAnswer depthQuestion(const Primitives &primitives, const ScanSettings &settings,
                          const FrameView &frame, Antialiasing antialiasing)
{
    DepthAnswer answer;
    if (primitives.appearance.depth != DepthUse::Auto || primitives.triangles.size() < 2)
        return answer;
    answer.ground = DepthAnswer::Ground::SameDepth;
    if (haveOneDepth(primitives))
        return answer;
    const SampledFrame where = sampledFrame(frame, settings, antialiasing);
    const DepthCandidates candidates = depthCandidatesOf(primitives, where);
    answer.ground = DepthAnswer::Ground::FewTriangles;
    if (candidates.boxes.size() < 2)
        return answer;
    answer.ground = DepthAnswer::Ground::InOrder;
    if (areInOrder(candidates))
        return answer;
    return PairComparison(primitives, where, candidates).answer();
}

} // namespace pixelplumb
