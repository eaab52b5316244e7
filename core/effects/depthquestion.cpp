// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/depthquestion.h"

#include "core/effects/depthtiles.h"
#include "core/effects/framereach.h"

#include <algorithm>
#include <limits>

namespace pixelplumb {

namespace {

// What things cost, in comparisons of two boxes, and how much may be spent.
constexpr std::int64_t meetingCost = 6;
constexpr std::int64_t planesCost = 20;
constexpr std::int64_t behindCost = 140;
constexpr std::int64_t sampleCost = 10;
constexpr std::int64_t leastBudget = 1'000'000;
constexpr std::int64_t budgetPerTriangle = 260;
/// How many samples are looked at, of pairs one after another, for a witness.
constexpr int mostSamples = 50'000;

/// The triangles that take part, each with its box in the frame and its range of depths.
struct Candidates {
    std::vector<UnitBox> boxes;
    std::vector<std::uint32_t> triangles; ///< indices in the primitives
    std::vector<std::array<Attribute, 3>> z;

    Attribute nearest(std::size_t i) const { return std::ranges::min(z[i]); }
    Attribute farthest(std::size_t i) const { return std::ranges::max(z[i]); }
    bool isFlat(std::size_t i) const { return nearest(i) == farthest(i); }
};

std::array<Attribute, 3> depthsOf(const TriangleAttributes &attributes)
{
    const auto &vertices = attributes.vertices;
    return {vertices[0].z, vertices[1].z, vertices[2].z};
}

/// Triangles without attributes have depth 0.
bool haveOneDepth(const Primitives &primitives)
{
    const std::vector<TriangleAttributes> &attributes = primitives.attributes;
    if (attributes.empty())
        return true;
    const Attribute depth
        = attributes.size() < primitives.triangles.size() ? 0 : attributes[0].vertices[0].z;
    return std::ranges::all_of(attributes, [depth](const TriangleAttributes &each) {
        return std::ranges::all_of(
            each.vertices, [depth](const VertexAttributes &vertex) { return vertex.z == depth; });
    });
}

/// The triangle's bounding box, widened by a margin, within the frame so widened.
UnitBox boxWithin(const Triangle &triangle, const FrameView &frame, Lattice margin)
{
    const auto &v = triangle.vertices;
    const auto [left, right] = std::minmax({v[0].position.x, v[1].position.x, v[2].position.x});
    const auto [low, high] = std::minmax({v[0].position.y, v[1].position.y, v[2].position.y});
    const auto within = [margin](Lattice coordinate, std::int32_t first, std::int32_t count) {
        const Lattice fromFirst = coordinate - first * unitsPerPixel + margin;
        return std::int32_t(
            std::clamp<Lattice>(fromFirst, 0, (count - 1) * unitsPerPixel + 2 * margin));
    };
    return {within(left - margin, frame.firstColumn, frame.width),
            within(right + margin, frame.firstColumn, frame.width),
            within(low - margin, frame.firstRow, frame.height),
            within(high + margin, frame.firstRow, frame.height)};
}

Lattice marginOf(Antialiasing antialiasing)
{
    return antialiasing == Antialiasing::None ? 0 : halfPixel;
}

Candidates candidatesOf(const Primitives &primitives, const FrameView &frame,
                        Antialiasing antialiasing)
{
    Candidates candidates;
    auto attributes = primitives.attributes.begin();
    for (std::size_t i = 0; i < primitives.triangles.size(); ++i) {
        std::array<Attribute, 3> z = {};
        if (attributes != primitives.attributes.end() && attributes->triangle == i)
            z = depthsOf(*attributes++);
        const Triangle &triangle = primitives.triangles[i];
        if (reachOf(triangle, frame, antialiasing).isEmpty() || doubledArea(triangle) == 0)
            continue;
        candidates.boxes.push_back(boxWithin(triangle, frame, marginOf(antialiasing)));
        candidates.triangles.push_back(std::uint32_t(i));
        candidates.z.push_back(z);
    }
    return candidates;
}

bool areInOrder(const Candidates &candidates)
{
    Attribute nearest = std::numeric_limits<Attribute>::max();
    for (std::size_t i = 0; i < candidates.z.size(); ++i) {
        if (candidates.farthest(i) > nearest)
            return false;
        nearest = candidates.nearest(i);
    }
    return true;
}

/// Compares the triangles of each tile, two by two.
class PairComparison {
public:
    PairComparison(const Primitives &primitives, const ScanSettings &settings,
                   const FrameView &frame, Antialiasing antialiasing, const Candidates &candidates)
        : m_primitives(primitives)
        , m_candidates(candidates)
        , m_rule(settings, frame)
        , m_frame(frame)
        , m_antialiasing(antialiasing)
        , m_tiles(candidates.boxes, sideOf(frame.width), sideOf(frame.height))
        , m_inQuestion(candidates.boxes.size(), false)
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
    std::int32_t sideOf(std::int32_t pixels) const
    {
        return std::int32_t((pixels - 1) * unitsPerPixel + 2 * marginOf(m_antialiasing));
    }

