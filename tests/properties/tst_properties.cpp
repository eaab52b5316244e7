// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/properties/pictures.h"
#include "tests/support/casestorun.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_properties {

using namespace pixelplumb;
using tilings::Layout;
using tilings::Place;
using tilings::Tiling;

/// Properties of every triangle and every tiling in exact arithmetic. RC_PARAMS="seed=…" repeats a
/// run; each run prints its seed.
class TestProperties : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { drawFewerRandomCases(); }

    void theOrderOfTheVerticesDoesNotMatter()
    {
        QVERIFY(rc::check("six orders, one picture", [] {
            const Place place = somePlace();
            const Triangle triangle = someTriangle(place);
            for (const FillRule rule : {FillRule::Closed, FillRule::HalfOpenColumn}) {
                const ScanPicture expected = drawn(triangle, rule, frameAround(place));
                std::array<std::size_t, 3> order = {0, 1, 2};
                while (std::ranges::next_permutation(order).found) {
                    const Triangle permuted
                        = {{triangle.vertices[order[0]], triangle.vertices[order[1]],
                            triangle.vertices[order[2]]}};
                    // With coincident vertices of zero area, the first of equals gives the colour.
                    RC_PRE(doubledArea(triangle) != 0);
                    RC_ASSERT(drawn(permuted, rule, frameAround(place)) == expected);
                }
            }
        }));
    }

    void aMoveByWholePixelsMovesThePictureAndNothingElse()
    {
        QVERIFY(rc::check("translation", [] {
            const Place place = somePlace();
            const Triangle triangle = someTriangle(place);
            const auto right = *rc::gen::inRange<std::int32_t>(-(1 << 24), 1 << 24);
            const auto up = *rc::gen::inRange<std::int32_t>(-(1 << 24), 1 << 24);
            Triangle moved = triangle;
            for (Vertex &vertex : moved.vertices) {
                vertex.position.x += right * unitsPerPixel;
                vertex.position.y += up * unitsPerPixel;
            }
            const FrameSpec frame = frameAround(place);
            const FrameSpec movedFrame = frameOf(frame.width, frame.height,
                                                 frame.firstColumn + right, frame.firstRow + up);
            for (const FillRule rule : {FillRule::Closed, FillRule::HalfOpenColumn})
                RC_ASSERT(isImage(drawn(triangle, rule, frame), drawn(moved, rule, movedFrame),
                                  [&](std::int64_t x, std::int64_t y) {
                                      return LatticePoint{x + right, y + up};
                                  }));
        }));
    }

    /// The closed rule has no direction: it equals each of its mirror images.
    void mirroringMirrorsTheClosedPicture()
    {
        QVERIFY(rc::check("mirrored in x, in y", [] {
            const Place place = somePlace();
            const Triangle triangle = someTriangle(place);
            const FrameSpec frame = frameAround(place);
            const FrameSpec inX = frameOf(frame.width, frame.height,
                                          -(frame.firstColumn + frame.width - 1), frame.firstRow);
            const FrameSpec inY = frameOf(frame.width, frame.height, frame.firstColumn,
                                          -(frame.firstRow + frame.height - 1));
            RC_PRE(doubledArea(triangle) != 0);
            const ScanPicture expected = drawn(triangle, FillRule::Closed, frame);
            RC_ASSERT(isImage(expected,
                              drawn(mapped(triangle,
                                           [](LatticePoint p) {
                                               return LatticePoint{-p.x, p.y};
                                           }),
                                    FillRule::Closed, inX),
                              [](std::int64_t x, std::int64_t y) {
                                  return LatticePoint{-x, y};
                              }));
            RC_ASSERT(isImage(expected,
                              drawn(mapped(triangle,
                                           [](LatticePoint p) {
                                               return LatticePoint{p.x, -p.y};
                                           }),
                                    FillRule::Closed, inY),
                              [](std::int64_t x, std::int64_t y) {
                                  return LatticePoint{x, -y};
                              }));
        }));
    }

    /// (+ε², +ε) mirrored at the diagonal is (+ε, +ε²), which is top-left when y points down.
    void exchangingTheAxesTurnsTheColumnRuleIntoTopLeft()
    {
        QVERIFY(rc::check("half-open-column exchanged is top-left", [] {
            const Place place = somePlace();
            const Triangle triangle = someTriangle(place);
            const FrameSpec frame = frameAround(place);
            const Triangle exchanged = mapped(triangle, [](LatticePoint p) {
                return LatticePoint{p.y, -p.x};
            });
            const FrameSpec exchangedFrame = frameOf(frame.height, frame.width, frame.firstRow,
                                                     -(frame.firstColumn + frame.width - 1));
            RC_ASSERT(isImage(drawn(triangle, FillRule::HalfOpenColumn, frame),
                              drawn(exchanged, FillRule::TopLeft, exchangedFrame),
                              [](std::int64_t x, std::int64_t y) {
                                  return LatticePoint{y, -x};
                              }));
        }));
    }

    /// Turned by 180°, the sample is displaced the other way: the triangle then owns the closed
    /// triangle's samples without those of the opposite side.
    void oppositeDisplacementsShareTheBoundaryOut()
    {
        QVERIFY(rc::check("half-open and half-open turned cover no less than the inside", [] {
            const Place place = somePlace();
            const Triangle triangle = someTriangle(place);
            RC_PRE(doubledArea(triangle) != 0);
            const FrameSpec frame = frameAround(place);
            const FrameSpec turnedFrame
                = frameOf(frame.width, frame.height, -(frame.firstColumn + frame.width - 1),
                          -(frame.firstRow + frame.height - 1));
            const ScanPicture closed = drawn(triangle, FillRule::Closed, frame);
            const ScanPicture halfOpen = drawn(triangle, FillRule::HalfOpenColumn, frame);
            const ScanPicture turned = drawn(mapped(triangle,
                                                    [](LatticePoint p) {
                                                        return LatticePoint{-p.x, -p.y};
                                                    }),
                                             FillRule::HalfOpenColumn, turnedFrame);
            for (std::int64_t y = frame.firstRow; y < frame.firstRow + frame.height; ++y) {
                for (std::int64_t x = frame.firstColumn; x < frame.firstColumn + frame.width; ++x) {
                    const auto verdict = oracle::judge(triangle, FillRule::Closed, x, y);
                    const bool strictlyInside
                        = std::ranges::all_of(verdict.edges, [](const oracle::EdgeVerdict &edge) {
                              return edge.edgeFunction > 0;
                          });
                    const bool either = halfOpen.at(x, y) != 0 || turned.at(-x, -y) != 0;
                    const bool both = halfOpen.at(x, y) != 0 && turned.at(-x, -y) != 0;
                    RC_ASSERT(both == strictlyInside);
                    RC_ASSERT(!either || closed.at(x, y) != 0);
                }
            }
        }));
    }

    void tilingsAreCoveredExactlyOnce_data()
    {
        QTest::addColumn<int>("shape");
        QTest::newRow("fans") << int(Layout::Fan);
        QTest::newRow("strips") << int(Layout::Strip);
        QTest::newRow("grids") << int(Layout::Grid);
        QTest::newRow("T-junctions with exact middle vertices") << int(Layout::TJunction);
    }
    void tilingsAreCoveredExactlyOnce()
    {
        QFETCH(int, shape);
        const auto property = [&] {
            const Place place = somePlace();
            const Tiling tiling = tilings::tiling(Layout(shape), place);
            const FrameSpec frame = frameAround(place);
            for (const FillRule rule : watertight) {
                std::vector<int> times(std::size_t(frame.width) * std::size_t(frame.height), 0);
                for (const tilings::Corners &corners : tiling.triangles) {
                    RC_PRE(doubledArea(corners[0], corners[1], corners[2]) > 0);
                    count(times,
                          drawn(triangleAtUnits(corners[0], corners[1], corners[2]), rule, frame));
                }
                for (std::size_t i = 0; i < times.size(); ++i) {
                    const LatticePoint sample
                        = latticePixel(frame.firstColumn + std::int64_t(i) % frame.width,
                                       frame.firstRow + std::int64_t(i) / frame.width);
                    const std::optional<bool> inside = tilings::isInside(tiling.outline, sample);
                    if (inside.has_value())
                        RC_ASSERT(times[i] == (*inside ? 1 : 0));
                    else
                        RC_ASSERT(times[i] <= 1);
                }
            }
        };
        QVERIFY(rc::check(QTest::currentDataTag(), property));
    }

    void coloursStayWithinTheVerticesRange()
    {
        QVERIFY(rc::check("least vertex level <= level <= greatest", [] {
            const Place place = somePlace();
            const Triangle triangle = someTriangle(place);
            const FrameSpec frame = frameAround(place);
            const ScanPicture drawing = drawn(triangle, FillRule::Closed, frame);
            for (std::int64_t y = frame.firstRow; y < frame.firstRow + frame.height; ++y) {
                for (std::int64_t x = frame.firstColumn; x < frame.firstColumn + frame.width; ++x) {
                    if (drawing.at(x, y) == 0)
                        continue;
                    const Colour colour = unpacked(drawing.at(x, y));
                    for (std::size_t channel = 0; channel < 3; ++channel) {
                        const auto [least, greatest]
                            = std::minmax({triangle.vertices[0].colour.channels[channel],
                                           triangle.vertices[1].colour.channels[channel],
                                           triangle.vertices[2].colour.channels[channel]});
                        RC_ASSERT(colour.channels[channel] >= least);
                        RC_ASSERT(colour.channels[channel] <= greatest);
                    }
                }
            }
        }));
    }

    /// Closed: A + B/2 + 1 samples. Half-open: two congruent triangles tile a parallelogram, which
    /// holds as many samples as its area under any displacement.
    void picksTheoremCountsTheSamplesOfWholePixelTriangles()
    {
        QVERIFY(rc::check("Pick", [] {
            Place place = somePlace();
            place.grid = unitsPerPixel;
            const Triangle triangle = someTriangle(place);
            const Int128 area = absolute(doubledArea(triangle)) / (unitsPerPixel * unitsPerPixel);
            RC_PRE(area != 0);
            std::int64_t boundary = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const LatticePoint a = triangle.vertices[i].position;
                const LatticePoint b = triangle.vertices[(i + 1) % 3].position;
                boundary
                    += std::int64_t(greatestCommonDivisor(b.x - a.x, b.y - a.y)) / unitsPerPixel;
            }
            const std::int64_t closed
                = drawn(triangle, FillRule::Closed, frameAround(place)).count();
            RC_ASSERT(2 * closed == area + boundary + 2);
            // The parallelogram's other half is the triangle turned by 180°.
            const auto &v = triangle.vertices;
            Triangle other = triangle;
            other.vertices[0].position = {v[1].position.x + v[2].position.x - v[0].position.x,
                                          v[1].position.y + v[2].position.y - v[0].position.y};
            const auto side = std::int32_t(16 * place.cell);
            const auto corner = std::int32_t(place.origin - 6 * place.cell);
            const FrameSpec wide = frameOf(side, side, corner, corner);
            for (const FillRule rule : watertight)
                RC_ASSERT(drawn(triangle, rule, wide).count() + drawn(other, rule, wide).count()
                          == area);
        }));
    }

    void aWindowShowsItsPartOfTheWholePicture()
    {
        QVERIFY(rc::check("clipped frame = window of the unclipped one", [] {
            const Place place = somePlace();
            const Triangle triangle = someTriangle(place);
            const FrameSpec whole = frameAround(place);
            const auto width = *rc::gen::inRange<std::int32_t>(1, whole.width);
            const auto height = *rc::gen::inRange<std::int32_t>(1, whole.height);
            const FrameSpec window = frameOf(
                width, height,
                whole.firstColumn + *rc::gen::inRange<std::int32_t>(0, whole.width - width),
                whole.firstRow + *rc::gen::inRange<std::int32_t>(0, whole.height - height));
            for (const FillRule rule : {FillRule::Closed, FillRule::HalfOpenColumn})
                RC_ASSERT(isImage(drawn(triangle, rule, window), drawn(triangle, rule, whole),
                                  [](std::int64_t x, std::int64_t y) {
                                      return LatticePoint{x, y};
                                  }));
        }));
    }

private:
    static void count(std::vector<int> &times, const ScanPicture &drawing)
    {
        const FrameSpec &frame = drawing.spec();
        for (std::size_t i = 0; i < times.size(); ++i) {
            const bool covered = drawing.at(frame.firstColumn + std::int64_t(i) % frame.width,
                                            frame.firstRow + std::int64_t(i) / frame.width)
                != 0;
            times[i] += covered ? 1 : 0;
        }
    }
};

PIXELPLUMB_TEST(TestProperties)

} // namespace tst_properties

#include "tst_properties.moc"
