// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

namespace tst_effectfaults {

using namespace pixelplumb;

namespace {

/// A scene of 12 × 12 pixels; single quotation marks stand for double ones.
QByteArray sceneOf(const QByteArray &members, const QByteArray &primitives)
{
    QByteArray text = "{'pixelplumb':1,'frame':{'width':12,'height':12}," + members
        + "'primitives':[" + primitives + "]}";
    return text.replace('\'', '\"');
}

/// From (1, 1) to (9, 9), red.
QByteArray segment(const QByteArray &members = {})
{
    return "{'triangle':[[1,1],[5,5],[9,9]],'colors':['#ff0000','#ff0000','#ff0000']" + members
        + '}';
}

/// Behind, over half of the frame.
const QByteArray blueBehind
    = "{'triangle':[[0,0],[11,0],[0,11]],'colors':['#0000ff','#0000ff','#0000ff'],'z':[1,1,1]}";
/// (4¼, 4¼), (4¾, 4¼), (4¾, 4¾): between the samples of pixels (4, 4), (5, 4) and (5, 5).
const QByteArray small
    = "{'triangle':[[4.25,4.25],[4.75,4.25],[4.75,4.75]],'colors':['#0000ff','#0000ff','#0000ff'],"
      "'z':[1,1,1]}";
const QByteArray redInFront
    = "{'triangle':[[1,1],[9,1],[1,9]],'colors':['#ff0000','#ff0000','#ff0000'],'z':[0,0,0]}";

QString drawnWith(const QByteArray &scene, const QStringList &options = {})
{
    return QString::fromUtf8(run(QStringList{"render", "-", "--ascii"} + options, scene).output);
}

QByteArray pixelOf(const QByteArray &scene, int x, int y, const QStringList &options = {})
{
    return run(QStringList{"pixel", "-", QString::number(x), QString::number(y)} + options, scene)
        .output;
}

QJsonObject planOf(const QByteArray &scene, const QStringList &options = {})
{
    return QJsonDocument::fromJson(run(QStringList{"plan", "-", "--json"} + options, scene).output)
        .object();
}

QJsonObject verdictOn(const QJsonObject &plan, const QString &effect)
{
    for (const QJsonValue &each : plan[QStringLiteral("effects")].toArray()) {
        if (each[QStringLiteral("effect")] == effect)
            return each.toObject();
    }
    return {};
}

/// "0+2 depth, 2+1"
QString batchesOf(const QJsonObject &plan)
{
    QStringList batches;
    for (const QJsonValue &batch : plan[QStringLiteral("batches")].toArray()) {
        QStringList effects;
        for (const QJsonValue &effect : batch[QStringLiteral("effects")].toArray())
            effects.append(effect.toString());
        batches.append(QStringLiteral("%1+%2 %3")
                           .arg(batch[QStringLiteral("first")].toInt())
                           .arg(batch[QStringLiteral("count")].toInt())
                           .arg(effects.join(u' '))
                           .trimmed());
    }
    return batches.join(QStringLiteral(", "));
}

} // namespace

/// Small scenes of which untrue things were said, or in which something was lost, with what is true
/// worked out by hand.
class TestEffectFaults : public QObject {
    Q_OBJECT

private slots:
    // The samples (1, 1) to (9, 9): nine.
    void aSegmentIsDrawnUnderEveryEffect_data()
    {
        QTest::addColumn<QByteArray>("scene");
        QTest::addColumn<QStringList>("options");
        const auto add
            = [](const char *name, const QByteArray &scene, const QStringList &options = {}) {
                  QTest::newRow(name) << scene << options;
              };
        add("none", sceneOf({}, segment()));
        add("depth", sceneOf({}, segment()), {"--force", "depth=on"});
        add("blending", sceneOf({}, segment(",'z':[0,0,0]").replace("#ff0000'", "#ff000080'")));
        add("perspective", sceneOf({}, segment(",'w':[1,2,3]")), {"--force", "perspective=on"});
        add("texture",
            sceneOf("'materials':{'board':{'texture':'checker'}},",
                    segment(",'material':'board','uv':[[0,0],[0,0],[0,0]]")));
        add("light",
            sceneOf("'lights':[{'direction':[0,0,1],'color':'#808080'}],",
                    segment(",'normals':[[0,0,-1],[0,0,-1],[0,0,-1]]")));
        add("4 samples", sceneOf("'antialiasing':4,", segment()));
        add("4 samples, forced", sceneOf({}, segment()), {"--force", "antialiasing=on"});
        add("two of them, 16 samples",
            sceneOf("'antialiasing':16,",
                    segment()
                        + ",{'triangle':[[1,1],[9,9],[5,5]],'colors':["
                          "'#00ff00','#00ff00','#00ff00']}"),
            {"--force", "antialiasing=on"});
        add("area", sceneOf("'antialiasing':'area',", segment()), {"--force", "antialiasing=on"});
    }
    void aSegmentIsDrawnUnderEveryEffect()
    {
        QFETCH(QByteArray, scene);
        QFETCH(QStringList, options);
        for (const char *method : {"column-scan", "interpolate-bilinear", "interpolate-plane",
                                   "interpolate-barycentric"}) {
            const QString picture = drawnWith(scene, options + QStringList{"--method", method});
            QVERIFY2(picture.count(u'#') == 9, qPrintable(picture));
            const QStringList rows = picture.trimmed().split(u'\n');
            for (int i = 1; i <= 9; ++i) // the upper row first
                QVERIFY2(rows[11 - i][i] == u'#', qPrintable(picture));
        }
    }

