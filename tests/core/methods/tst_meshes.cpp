// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/oracle/effectoracle.h"
#include "tests/support/framespec.h"
#include "tests/support/scenes/trianglemeshes.h"
#include "tests/support/scenes/trianglepictures.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_meshes {

using namespace pixelplumb;

namespace {

/// Samples of a mesh's rectangle that are not covered exactly once.
struct MeshFaults {
    int holes = 0;
    int doubles = 0;

    MeshFaults &operator+=(const MeshFaults &other)
    {
        holes += other.holes;
        doubles += other.doubles;
        return *this;
    }
    friend bool operator==(const MeshFaults &, const MeshFaults &) = default;
};

/// Draws triangle by triangle and counts how often each sample of a window around the mesh is
/// covered.
MeshFaults faultsOf(const TriangleMesh &mesh, const Method &method, const ScanSettings &settings)
{
    const auto first = [](Lattice coordinate) { return std::int32_t(floorPixel(coordinate)) - 1; };
    const std::int32_t left = first(mesh.lowest.x), low = first(mesh.lowest.y);
    const auto side = std::int32_t(ceilPixel(mesh.highest.x)) + 2 - left;
    ScanPicture picture(frameOf(side, side, left, low));
    std::vector<int> counts(picture.pixels().size(), 0);
    for (const Triangle &triangle : mesh.triangles) {
        picture.clear();
        picture.draw(method, triangle, settings);
        for (std::size_t i = 0; i < counts.size(); ++i)
            counts[i] += int(picture.pixels()[i] != 0);
    }
    MeshFaults faults;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const LatticePoint sample
            = latticePixel(left + std::int64_t(i) % side, low + std::int64_t(i) / side);
        const bool isInside = sample.x > mesh.lowest.x && sample.x < mesh.highest.x
            && sample.y > mesh.lowest.y && sample.y < mesh.highest.y;
        faults.holes += int(isInside && counts[i] == 0);
        faults.doubles += int(counts[i] > 1);
    }
    return faults;
}

/// In float32, 16384 px from the origin on the finest lattice: products of coordinates are rounded.
MeshFaults faultsFarFromTheOrigin(const Method &method)
{
    MeshFaults faults;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const MeshPlace place{{16384 * unitsPerPixel + 5, 16384 * unitsPerPixel + 15}, 1};
        for (const TriangleMesh &mesh : MeshMaker(place, seed).all())
            faults += faultsOf(mesh, method,
                               {Arithmetic::Float32, FillRule::TopLeft, ByteRounding::Nearest});
    }
    return faults;
}

/// Whether an edge's line passes through the off-screen point, where the rule guarantees nothing.
bool meetsOffScreenPoint(const TriangleMesh &mesh)
{
    const LatticePoint point = latticePixel(-1, -1);
    return std::ranges::any_of(mesh.triangles, [&](const Triangle &triangle) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (doubledArea(triangle.vertices[i].position, triangle.vertices[(i + 1) % 3].position,
                            point)
                == 0)
                return true;
        }
        return false;
    });
}

std::vector<MeshPlace> places()
{
    std::vector<MeshPlace> found;
    for (const Lattice step : {256, 16, 1}) {
        for (const Lattice origin : {0, 16384, -16384, 1 << 20, -(1 << 20)}) {
            // Vertices lie between samples on the finer lattices.
            const Lattice shift = step == 256 ? 0 : 5 * step;
            found.push_back({{origin * unitsPerPixel + shift, -origin * unitsPerPixel + 3 * shift},
                             step,
                             24 * unitsPerPixel});
        }
    }
    return found;
}

constexpr std::array watertightRules
    = {FillRule::HalfOpenColumn, FillRule::TopLeft, FillRule::OffScreenPoint};

} // namespace

