// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

namespace tst_plancommand {

using namespace pixelplumb;

namespace {

QJsonObject planOf(const QString &scene, const QStringList &options = {})
{
    const ProgramRun plan = run(
        QStringList{QStringLiteral("plan"), sceneFile(scene), QStringLiteral("--json")} + options);
    return QJsonDocument::fromJson(plan.output).object();
}

/// The verdict on an effect, and what else is said of it.
QJsonObject verdictOn(const QJsonObject &plan, const QString &effect)
{
    const QJsonArray effects = plan[QStringLiteral("effects")].toArray();
    for (const QJsonValue &each : effects) {
        if (each[QStringLiteral("effect")] == effect)
            return each.toObject();
    }
    return {};
}

QStringList calledFor(const QJsonObject &plan)
{
    QStringList names;
    const QJsonArray effects = plan[QStringLiteral("effects")].toArray();
    for (const QJsonValue &each : effects) {
        if (each[QStringLiteral("verdict")] == QStringLiteral("called for"))
            names.append(each[QStringLiteral("effect")].toString());
    }
    return names;
}

} // namespace

/// `pixelplumb-cli plan`, and --force.
class TestPlanCommand : public QObject {
    Q_OBJECT

private slots:
    void tellsWhatEachExampleCallsFor_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QStringList>("effects");
        const auto add = [](const char *scene, const QStringList &effects) {
            QTest::newRow(scene) << QString::fromLatin1(scene) << effects;
        };
        const QString smooth = QStringLiteral("smooth colour");
        add("default.json", {smooth});
        add("crossing-triangles.json", {QStringLiteral("depth")});
        add("glass-panes.json", {QStringLiteral("blending")});
        add("even-lines.json", {QStringLiteral("antialiasing")});
    }
    void tellsWhatEachExampleCallsFor()
    {
        QFETCH(QString, scene);
        QFETCH(QStringList, effects);

        const QStringList found = calledFor(planOf(scene));

        for (const QString &effect : effects)
            QVERIFY2(found.contains(effect), qPrintable(found.join(u',')));
    }

    void printsATableWithTheReasons()
    {
        const ProgramRun plan = run({QStringLiteral("plan"), defaultScene()});

        QCOMPARE(plan.exitCode, 0);
        QVERIFY(plan.messages.isEmpty());
        QVERIFY2(plan.output.startsWith("effect "), plan.output);
        QVERIFY2(plan.output.contains("every alpha is 255: opaque"), plan.output);
        QVERIFY2(plan.output.contains("one sample a pixel"), plan.output);
    }

    void saysThatTheNearPlaneCutsAFace()
    {
        const ProgramRun plan = run(
            {"plan", "-"},
            "{\"pixelplumb\": 1, \"frame\": {\"width\": 32, \"height\": 24},"
            " \"camera\": {\"eye\": [0, 0, 4], \"target\": [0, 0, 0], \"fieldOfView\": 60,"
            " \"near\": 1, \"far\": 20}, \"primitives\": [{\"triangle3\":"
            " [[-1, -1, 3.5], [2, -1, -2], [0, 1.5, 0]], \"colors\": [\"#ff0000\", \"#00ff00\","
            " \"#0000ff\"]}]}");
        QVERIFY2(plan.output.contains("both triangles are of a face that the near plane cuts"),
                 plan.output);
    }

    void aSceneThatNoMethodDrawsRunsNothing()
    {
        const QByteArray scene
            = "{\"pixelplumb\": 1, \"frame\": {\"width\": 9, \"height\": 9}, \"fillRule\":"
              " \"off-screen-point\", \"primitives\": [{\"triangle\": [[1, 1], [8, 1], [1, 8]],"
              " \"colors\": [\"#ff000080\", \"#ff000080\", \"#ff000080\"]}]}";
        const ProgramRun text = run({"plan", "-"}, scene);
        const ProgramRun json = run({"plan", "-", "--json"}, scene);

        QVERIFY2(text.output.contains("called for      refused"), text.output);
        QVERIFY2(!text.output.contains(" yes "), text.output);
        const QJsonObject plan = QJsonDocument::fromJson(json.output).object();
        QVERIFY(!verdictOn(plan, "blending")["runs"].toBool());
        QVERIFY(plan["refused"].toString().contains("cannot do blending"));
    }

    void whatIsNotDrawnIsSaidOfTheBatchThatItJoins()
    {
        const ProgramRun plan
            = run({"plan", "-"},
                  "{\"pixelplumb\": 1, \"frame\": {\"width\": 8, \"height\": 8}, \"primitives\": ["
                  "{\"triangle\": [[1, 1], [6, 1], [1, 6]], \"colors\": [\"#ff000080\", "
                  "\"#ff000080\", \"#ff000080\"]},"
                  "{\"triangle\": [[20, 20], [26, 20], [20, 26]], \"colors\": [\"#ffffff\", "
                  "\"#ffffff\", \"#ffffff\"]}]}");
        QVERIFY2(plan.output.contains("0 … 1, 1 of them not drawn  blending"), plan.output);
    }

    void whatIsForcedRunsAndIsNamed()
    {
        const QJsonObject plan
            = planOf(QStringLiteral("default.json"),
                     {QStringLiteral("--force"), QStringLiteral("depth=on"),
                      QStringLiteral("--force"), QStringLiteral("smooth-colour=off")});
        const QJsonObject depth = verdictOn(plan, QStringLiteral("depth"));
        QCOMPARE(depth[QStringLiteral("verdict")].toString(), QStringLiteral("not called for"));
        QVERIFY(depth[QStringLiteral("forced")].toBool());
        QVERIFY(depth[QStringLiteral("runs")].toBool());
        const QJsonObject smooth = verdictOn(plan, QStringLiteral("smooth colour"));
        QCOMPARE(smooth[QStringLiteral("verdict")].toString(), QStringLiteral("called for"));
        QVERIFY(!smooth[QStringLiteral("runs")].toBool());
    }