    // A segment paints all samples of its pixels, also where an edge of another triangle passes:
    // the blue one's x + y = 11 touches the squares of (5, 5) and (6, 6).
    void aSegmentInFrontIsNotCoveredByWhatIsBehind_data()
    {
        QTest::addColumn<QByteArray>("antialiasing");
        QTest::newRow("one sample") << QByteArray();
        QTest::newRow("4 samples") << QByteArray("'antialiasing':4,");
        QTest::newRow("16 samples") << QByteArray("'antialiasing':16,");
        QTest::newRow("area") << QByteArray("'antialiasing':'area',");
    }
    void aSegmentInFrontIsNotCoveredByWhatIsBehind()
    {
        QFETCH(QByteArray, antialiasing);
        const QByteArray scene = sceneOf(antialiasing, segment(",'z':[0,0,0]") + ',' + blueBehind);
        const QJsonObject depth = verdictOn(planOf(scene), QStringLiteral("depth"));
        QCOMPARE(depth[QStringLiteral("verdict")].toString(), QStringLiteral("called for"));
        QCOMPARE(depth[QStringLiteral("primitives")].toInt(), 2);
        for (int i = 1; i <= 9; ++i)
            QVERIFY2(pixelOf(scene, i, i)
                         .startsWith("pixel (" + QByteArray::number(i) + ", "
                                     + QByteArray::number(i) + ") #ff0000"),
                     pixelOf(scene, i, i));
        QVERIFY(pixelOf(scene, 3, 2).startsWith("pixel (3, 2) #0000ff"));
    }

    // The square's corner (4½, 4½) parts the triangle into 1/32, 1/16 and 1/32 px²: 255/32 = 7.97,
    // 255/16 = 15.94.
    void anAreaBetweenSamplesIsNotSaidToBeUndrawn()
    {
        const QByteArray scene = sceneOf("'antialiasing':'area',", small);
        const ProgramRun drawn = run({"render", "-", "--ascii"}, scene);
        QVERIFY2(drawn.messages.isEmpty(), drawn.messages);
        QCOMPARE(QString::fromUtf8(drawn.output).count(u'#'), 3);
        for (const auto &[x, y, colour] : {std::tuple(4, 4, "#000008"), std::tuple(5, 4, "#000010"),
                                           std::tuple(5, 5, "#000008")}) {
            const QByteArray told = pixelOf(scene, x, y);
            QVERIFY2(told.contains(colour) && !told.contains("Nothing is drawn"), told);
        }
    }

