// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/tracedscene.h"
#include "core/scene/scenefile.h"
#include "tests/support/formularange.h"
#include "tests/support/scenes/spacescenes.h"
#include "tests/support/sourcetree.h"
#include "tests/support/spread.h"
#include "tests/support/testprogram.h"

#include <QSet>
#include <QTest>

namespace tst_stageformulas {

using namespace pixelplumb;

namespace {

/// The steps checked per run: the first, the last and others evenly between them.
constexpr std::size_t mostSteps = 280;

Scene exampleNamed(const QString &name)
{
    return readSceneFile(resource(u"/scenes/"_s) + name)->scene;
}

} // namespace

/// Each stage of a lit sample, and each from space to the frame, has its formulas; tst_everyrun
/// checks that the other formulas give the numbers next to them.
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
        Scene scene = exampleNamed(u"lit-sphere.json"_s);
        scene.method = id.toStdString();
        const auto traced = traceScene(scene);
        QSet<QString> shown;
        for (const std::size_t step : spreadOver(traced->trace->stepCount(), mostSteps)) {
            for (const FormulaLine &line : explainStep(*traced, step).lines)
                shown.insert(line.symbols);
        }
        QStringList expected
            = {u"|N| = √(N_x² + N_y² + N_z²)"_s,
               u"n_y = N_y/|N|"_s,
               u"V_z = (E_z − p_z)/√((E_x − p_x)² + (E_y − p_y)² + (E_z − p_z)²)"_s,
               u"L_0x = (−d_0x)/√((−d_0x)² + (−d_0y)² + (−d_0z)²)"_s,
               u"L_1x = (S_1x − p_x)/√((S_1x − p_x)² + (S_1y − p_y)² + (S_1z − p_z)²)"_s,
               u"NL_1 = max(0, n_x·L_1x + n_y·L_1y + n_z·L_1z)"_s,
               u"H_0y = (L_0y + V_y)/√((L_0x + V_x)² + (L_0y + V_y)² + (L_0z + V_z)²)"_s,
               u"NH_0 = max(0, n_x·H_0x + n_y·H_0y + n_z·H_0z)"_s,
               u"highlight_0 = NH_0^shininess"_s,
               u"I_R = base_R·(ambient_R + light_0R·NL_0 + light_1R·NL_1)/255 + "
               "specular_R·(light_0R·highlight_0 + light_1R·highlight_1)/255"_s,
               u"s_R = min(255, ⌊I_R + ½⌋)"_s,
               u"y_T ← y_T′ + m₀₂"_s,
               u"m₀₁ = (y₁ − y₀)/(x₁ − x₀)"_s};
        if (!id.contains(u"plane"_s) && !id.contains(u"barycentric"_s))
            expected += {u"q_B ← q_B′ + δq₀₂"_s, u"q_T ← q₀ + (x − x₀)·δq₀₂"_s,
                         u"N_xwB ← N_xwB′ + δN_xw₀₂"_s, u"δq₁₂ = (q₂ − q₁)/(x₂ − x₁)"_s};
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
                cuts += stage.note.contains(u"the near plane cuts"_s) ? 1 : 0;
                for (const FormulaLine &line : stage.lines) {
                    if (line.substituted.isEmpty())
                        continue;
                    formulas.insert(line.symbols);
                    const QString fault = formulaFault(
                        line, FormulaRange::of(line.substituted, Arithmetic::Float64),
                        Arithmetic::Float64);
                    QVERIFY2(fault.isEmpty(),
                             qPrintable(u"%1, %2: %3: %4 %5, not %6"_s.arg(
                                 stage.stage, stage.point, line.symbols, line.substituted, fault,
                                 toText(line.used))));
                }
            }
        }
        QCOMPARE(stages.size(), shading == Shading::Phong ? 7 : 8);
        QVERIFY(cuts > 0);
        if (projection == Projection::Perspective)
            QVERIFY(formulas.contains(u"φ = fieldOfView/180·π/2"_s));
        if (shading == Shading::Flat) {
            for (const char *formula : {"x = 1/3·(V₀_x + V₁_x + V₂_x)",
                                        "base_G = ⌊(V₀_base_G + V₁_base_G + V₂_base_G)/3 + ½⌋"})
                QVERIFY2(formulas.contains(QString::fromUtf8(formula)), formula);
        }
        for (const char *formula :
             {"x_view = right_x·(x − E_x) + right_y·(y − E_y) + right_z·(z − E_z)",
              "z_clip = scale_z·(−z_view − near)", "x_device = x_clip/w",
              "x = x_first + (x_device + 1)/2·width − ½", "x = ⌊256·x′ + ½⌋/256",
              "t = z_clip_V₁/(z_clip_V₁ − z_clip_V₂)", "base_R = ⌊c_R·diffuse_R/255 + ½⌋",
              "area_x = (V₁_y − V₀_y)·(V₂_z − V₀_z) − (V₁_z − V₀_z)·(V₂_y − V₀_y)",
              "face_z = area_z/√(area_x² + area_y² + area_z²)", "x_N = face_x",
              "back_y = (E_y − target_y)/√((E_x − target_x)² + (E_y − target_y)² + (E_z − "
              "target_z)²)",
              "up_z = back_x·right_y − back_y·right_x"})
            QVERIFY2(formulas.contains(QString::fromUtf8(formula)), formula);
    }

    /// Red, under an ambient light of 32 and one of 128 that meets V₀ along its normal and V₁ at
    /// 45°: 255·(32 + 128)/255 and 255·(32 + 128/√2)/255 = 122.5 …, which is 123.
    void aPlainTriangleTellsHowItIsLit_data()
    {
        QTest::addColumn<QByteArray>("shading");
        QTest::addColumn<QStringList>("points");
        QTest::addColumn<QList<double>>("bytes");
        QTest::newRow("gouraud") << QByteArray("gouraud") << QStringList{u"V₀"_s, u"V₁"_s}
                                 << QList<double>{160, 123};
        // The mean normal: (1/√2, 0, −2 − 1/√2), N·L = 2.7071…/√(½ + 2.7071²) = 0.9675…
        QTest::newRow("flat") << QByteArray("flat") << QStringList{u"centre"_s}
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
        for (const StageFormulas &stage : stages) {
            for (const FormulaLine &line : stage.lines) {
                if (line.substituted.isEmpty())
                    continue;
                const QString fault
                    = formulaFault(line, FormulaRange::of(line.substituted, Arithmetic::Float64),
                                   Arithmetic::Float64);
                QVERIFY2(fault.isEmpty(),
                         qPrintable(line.symbols + u": "_s + line.substituted + u' ' + fault));
            }
        }
        for (qsizetype i = 0; i < points.size(); ++i) {
            bool isFound = false;
            for (const StageFormulas &stage : stages) {
                for (const FormulaLine &line : stage.lines) {
                    if (stage.point != points[i] || !line.symbols.startsWith(u"s_R"))
                        continue;
                    QCOMPARE(line.symbols, u"s_R = min(255, ⌊I_R + ½⌋)"_s);
                    QCOMPARE(line.used.toDouble(), bytes[i]);
                    QCOMPARE(traced->primitives.triangles[0].vertices[std::size_t(i)].colour.red(),
                             std::uint8_t(bytes[i]));
                    isFound = true;
                }
            }
            QVERIFY2(isFound, qPrintable(points[i]));
        }
    }

    void aNameThatIsNoNumberIsNoticed()
    {
        QVERIFY(FormulaRange::of(u"(9 1/2) + 3·2²"_s, Arithmetic::Exact));
        for (const char *text : {"(9 1/2) + ΔR", "p_k₊₁", "", "3 +", "(4", "1/0", "R′ + 2"})
            QVERIFY2(!FormulaRange::of(QString::fromUtf8(text), Arithmetic::Exact), text);
    }
};

PIXELPLUMB_TEST(TestStageFormulas)

} // namespace tst_stageformulas

#include "tst_stageformulas.moc"
