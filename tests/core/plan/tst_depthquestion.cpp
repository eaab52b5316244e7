// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/effectoracle.h"
#include "core/oracle/exactsample.h"
#include "core/oracle/oracle.h"
#include "core/oracle/squarearea.h"
#include "core/plan/depthquestion.h"
#include "core/plan/effectreason.h"
#include "core/plan/framereach.h"
#include "core/plan/sharededges.h"
#include "core/shade/edgepixels.h"
#include "tests/support/framespec.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/plannedtriangles.h"
#include "tests/support/testprogram.h"

#include <QRandomGenerator>
#include <QtTest>

#include <set>

namespace tst_depthquestion {

using namespace pixelplumb;

namespace {

constexpr int sidePixels = 24;

FrameView frameView()
{
    static const FrameBuffer frame(frameOf(sidePixels, sidePixels, -4, 3));
    return frame.view();
}

/// Triangles in and around the frame, on a coarse lattice so that edges and corners meet, with few
/// distinct depths.
Primitives randomScene(quint32 seed)
{
    QRandomGenerator random(seed);
    const Lattice steps[] = {unitsPerPixel, unitsPerPixel / 2, 37, 4 * unitsPerPixel};
    const Lattice step = steps[seed % 4];
    const int count = 2 + int(random.bounded(5));
    Primitives primitives;
    for (int i = 0; i < count; ++i) {
        Triangle triangle = triangleAt({});
        for (Vertex &vertex : triangle.vertices) {
            const auto coordinate = [&](Lattice first) {
                return first
                    + Lattice(random.bounded(quint32((sidePixels + 8) * 256 / step))) * step;
            };
            vertex.position = {coordinate(-8 * unitsPerPixel), coordinate(-unitsPerPixel)};
        }
        primitives.triangles.push_back(triangle);
        const auto quarter = [&] { return int(random.bounded(5)); };
        const int nearest = quarter();
        const bool isFlat = random.bounded(2) == 0;
        setDepths(primitives, std::size_t(i),
                  isFlat ? std::array<int, 3>{nearest, nearest, nearest}
                         : std::array<int, 3>{nearest, quarter(), quarter()});
    }
    return primitives;
}

/// One sample of a pixel, as antialiasing places it, and what each triangle has there.
class DrawnSample {
public:
    DrawnSample(const Primitives &primitives, const BoundaryRule &rule, Antialiasing antialiasing,
                const LatticePoint &offset, const SamplePlace &place)
    {
        oracle::EffectTruth what = oracle::truthOf(primitives.appearance);
        what.light = false; // light changes no depth and takes time
        for (std::size_t i = 0; i < primitives.triangles.size(); ++i) {
            Triangle seen = primitives.triangles[i];
            const bool isSegment = doubledArea(seen) == 0;
            for (Vertex &vertex : seen.vertices) {
                if (!isSegment)
                    vertex.position = {vertex.position.x - offset.x, vertex.position.y - offset.y};
            }
            const bool isDrawn = antialiasing == Antialiasing::Area && !isSegment
                ? oracle::areaInSquare(seen, place.x, place.y) > 0
                : oracle::covers(seen, rule, place.x, place.y);
            const auto exact = isDrawn
                ? oracle::exactSampleAt(primitives, i, seen, ByteRounding::Nearest, what, place.x,
                                        place.y)
                : std::nullopt;
            m_depths.push_back(exact ? std::optional(
                                   oracle::keptDepth(exact->z, primitives.appearance.depthFormat))
                                     : std::nullopt);
        }
    }

