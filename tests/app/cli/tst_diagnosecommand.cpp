// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnosis.h"
#include "core/scene/scenefile.h"
#include "tests/support/probescenes.h"
#include "tests/support/programrun.h"
#include "tests/support/scanning.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

namespace tst_diagnosecommand {

using namespace pixelplumb;

/// The bug is named on the command line.
class TestDiagnoseCommand : public QObject {
    Q_OBJECT

private slots:
    void defectsAreThoseOfAProgramThatIsNotOurs_data()
    {
        QTest::addColumn<QString>("mode");
        QTest::newRow("") << QString();
        QTest::newRow("ends-truncated") << QStringLiteral("floor");
        QTest::newRow("ends-upward") << QStringLiteral("ceil");
        QTest::newRow("colour-divisor-plus-one") << QStringLiteral("plus");
        QTest::newRow("colours-without-edge-pre-step") << QStringLiteral("late");
    }
    void defectsAreThoseOfAProgramThatIsNotOurs()
    {
        QFETCH(QString, mode);
        if (QStandardPaths::findExecutable(QStringLiteral("python3")).isEmpty())
            QSKIP("python3 is not there");
        QStringList words = {QStringLiteral("try"), QStringLiteral("--json")};
        for (const char *number : {"1", "2", "3"})
            words += {
                QStringLiteral("--scene"),
                resource(QStringLiteral("/probes/column-scan-%1.json")).arg(QLatin1String(number))};
        const QString id = QString::fromLatin1(QTest::currentDataTag());

        const ProgramRun tried = run(words
                                     + QStringList{QStringLiteral("--"), QStringLiteral("python3"),
                                                   testData("student/columnscan.py"), mode});

        const QJsonDocument json = QJsonDocument::fromJson(tried.output);
        QCOMPARE(json[QStringLiteral("right")].toBool(), id.isEmpty());
        const QJsonArray candidates
            = json[QStringLiteral("diagnosis")][QStringLiteral("candidates")].toArray();
        QCOMPARE(candidates.isEmpty(), id.isEmpty());
        if (id.isEmpty())
            return;
        const QJsonObject first = candidates.first().toObject();
        QCOMPARE(first[QStringLiteral("distance")].toInt(-1), 0);
        QCOMPARE(first[QStringLiteral("defects")].toArray(), QJsonArray({id}));
        // Which step of the right run its picture parts from, though no run of ours has it.
        QVERIFY(first[QStringLiteral("parts")][QStringLiteral("step")].toInt() > 0);
        QVERIFY(!first[QStringLiteral("parts")][QStringLiteral("how")].toString().isEmpty());
    }

    void theDefectsOfAMethodAreListed()
    {
        const ProgramRun listed = run({QStringLiteral("probes"), QStringLiteral("--list"),
                                       QStringLiteral("--method"), QStringLiteral("row-walk")});
        QCOMPARE(listed.exitCode, 0);
        for (const Scene &scene : probeScenes("row-walk")) {
            for (const Defect &defect : defectsFor(scene))
                QVERIFY2(listed.output.contains('\n' + defect.id.toUtf8() + ' ')
                             || listed.output.startsWith(defect.id.toUtf8() + ' '),
                         qPrintable(defect.id));
        }
        QVERIFY(listed.output.contains("\nunsorted-colours "));
    }