    // Of the 16 samples of pixel (5, 4) one, (4⅝, 4¼), lies on the blue triangle, of pixel (5, 5)
    // one on its upper edge: red (15·255)/16 = 239.06, blue 255/16 = 15.94.
    void depthIsAskedForAtTheSamplesThatAreDrawn()
    {
        const QByteArray scene = sceneOf("'antialiasing':16,", redInFront + ',' + small);
        QCOMPARE(
            verdictOn(planOf(scene), QStringLiteral("depth"))[QStringLiteral("verdict")].toString(),
            QStringLiteral("called for"));
        const QByteArray hidden = pixelOf(scene, 5, 4);
        QVERIFY2(hidden.startsWith("pixel (5, 4) #ff0000"), hidden);
        QVERIFY2(hidden.contains("triangle 1: Refused: at each of the pixel's 16 samples that the "
                                 "triangle covers it lies behind what stands there."),
                 hidden);

        const QByteArray painted = pixelOf(scene, 5, 4, {"--force", "depth=off"});
        QVERIFY2(painted.startsWith("pixel (5, 4) #ef0010"), painted);
        QVERIFY2(painted.contains("of its 16 samples this triangle wrote 1 (number "), painted);
        QVERIFY2(painted.contains("    R → 239\n    G → 0\n    B → 16\n"), painted);
        QVERIFY2(!painted.contains("Nothing is drawn"), painted);
        QVERIFY2(!painted.contains("=  →"), painted);

        const QByteArray beside = pixelOf(scene, 4, 5);
        QVERIFY2(beside.contains("triangle 1: No sample of the pixel lies in the triangle."),
                 beside);
    }

    // The square of pixel (−1, 3) reaches to x = −½, and the triangle to −0.9.
    void areasReachHalfAPixelBeyondTheSamples()
    {
        const QByteArray triangle
            = "{'triangle':[[-0.9,1],[9,1],[-0.9,9]],'colors':['#ff0000','#ff0000','#ff0000']}";
        const auto clipping = [&](const QByteArray &antialiasing) {
            return verdictOn(planOf(sceneOf(antialiasing, triangle)),
                             QStringLiteral("clipping"))[QStringLiteral("verdict")]
                .toString();
        };
        QCOMPARE(clipping({}), QStringLiteral("not called for"));
        QCOMPARE(clipping("'antialiasing':'area',"), QStringLiteral("called for"));
        QCOMPARE(clipping("'antialiasing':16,"), QStringLiteral("called for"));
    }

    void depthRunsForTheTrianglesInQuestionAlone()
    {
        const QByteArray third
            = "{'triangle':[[7,7],[11,7],[11,10]],'colors':['#00ff00','#00ff00','#00ff00'],"
              "'z':[1,1,1]}";
        const QByteArray fourth
            = "{'triangle':[[1,10],[2,10],[1,11]],'colors':['#00ff00ff','#00ff00fe','#00ff00ff'],"
              "'z':[1,1,1]}";
        const QByteArray second
            = "{'triangle':[[2,1],[6,1],[6,4]],'colors':['#0000ff','#0000ff','#0000ff'],"
              "'z':[1,1,1]}";
        const QByteArray all = redInFront + ',' + second + ',' + third + ',' + fourth;
        const QJsonObject plan = planOf(sceneOf({}, all));
        QCOMPARE(batchesOf(plan), QStringLiteral("0+2 depth, 2+1, 3+1 blending"));
        QCOMPARE(verdictOn(plan, QStringLiteral("depth"))[QStringLiteral("primitives")].toInt(), 2);

        const QJsonObject mesh
            = QJsonDocument::fromJson(run({"plan", sceneFile("mesh.json"), "--json"}).output)
                  .object();
        int inBatches = 0;
        for (const QJsonValue &batch : mesh[QStringLiteral("batches")].toArray()) {
            if (batch[QStringLiteral("effects")].toArray().contains(QStringLiteral("depth")))
                inBatches += batch[QStringLiteral("count")].toInt();
        }
        QCOMPARE(inBatches,
                 verdictOn(mesh, QStringLiteral("depth"))[QStringLiteral("primitives")].toInt());
    }