    bool isBehind(std::size_t later, std::size_t earlier) const
    {
        return m_depths[later] && m_depths[earlier]
            && !oracle::isNoFarther(*m_depths[later], *m_depths[earlier]);
    }

private:
    std::vector<std::optional<oracle::WideFraction>> m_depths; ///< of the triangles drawn here
};

/// The samples of a pixel: several if an edge meets its square.
std::vector<DrawnSample> samplesAt(const Primitives &primitives, const BoundaryRule &rule,
                                   Antialiasing antialiasing, const SamplePlace &place)
{
    const bool isOnEdge = std::ranges::any_of(primitives.triangles, [&](const Triangle &triangle) {
        return doubledArea(triangle) != 0 && oracle::edgeMeetsSquare(triangle, place.x, place.y);
    });
    std::vector<DrawnSample> samples;
    for (const LatticePoint &offset :
         oracle::sampleOffsets(isOnEdge ? antialiasing : Antialiasing::None))
        samples.emplace_back(primitives, rule, antialiasing, offset, place);
    return samples;
}

bool isBehindAt(const Primitives &primitives, std::size_t earlier, std::size_t later,
                const BoundaryRule &rule, Antialiasing antialiasing, const SamplePlace &place)
{
    return std::ranges::any_of(
        samplesAt(primitives, rule, antialiasing, place),
        [&](const DrawnSample &sample) { return sample.isBehind(later, earlier); });
}

/// The triangles that, at some sample, lie behind an earlier one or in front of a later one.
std::set<std::size_t> trulyInQuestion(const Primitives &primitives, const BoundaryRule &rule,
                                      FrameView frame,
                                      Antialiasing antialiasing = Antialiasing::None)
{
    std::set<std::size_t> found;
    for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
        for (std::int64_t x = frame.firstColumn; x < frame.endColumn(); ++x) {
            for (const DrawnSample &sample : samplesAt(primitives, rule, antialiasing, {x, y})) {
                for (std::size_t later = 1; later < primitives.triangles.size(); ++later) {
                    for (std::size_t earlier = 0; earlier < later; ++earlier) {
                        if (sample.isBehind(later, earlier))
                            found.insert({earlier, later});
                    }
                }
            }
        }
    }
    return found;
}

std::set<std::size_t> inQuestion(const DepthAnswer &answer)
{
    std::set<std::size_t> found;
    for (std::size_t i = 0; i < answer.inQuestion.size(); ++i) {
        if (answer.inQuestion[i])
            found.insert(i);
    }
    return found;
}

/// Triangles far larger than a frame of 3000 × 3000 px shows, each a little nearer than the one
/// before it and so tilted that their planes cross, mostly beyond the triangles.
Primitives tiltedSheets(quint32 seed)
{
    QRandomGenerator random(seed);
    Primitives primitives;
    constexpr int count = 40;
    for (int i = 0; i < count; ++i) {
        Triangle triangle = triangleAt({});
        setDepths(primitives, std::size_t(i), {});
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.vertices[k].position
                = latticePixel(random.bounded(5000) - 1000, random.bounded(5000) - 1000);
            attributesAt(primitives, std::size_t(i)).vertices[k].z
                = (count - i) * attributeOne / (count + 1)
                + Attribute(random.bounded(quint32(3 * attributeOne / count)));
        }
        primitives.triangles.push_back(triangle);
    }
    return primitives;
}

/// A terrain of triangles over the frame, two per square of the grid; the depth grows with the
/// column and, by `slope`, with the row.
Primitives grid(int cells, FrameView frame, int slope)
{
    Primitives primitives;
    const Lattice size = frame.width * unitsPerPixel / cells;
    const auto corner = [&](int i, int j) { return LatticePoint{i * size, j * size}; };
    const auto depth = [&](int i, int j) {
        return Attribute(i * i + j * slope) * attributeOne / (cells * cells * 8);
    };
    const auto add = [&](std::array<std::array<int, 2>, 3> corners) {
        TriangleAttributes attributes{primitives.triangles.size(), {}, noMaterial};
        Triangle triangle = triangleAt({});
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.vertices[k].position = corner(corners[k][0], corners[k][1]);
            attributes.vertices[k].z = depth(corners[k][0], corners[k][1]);
        }
        primitives.triangles.push_back(triangle);
        primitives.attributes.push_back(attributes);
    };
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            add({{{i, j}, {i + 1, j}, {i, j + 1}}});
            add({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
        }
    }
    return primitives;
}

DepthAnswer answerFor(const Primitives &primitives, FrameView frame,
                      FillRule rule = FillRule::Closed,
                      Antialiasing antialiasing = Antialiasing::None)
{
    return depthQuestion(primitives, {Arithmetic::Exact, rule, ByteRounding::Nearest}, frame,
                         antialiasing);
}

/// A random scene with different w, in which every third triangle has no area.
Primitives randomSceneOfSegments(quint32 seed)
{
    Primitives primitives = randomScene(seed);
    QRandomGenerator random(seed);
    for (std::size_t i = 0; i < primitives.triangles.size(); ++i) {
        auto &vertices = primitives.triangles[i].vertices;
        if (i % 3 == seed % 3)
            vertices[1].position = random.bounded(2) == 0
                ? vertices[0].position
                : LatticePoint{2 * vertices[0].position.x - vertices[2].position.x,
                               2 * vertices[0].position.y - vertices[2].position.y};
        vertices[0].colour = {};
        for (VertexAttributes &vertex : attributesAt(primitives, i).vertices)
            vertex.w = attributeOne << random.bounded(6);
    }
    return primitives;
}

} // namespace