    void theCommandNamesTheBug()
    {
        const QTemporaryDir folder;
        QStringList arguments = {QStringLiteral("diagnose"), QStringLiteral("--json")};
        int number = 0;
        for (const Scene &scene : probeScenes()) {
            const QString file = folder.filePath(QStringLiteral("%1.json").arg(number));
            const QString picture = folder.filePath(QStringLiteral("%1.png").arg(number++));
            QVERIFY(!writeSceneFile(file, scene));
            const ProgramRun drawn
                = run({QStringLiteral("render"), file, QStringLiteral("-o"), picture,
                       QStringLiteral("--variant"), QStringLiteral("unsorted-colours")});
            QCOMPARE(drawn.exitCode, 0);
            arguments += {QStringLiteral("--scene"), file, picture};
        }
        const ProgramRun result = run(arguments);
        QCOMPARE(result.exitCode, 1);
        const QJsonDocument json = QJsonDocument::fromJson(result.output);
        QCOMPARE(json[QStringLiteral("verdict")].toString(), QStringLiteral("wrong"));
        const QJsonArray candidates = json[QStringLiteral("candidates")].toArray();
        QCOMPARE(candidates.size(), 1);
        const QJsonObject candidate = candidates.first().toObject();
        QCOMPARE(candidate[QStringLiteral("distance")].toInt(-1), 0);
        QCOMPARE(candidate[QStringLiteral("defects")].toArray(),
                 QJsonArray({QStringLiteral("unsorted-colours")}));
        QVERIFY(candidate[QStringLiteral("parts")].isObject());
    }

    void undecidablePixelsAreCountedAsByDiff()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("edge.json"));
        Scene scene = sceneWith({triangleAt(1, 1, 4, 1, 1, 3)});
        scene.frame.width = 6;
        scene.frame.height = 5;
        QVERIFY(!writeSceneFile(file, scene));
        // (1, 1) lies on two edges, (5, 3) is outside.
        const QByteArray raster = "......\n.#...#\n.##...\n..###.\n......\n";
        const auto answer = [&](const QStringList &words) {
            return QJsonDocument::fromJson(run(words, raster).output).object();
        };

        const QJsonObject named = answer({QStringLiteral("diagnose"), QStringLiteral("--json"),
                                          QStringLiteral("--scene"), file, QStringLiteral("-")});
        const QJsonObject compared
            = answer({QStringLiteral("diff"), QStringLiteral("--json"), file, QStringLiteral("-")});

        QCOMPARE(named[QStringLiteral("verdict")].toString(), QStringLiteral("wrong"));
        QCOMPARE(named[QStringLiteral("differing")].toInt(), 2);
        QCOMPARE(named[QStringLiteral("undecidable")].toInt(), 1);
        QCOMPARE(compared[QStringLiteral("undecidable")].toInt(), 1);
    }

    void theCommandWantsAsManyScenesAsPictures()
    {
        const ProgramRun result
            = run({QStringLiteral("diagnose"), QStringLiteral("a.png"), QStringLiteral("b.png"),
                   QStringLiteral("--scene"), defaultScene()});
        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains("1 scenes and 2 pictures"), result.messages.constData());
    }

    void nobodyIsJudgedByAMethodThatDrawsNothingOfTheScene_data()
    {
        QTest::addColumn<QStringList>("words");
        const QStringList method = {QStringLiteral("--scene"), defaultScene(),
                                    QStringLiteral("--method"), QStringLiteral("line-bresenham")};
        QTest::newRow("diagnose") << QStringList{QStringLiteral("diagnose"), QStringLiteral("-")}
                + method;
        QTest::newRow("try") << QStringList{QStringLiteral("try"), QStringLiteral("true")} + method;
    }
    void nobodyIsJudgedByAMethodThatDrawsNothingOfTheScene()
    {
        QFETCH(QStringList, words);
        const ProgramRun result = run(words, "..\n");
        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains("method “line-bresenham” draws none of the primitives"),
                 result.messages.constData());
    }

    void aRasterWithAnotherCharacterIsToldWithItsPlace()
    {
        const ProgramRun result = run({QStringLiteral("diagnose"), QStringLiteral("-"),
                                       QStringLiteral("--scene"), defaultScene()},
                                      "#.#\n#?#\n");
        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains("line 2, column 2: “?”; expected # or ."),
                 result.messages.constData());
    }
};

PIXELPLUMB_TEST(TestDiagnoseCommand)

} // namespace tst_diagnosecommand

#include "tst_diagnosecommand.moc"