    // Half way from red to green: 127½.
    void aLinesSmoothColourIsToldAndCanBeForcedOff()
    {
        const QByteArray scene
            = sceneOf({}, "{'line':[[1,4],[9,4]],'colors':['#ff0000','#00ff00']}");
        const QStringList off = {"--force", "smooth-colour=off"};
        const QString name = QStringLiteral("smooth colour");
        QVERIFY(verdictOn(planOf(scene), name)[QStringLiteral("runs")].toBool());
        const QJsonObject forced = verdictOn(planOf(scene, off), name);
        QVERIFY(!forced[QStringLiteral("runs")].toBool());
        QCOMPARE(forced[QStringLiteral("verdict")].toString(), QStringLiteral("called for"));
        QVERIFY(pixelOf(scene, 5, 4).startsWith("pixel (5, 4) #808000, as the truth"));
        QVERIFY(pixelOf(scene, 5, 4, off).startsWith("pixel (5, 4) #ff0000, as the truth"));
    }

    // At (1, 1) N·L = 1: 255·(32 + 128)/255 = 160, in flat shading the mean of three such.
    void lightOfFlatAndGouraudShadingIsToldAndCanBeForcedOff()
    {
        for (const char *shading : {"flat", "gouraud"}) {
            const QByteArray scene = sceneOf(
                "'shading':'" + QByteArray(shading)
                    + "','lights':[{'direction':[0,0,1],'color':'#808080'}],",
                "{'triangle':[[1,1],[9,1],[1,9]],'colors':['#ff0000','#ff0000','#ff0000'],"
                "'normals':[[0,0,-1],[0,0,-1],[0,0,-1]]}");
            const QJsonObject light = verdictOn(planOf(scene), QStringLiteral("light"));
            QCOMPARE(light[QStringLiteral("verdict")].toString(), QStringLiteral("called for"));
            QVERIFY(light[QStringLiteral("runs")].toBool());
            QVERIFY(
                light[QStringLiteral("reason")].toString().contains(QStringLiteral("in set-up")));
            QVERIFY(pixelOf(scene, 1, 1).startsWith("pixel (1, 1) #a00000, as the truth"));

            const QStringList off = {"--force", "light=off"};
            QVERIFY(!verdictOn(planOf(scene, off), QStringLiteral("light"))[QStringLiteral("runs")]
                         .toBool());
            QVERIFY(pixelOf(scene, 1, 1, off).startsWith("pixel (1, 1) #ff0000, as the truth"));
            // Every other method draws what set-up has lit.
            QVERIFY(pixelOf(scene, 1, 1, {"--method", "row-walk"})
                        .startsWith("pixel (1, 1) #a00000, as the truth"));
        }
    }

    void antialiasingIsNotCalledForWhereNoEdgeIs()
    {
        for (const char *antialiasing : {"4", "16", "'area'"}) {
            const QByteArray scene = sceneOf("'antialiasing':" + QByteArray(antialiasing) + ',',
                                             "{'triangle':[[-90,-50],[200,-50],[-90,300]],"
                                             "'colors':['#ff0000','#ff0000','#ff0000']}");
            const QJsonObject verdict = verdictOn(planOf(scene), QStringLiteral("antialiasing"));
            QCOMPARE(verdict[QStringLiteral("verdict")].toString(),
                     QStringLiteral("not called for"));
            QVERIFY(!verdict[QStringLiteral("runs")].toBool());
        }
    }