class TestDepthQuestion : public QObject {
    Q_OBJECT

private slots:
    void theAnswerIsThatOfAllSamples_data()
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 0; seed < quint32(fewerIfSanitized(200)); ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void theAnswerIsThatOfAllSamples()
    {
        QFETCH(quint32, seed);
        const Primitives primitives = randomScene(seed);
        const FillRule rule = allFillRules[seed / 4 % allFillRules.size()];
        const BoundaryRule boundary({Arithmetic::Exact, rule, ByteRounding::Nearest}, frameView());

        const DepthAnswer answer = answerFor(primitives, frameView(), rule);
        const std::set<std::size_t> truly = trulyInQuestion(primitives, boundary, frameView());

        QCOMPARE(int(answer.verdict),
                 int(truly.empty() ? Verdict::NotCalledFor : Verdict::CalledFor));
        QCOMPARE(inQuestion(answer), truly);
        if (answer.verdict == Verdict::CalledFor)
            QVERIFY(isBehindAt(primitives, answer.earlier, answer.later, boundary,
                               Antialiasing::None, answer.place));
    }

    void theAnswerIsThatOfWhatAntialiasingDraws_data()
    {
        QTest::addColumn<Antialiasing>("antialiasing");
        QTest::newRow("one sample") << Antialiasing::None;
        QTest::newRow("4 samples") << Antialiasing::Samples4;
        QTest::newRow("16 samples") << Antialiasing::Samples16;
        QTest::newRow("area") << Antialiasing::Area;
    }
    void theAnswerIsThatOfWhatAntialiasingDraws()
    {
        QFETCH(Antialiasing, antialiasing);
        const FrameBuffer frame(frameOf(9, 9, -4, 3));
        int calledFor = 0;
        for (quint32 seed = 0; seed < quint32(fewerIfSanitized(60)); ++seed) {
            Primitives primitives = randomSceneOfSegments(seed);
            primitives.appearance.antialiasing = antialiasing;
            primitives.appearance.depthFormat
                = seed % 5 == 0 ? DepthFormat::Bits16 : DepthFormat::Exact;
            const FillRule rule
                = seed % 3 == 0 ? allFillRules[seed / 3 % allFillRules.size()] : FillRule::Closed;
            const BoundaryRule boundary({Arithmetic::Exact, rule, {}}, frame.view());
            const DepthAnswer answer = answerFor(primitives, frame.view(), rule, antialiasing);
            const std::set<std::size_t> truly
                = trulyInQuestion(primitives, boundary, frame.view(), antialiasing);

            QVERIFY2(inQuestion(answer) == truly, qPrintable(QString::number(seed)));
            QCOMPARE(answer.shown, truly.size());
            QCOMPARE(answer.verdict == Verdict::CalledFor, !truly.empty());
            QCOMPARE(answer.verdict == Verdict::NotCalledFor, truly.empty());
            if (truly.empty())
                continue;
            QVERIFY(isBehindAt(primitives, answer.earlier, answer.later, boundary, antialiasing,
                               answer.place));
            ++calledFor;
        }
        QVERIFY(calledFor > 0 || isSanitized); // too few scenes then
    }

    void manyLargeTrianglesAskOnlyWhatTheirPairsAsk()
    {
        const FrameBuffer frame(frameOf(3000, 3000));
        std::size_t asked = 0, all = 0;
        for (quint32 seed = 0; seed < 4; ++seed) {
            const Primitives primitives = tiltedSheets(seed);
            const auto answerOf = [&](const Primitives &some) {
                return answerFor(some, frame.view(), FillRule::HalfOpenColumn, Antialiasing::Area);
            };
            std::set<std::size_t> ofPairs;
            for (std::size_t later = 1; later < primitives.triangles.size(); ++later) {
                for (std::size_t earlier = 0; earlier < later; ++earlier) {
                    Primitives pair;
                    for (const std::size_t i : {earlier, later}) {
                        pair.attributes.push_back(primitives.attributes[i]);
                        pair.attributes.back().triangle = pair.triangles.size();
                        pair.triangles.push_back(primitives.triangles[i]);
                    }
                    const DepthAnswer answer = answerOf(pair);
                    QVERIFY(answer.verdict != Verdict::NotRuledOut);
                    if (answer.verdict == Verdict::CalledFor)
                        ofPairs.insert({earlier, later});
                }
            }
            const DepthAnswer answer = answerOf(primitives);

            QCOMPARE(inQuestion(answer), ofPairs);
            QCOMPARE(answer.shown, ofPairs.size());
            asked += ofPairs.size();
            all += primitives.triangles.size();
        }
        QVERIFY(asked > 0);
        QVERIFY(asked < all);
    }