    /// False when no more can be compared.
    bool compareTile(std::size_t tile)
    {
        const std::span<const TiledBox> boxes = m_tiles.boxesOf(tile);
        for (std::size_t later = 1; later < boxes.size(); ++later) {
            const UnitBox &b = boxes[later].box;
            for (std::size_t earlier = 0; earlier < later; ++earlier) {
                const UnitBox &a = boxes[earlier].box;
                if (a.meets(b)
                    && m_tiles.tileAt(std::max(a.left, b.left), std::max(a.low, b.low)) == tile)
                    compare(boxes[earlier].place, boxes[later].place);
            }
            m_answer.operations += std::int64_t(later);
            if (m_answer.operations > m_budget)
                return false;
        }
        return true;
    }

    void compare(std::size_t earlier, std::size_t later)
    {
        m_answer.operations += meetingCost;
        // Depth runs for both already: nothing more is learnt, once it is known that it must.
        if (m_inQuestion[earlier] && m_inQuestion[later] && isCalledFor())
            return;
        const bool inOrder = m_candidates.farthest(later) <= m_candidates.nearest(earlier);
        if (m_antialiasing == Antialiasing::Area
            && !(m_candidates.isFlat(earlier) && m_candidates.isFlat(later))) {
            // A plane counts at samples outside of its triangle, too.
            question(earlier, later);
        } else if (!inOrder || !m_mayOverlap) {
            compareOverlap(earlier, later, inOrder);
        }
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
        // What the pixel's square has of a triangle is blended: they overlap where boxes do.
        if (m_antialiasing == Antialiasing::Area)
            return PlaneOrder::Behind;
        return planeOrderOf(depthTriangle(earlier), depthTriangle(later), m_rule.rule);
    }

    /// Somewhere the later one lies behind, or may.
    void question(std::size_t earlier, std::size_t later)
    {
        if (!isCalledFor() && m_samples < mostSamples) {
            const WitnessSearch search = searchWitness(depthTriangle(earlier), depthTriangle(later),
                                                       sharedReach(earlier, later), m_rule,
                                                       m_primitives.appearance.depthFormat);
            m_samples += search.samples;
            m_answer.operations += sampleCost * search.samples;
            if (search.wasComplete && !search.found && m_antialiasing == Antialiasing::None) {
                m_onlyBetweenSamples = true;
                return;
            }
            if (search.found)
                m_answer.verdict = Verdict::CalledFor;
            if (search.found || m_answer.verdict == Verdict::NotCalledFor)
                keepExample(earlier, later, search.found.value_or(SamplePlace{}));
        }
        if (!isCalledFor())
            m_answer.verdict = Verdict::NotRuledOut;
        m_inQuestion[earlier] = true;
        m_inQuestion[later] = true;
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
    }

    bool isCalledFor() const { return m_answer.verdict == Verdict::CalledFor; }
    DepthTriangle depthTriangle(std::size_t i) const
    {
        return {&m_primitives.triangles[m_candidates.triangles[i]], m_candidates.z[i]};
    }
    SampleBox sharedReach(std::size_t a, std::size_t b) const
    {
        return intersection(reachOf(*depthTriangle(a).triangle, m_frame, Antialiasing::None),
                            reachOf(*depthTriangle(b).triangle, m_frame, Antialiasing::None));
    }

    const Primitives &m_primitives;
    const Candidates &m_candidates;
    BoundaryRule m_rule;
    FrameView m_frame;
    Antialiasing m_antialiasing;
    DepthTiles m_tiles;
    std::vector<bool> m_inQuestion; ///< by candidate
    std::int64_t m_budget;
    DepthAnswer m_answer;
    bool m_mayOverlap = false;
    bool m_onlyBetweenSamples = false;
    int m_samples = 0; ///< looked at
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
    const Candidates candidates = candidatesOf(primitives, frame, antialiasing);
    answer.ground = DepthAnswer::Ground::FewTriangles;
    if (candidates.boxes.size() < 2)
        return answer;
    answer.ground = DepthAnswer::Ground::InOrder;
    const bool planesEndAtEdges = antialiasing != Antialiasing::Area;
    if (planesEndAtEdges && areInOrder(candidates))
        return answer;
    return PairComparison(primitives, settings, frame, antialiasing, candidates).answer();
}

} // namespace pixelplumb
