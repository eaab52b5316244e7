// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/coveragemask.h"
#include "core/runs/tracedscene.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/filldefinition.h"
#include "tests/support/scenes/rulescenes.h"
#include "tests/support/scenes/trianglemeshes.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_fillrules {

using namespace pixelplumb;

namespace {

/// The coverage: `#` covered, `.` not; row by row from the frame's first.
template <class Covers>
QString pictureOf(const FrameSpec &spec, const Covers &covers)
{
    QString text;
    for (std::int32_t row = spec.firstRow; row < spec.firstRow + spec.height; ++row) {
        for (std::int32_t column = spec.firstColumn; column < spec.firstColumn + spec.width;
             ++column)
            text += covers(column, row) ? u'#' : u'.';
        text += u'\n';
    }
    return text;
}

QString definedPicture(const Scene &scene)
{
    return pictureOf(scene.frame, [&](std::int32_t column, std::int32_t row) {
        const auto holds = [&](const auto &primitive) {
            return definition::isInside(primitive, column, row, scene);
        };
        return std::ranges::any_of(scene.triangles, holds)
            || std::ranges::any_of(scene.shapes, holds);
    });
}

/// The coverage of what `draw` writes into a frame of alpha 0; every kernel writes alpha 255.
template <class Draw>
QString writtenPicture(const Scene &scene, const Draw &draw)
{
    const FrameBuffer frame(scene.frame);
    const FrameView view = frame.view();
    for (std::int64_t y = view.firstRow; y < view.endRow(); ++y)
        std::fill_n(view.at(view.firstColumn, y), view.width, QRgb(0));
    draw(scene, frame);
    return pictureOf(scene.frame, [&](std::int32_t column, std::int32_t row) {
        return *view.at(column, row) != 0;
    });
}

QString recordedPicture(const Scene &scene)
{
    const auto traced = traceScene(scene);
    CoverageMask written(scene.frame);
    const ScanTrace &trace = *traced->trace;
    for (std::size_t sample = 0; sample < trace.sampleCount(); ++sample) {
        const PixelChange &change = trace.changes()[sample];
        if (change.isWritten())
            written.cover(change.x, change.y);
    }
    return pictureOf(scene.frame, [&](std::int32_t column, std::int32_t row) {
        return written.covers(column, row);
    });
}

Scene sceneOf(const FrameSpec &frame, const Method &method, FillRule rule)
{
    Scene scene;
    scene.frame = frame;
    scene.method = method.id.toStdString();
    scene.settings.fillRule = rule;
    return scene;
}

QString positionsOf(const Scene &scene)
{
    QString text;
    const auto append = [&](const Vertex &vertex) {
        text += u" (%1, %2)"_s.arg(vertex.position.x).arg(vertex.position.y);
    };
    for (const Triangle &triangle : scene.triangles)
        std::ranges::for_each(triangle.vertices, append);
    for (const Shape &shape : scene.shapes)
        std::ranges::for_each(shape.vertices, append);
    return text;
}

QString describe(const Scene &scene, const QString &expected, const QString &found)
{
    return u"%1, %2, %3, first (%4, %5), units of 1/256 px:%6\nby definition:\n%7found:\n%8"_s
        .arg(QString::fromStdString(scene.method),
             scene.frame.origin == FrameOrigin::TopLeft ? "y down" : "y up",
             scene.frame.pixelCentre == PixelCentre::Half ? "half" : "integer")
        .arg(scene.frame.firstColumn)
        .arg(scene.frame.firstRow)
        .arg(positionsOf(scene), expected, found);
}

/// How the program's pictures of a scene differ from the definition's.
QString faultOf(const Scene &scene, bool isRecorded)
{
    const QString expected = definedPicture(scene);
    std::vector<QString> found
        = {writtenPicture(scene, drawScene), writtenPicture(scene, drawTruth)};
    if (isRecorded)
        found.push_back(recordedPicture(scene));
    for (const QString &picture : found) {
        if (picture != expected)
            return describe(scene, expected, picture);
    }
    return {};
}

/// Whether the line of an edge passes through the off-screen point, where the rule guarantees
/// nothing.
bool hasEdgeThrough(const TriangleMesh &mesh, const Scene &scene)
{
    const LatticePoint point = definition::pointOf(scene.frame);
    return std::ranges::any_of(mesh.triangles, [&](const Triangle &triangle) {
        const auto &[a, b, c] = triangle.vertices;
        return doubledArea(a.position, b.position, point) == 0
            || doubledArea(b.position, c.position, point) == 0
            || doubledArea(c.position, a.position, point) == 0;
    });
}

/// The parts of a mesh's rectangle that are not written exactly once, as `0`, `2` and so on; empty
/// if there are none.
QString coverageFault(const TriangleMesh &mesh, const Scene &scene)
{
    FrameMap<int> writes(scene.frame);
    const FrameBuffer frame(scene.frame);
    const FrameView view = frame.view();
    for (const Triangle &triangle : mesh.triangles) {
        for (std::int64_t y = view.firstRow; y < view.endRow(); ++y)
            std::fill_n(view.at(view.firstColumn, y), view.width, QRgb(0));
        Scene one = scene;
        one.triangles = {triangle};
        drawScene(one, frame);
        for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
            for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x)
                writes.at(x, y) += *view.at(x, y) != 0 ? 1 : 0;
        }
    }
    const Lattice centre = scene.frame.pixelCentre == PixelCentre::Half ? 128 : 0;
    for (std::int64_t y = view.firstRow; y < view.endRow(); ++y) {
        for (std::int64_t x = view.firstColumn; x < view.endColumn(); ++x) {
            const LatticePoint sample = {x * 256 + centre, y * 256 + centre};
            const bool isInside = sample.x > mesh.lowest.x && sample.x < mesh.highest.x
                && sample.y > mesh.lowest.y && sample.y < mesh.highest.y;
            if (writes.at(x, y) > 1 || (isInside && writes.at(x, y) == 0))
                return u"(%1, %2) is written %3 times in a mesh of%4"_s.arg(x)
                    .arg(y)
                    .arg(writes.at(x, y))
                    .arg(positionsOf(scene));
        }
    }
    return {};
}

} // namespace

