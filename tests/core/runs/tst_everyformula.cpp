// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/formulaexplanation.h"
#include "core/runs/sceneplan.h"
#include "core/runs/tracedscene.h"
#include "core/scan/choicenames.h"
#include "core/scene/scenefile.h"
#include "tests/support/formularange.h"
#include "tests/support/hardcasescenes.h"
#include "tests/support/polygons.h"
#include "tests/support/scenesformethods.h"
#include "tests/support/shapes.h"
#include "tests/support/sourcetree.h"
#include "tests/support/spacescenes.h"
#include "tests/support/spread.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QSet>
#include <QTest>

#include <map>

namespace tst_everyformula {

using namespace pixelplumb;

namespace {

/// Of a run: its first step, its last and others evenly between them.
constexpr std::size_t mostSteps = 70;
/// How many formulas may be known so badly from the digits that are shown that a wrong number would
/// pass: those that divide by a difference of two shortened numbers.
constexpr double vagueShare = 0.03;

QString runName(const QString &scene, const TracedScene &traced, std::size_t step)
{
    return QStringLiteral("%1, %2 %3 %4, step %5 of %6")
        .arg(scene, traced.method->id, nameText(nameOf(traced.scene.settings.arithmetic)),
             nameText(nameOf(traced.scene.settings.fillRule)))
        .arg(step + 1)
        .arg(traced.trace->stepCount());
}

Scene exampleNamed(const QString &name)
{
    return readSceneFile(resource(QStringLiteral("/scenes/")) + name)->scene;
}

/// A triangle in three colours with four texels a sample, as far from the eye everywhere.
Scene flatTexture()
{
    Scene scene;
    scene.frame = frameOf(24, 18);
    Material material;
    material.name = "board";
    material.texture = std::make_shared<Texture>(checkerTexture());
    material.filter = TextureFilter::Bilinear;
    scene.appearance.materials = {material};
    scene.triangles.push_back(Triangle{{{{latticePixel(2, 2), {{255, 0, 90}}},
                                         {latticePixel(21, 5), {{0, 255, 30}}},
                                         {latticePixel(7, 16), {{20, 60, 255}}}}}});
    TriangleAttributes attributes{0, {}, 0};
    attributes.vertices[1].texture = {attributeOne, attributeOne / 8};
    attributes.vertices[2].texture = {attributeOne / 4, attributeOne};
    scene.attributes = {attributes};
    return scene;
}

/// Scenes with effects in the ways in which pixels are covered, each in a frame that cuts it.
std::vector<NamedScene> shadedScenes()
{
    std::vector<NamedScene> scenes;
    for (const char *name : {"lit-sphere.json", "textured-board.json", "glass-panes.json"}) {
        for (const Antialiasing antialiasing :
             {Antialiasing::None, Antialiasing::Samples4, Antialiasing::Area}) {
            Scene scene = exampleNamed(QString::fromLatin1(name));
            scene.appearance.antialiasing = antialiasing;
            scene.frame.width = 40;
            scenes.push_back(
                {QStringLiteral("%1, antialiasing %2").arg(name).arg(int(antialiasing)), scene});
        }
    }
    Scene filtered = exampleNamed(QStringLiteral("textured-board.json"));
    for (Material &material : filtered.appearance.materials)
        material.filter = TextureFilter::Bilinear;
    filtered.frame.width = 40;
    scenes.push_back({QStringLiteral("four texels"), filtered});
    scenes.push_back({QStringLiteral("four texels without perspective"), flatTexture()});
    return scenes;
}

/// The examples as a person opens them, and what they lack: a frame that cuts primitives on all
/// sides, lines that are steep, fall or are given backwards, points, and triangles of all forms.
std::vector<NamedScene> formulaScenes()
{
    std::vector<NamedScene> scenes = scenesForEveryMethod();
    const QDir folder(resource(QStringLiteral("/scenes")));
    for (const QString &name : folder.entryList({QStringLiteral("*.json")}))
        scenes.push_back(
            {name + QStringLiteral(", whole"), readSceneFile(folder.filePath(name))->scene});
    Scene cut;
    cut.frame = frameOf(14, 11, 3, 2);
    const auto triangle = [](std::array<LatticePoint, 3> points) {
        return Triangle{{{{points[0], {{255, 3, 90}}},
                          {points[1], {{7, 255, 0}}},
                          {points[2], {{0, 60, 255}}}}}};
    };
    cut.triangles = {triangle({LatticePoint{100, 100}, LatticePoint{5200, 900}, {1300, 4500}}),
                     triangle({LatticePoint{1300, 4500}, LatticePoint{90, 3000}, {4000, 3333}}),
                     triangle({latticePixel(5, 3), latticePixel(5, 9), latticePixel(12, 6)}),
                     triangle({latticePixel(9, 3), latticePixel(9, 10), latticePixel(9, 3)})};
    cut.shapes = {lineAt(1, 1, 40, 20),
                  lineAt(16, 2, 0, 9),
                  lineAt(8, 30, 5, -4),
                  lineAt(7, 7, 7, 7),
                  lineAtUnits({900, 600}, {4000, 3000}),
                  lineAtUnits({4000, 700}, {900, 2500}),
                  lineAtUnits({2100, -300}, {2900, 5000}),
                  lineAtUnits({2900, -300}, {2100, 5000}),
                  circleAt(6, 5, 9),
                  circleAt(9, 7, 0),
                  circleAt(9, 7, 1),
                  circleAt(9, 7, 4, ShapeFill::NonZero),
                  ellipseAtUnits({2304, 1792}, 1700, 300),
                  ellipseAtUnits({2304, 1792}, 300, 1700),
                  polygonOf({pixels({{1, 1}, {15, 3}, {13, 12}, {4, 10}})}),
                  pentagram(ShapeFill::NonZero),
                  pentagram(ShapeFill::Outline),
                  bezierAt({{900, 600}, {4000, 3000}, {2100, 100}})};
    cut.shapes.back().fill = ShapeFill::EvenOdd;
    Shape points;
    points.kind = PrimitiveKind::Point;
    for (std::int64_t i = 0; i < 12; ++i)
        points.vertices.push_back({latticePixel(2 + i, 1 + i), {{200, 100, 50}}});
    cut.shapes.push_back(points);
    scenes.push_back({QStringLiteral("cut by its frame"), cut});
    for (const NamedScene &shaded : shadedScenes())
        scenes.push_back(shaded);
    return scenes;
}

/// "y_B ← y_B′ + m₀₂": what stands on the left, and what on the right.
std::pair<QString, QString> sidesOf(const QString &symbols)
{
    for (const QChar sign : {QChar(u'←'), QChar(u'=')}) {
        if (const qsizetype place = symbols.indexOf(sign); place >= 0)
            return {symbols.first(place).trimmed(), symbols.sliced(place + 1).trimmed()};
    }
    return {symbols, symbols};
}

/// What an exact run has no exact number for it computes in double.
Arithmetic arithmeticOf(const FormulaLine &line, Arithmetic ofRun)
{
    return ofRun == Arithmetic::Exact && !line.used.isRational() ? Arithmetic::Float64 : ofRun;
}

/// What is wrong with a line that comes out within the range; empty where nothing is.
QString faultOf(const FormulaLine &line, const std::optional<FormulaRange> &range,
                Arithmetic arithmetic)
{
    const auto [left, right] = sidesOf(line.symbols);
    if (left == right)
        return QStringLiteral("says nothing");
    if (!range)
        return QStringLiteral("cannot be worked out");
    if (range->holds(line.used))
        return QString();
    const auto wrapped = FormulaRange::wrappedOf(line.substituted, arithmetic);
    return wrapped && wrapped->holds(line.used) ? QString()
                                                : QStringLiteral("gives ") + range->text();
}

} // namespace

/// Every method on every scene, in every arithmetic, the rules in turn: the formulas that are shown
/// of set-ups, spans and samples come out at the numbers beside them.
class TestEveryFormula : public QObject {
    Q_OBJECT

private slots:
    void everyFormulaComesOutAtTheNumberBesideIt_data()
    {
        QTest::addColumn<QString>("id");
        for (const Method &method : methods())
            QTest::newRow(qPrintable(method.id)) << method.id;
    }
    void everyFormulaComesOutAtTheNumberBesideIt()
    {
        QFETCH(QString, id);
        const Method &method = *methodNamed(id);
        Tally tally;
        std::size_t turn = 0;
        for (const auto &[name, example] : m_scenes) {
            for (const Arithmetic arithmetic : method.arithmetics) {
                Scene scene = example;
                scene.method = id.toStdString();
                scene.settings.arithmetic = arithmetic;
                scene.settings.fillRule = method.fillRules[turn++ % method.fillRules.size()];
                if (objectionTo(scene).isEmpty())
                    look(name, *traceScene(scene), tally);
            }
        }
        for (const auto &[formula, fault] : tally.faults)
            qWarning("%s", qPrintable(formula + QStringLiteral(": ") + fault));
        QVERIFY2(tally.faults.empty(), qPrintable(QString::number(tally.faults.size())));
        QVERIFY2(tally.isExpected(method), qPrintable(QString::number(tally.count)));
        QVERIFY2(tally.vague <= vagueShare * tally.count,
                 qPrintable(QStringLiteral("%1 of %2").arg(tally.vague).arg(tally.count)));
    }

