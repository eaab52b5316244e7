// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/fileaccess.h"
#include "core/scene/scenefile.h"
#include "tests/support/programs/probesheet.h"
#include "tests/support/scanning.h"
#include "tests/support/scenes/probescenes.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QTest>

#include <algorithm>

namespace tst_probesheets {

using namespace pixelplumb;

/// The sheets of resources/probes/: a few scenes on which every known defect of a method draws
/// pictures of its own. PIXELPLUMB_RECORD=1 in the environment writes them anew.
class TestProbeSheets : public QObject {
    Q_OBJECT

private slots:
    void theSearchFindsTheSheetAgain_data() { addMethods(); }
    void theSearchFindsTheSheetAgain()
    {
        QFETCH(QString, method);
        const bool isRecorded = qEnvironmentVariableIsSet("PIXELPLUMB_RECORD");
        if (!isRecorded && method != QLatin1String("row-walk"))
            QSKIP("One search shows that it finds the same again; each takes seconds.");
        Scene conventions;
        conventions.method = method.toStdString();
        std::vector<QByteArray> found;
        for (const Scene &scene : searchProbes(conventions, 1, 240))
            found.push_back(writeScene(scene));

        const QStringList paths = sheetPaths(method);
        if (isRecorded) {
            for (const QString &path : paths)
                QVERIFY(QFile::remove(path));
            for (std::size_t i = 0; i < found.size(); ++i)
                QVERIFY(!writeFile(
                    resource(u"/probes/%1-%2.json"_s.arg(method, QString::number(i + 1))),
                    found[i]));
            return;
        }
        QCOMPARE(std::size_t(paths.size()), found.size());
        for (qsizetype i = 0; i < paths.size(); ++i)
            QCOMPARE(found[std::size_t(i)], *readFile(paths[i]));
    }

    void aSheetTellsAllDefectsApart_data() { addMethods(); }
    void aSheetTellsAllDefectsApart()
    {
        QFETCH(QString, method);
        QFETCH(int, fewest);
        const std::vector<Scene> scenes = probeSheet(method);
        QVERIFY(scenes.size() >= 1 && scenes.size() <= 5);
        for (const Scene &scene : scenes)
            QCOMPARE(scene.method, method.toStdString());
        const ProbeResult result = probe(scenes);
        QStringList alike;
        for (const AlikeDefects &group : result.alike) {
            for (const Defect &defect : group.defects)
                alike += defect.id;
        }
        QVERIFY2(alike.isEmpty(), qPrintable(alike.join(u' ')));
        QCOMPARE(result.distinct(), result.defects + 1);
        // Far shifts are many, but not a kind of their own.
        const std::vector<Defect> defects = defectsFor(scenes.front());
        QVERIFY(std::ranges::count(defects, false, &Defect::standsAlone) >= fewest);
    }

    void theListOfAMethodHasTheDefectsOfItsScenes_data() { addMethods(); }
    void theListOfAMethodHasTheDefectsOfItsScenes()
    {
        QFETCH(QString, method);
        std::vector<Scene> scenes = probeSheet(method);
        if (method != QLatin1String("line-bresenham"))
            std::ranges::move(probeScenes(method.toLatin1().constData()),
                              std::back_inserter(scenes));
        const std::vector<Defect> listed = defectsUnder(scenes.front());
        for (const Scene &scene : scenes) {
            for (const Defect &defect : defectsFor(scene))
                QVERIFY2(std::ranges::find(listed, defect.id, &Defect::id) != listed.end(),
                         qPrintable(defect.id));
        }
    }

    void oneTriangleLeavesDefectsAlike()
    {
        const std::vector<Scene> scenes = {sceneWith({triangleAt(5, 5, 30, 5, 5, 30)})};
        const ProbeResult result = probe(scenes);
        QVERIFY(!result.alike.empty());
        QVERIFY(result.alike.front().equalRight);
        // A single triangle toggles nothing: traversing it again gives the same.
        QVERIFY(std::ranges::any_of(result.alike.front().defects,
                                    [](const Defect &defect) { return defect.id == u"parity"_s; }));
        QVERIFY(result.distinct() < result.defects + 1);
        QVERIFY(result.distinct() > 20);
    }

private:
    static void addMethods()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<int>("fewest"); // known defects
        const auto add = [](const char *method, int fewest) {
            QTest::newRow(method) << QString::fromLatin1(method) << fewest;
        };
        add("column-scan", 140);
        add("row-walk", 180);
        add("edge-equations", 120);
        add("barycentric-rectangle", 120);
        add("line-bresenham", 90);
    }

    static QStringList sheetPaths(const QString &method)
    {
        const QDir folder(resource(u"/probes"_s));
        QStringList paths;
        for (const QString &name : folder.entryList({method + u"-*.json"_s}))
            paths += folder.filePath(name);
        return paths;
    }
};

PIXELPLUMB_TEST(TestProbeSheets)

} // namespace tst_probesheets

#include "tst_probesheets.moc"