    // Left edge x = 0 is owned, the lower one and x + y = 6 are not: 5 + 4 + 3 + 2 + 1 samples.
    void aSceneWithoutMethodGetsOneThatKeepsItsRule()
    {
        const QByteArray rule = "'fillRule':'top-left',";
        const QByteArray plain
            = "{'triangle':[[0,0],[6,0],[0,6]],'colors':['#ff0000','#ff0000','#ff0000']}";
        const QByteArray glass
            = "{'triangle':[[0,0],[6,0],[0,6]],'colors':['#ff000080','#ff000080','#ff000080']}";
        for (const QByteArray &primitive : {plain, glass}) {
            const ProgramRun drawn = run({"render", "-", "--ascii"}, sceneOf(rule, primitive));
            QVERIFY2(drawn.exitCode == 0, drawn.messages);
            QCOMPARE(QString::fromUtf8(drawn.output).count(u'#'), 15);
        }
        const ProgramRun chosen
            = run({"render", "-", "--ascii", "--fill-rule", "top-left"}, sceneOf({}, glass));
        QVERIFY2(chosen.exitCode == 0, chosen.messages);
        QCOMPARE(QString::fromUtf8(chosen.output).count(u'#'), 15);
        const ProgramRun named
            = run({"render", "-", "--ascii", "--method", "edge-equations"}, sceneOf(rule, plain));
        QVERIFY2(named.exitCode == 0, named.messages);
        // A method that is named is kept, and says what it cannot.
        QCOMPARE(run({"render", "-", "--ascii", "--method", "column-scan"}, sceneOf(rule, plain))
                     .exitCode,
                 2);
    }

    // (0, 0), (10, 0), (0, 5), black, white, black, with w = 1, 3, 1. At (5, 0) λ = ½, ½, 0:
    // (½·255/3) ÷ (½/1 + ½/3) = 42½ ÷ ⅔ = 63¾; without perspective 127½.
    void thatOfATriangleInPerspectiveIsNotTheFlatOne()
    {
        const QByteArray scene = sceneOf({},
                                         "{'triangle':[[0,0],[10,0],[0,5]],"
                                         "'colors':['#000000','#ffffff','#000000'],'w':[1,3,1]}");
        const QByteArray told = run({"pixel", "-", "5", "0"}, scene).output;
        QVERIFY2(told.contains("    R = 63 3/4 → 64; exact 63 3/4, error 0\n"), told);
        const QByteArray flat
            = run({"pixel", "-", "5", "0", "--force", "perspective=off"}, scene).output;
        QVERIFY2(flat.contains("    R = 127 1/2 → 128; exact 127 1/2, error 0\n"), flat);
    }

    // The base level is white; half of it over black is ⌊255·128/255 + ½⌋ = 128.
    void ofAByteThatEffectsMadeTheLevelsOwnByteStandsBeforeIt()
    {
        const QByteArray scene = sceneOf({},
                                         "{'triangle':[[0,0],[10,0],[0,5]],"
                                         "'colors':['#ffffff80','#ffffff80','#ffffff80']}");
        const QByteArray told = run({"pixel", "-", "1", "1"}, scene).output;
        QVERIFY2(told.contains("    R = 255 → 255 → 128; exact 255, error 0\n"), told);
    }

    void aMethodThatCannotKeepTheRuleIsNotRecommended()
    {
        const QByteArray scene = sceneOf("'fillRule':'off-screen-point',",
                                         "{'triangle':[[0,0],[10,0],[0,5]],"
                                         "'colors':['#ff0000','#00ff00','#0000ff'],'w':[1,2,3]}");
        const ProgramRun refused = run({"render", "-", "--ascii"}, scene);
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.messages.contains("; no method that keeps the fill rule can"),
                 refused.messages);
    }
};

PIXELPLUMB_TEST(TestEffectFaults)

} // namespace tst_effectfaults

#include "tst_effectfaults.moc"