    void everyFormulaOfAVariantComesOutAtTheNumberBesideIt_data()
    {
        QTest::addColumn<QString>("id");
        for (const Method &method : methods()) {
            if (!method.variants.empty())
                QTest::newRow(qPrintable(method.id)) << method.id;
        }
    }
    void everyFormulaOfAVariantComesOutAtTheNumberBesideIt()
    {
        QFETCH(QString, id);
        const Method &method = *methodNamed(id);
        Tally tally;
        for (const auto &[name, example] : scenesForEveryMethod()) {
            for (const Arithmetic arithmetic : method.arithmetics) {
                VariantSet together;
                for (const Variant variant : method.variants) {
                    together = together.with(variant);
                    for (const VariantSet variants : {VariantSet().with(variant), together}) {
                        Scene scene = example;
                        scene.method = id.toStdString();
                        scene.settings.arithmetic = arithmetic;
                        scene.settings.variants = variants;
                        scene.settings = method.adapted(scene.settings);
                        look(name, *traceScene(scene), tally);
                    }
                }
            }
        }
        for (const auto &[formula, fault] : tally.faults)
            qWarning("%s", qPrintable(formula + QStringLiteral(": ") + fault));
        QVERIFY2(tally.faults.empty(), qPrintable(QString::number(tally.faults.size())));
    }

