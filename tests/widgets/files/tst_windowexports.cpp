// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/fileaccess.h"
#include "core/scene/motion.h"
#include "core/scene/scene.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/files/sceneexports.h"
#include "widgets/files/scenefiles.h"
#include "widgets/files/svgexport.h"
#include "widgets/model/job.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

#include <QtTest>
#include <QtWidgets>

#include <unistd.h>

namespace tst_windowexports {

using namespace pixelplumb;

/// Exports from the window: of which moment, to which path, and when they are cancelled.
class TestWindowExports : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void theMenuNamesWhatTheMethodWalks_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("csv");
        QTest::addColumn<QString>("json");
        const auto add = [](const char *method, const char *csv, const char *json) {
            QTest::newRow(method) << method << QString::fromUtf8(csv) << QString::fromUtf8(json);
        };
        add("column-scan", "&Columns (CSV)…", "Columns (&JSON)…");
        add("row-walk", "Ro&ws (CSV)…", "Rows (&JSON)…");
    }
    void theMenuNamesWhatTheMethodWalks()
    {
        QFETCH(QString, method);
        for (const bool isEmpty : {false, true}) {
            Scene scene = defaultSceneIn(Arithmetic::Exact);
            scene.method = method.toStdString();
            if (isEmpty)
                scene.triangles.clear();
            const auto window = openedWindow(scene);
            QMetaObject::invokeMethod(window->findChild<QMenu *>(u"exportMenu"_s), "aboutToShow");

            QTEST(action(*window, "exportColumnsCsv")->text(), "csv");
            QTEST(action(*window, "exportColumnsJson")->text(), "json");
        }
    }

    void noExportReplacesTheOpenedSceneNorWhatItRefersTo_data()
    {
        QTest::addColumn<QString>("target");
        for (const char *target :
             {"scene.json", "symlink", "hardlink", "texture.png", "link.png", "mesh.obj"})
            QTest::newRow(target) << QString::fromLatin1(target);
    }
    void noExportReplacesTheOpenedSceneNorWhatItRefersTo()
    {
        QFETCH(QString, target);
        const QTemporaryDir folder;
        const QString scene = folder.filePath(u"scene.json"_s);
        QVERIFY(QImage(4, 4, QImage::Format_RGB32).save(folder.filePath(u"texture.png"_s)));
        QVERIFY(QFile::link(u"texture.png"_s, folder.filePath(u"link.png"_s)));
        QVERIFY(!writeFile(folder.filePath(u"mesh.obj"_s), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        QVERIFY(!writeFile(scene, R"({ "pixelplumb": 1, "frame": { "width": 8, "height": 8 },
            "camera": { "eye": [0, 0, 4], "fieldOfView": 40, "near": 1, "far": 10 },
            "materials": { "a": { "texture": "texture.png" } },
            "primitives": [ { "mesh": "mesh.obj", "material": "a" } ] })"));
        QVERIFY(QFile::link(scene, folder.filePath(u"symlink"_s)));
        QVERIFY(::link(QFile::encodeName(scene).constData(),
                       QFile::encodeName(folder.filePath(u"hardlink"_s)).constData())
                == 0);
        const QString path = folder.filePath(target);
        const QByteArray before = *readFile(path);
        const auto window = openedWindow();
        QVERIFY(window->openScene(scene));
        SceneExports *exports = window->parts().exports;
        QSignalSpy complaints(exports, &SceneExports::complaint);

        QVERIFY(!exports->writePicture(path));
        QVERIFY(!exports->writeAnnotatedGrid(path));
        QVERIFY(!exports->writeTrace(path, TraceLevel::Column, TableFormat::Csv));
        QVERIFY(!exports->writeTrace(path, TraceLevel::Pixel, TableFormat::Json));
        QVERIFY(!exports->writeRaster(path));

        QCOMPARE(complaints.size(), 5);
        QVERIFY(complaints[0][0].toString().contains(
            u"it was read, and the export would replace it"_s));
        if (target.contains(u'.') && target != u"scene.json"_s)
            QVERIFY(!window->parts().files->saveTo(path));
        QCOMPARE(*readFile(path), before);
        QVERIFY(exports->writeRaster(folder.filePath(u"raster.txt"_s)));
        QVERIFY(window->parts().files->saveTo(scene)); // the scene's own file
    }

    void exportsTellOfTheFinishedRunUnlessAskedOtherwise()
    {
        const QTemporaryDir folder;
        const auto path = [&folder](const char *name) { return folder.filePath(name); };
        const auto window = openedWindow(); // half drawn
        const Playhead &playhead = *window->parts().playhead;
        SceneExports *exports = window->parts().exports;
        const TracedScene &traced = *playhead.traced();
        constexpr auto asDrawn = ExportMoment::AsDrawn;
        FrameBuffer finished(traced.scene.frame);
        drawScene(traced.scene, finished);

        QVERIFY(exports->writePicture(path("finished.png")));
        QVERIFY(exports->writePicture(path("drawn.png"), asDrawn));
        QCOMPARE(QImage(path("finished.png")).convertToFormat(QImage::Format_RGB32),
                 finished.copy());
        QCOMPARE(QImage(path("drawn.png")).convertToFormat(QImage::Format_RGB32),
                 playhead.frame()->copy());
        QVERIFY(finished.copy() != playhead.frame()->copy());

        QVERIFY(exports->writeRaster(path("finished.txt")));
        QVERIFY(exports->writeRaster(path("drawn.txt"), asDrawn));
        const auto covered = [&path](const char *name) { return readFile(path(name))->count('#'); };
        QCOMPARE(covered("finished.txt"), qsizetype(traced.trace->writtenCount()));
        QCOMPARE(covered("drawn.txt"), qsizetype(traced.trace->samplesDoneAt(playhead.position())));

        QVERIFY(exports->writeAnnotatedGrid(path("finished.svg")));
        QVERIFY(exports->writeAnnotatedGrid(path("drawn.svg"), asDrawn));
        QCOMPARE(*readFile(path("drawn.svg")), svgFigure(playhead, *window->parts().options));
        QVERIFY(*readFile(path("finished.svg")) != *readFile(path("drawn.svg")));

        const auto rows = [&](const char *name, TraceLevel level, ExportMoment moment) {
            const bool starts = exports->writeTrace(path(name), level, TableFormat::Csv, moment);
            return starts && QTest::qWaitFor([&] { return !exports->writing().isRunning(); })
                ? readFile(path(name))->count('\n') - 1
                : -1;
        };
        QCOMPARE(rows("all.csv", TraceLevel::Pixel, ExportMoment::Finished),
                 qsizetype(traced.trace->sampleCount()));
        QCOMPARE(rows("drawn.csv", TraceLevel::Pixel, asDrawn),
                 qsizetype(traced.trace->samplesDoneAt(playhead.position())));
        QCOMPARE(rows("columns.csv", TraceLevel::Column, asDrawn),
                 qsizetype(*playhead.currentSpan() + 1));
    }

    void exportsOfAMovingSceneNameTheFrameThatTheyAreOf()
    {
        const QTemporaryDir folder;
        const auto path = [&folder](const char *name) { return folder.filePath(name); };
        const auto window = openedWindow(u"moving-sliver.json"_s);
        SceneDocument &document = *window->parts().document;
        document.setCurrentFrame(8);
        QTRY_COMPARE(window->parts().playhead->traced()->scene.triangles,
                     sceneAtFrame(document.scene(), 8).triangles);
        SceneExports *exports = window->parts().exports;
        QSignalSpy notices(exports, &SceneExports::notice);
        const QString frame = u"frame 8 of 24 of the motion"_s;

        QVERIFY(exports->writePicture(path("at8.png")));
        QCOMPARE(QImage(path("at8.png")).text(u"Description"_s), frame);
        QVERIFY(exports->writeAnnotatedGrid(path("at8.svg")));
        QCOMPARE(readFile(path("at8.svg"))->count(frame.toLatin1()), 2); // once in the description
                                                                         // and once in the drawing
        QVERIFY(exports->writeRaster(path("at8.txt")));
        for (const auto &[name, format] :
             {std::pair("at8.csv", TableFormat::Csv), std::pair("at8.json", TableFormat::Json)}) {
            QVERIFY(exports->writeTrace(path(name), TraceLevel::Column, format));
            QTRY_VERIFY(!exports->writing().isRunning());
        }
        const QList<QByteArray> lines = readFile(path("at8.csv"))->split('\n');
        QVERIFY(lines[0].startsWith("frame,step,primitive,"));
        QVERIFY(lines[1].startsWith("8,"));
        QVERIFY(readFile(path("at8.json"))
                    ->startsWith("{\n  \"pixelplumbTrace\": 2,\n  \"frame\": 8,"));
        QTRY_COMPARE(notices.size(), 5);
        for (const QList<QVariant> &notice : notices)
            QVERIFY2(notice[0].toString().endsWith(frame + u'.'), qPrintable(notice[0].toString()));
    }

    void thePictureIsExportedAsDrawnOnlyInTheMidstOfARun()
    {
        const auto window = openedWindow();
        const QAction *asDrawn = action(*window, "exportPictureAsDrawn");
        Playhead &playhead = *window->parts().playhead;
        QVERIFY(asDrawn->isEnabled());
        playhead.seek(0);
        QVERIFY(!asDrawn->isEnabled());
        playhead.seek(1);
        QVERIFY(asDrawn->isEnabled());
        playhead.seek(playhead.end());
        QVERIFY(!asDrawn->isEnabled());
    }

    void eachExportOfThePictureWritesTheMomentOfItsName_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("finished") << QByteArray("exportPicture");
        QTest::newRow("as drawn so far") << QByteArray("exportPictureAsDrawn");
    }
    void eachExportOfThePictureWritesTheMomentOfItsName()
    {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        const auto window = openedWindow();
        QFETCH(QByteArray, name);
        const QString path = m_settings.folder() + u'/' + QLatin1String(name) + ".png";
        QStringList filters;
        QTimer::singleShot(0, window.get(), [&] {
            auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
            filters = dialog->nameFilters();
            dialog->selectFile(path);
            dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Save)->click();
        });
        action(*window, name.constData())->trigger();

        QCOMPARE(filters.size(), 1);
        QVERIFY2(filters[0].contains(QLatin1String(QTest::currentDataTag())),
                 qPrintable(filters[0]));
        Playhead &playhead = *window->parts().playhead;
        const QImage soFar = playhead.frame()->copy();
        playhead.seek(playhead.end());
        const QImage finished = playhead.frame()->copy();
        QVERIFY(soFar != finished);
        QCOMPARE(QImage(path).convertToFormat(QImage::Format_RGB32),
                 name == "exportPicture" ? finished : soFar);
    }

    void aTraceIsWrittenBesideTheWindow()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"pixels.csv"_s);
        const auto window = openedWindow();
        SceneExports *exports = window->parts().exports;
        QSignalSpy notices(exports, &SceneExports::notice);

        QVERIFY(exports->writeTrace(path, TraceLevel::Pixel, TableFormat::Csv));

        // The call has returned, the file does not exist yet, and a second call would cancel the
        // first.
        QVERIFY(exports->writing().isRunning());
        QVERIFY(!QFile::exists(path));
        QVERIFY(!exports->writeTrace(folder.filePath(u"other.csv"_s), TraceLevel::Pixel,
                                     TableFormat::Csv));
        QTRY_COMPARE(notices.size(), 1);
        QCOMPARE(notices[0][0].toString(), u"pixels.csv is written."_s);
        QBuffer direct;
        direct.open(QIODevice::WriteOnly);
        QVERIFY(exportTrace(*window->parts().playhead->traced(),
                            {TraceLevel::Pixel, TableFormat::Csv}, direct));
        QCOMPARE(*readFile(path), direct.data());
    }

    void aCancelledTraceLeavesNoFile()
    {
        const QTemporaryDir folder;
        const auto window = openedWindow();
        SceneExports *exports = window->parts().exports;
        QSignalSpy notices(exports, &SceneExports::notice);
        QVERIFY(exports->writeTrace(folder.filePath(u"pixels.json"_s), TraceLevel::Pixel,
                                    TableFormat::Json));

        named<QAbstractButton>(*window, "cancelExport")->click();

        QVERIFY(!exports->writing().isRunning());
        QCOMPARE(notices[0][0].toString(), u"pixels.json was not written."_s);
        QVERIFY(jobPool()->waitForDone());
        QCoreApplication::processEvents();
        QVERIFY(QDir(folder.path()).isEmpty());
        QCOMPARE(notices.size(), 1);
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestWindowExports)

} // namespace tst_windowexports

#include "tst_windowexports.moc"