/// A mesh of triangles is one surface: under a watertight rule no sample is missed or drawn twice.
class TestMeshes : public QObject {
    Q_OBJECT

private slots:
    void everyStableMethodCoversEachInteriorSampleOnce_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<ScanSettings>("settings");
        for (const Method *method : triangleMethods()) {
            for (const Arithmetic arithmetic : method->stableArithmetics) {
                for (const FillRule rule : watertightRules) {
                    const ScanSettings settings{arithmetic, rule, ByteRounding::Nearest};
                    if (method->supports(rule))
                        QTest::newRow(rowName(*method, settings).c_str()) << method->id << settings;
                }
            }
        }
    }
    void everyStableMethodCoversEachInteriorSampleOnce()
    {
        QFETCH(QString, id);
        QFETCH(ScanSettings, settings);
        const Method &method = *methodNamed(id);
        int meshes = 0;
        for (const MeshPlace &place : places()) {
            constexpr std::uint64_t seed = 3;
            for (const TriangleMesh &mesh : MeshMaker(place, seed).all()) {
                if (settings.fillRule == FillRule::OffScreenPoint && meetsOffScreenPoint(mesh))
                    continue;
                const MeshFaults faults = faultsOf(mesh, method, settings);
                QVERIFY2(faults == MeshFaults(),
                         qPrintable(u"%1 holes, %2 doubles; seed %3, %4 triangles "
                                    "from (%5, %6) in steps of %7/256 px"_s.arg(faults.holes)
                                        .arg(faults.doubles)
                                        .arg(seed)
                                        .arg(mesh.triangles.size())
                                        .arg(place.origin.x)
                                        .arg(place.origin.y)
                                        .arg(place.step)));
                ++meshes;
            }
        }
        QVERIFY(meshes >= 40);
    }

    // ⌊200·128/255 + ½⌋ = 100, and half as much again: once, and no sample twice.
    void theInterpolationsCoverOnceWithEffectsUnderTopLeft_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<Antialiasing>("antialiasing");
        for (const char *id :
             {"interpolate-bilinear", "interpolate-plane", "interpolate-barycentric"}) {
            QTest::addRow("%s, one sample", id) << id << Antialiasing::None;
            QTest::addRow("%s, 4 samples", id) << id << Antialiasing::Samples4;
            QTest::addRow("%s, 16 samples", id) << id << Antialiasing::Samples16;
        }
    }
    void theInterpolationsCoverOnceWithEffectsUnderTopLeft()
    {
        QFETCH(QString, id);
        QFETCH(Antialiasing, antialiasing);
        for (const Lattice step : {unitsPerPixel, Lattice(16), Lattice(1)}) {
            const MeshPlace place{{5 * step, 3 * step}, step, 24 * unitsPerPixel};
            for (const TriangleMesh &mesh : MeshMaker(place, 3).all()) {
                for (const FrameOrigin origin : {FrameOrigin::BottomLeft, FrameOrigin::TopLeft})
                    compareWithEffects(mesh, *methodNamed(id), antialiasing, origin);
            }
        }
    }

    void theClosedRuleDrawsSharedEdgesTwice()
    {
        const TriangleMesh mesh = MeshMaker({{0, 0}}, 3).junctions();
        const MeshFaults faults = faultsOf(mesh, *methodNamed(u"edge-equations"), {});
        QCOMPARE(faults.holes, 0);
        QVERIFY(faults.doubles >= 23);
    }

    void literalFloatFormsTearMeshesFarFromTheOrigin_data()
    {
        QTest::addColumn<QString>("id");
        for (const char *id : {"edge-equations", "edge-equations-incremental",
                               "edge-equations-solved", "barycentric-rectangle"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }
    void literalFloatFormsTearMeshesFarFromTheOrigin()
    {
        QFETCH(QString, id);
        const MeshFaults faults = faultsFarFromTheOrigin(*methodNamed(id));
        qInfo("%d holes, %d doubles", faults.holes, faults.doubles);
        QVERIFY(faults.holes + faults.doubles > 0);
    }

    void theStableFormsHoldInFloat32WhereTheLiteralOnesTear_data()
    {
        QTest::addColumn<QString>("id");
        for (const char *id : {"edge-equations-canonical", "barycentric-relative"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }
    void theStableFormsHoldInFloat32WhereTheLiteralOnesTear()
    {
        QFETCH(QString, id);
        const MeshFaults faults = faultsFarFromTheOrigin(*methodNamed(id));
        QCOMPARE(faults, MeshFaults());
    }

    void theOffScreenRuleTearsAnEdgeThatPassesThroughItsPoint()
    {
        // The diagonal of the square passes through (−1, −1): neither triangle takes it.
        TriangleMesh mesh{{}, latticePixel(0, 0), latticePixel(64, 64)};
        mesh.add(latticePixel(0, 0), latticePixel(64, 0), latticePixel(64, 64));
        mesh.add(latticePixel(0, 0), latticePixel(64, 64), latticePixel(0, 64));
        QVERIFY(meetsOffScreenPoint(mesh));
        const MeshFaults faults
            = faultsOf(mesh, *methodNamed(u"barycentric-off-screen"),
                       {Arithmetic::Exact, FillRule::OffScreenPoint, ByteRounding::Nearest});
        QCOMPARE(faults, (MeshFaults{63, 0}));
    }

private:
    /// Compares with the truth and checks that every inner pixel is blended exactly once.
    static void compareWithEffects(const TriangleMesh &mesh, const Method &method,
                                   Antialiasing antialiasing, FrameOrigin origin)
    {
        FrameSpec spec = frameOf(30, 30, -1, -1);
        spec.origin = origin;
        const ScanSettings settings{Arithmetic::Exact, FillRule::TopLeft, ByteRounding::Nearest};
        Primitives primitives;
        primitives.triangles = mesh.triangles;
        primitives.appearance.antialiasing = antialiasing;
        primitives.appearance.depth = DepthUse::On;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            TriangleAttributes attributes{i, {}, noMaterial};
            for (VertexAttributes &vertex : attributes.vertices)
                vertex.alpha = 128;
            attributes.vertices[i % 3].w = Attribute(1 + i) * attributeOne;
            primitives.attributes.push_back(attributes);
        }
        const FrameBuffer drawn(spec);
        Run(&method, primitives, settings, drawn.view()).draw(drawn.view());
        const FrameBuffer truth(spec);
        oracle::drawEffects(primitives, settings, oracle::truthOf(primitives.appearance),
                            truth.view());
        const FrameView view = drawn.view();
        for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
            for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x) {
                const LatticePoint sample = latticePixel(x, y);
                const bool isInside = sample.x - halfPixel > mesh.lowest.x
                    && sample.x + halfPixel < mesh.highest.x && sample.y - halfPixel > mesh.lowest.y
                    && sample.y + halfPixel < mesh.highest.y;
                if (isInside)
                    QCOMPARE(*view.at(x, y), qRgb(100, 50, 25));
            }
        }
        QVERIFY(drawn.image() == truth.image());
    }
};

PIXELPLUMB_TEST(TestMeshes)

} // namespace tst_meshes

#include "tst_meshes.moc"