    void whatWasNotRuledOutIsToldApartFromWhatIsSeen()
    {
        // In 16 bits the first two have one level at each of 28,000 pixels; of the others the later
        // lies behind.
        const FrameBuffer frame(frameOf(300, 300));
        const Triangle large = triangleAt({{{0, 0}, {240, 0}, {0, 240}}});
        const Triangle small = triangleAt({{{250, 250}, {290, 250}, {250, 290}}});
        Primitives primitives;
        primitives.triangles = {large, large, small, small};
        for (std::size_t i = 0; i < 3; ++i)
            setDepths(primitives, i, {1, 1, 1});
        for (VertexAttributes &vertex : attributesAt(primitives, 1).vertices)
            ++vertex.z;
        setDepths(primitives, 3, {2, 2, 2});
        primitives.appearance.depthFormat = DepthFormat::Bits16;

        const DepthAnswer answer = answerFor(primitives, frame.view());
        QCOMPARE(answer.countInQuestion(), std::size_t(4));
        QCOMPARE(answer.shown, std::size_t(2));
        QVERIFY(depthReason(answer, {frame.view()})
                    .endsWith(QStringLiteral("; 2 triangles are in question, and 2 more may be")));
    }

    void depthsOfAnySizeAreComparedInTheirLastUnit()
    {
        for (quint32 seed = 0; seed < quint32(fewerIfSanitized(200)); ++seed) {
            Primitives primitives = randomScene(seed);
            QRandomGenerator random(seed + 1);
            for (TriangleAttributes &attributes : primitives.attributes) {
                for (VertexAttributes &vertex : attributes.vertices)
                    vertex.z = (vertex.z - attributeOne / 2) * largestAttributeValue
                        + Attribute(random.bounded(3));
            }
            const BoundaryRule boundary({Arithmetic::Exact, FillRule::Closed, {}}, frameView());
            const std::set<std::size_t> truly = trulyInQuestion(primitives, boundary, frameView());

            const DepthAnswer answer = answerFor(primitives, frameView());
            QCOMPARE(answer.verdict != Verdict::NotCalledFor, !truly.empty());
            QCOMPARE(inQuestion(answer), truly);
        }
    }

    void aContinuousMeshNeedsNoDepthUnderAnyRule()
    {
        const FrameBuffer frame(frameOf(200, 200));
        const Primitives primitives = grid(60, frame.view(), 3);
        for (const FillRule rule : allFillRules) {
            const DepthAnswer answer = answerFor(primitives, frame.view(), rule);
            QCOMPARE(int(answer.verdict), int(Verdict::NotCalledFor));
            QVERIFY(answer.inQuestion.empty());
        }
    }

    void manyTrianglesAreComparedInFewOperationsEach()
    {
        const FrameBuffer frame(frameOf(500, 500));
        const Primitives few = grid(20, frame.view(), 3);
        const Primitives many = grid(200, frame.view(), 3);
        const auto operationsEach = [&](const Primitives &primitives) {
            return double(answerFor(primitives, frame.view()).operations)
                / double(primitives.triangles.size());
        };
        QVERIFY(operationsEach(many) < 1000);
        QVERIFY(operationsEach(many) < 2 * operationsEach(few));
    }

    void whatCannotBeComparedInTimeIsNotRuledOut()
    {
        // Slivers that all cross, each a little nearer than the previous one, but with overlapping
        // ranges.
        const FrameBuffer frame(frameOf(200, 200));
        Primitives primitives;
        for (int i = 0; i < 3000; ++i) {
            Triangle triangle = triangleAt({{{0, 0}, {199, 100}, {199, 101}}});
            triangle.vertices[0].position.y = i;
            primitives.triangles.push_back(triangle);
            setDepths(primitives, std::size_t(i), {0, 3, 3});
            for (VertexAttributes &vertex : primitives.attributes.back().vertices)
                vertex.z -= i;
        }
        const DepthAnswer answer = answerFor(primitives, frame.view());

        QCOMPARE(int(answer.ground), int(DepthAnswer::Ground::TooMany));
        QCOMPARE(int(answer.verdict), int(Verdict::NotRuledOut));
        QCOMPARE(answer.countInQuestion(), primitives.triangles.size());
        QCOMPARE(answer.shown, std::size_t(0));
        QVERIFY(answer.operations < 10'000'000);
    }