class TestFillRules : public QObject {
    Q_OBJECT

private slots:
    void everyMethodAndTheTruthCoverWhatTheRulesDefinitionCovers_data()
    {
        QTest::addColumn<const Method *>("method");
        QTest::addColumn<FillRule>("rule");
        for (const Method *method : methodsOfTriangles()) {
            for (const FillRule rule : method->fillRules) {
                const ScanSettings settings{Arithmetic::Exact, rule, ByteRounding::Nearest};
                QTest::newRow(rowName(*method, settings).c_str()) << method << rule;
            }
        }
    }
    void everyMethodAndTheTruthCoverWhatTheRulesDefinitionCovers()
    {
        QFETCH(const Method *, method);
        QFETCH(FillRule, rule);
        constexpr int trianglesOfAStep = fewerIfSanitized(40);
        constexpr int recordedOfAStep = fewerIfSanitized(8);
        std::uint64_t seed = 0;
        for (const FrameSpec &frame : frames()) {
            for (const Lattice step : {Lattice(1), unitsPerPixel / 2, unitsPerPixel}) {
                VertexSource source(frame, step, ++seed);
                for (int i = 0; i < trianglesOfAStep; ++i) {
                    Scene scene = sceneOf(frame, *method, rule);
                    scene.triangles = {i % 8 == 0 ? source.nextFlat() : source.next()};
                    QCOMPARE(faultOf(scene, i < recordedOfAStep), QString());
                }
            }
        }
    }

    void withoutAPointOfItsOwnEveryFrameHasTheOffScreenPointOffTheScreen()
    {
        for (const FrameSpec &frame : frames()) {
            const LatticePoint point = definition::pointOf(frame);
            const Lattice offset = frame.pixelCentre == PixelCentre::Half ? 128 : 0;
            const LatticePoint sample = offScreenSample(frame);
            QCOMPARE(sample.x + offset, point.x);
            QCOMPARE(sample.y + offset, point.y);
            QVERIFY(
                !FrameBuffer(frame).view().contains(floorPixel(sample.x), floorPixel(sample.y)));
        }
    }

    void aMeshIsCoveredOnceUnderTheWatertightRulesInEveryFrame_data()
    {
        QTest::addColumn<const Method *>("method");
        QTest::addColumn<FillRule>("rule");
        for (const Method *method : methodsOfTriangles()) {
            for (const FillRule rule :
                 {FillRule::HalfOpenColumn, FillRule::TopLeft, FillRule::OffScreenPoint}) {
                const ScanSettings settings{Arithmetic::Exact, rule, ByteRounding::Nearest};
                if (method->supports(rule))
                    QTest::newRow(rowName(*method, settings).c_str()) << method << rule;
            }
        }
    }
    void aMeshIsCoveredOnceUnderTheWatertightRulesInEveryFrame()
    {
        QFETCH(const Method *, method);
        QFETCH(FillRule, rule);
        int meshes = 0;
        for (const FrameSpec &frame : frames()) {
            const LatticePoint corner = latticePixel(frame.firstColumn, frame.firstRow);
            for (const Lattice step : {Lattice(1), unitsPerPixel / 2, unitsPerPixel}) {
                MeshMaker maker({corner, step, 10 * unitsPerPixel}, std::uint64_t(step));
                for (const TriangleMesh &mesh : maker.all()) {
                    Scene scene = sceneOf(frame, *method, rule);
                    scene.triangles = mesh.triangles;
                    if (rule == FillRule::OffScreenPoint && hasEdgeThrough(mesh, scene))
                        continue;
                    QCOMPARE(coverageFault(mesh, scene), QString());
                    ++meshes;
                }
            }
        }
        QVERIFY(meshes >= 20);
    }

    void everyPolygonMethodAndTheTruthCoverWhatTheRulesDefinitionCovers_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<int>("vertices");
        QTest::newRow("parity of any polygon") << "polygon-parity" << 7;
        QTest::newRow("a fan") << "polygon-fan" << 3;
        QTest::newRow("Delaunay triangles") << "polygon-delaunay" << 3;
    }
    void everyPolygonMethodAndTheTruthCoverWhatTheRulesDefinitionCovers()
    {
        QFETCH(QString, id);
        QFETCH(int, vertices);
        std::uint64_t seed = 0;
        for (const FrameSpec &frame : frames()) {
            for (const Lattice step : {Lattice(1), unitsPerPixel / 2, unitsPerPixel}) {
                VertexSource source(frame, step, ++seed);
                for (int i = 0; i < fewerIfSanitized(60); ++i) {
                    Scene scene = sceneOf(frame, *methodNamed(id), FillRule::TopLeft);
                    scene.shapes = {source.nextPolygon(vertices)};
                    QCOMPARE(faultOf(scene, i < 8), QString());
                }
            }
        }
    }
};

PIXELPLUMB_TEST(TestFillRules)

} // namespace tst_fillrules

#include "tst_fillrules.moc"
