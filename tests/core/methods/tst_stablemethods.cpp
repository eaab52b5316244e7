// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/casestorun.h"
#include "tests/support/scenesformethods.h"
#include "tests/support/shapes.h"
#include "tests/support/testprogram.h"

#include <QtTest>

#include <random>

namespace tst_stablemethods {

using namespace pixelplumb;

namespace {

constexpr int side = 24;

/// Points in and around the frame, finer and finer: on whole pixels, on halves, on 1/256 px.
class RandomScenes {
public:
    explicit RandomScenes(unsigned seed)
        : m_random(seed)
    {
    }

    /// Something of each kind, of which a method draws what it draws.
    Scene next()
    {
        m_step = std::array<Lattice, 3>{256, 128, 1}[below(3)];
        Scene scene;
        scene.frame.width = scene.frame.height = side;
        scene.frame.origin = below(2) == 0 ? FrameOrigin::BottomLeft : FrameOrigin::TopLeft;
        scene.frame.pixelCentre = below(2) == 0 ? PixelCentre::Integer : PixelCentre::Half;
        scene.triangles = {{{vertex(), vertex(), vertex()}}};
        scene.shapes = {shape(PrimitiveKind::Point, 1), shape(PrimitiveKind::Line, 2),
                        shape(PrimitiveKind::Bezier, 3 + below(2)),
                        shape(PrimitiveKind::Polygon, 3 + below(4))};
        scene.shapes.back().fill = below(2) == 0 ? ShapeFill::EvenOdd : ShapeFill::NonZero;
        for (const ShapeFill fill : {ShapeFill::Outline, ShapeFill::NonZero}) {
            scene.shapes.push_back(circleAt(std::int64_t(below(side)), std::int64_t(below(side)),
                                            std::int64_t(1 + below(12)), fill));
            scene.shapes.push_back(
                ellipseAtUnits(point(), 1 + Lattice(below(3000)), 1 + Lattice(below(3000)), fill));
        }
        scene.shapes.push_back(shape(PrimitiveKind::Polygon, 3 + below(4))); // its outline
        Shape text = shape(PrimitiveKind::Text, 1);
        text.text = "g8";
        text.textHeight = Lattice(1000 + below(4000));
        scene.shapes.push_back(text);
        return scene;
    }

private:
    std::size_t below(std::size_t end) { return m_random() % end; }
    LatticePoint point()
    {
        const auto coordinate = [this] {
            return (Lattice(below((side + 16) * unitsPerPixel)) / m_step
                    - 8 * unitsPerPixel / m_step)
                * m_step;
        };
        const Lattice x = coordinate();
        return {x, coordinate()};
    }
    Vertex vertex()
    {
        const auto byte = [this] { return std::uint8_t(below(256)); };
        const LatticePoint position = point();
        const std::uint8_t red = byte();
        const std::uint8_t green = byte();
        return {position, {{red, green, byte()}}};
    }
    Shape shape(PrimitiveKind kind, std::size_t vertices)
    {
        Shape shape;
        shape.kind = kind;
        for (std::size_t i = 0; i < vertices; ++i)
            shape.vertices.push_back(vertex());
        return shape;
    }

    std::mt19937 m_random;
    Lattice m_step = unitsPerPixel;
};

std::vector<NamedScene> randomScenes()
{
    std::vector<NamedScene> scenes;
    RandomScenes random(8);
    for (int i = 0; i < 60; ++i)
        scenes.push_back({QStringLiteral("random %1").arg(i), random.next()});
    return scenes;
}

/// Where the picture of a run that was not rejected differs from the truth; empty where nowhere.
QString differenceOf(const TracedScene &traced)
{
    const ScanTrace &trace = *traced.trace;
    for (std::size_t i = 0; i < trace.primitiveCount(); ++i) {
        // What a method refuses to draw, with a reason, is no picture of it.
        const auto &rejection = trace.setUp(i).rejection;
        if (rejection && !(*rejection == PrimitiveRejection::OutsideFrame)
            && !(*rejection == PrimitiveRejection::ZeroArea)
            && !(*rejection == PrimitiveRejection::NotOfThisMethod))
            return {};
    }
    return traced.differences.total() == 0
        ? QString()
        : QStringLiteral("%1 pixels").arg(traced.differences.total());
}

} // namespace

/// Each method is the truth in the arithmetics that its row of the table of methods names.
class TestStableMethods : public QObject {
    Q_OBJECT

private slots:
    void everyMethodIsTheTruthWhereItSaysSo_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<ScanSettings>("settings");
        for (const Method &method : methods()) {
            for (const Arithmetic arithmetic : method.stableArithmetics) {
                for (const FillRule rule : method.fillRules)
                    QTest::addRow("%s %d %d", qPrintable(method.id), int(arithmetic), int(rule))
                        << method.id << ScanSettings{arithmetic, rule, ByteRounding::Nearest};
            }
        }
    }
    void everyMethodIsTheTruthWhereItSaysSo()
    {
        QFETCH(QString, id);
        QFETCH(ScanSettings, settings);
        std::vector<NamedScene> scenes = scenesForEveryMethod();
        for (const NamedScene &scene : casesToRun(randomScenes()))
            scenes.push_back(scene);
        std::size_t written = 0;
        for (auto &[name, whole] : scenes) {
            Scene scene = whole;
            scene.method = id.toStdString();
            scene.settings = settings;
            // One by one, so that one that is not drawn hides no other.
            for (std::size_t i = 0; i < whole.triangles.size() + whole.shapes.size(); ++i) {
                scene.triangles.clear();
                scene.shapes.clear();
                scene.attributes.clear();
                scene.solids.clear();
                scene.appearance = {};
                if (i < whole.triangles.size())
                    scene.triangles = {whole.triangles[i]};
                else
                    scene.shapes = {whole.shapes[i - whole.triangles.size()]};
                const auto traced = traceScene(scene);
                const QString difference = differenceOf(*traced);
                written += traced->trace->writtenCount();
                QVERIFY2(
                    difference.isEmpty(),
                    qPrintable(QStringLiteral("%1, primitive %2: ").arg(name).arg(i) + difference));
            }
        }
        QVERIFY(written > 0); // else nothing was compared
    }

    void someMethodOfEveryFamilySaysSo()
    {
        QSet<MethodFamily> families;
        QSet<MethodFamily> stable;
        for (const Method &method : methods()) {
            families.insert(method.family);
            if (!method.stableArithmetics.empty())
                stable.insert(method.family);
        }
        QCOMPARE(stable, families);
    }
};

PIXELPLUMB_TEST(TestStableMethods)

} // namespace tst_stablemethods

#include "tst_stablemethods.moc"