    void touchedPixelsAreBoundedFromAbove()
    {
        for (quint32 seed = 0; seed < quint32(fewerIfSanitized(400)); ++seed) {
            for (const Triangle &triangle : randomScene(seed).triangles) {
                const FrameView frame = frameView();
                std::int64_t covered = 0;
                for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
                    for (std::int64_t x = frame.firstColumn; x < frame.endColumn(); ++x)
                        covered += oracle::covers(triangle, FillRule::Closed, x, y) ? 1 : 0;
                }
                const SampleBox reach = reachOf(triangle, {frame});
                QVERIFY(mostPixelsOf(triangle, reach, Antialiasing::None) >= covered);
            }
        }
    }

    void touchedSquaresAreBoundedFromAbove()
    {
        for (quint32 seed = 0; seed < quint32(fewerIfSanitized(60)); ++seed) {
            for (const Triangle &triangle : randomScene(seed).triangles) {
                const FrameView frame = frameView();
                std::int64_t touched = 0;
                for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
                    for (std::int64_t x = frame.firstColumn; x < frame.endColumn(); ++x)
                        touched += oracle::areaInSquare(triangle, x, y) > 0 ? 1 : 0;
                }
                for (const Antialiasing antialiasing :
                     {Antialiasing::Area, Antialiasing::Samples4}) {
                    const SampleBox reach
                        = reachOf(triangle, {frame, FillRule::Closed, antialiasing});
                    if (antialiasing == Antialiasing::Samples4 && reach.isEmpty())
                        continue; // it touches squares but none of their samples
                    QVERIFY(mostPixelsOf(triangle, reach, antialiasing) >= touched);
                }
            }
        }
    }

    void samplesOnSharedEdgesAreCountedOnce()
    {
        const FrameView frame = frameView();
        int seen = 0;
        for (quint32 seed = 0; seed < quint32(fewerIfSanitized(200)); ++seed) {
            for (const Antialiasing antialiasing : {Antialiasing::None, Antialiasing::Samples4}) {
                const Triangle triangle = randomScene(seed).triangles.front();
                const std::array<const Triangle *, 2> twice = {&triangle, &triangle};
                const SampledFrame where{frame, FillRule::Closed, antialiasing};

                std::int64_t expected = 0;
                if (samplePattern(where.antialiasingOf(triangle)).empty())
                    expected = samplesOnEdgesOf(triangle, frame);
                for (const LatticePoint &sample : samplePattern(where.antialiasingOf(triangle)))
                    expected += samplesOnEdgesOf(seenFrom(triangle, sample), frame);
                seen += expected > 0 ? 1 : 0;

                const std::span<const Triangle *const> both(twice);
                QCOMPARE(sharedSamplesOf(both, {}, where).samples, expected);
                // First, one of the two lets the other show through; then neither does.
                QCOMPARE(sharedSamplesOf(both.first(1), both.last(1), where).samples, expected);
                QCOMPARE(sharedSamplesOf({}, both, where).samples, 0);
            }
        }
        QVERIFY(seen > 10);
    }

private:
    /// The number of pixel centres on the border of a triangle.
    static std::int64_t samplesOnEdgesOf(const Triangle &triangle, const FrameView &frame)
    {
        std::int64_t count = 0;
        for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
            for (std::int64_t x = frame.firstColumn; x < frame.endColumn(); ++x) {
                bool isOnEdge = false;
                for (std::size_t i = 0; i < 3; ++i) {
                    Triangle edge = triangle;
                    edge.vertices[(i + 2) % 3] = edge.vertices[i];
                    isOnEdge |= oracle::covers(edge, FillRule::Closed, x, y);
                }
                count += isOnEdge ? 1 : 0;
            }
        }
        return count;
    }
};

PIXELPLUMB_TEST(TestDepthQuestion)

} // namespace tst_depthquestion

#include "tst_depthquestion.moc"