    void theStagesOfALitSampleHaveFormulas_data()
    {
        QTest::addColumn<QString>("id");
        for (const char *id : {"column-scan", "interpolate-bilinear", "interpolate-plane",
                               "interpolate-barycentric"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }
    void theStagesOfALitSampleHaveFormulas()
    {
        QFETCH(QString, id);
        Scene scene = exampleNamed(QStringLiteral("lit-sphere.json"));
        scene.method = id.toStdString();
        const auto traced = traceScene(scene);
        QSet<QString> shown;
        for (const std::size_t step : spreadOver(traced->trace->stepCount(), 4 * mostSteps)) {
            for (const FormulaLine &line : explainStep(*traced, step).lines)
                shown.insert(line.symbols);
        }
        QStringList expected = {
            QStringLiteral("|N| = √(N_x² + N_y² + N_z²)"),
            QStringLiteral("n_y = N_y/|N|"),
            QStringLiteral("V_z = (E_z − p_z)/√((E_x − p_x)² + (E_y − p_y)² + (E_z − p_z)²)"),
            QStringLiteral("L_0x = (−d_0x)/√((−d_0x)² + (−d_0y)² + (−d_0z)²)"),
            QStringLiteral("L_1x = (S_1x − p_x)/√((S_1x − p_x)² + (S_1y − p_y)² + (S_1z − p_z)²)"),
            QStringLiteral("NL_1 = max(0, n_x·L_1x + n_y·L_1y + n_z·L_1z)"),
            QStringLiteral("H_0y = (L_0y + V_y)/√((L_0x + V_x)² + (L_0y + V_y)² + (L_0z + V_z)²)"),
            QStringLiteral("NH_0 = max(0, n_x·H_0x + n_y·H_0y + n_z·H_0z)"),
            QStringLiteral("highlight_0 = NH_0^shininess"),
            QStringLiteral("I_R = base_R·(ambient_R + light_0R·NL_0 + light_1R·NL_1)/255 + "
                           "specular_R·(light_0R·highlight_0 + light_1R·highlight_1)/255"),
            QStringLiteral("s_R = min(255, ⌊I_R + ½⌋)"),
            QStringLiteral("y_T ← y_T′ + m₀₂"),
            QStringLiteral("m₀₁ = (y₁ − y₀)/(x₁ − x₀)")};
        if (!id.contains(QStringLiteral("plane")) && !id.contains(QStringLiteral("barycentric")))
            expected
                += {QStringLiteral("q_B ← q_B′ + δq₀₂"), QStringLiteral("q_T ← q₀ + (x − x₀)·δq₀₂"),
                    QStringLiteral("N_xwB ← N_xwB′ + δN_xw₀₂"),
                    QStringLiteral("δq₁₂ = (q₂ − q₁)/(x₂ − x₁)")};
        for (const QString &formula : expected)
            QVERIFY2(shown.contains(formula), qPrintable(formula));
    }

    void everyFormulaOfTheWayFromSpaceComesOutAtTheNumberBesideIt_data()
    {
        QTest::addColumn<Projection>("projection");
        QTest::addColumn<FrameOrigin>("origin");
        QTest::addColumn<Shading>("shading");
        QTest::newRow("perspective, lit at the vertices")
            << Projection::Perspective << FrameOrigin::BottomLeft << Shading::Gouraud;
        QTest::newRow("perspective, lit at the samples")
            << Projection::Perspective << FrameOrigin::TopLeft << Shading::Phong;
        QTest::newRow("orthographic, lit once a face")
            << Projection::Orthographic << FrameOrigin::BottomLeft << Shading::Flat;
    }
    void everyFormulaOfTheWayFromSpaceComesOutAtTheNumberBesideIt()
    {
        QFETCH(Projection, projection);
        QFETCH(FrameOrigin, origin);
        QFETCH(Shading, shading);
        Scene scene = sceneOf({triangle3({-1, -0.5, 2}, {1, -0.5, 2}, {0, 1, 5.5}),
                               solidOf(SolidKind::Sphere), solidOf(SolidKind::Patch)});
        scene.camera->projection = projection;
        scene.camera->eye = {0.3, 0.4, 4.7};
        scene.frame.origin = origin;
        scene.appearance.shading = shading;
        scene.appearance.lights
            = {{Light::Kind::Directional, {-attributeOne, -attributeOne, 0}, {}},
               {Light::Kind::Positional, {0, attributeOne, attributeOne}, {}}};
        const auto traced = traceScene(scene);
        QSet<QString> stages;
        QSet<QString> formulas;
        std::size_t cuts = 0;
        for (std::size_t primitive = 0; primitive < traced->trace->primitiveCount();
             primitive += 3) {
            const std::size_t step = traced->trace->indexOfSetUp(primitive);
            for (const StageFormulas &stage : explainStep(*traced, step).stages) {
                stages.insert(stage.stage);
                cuts += stage.note.contains(QStringLiteral("the near plane cuts")) ? 1 : 0;
                for (const FormulaLine &line : stage.lines) {
                    if (line.substituted.isEmpty())
                        continue;
                    formulas.insert(line.symbols);
                    const QString fault
                        = faultOf(line, FormulaRange::of(line.substituted, Arithmetic::Float64),
                                  Arithmetic::Float64);
                    QVERIFY2(fault.isEmpty(),
                             qPrintable(QStringLiteral("%1, %2: %3: %4 %5, not %6")
                                            .arg(stage.stage, stage.point, line.symbols,
                                                 line.substituted, fault, toText(line.used))));
                }
            }
        }
        QCOMPARE(stages.size(), shading == Shading::Phong ? 7 : 8);
        QVERIFY(cuts > 0);
        for (const char *formula :
             {"x_view = right_x·(x − E_x) + right_y·(y − E_y) + right_z·(z − E_z)",
              "z_clip = scale_z·(−z_view − near)", "x_device = x_clip/w",
              "x = x_first + (x_device + 1)/2·width − ½", "x = ⌊256·x′ + ½⌋/256",
              "t = z_V₁/(z_V₁ − z_V₂)"})
            QVERIFY2(formulas.contains(QString::fromUtf8(formula)), formula);
    }

    void everyFormulaOfAHardCaseComesOutAtTheNumberBesideIt_data()
    {
        QTest::addColumn<QString>("id");
        for (const Method &method : methods())
            QTest::newRow(qPrintable(method.id)) << method.id;
    }
    void everyFormulaOfAHardCaseComesOutAtTheNumberBesideIt()
    {
        QFETCH(QString, id);
        const Method &method = *methodNamed(id);
        Tally tally;
        // The fill rules take turns, from case to case and from arithmetic to arithmetic.
        std::size_t turn = 0;
        for (const auto &[name, hard] : m_cases) {
            for (const Arithmetic arithmetic : method.arithmetics) {
                Scene scene = hard;
                scene.method = id.toStdString();
                scene.settings.arithmetic = arithmetic;
                scene.settings.fillRule = method.fillRules[turn++ % method.fillRules.size()];
                look(name, *traceScene(scene), tally);
            }
        }
        for (const auto &[formula, fault] : tally.faults)
            qWarning("%s", qPrintable(formula + QStringLiteral(": ") + fault));
        QVERIFY2(tally.faults.empty(), qPrintable(QString::number(tally.faults.size())));
    }

    void aNameThatIsNoNumberIsNoticed()
    {
        QVERIFY(FormulaRange::of(QStringLiteral("(9 1/2) + 3·2²"), Arithmetic::Exact));
        for (const char *text : {"(9 1/2) + ΔR", "p_k₊₁", "", "3 +", "(4", "1/0", "R′ + 2"})
            QVERIFY2(!FormulaRange::of(QString::fromUtf8(text), Arithmetic::Exact), text);
    }

private:
    struct Tally {
        double count = 0; ///< formulas that were worked out
        double vague = 0; ///< of these, from too few digits
        std::map<QString, QString> faults; ///< one for each formula in symbols

        /// A method whose numbers have formulas has shown them.
        bool isExpected(const Method &method) const
        {
            const auto hasFormula
                = [](const NumberDescription &number) { return !number.formula.isEmpty(); };
            return std::ranges::none_of(method.numbers.span, hasFormula) || count > 40;
        }
    };

    static void look(const QString &scene, const TracedScene &traced, Tally &tally)
    {
        for (const std::size_t step : spreadOver(traced.trace->stepCount(), mostSteps)) {
            for (const FormulaLine &line : explainStep(traced, step).lines) {
                const Arithmetic arithmetic = arithmeticOf(line, traced.scene.settings.arithmetic);
                // What no formula gives, where effects are done, stands by itself.
                if (traced.plan && line.substituted.isEmpty())
                    continue;
                const auto range = FormulaRange::of(line.substituted, arithmetic);
                const QString fault = faultOf(line, range, arithmetic);
                if (!fault.isEmpty())
                    tally.faults.emplace(line.symbols,
                                         QStringLiteral("%1 %2, not %3 (%4)")
                                             .arg(line.substituted, fault, toText(line.used),
                                                  runName(scene, traced, step)));
                ++tally.count;
                tally.vague += range && !range->isNarrow();
            }
        }
    }

    std::vector<NamedScene> m_scenes = formulaScenes();
    std::vector<NamedScene> m_cases = hardCaseDetails();
};

PIXELPLUMB_TEST(TestEveryFormula)

} // namespace tst_everyformula

#include "tst_everyformula.moc"