    void aWrongSwitchIsRefused_data()
    {
        QTest::addColumn<QString>("entry");
        QTest::addColumn<QByteArray>("message");
        QTest::newRow("unknown effect") << QStringLiteral("shadow=on") << QByteArray("shadow");
        QTest::newRow("near to one") << QStringLiteral("dept=on") << QByteArray("depth");
        QTest::newRow("no state") << QStringLiteral("depth") << QByteArray("depth=on or depth=off");
        QTest::newRow("clipping") << QStringLiteral("clipping=off")
                                  << QByteArray("clipping has no switch");
    }
    void aWrongSwitchIsRefused()
    {
        QFETCH(QString, entry);
        QFETCH(QByteArray, message);

        const ProgramRun plan
            = run({QStringLiteral("plan"), defaultScene(), QStringLiteral("--force"), entry});

        QCOMPARE(plan.exitCode, 2);
        QVERIFY2(plan.messages.contains(message), plan.messages);
    }

    void aSwitchIsNotTurnedBothWays()
    {
        const ProgramRun plan
            = run({"plan", defaultScene(), "--force", "depth=on", "--force", "depth=off"});

        QCOMPARE(plan.exitCode, 2);
        QVERIFY2(plan.messages.contains("depth=on and depth=off; expected one of them"),
                 plan.messages);
    }

    void whatIsForcedIsNotSaidToBeCalledFor()
    {
        const ProgramRun drawn = run(
            {"render", defaultScene(), "--ascii", "--method", "row-walk", "--force", "depth=on"});
        const ProgramRun inVain = run({"plan", defaultScene(), "--force", "texture=on"});

        QCOMPARE(drawn.exitCode, 2);
        QVERIFY2(drawn.messages.contains("cannot do depth, which is forced on; "), drawn.messages);
        QVERIFY2(inVain.output.contains("no (nothing to force)"), inVain.output);
    }

    void measuresWhatEachEffectCosts()
    {
        const QString scene = sceneFile(QStringLiteral("glass-panes.json"));

        const ProgramRun text = run({"plan", scene, "--measure"});
        const ProgramRun json = run({"plan", scene, "--measure", "--json"});

        QCOMPARE(text.exitCode, 0);
        QVERIFY2(text.output.contains("ns a pixel"), text.output);
        const QJsonArray effects
            = QJsonDocument::fromJson(json.output)[QStringLiteral("effects")].toArray();
        for (const QJsonValue &effect : effects) {
            const QJsonObject measured = effect[QStringLiteral("measured")].toObject();
            const bool isBlending
                = effect[QStringLiteral("effect")].toString() == QStringLiteral("blending");
            if (isBlending) {
                QVERIFY(measured[QStringLiteral("changedPixels")].toInt() > 0);
                QVERIFY(measured[QStringLiteral("operationsPerPixel")].toDouble() >= 1);
            }
            if (!measured.isEmpty())
                QVERIFY(measured[QStringLiteral("ratio")][QStringLiteral("median")].toDouble() > 0);
        }
    }

    void aMethodThatCannotIsRefusedWithThoseThatCan_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("render") << QStringList{QStringLiteral("render"), QStringLiteral("--ascii")};
        QTest::newRow("trace") << QStringList{QStringLiteral("trace")};
    }
    void aMethodThatCannotIsRefusedWithThoseThatCan()
    {
        QFETCH(QStringList, arguments);
        const QString scene = sceneFile(QStringLiteral("glass-panes.json"));

        const ProgramRun refused
            = run(arguments
                  + QStringList{scene, QStringLiteral("--method"), QStringLiteral("row-walk"),
                                QStringLiteral("--arithmetic"), QStringLiteral("exact")});

        QCOMPARE(refused.exitCode, 2);
        QVERIFY(refused.output.isEmpty());
        QVERIFY2(refused.messages.contains("method “row-walk” cannot do blending"),
                 refused.messages);
        QVERIFY2(refused.messages.contains("column-scan, interpolate-bilinear, interpolate-plane, "
                                           "interpolate-barycentric can"),
                 refused.messages);
    }

    void anArithmeticThatCannotIsRefusedWithThoseThatCan()
    {
        const ProgramRun refused = run(
            {QStringLiteral("render"), sceneFile(QStringLiteral("glass-panes.json")),
             QStringLiteral("--ascii"), QStringLiteral("--method"), QStringLiteral("column-scan"),
             QStringLiteral("--arithmetic"), QStringLiteral("fixed16.16")});

        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.messages.contains("it can in exact, float32"), refused.messages);
    }

    void forcingOffLetsAnyMethodDraw()
    {
        const ProgramRun drawn = run(
            {QStringLiteral("render"), sceneFile(QStringLiteral("glass-panes.json")),
             QStringLiteral("--ascii"), QStringLiteral("--method"), QStringLiteral("row-walk"),
             QStringLiteral("--fill-rule"), QStringLiteral("closed"), QStringLiteral("--force"),
             QStringLiteral("blending=off"), QStringLiteral("--force"),
             QStringLiteral("depth=off")});

        QVERIFY2(drawn.exitCode == 0, drawn.messages);
    }
};

PIXELPLUMB_TEST(TestPlanCommand)

} // namespace tst_plancommand

#include "tst_plancommand.moc"
