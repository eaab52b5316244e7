// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/formulaexplanation.h"
#include "core/runs/tracedscene.h"
#include "core/scene/scenefile.h"
#include "tests/support/formularange.h"
#include "tests/support/sourcetree.h"
#include "tests/support/spacescenes.h"
#include "tests/support/spread.h"
#include "tests/support/testprogram.h"

#include <QSet>
#include <QTest>

namespace tst_stageformulas {

using namespace pixelplumb;

namespace {

/// Of a run: its first step, its last and others evenly between them.
constexpr std::size_t mostSteps = 280;

Scene exampleNamed(const QString &name)
{
    return readSceneFile(resource(QStringLiteral("/scenes/")) + name)->scene;
}

} // namespace

/// Of the stages of a lit sample and of those from space to the frame each has its formulas; that
/// the others come out at the numbers beside them is checked of every run (tst_everyrun).
class TestStageFormulas : public QObject {
    Q_OBJECT

private slots:
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
        for (const std::size_t step : spreadOver(traced->trace->stepCount(), mostSteps)) {
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
                    const QString fault = formulaFault(
                        line, FormulaRange::of(line.substituted, Arithmetic::Float64),
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

    /// Red, under an ambient light of 32 and one of 128 that meets V₀ in its normal and V₁ at 45°:
    /// 255·(32 + 128)/255 and 255·(32 + 128/√2)/255 = 122.5 …, which is 123.
    void aPlainTriangleTellsHowItIsLit_data()
    {
        QTest::addColumn<QByteArray>("shading");
        QTest::addColumn<QStringList>("points");
        QTest::addColumn<QList<double>>("bytes");
        QTest::newRow("gouraud") << QByteArray("gouraud")
                                 << QStringList{QStringLiteral("V₀"), QStringLiteral("V₁")}
                                 << QList<double>{160, 123};
        // The normals' mean: (1/√2, 0, −2 − 1/√2), N·L = 2.7071…/√(½ + 2.7071²) = 0.9675…
        QTest::newRow("flat") << QByteArray("flat") << QStringList{QStringLiteral("centre")}
                              << QList<double>{156};
    }
    void aPlainTriangleTellsHowItIsLit()
    {
        QFETCH(QByteArray, shading);
        QFETCH(QStringList, points);
        QFETCH(QList<double>, bytes);
        QByteArray text = "{ 'pixelplumb': 1, 'frame': { 'width': 16, 'height': 12 }, "
                          "'shading': '%1', 'lights': [ { 'direction': [0, 0, 1], "
                          "'color': '#808080' } ], "
                          "'primitives': [ { 'triangle': [[1, 1], [9, 1], [1, 9]], "
                          "'colors': ['#ff0000', '#ff0000', '#ff0000'], "
                          "'normals': [[0, 0, -1], [1, 0, -1], [0, 0, -1]] } ] }";
        const auto scene = readScene(text.replace('\'', '"').replace("%1", shading));
        QVERIFY2(scene.isOk(), scene ? "" : qPrintable(scene.error().message()));
        const auto traced = traceScene(scene->scene);
        const std::vector<StageFormulas> stages = explainStep(*traced, 0).stages;
        for (qsizetype i = 0; i < points.size(); ++i) {
            bool isFound = false;
            for (const StageFormulas &stage : stages) {
                for (const FormulaLine &line : stage.lines) {
                    if (stage.point != points[i] || !line.symbols.startsWith(u"s_R"))
                        continue;
                    QCOMPARE(line.symbols, QStringLiteral("s_R = min(255, ⌊I_R + ½⌋)"));
                    QCOMPARE(line.used.toDouble(), bytes[i]);
                    QCOMPARE(traced->primitives.triangles[0].vertices[std::size_t(i)].colour.red(),
                             std::uint8_t(bytes[i]));
                    isFound = true;
                }
            }
            QVERIFY2(isFound, qPrintable(points[i]));
        }
    }

    /// Texels beyond the texture, levels beyond a byte, planes and weights of triangles and of
    /// segments, and what has no w beside what has.
    void everyNumberOfAShadedTriangleHasAFormulaThatComesOut_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<Arithmetic>("arithmetic");
        for (const char *method : {"column-scan", "interpolate-bilinear", "interpolate-plane",
                                   "interpolate-barycentric"})
            for (const Arithmetic arithmetic :
                 {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64})
                QTest::addRow("%s, %s", method, nameOf(arithmetic).data())
                    << QString::fromLatin1(method) << arithmetic;
    }
    void everyNumberOfAShadedTriangleHasAFormulaThatComesOut()
    {
        QFETCH(QString, method);
        QFETCH(Arithmetic, arithmetic);
        QByteArray text
            = "{ 'pixelplumb': 1, 'frame': { 'width': 12, 'height': 12 }, 'materials': { "
              "'a': { 'texture': 'checker', 'filter': 'bilinear', 'wrap': 'repeat' }, "
              "'b': { 'texture': 'checker', 'filter': 'nearest', 'wrap': 'clamp' }, "
              "'c': { 'texture': 'checker', 'filter': 'nearest', 'wrap': 'repeat' }, "
              "'d': { 'texture': 'checker', 'filter': 'bilinear', 'wrap': 'clamp' } }, "
              "'primitives': [ ";
        const QByteArray triangle
            = "{ 'triangle': [[1, 1], [9, 2], [3, 10]], 'colors': ['#ff0000', '#00ff00', "
              "'#0000ff'], 'uv': [[-1.5, -0.75], [2.25, 0.5], [0.125, 1.75]], 'w': [%1], "
              "'material': '%2' }";
        const QByteArray segment
            = "{ 'triangle': [%1], 'colors': ['#ff0000', '#00ff00', '#0000ff'], 'uv': [[-1, -1], "
              "[2, 0.5], [0, 1]], 'material': 'a' }";
        QByteArrayList primitives;
        for (const char *material : {"a", "b", "c", "d"}) {
            for (const char *w : {"1, 2, 3", "2, 2, 2"})
                primitives += QByteArray(triangle).replace("%1", w).replace("%2", material);
        }
        for (const char *points : {"[1, 1], [5, 5], [9, 9]", "[3, 9], [3, 1], [3, 4]",
                                   "[4, 4], [4, 4], [4, 4]", "[9, 6], [5, 6], [1, 6]"})
            primitives += QByteArray(segment).replace("%1", points);
        text += primitives.join(", ") + " ] }";
        const auto read = readScene(text.replace('\'', '"'));
        QVERIFY2(read.isOk(), read ? "" : qPrintable(read.error().message()));
        Scene scene = read->scene;
        scene.method = method.toStdString();
        scene.settings.arithmetic = arithmetic;
        const auto traced = traceScene(scene);
        QSet<QString> shown;
        for (std::size_t step = 0; step < traced->trace->stepCount(); ++step) {
            for (const FormulaLine &line : explainStep(*traced, step).lines) {
                if (line.substituted.isEmpty())
                    continue;
                shown.insert(line.symbols);
                const QString fault = formulaFault(
                    line, FormulaRange::of(line.substituted, arithmetic), arithmetic);
                QVERIFY2(
                    fault.isEmpty(),
                    qPrintable(QStringLiteral("step %1: %2: %3 %4, not %5")
                                   .arg(step)
                                   .arg(line.symbols, line.substituted, fault, toText(line.used))));
            }
        }
        QStringList expected = {QStringLiteral("i = ⌊8·u − ½⌋ − 8·⌊⌊8·u − ½⌋/8⌋"),
                                QStringLiteral("j = min(max(⌊8·v⌋, 0), 7)"),
                                QStringLiteral("j = ⌊8·v⌋ − 8·⌊⌊8·v⌋/8⌋"),
                                QStringLiteral("i = min(max(⌊8·u − ½⌋, 0), 7)"),
                                QStringLiteral("f_u = 8·u − ½ − ⌊8·u − ½⌋"),
                                QStringLiteral("f_u = 8·u − ½ − i"),
                                QStringLiteral("R_w₁ = R₁/w₁"),
                                QStringLiteral("R_w₁ = R₁"),
                                QStringLiteral("R = R_w/q"),
                                QStringLiteral("R = R_w")};
        if (method.endsWith(QStringLiteral("plane")))
            expected += {QStringLiteral("c_Rw = R_w₀ − a_Rw·x₀ − b_Rw·y₀"),
                         QStringLiteral("a_Rw = (R_w₂ − R_w₀)/(x₂ − x₀)"),
                         QStringLiteral("b_Rw = (R_w₀ − R_w₁)/(y₀ − y₁)")};
        else if (method.endsWith(QStringLiteral("barycentric")))
            expected
                += {QStringLiteral("a_α = (y₂ − y₁)/((y₂ − y₁)·(x₀ − x₁) + (x₁ − x₂)·(y₀ − y₁))"),
                    QStringLiteral("c_γ = −a_γ·x₀"), QStringLiteral("c_α = 1 − a_α·x₀")};
        else
            expected += {QStringLiteral("ΔR_w = 0")};
        for (const QString &formula : expected)
            QVERIFY2(shown.contains(formula),
                     qPrintable(formula + u'\n' + QStringList(shown.values()).join(u'\n')));
    }

    /// 2^16 − 1 levels of depth, a depth beyond 1, and pixels of several samples.
    void depthLevelsAndMeansHaveFormulas()
    {
        const auto read = readScene(
            "{ \"pixelplumb\": 1, \"frame\": { \"width\": 12, \"height\": 12 }, \"depth\": \"on\","
            " \"depthBits\": 16, \"antialiasing\": 4, \"primitives\": [ { \"triangle\": [[1, 1],"
            " [10, 2], [3, 10]], \"colors\": [\"#ff0000\", \"#00ff00\", \"#0000ff\"],"
            " \"z\": [0.1, 1.5, 0.25] } ] }");
        QVERIFY2(read.isOk(), read ? "" : qPrintable(read.error().message()));
        const auto traced = traceScene(read->scene);
        QSet<QString> shown;
        for (std::size_t step = 0; step < traced->trace->stepCount(); ++step) {
            for (const FormulaLine &line : explainStep(*traced, step).lines) {
                if (line.substituted.isEmpty())
                    continue;
                shown.insert(line.symbols);
                const QString fault = formulaFault(
                    line, FormulaRange::of(line.substituted, Arithmetic::Exact), Arithmetic::Exact);
                QVERIFY2(fault.isEmpty(),
                         qPrintable(line.symbols + u' ' + line.substituted + fault));
            }
        }
        for (const char *formula : {"z_level = ⌊z·65535 + ½⌋", "mean_R = ⌊sum_R/4 + ½⌋",
                                    "z_level = ⌊min(1, max(0, z))·65535 + ½⌋"})
            QVERIFY2(shown.contains(QString::fromUtf8(formula)), formula);
    }

    /// By hand: 118 1/2 exactly, which float64 has as 118.49999999999999; A = −132, and β is
    /// 1/(4·132·256²) = 2.88992…·10⁻⁸.
    void whatIsAddedToLevelsInFloat64IsShown()
    {
        const auto read = readScene(
            "{ \"pixelplumb\": 1, \"frame\": { \"width\": 50, \"height\": 50 }, \"method\":"
            " \"column-scan-bias\", \"arithmetic\": \"float64\", \"primitives\": [ { \"triangle\":"
            " [[32, 39], [23, 9], [21, 17]], \"colors\": [\"#2f243c\", \"#9ff97e\", \"#a2339b\"]"
            " } ] }");
        QVERIFY2(read.isOk(), read ? "" : qPrintable(read.error().message()));
        const auto traced = traceScene(read->scene);
        QStringList bytes;
        for (std::size_t step = 0; step < traced->trace->stepCount(); ++step) {
            const TraceStep at = traced->trace->stepAt(step);
            if (at.kind != StepKind::Sample)
                continue;
            const PixelChange &change = traced->trace->changes()[at.sample];
            for (const FormulaLine &line : explainStep(*traced, step).lines) {
                const QString fault
                    = formulaFault(line, FormulaRange::of(line.substituted, Arithmetic::Float64),
                                   Arithmetic::Float64);
                QVERIFY2(fault.isEmpty(),
                         qPrintable(line.symbols + u' ' + line.substituted + fault));
                if (change.x == 25 && change.y == 23 && line.symbols.startsWith(u"byte"))
                    bytes.append(line.symbols + QStringLiteral(": ") + line.substituted);
            }
        }
        QCOMPARE(bytes.size(), 3);
        QVERIFY2(bytes[2].startsWith(u"byte = ⌊B + (½ + β_C)⌋: ⌊118.49999999999999 + (½ + 2.88992"),
                 qPrintable(bytes[2]));
    }

    void beyondTheHorizonTheHorizonRefuses()
    {
        const auto read = readScene(
            "{ \"pixelplumb\": 1, \"frame\": { \"width\": 12, \"height\": 12 }, \"depth\": \"on\","
            " \"antialiasing\": \"area\", \"method\": \"interpolate-plane\", \"primitives\": [ {"
            " \"triangle\": [[2, 8], [6.5, 10], [4.5, 7]], \"colors\": [\"#ff0000\", \"#00ff00\","
            " \"#ff0000\"], \"z\": [0.5, 0.25, 0.5], \"w\": [1, 1, 16] } ] }");
        QVERIFY2(read.isOk(), read ? "" : qPrintable(read.error().message()));
        const auto traced = traceScene(read->scene);
        int refused = 0;
        for (std::size_t step = 0; step < traced->trace->stepCount(); ++step) {
            const TraceStep at = traced->trace->stepAt(step);
            if (at.kind != StepKind::Sample || traced->trace->changes()[at.sample].isWritten())
                continue;
            ++refused;
            const QString sentence = explainStep(*traced, step).sentence;
            QVERIFY2(sentence.contains(u"horizon"), qPrintable(sentence));
        }
        QVERIFY(refused > 0);
    }

    void aNameThatIsNoNumberIsNoticed()
    {
        QVERIFY(FormulaRange::of(QStringLiteral("(9 1/2) + 3·2²"), Arithmetic::Exact));
        for (const char *text : {"(9 1/2) + ΔR", "p_k₊₁", "", "3 +", "(4", "1/0", "R′ + 2"})
            QVERIFY2(!FormulaRange::of(QString::fromUtf8(text), Arithmetic::Exact), text);
    }
};

PIXELPLUMB_TEST(TestStageFormulas)

} // namespace tst_stageformulas

#include "tst_stageformulas.moc"
