// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/depthquestion.h"
#include "core/effects/framereach.h"
#include "core/effects/sharededges.h"
#include "core/number/wideinteger.h"
#include "core/oracle/oracle.h"
#include "core/oracle/squarearea.h"
#include "tests/support/framespec.h"
#include "tests/support/plannedtriangles.h"
#include "tests/support/sanitized.h"
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

/// Triangles in and about the frame, on a coarse lattice so that edges and corners meet, with
/// depths of few values.
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

/// The depth at a sample, numerator and denominator > 0.
std::pair<Int256, Int256> depthAt(const Primitives &primitives, std::size_t triangle,
                                  const SamplePlace &place)
{
    const auto verdict
        = oracle::judge(primitives.triangles[triangle], FillRule::Closed, place.x, place.y);
    Int256 numerator = 0, denominator = 0;
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const Attribute z = primitives.attributesOf(triangle)->vertices[(edge + 2) % 3].z;
        numerator += Int256(verdict.edges[edge].edgeFunction) * z;
        denominator += Int256(verdict.edges[edge].edgeFunction);
    }
    return {numerator, denominator};
}

bool isBehindAt(const Primitives &primitives, std::size_t earlier, std::size_t later,
                const BoundaryRule &rule, const SamplePlace &place)
{
    for (const std::size_t each : {earlier, later}) {
        if (doubledArea(primitives.triangles[each]) == 0
            || !oracle::covers(primitives.triangles[each], rule, place.x, place.y))
            return false;
    }
    const auto [a, aBelow] = depthAt(primitives, earlier, place);
    const auto [b, bBelow] = depthAt(primitives, later, place);
    return b * aBelow > a * bBelow;
}

/// The triangles that lie behind an earlier one, or before a later one, at some sample.
std::set<std::size_t> trulyInQuestion(const Primitives &primitives, const BoundaryRule &rule)
{
    std::set<std::size_t> found;
    const FrameView frame = frameView();
    for (std::size_t later = 1; later < primitives.triangles.size(); ++later) {
        for (std::size_t earlier = 0; earlier < later; ++earlier) {
            for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
                for (std::int64_t x = frame.firstColumn; x < frame.endColumn(); ++x) {
                    if (isBehindAt(primitives, earlier, later, rule, {x, y}))
                        found.insert({earlier, later});
                }
            }
        }
    }
    return found;
}

/// A terrain of triangles over the frame, each square of the grid two, later rows farther away
/// where `isTilted`.
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
                      FillRule rule = FillRule::Closed)
{
    return depthQuestion(primitives, {Arithmetic::Exact, rule, ByteRounding::Nearest}, frame,
                         Antialiasing::None);
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
        const std::set<std::size_t> truly = trulyInQuestion(primitives, boundary);

        QCOMPARE(int(answer.verdict),
                 int(truly.empty() ? Verdict::NotCalledFor : Verdict::CalledFor));
        for (const std::size_t triangle : truly)
            QVERIFY(answer.inQuestion[triangle]);
        if (answer.verdict == Verdict::CalledFor)
            QVERIFY(isBehindAt(primitives, answer.earlier, answer.later, boundary, answer.place));
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
            const std::set<std::size_t> truly = trulyInQuestion(primitives, boundary);

            const DepthAnswer answer = answerFor(primitives, frameView());
            QCOMPARE(answer.verdict != Verdict::NotCalledFor, !truly.empty());
            for (const std::size_t triangle : truly)
                QVERIFY(answer.inQuestion[triangle]);
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
        // Slivers that all cross, each a little nearer than the one before, but not by range.
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
                const SampleBox reach = reachOf(triangle, frame, Antialiasing::None);
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
                    const SampleBox reach = reachOf(triangle, frame, antialiasing);
                    QVERIFY(mostPixelsOf(triangle, reach, antialiasing) >= touched);
                }
            }
        }
    }

    void samplesOnSharedEdgesAreCountedOnce()
    {
        for (quint32 seed = 0; seed < quint32(fewerIfSanitized(200)); ++seed) {
            const Triangle triangle = randomScene(seed).triangles.front();
            const std::array<const Triangle *, 2> twice = {&triangle, &triangle};
            const FrameView frame = frameView();

            std::int64_t expected = 0;
            for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
                for (std::int64_t x = frame.firstColumn; x < frame.endColumn(); ++x) {
                    bool isOnEdge = false;
                    for (std::size_t i = 0; i < 3; ++i) {
                        Triangle edge = triangle;
                        edge.vertices[(i + 2) % 3] = edge.vertices[i];
                        isOnEdge |= oracle::covers(edge, FillRule::Closed, x, y);
                    }
                    expected += isOnEdge ? 1 : 0;
                }
            }
            const std::span<const Triangle *const> both(twice);
            QCOMPARE(sharedSamplesOf(both, {}, frame).samples, expected);
            // One of them lets the other through; neither does.
            QCOMPARE(sharedSamplesOf(both.first(1), both.last(1), frame).samples, expected);
            QCOMPARE(sharedSamplesOf({}, both, frame).samples, 0);
        }
    }
};

PIXELPLUMB_TEST(TestDepthQuestion)

} // namespace tst_depthquestion

#include "tst_depthquestion.moc"
