// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileaccess.h"
#include "core/scene/scenefile.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/openwindow.h"
#include "tests/support/scanning.h"
#include "widgets/files/sceneexports.h"
#include "widgets/files/scenefiles.h"
#include "widgets/look/messagebar.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

#include <QAbstractButton>
#include <QBuffer>
#include <QFileDialog>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>
#include <QTimer>

#include <unistd.h>

using namespace pixelplumb;

namespace {

QString writtenFile(const IsolatedSettings &settings, const QString &name, const QByteArray &text)
{
    const QString path = settings.folder() + QLatin1Char('/') + name;
    QFile file(path);
    if (file.open(QIODevice::WriteOnly))
        file.write(text);
    return path;
}

} // namespace

/// Scenes opened and saved in the window, and what it asks and tells of them.
class TestWindowFiles : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void unsavedChangesAskBeforeTheWindowCloses()
    {
        const auto window = openedWindow();
        clickPixel(*window, {10, 40});
        int questions = 0;
        auto answer = UnsavedChanges::Cancel;
        window->parts().files->askAboutChanges = [&] {
            ++questions;
            return answer;
        };

        QVERIFY(!window->close());
        QVERIFY(window->isVisible());
        answer = UnsavedChanges::Discard;
        QVERIFY(window->close());
        QCOMPARE(questions, 2);
    }

    void anUnchangedWindowClosesWithoutAQuestion()
    {
        const auto window = openedWindow();
        window->parts().files->askAboutChanges = [] {
            QTest::qFail("asked", __FILE__, __LINE__);
            return UnsavedChanges::Cancel;
        };
        QVERIFY(window->close());
    }

    void savesAndOpensTheSameScene()
    {
        const auto window = openedWindow();
        window->parts().document->addTriangle(triangleAt(1, 1, 9, 2, 5, 20));
        const Scene saved = window->parts().document->scene();
        const QString path = m_settings.folder() + "/two.json";
        QVERIFY(window->parts().files->saveTo(path));
        QCOMPARE(window->windowTitle(), "two.json[*] — Pixelplumb");
        QVERIFY(!window->isWindowModified());

        const auto other = openedWindow();
        QVERIFY(other->openScene(path));
        QVERIFY(other->parts().document->scene() == saved);
        QVERIFY(action(*other, "revertScene")->isEnabled());
    }

    void aFileThatCannotBeReadIsToldInTheMessageBar()
    {
        const auto window = openedWindow();
        const Scene before = window->parts().document->scene();
        const QString path = writtenFile(m_settings, "cut.json", "{ \"pixelplumb\": 1, \"frame\"");

        QVERIFY(!window->openScene(path));

        const auto *bar = named<MessageBar>(*window, "messageBar");
        QVERIFY(bar->isVisible());
        QVERIFY2(bar->text().contains("cut.json"), qPrintable(bar->text()));
        QVERIFY(window->parts().document->scene() == before);
        QVERIFY(!window->openScene(m_settings.folder() + "/missing.json"));
        QVERIFY(bar->text().contains("missing.json"));
    }

    void tellsWhatSnappingDisplaced()
    {
        const auto window = openedWindow();
        Scene scene;
        scene.triangles = {triangleAt(1, 1, 9, 2, 5, 12)};
        QByteArray text = writeScene(scene);
        QVERIFY(text.contains("[1, 1]"));
        const QString path
            = writtenFile(m_settings, "snap.json", text.replace("[1, 1]", "[1.1, 1]"));
        const auto *bar = named<MessageBar>(*window, "messageBar");
        QVERIFY2(window->openScene(path), qPrintable(bar->text()));

        QVERIFY(bar->isVisible());
        QVERIFY2(bar->text().contains("1.1"), qPrintable(bar->text()));
    }

    void noExportReplacesTheOpenedScene_data()
    {
        QTest::addColumn<QString>("target");
        for (const char *target : {"own.json", "symlink", "hardlink"})
            QTest::newRow(target) << QString::fromLatin1(target);
    }
    void noExportReplacesTheOpenedScene()
    {
        QFETCH(QString, target);
        const QTemporaryDir folder;
        const QString scene = folder.filePath(QStringLiteral("own.json"));
        QVERIFY(QFile::copy(QStringLiteral(PIXELPLUMB_RESOURCES "/scenes/sliver.json"), scene));
        QVERIFY(QFile::link(scene, folder.filePath(QStringLiteral("symlink"))));
        QVERIFY(::link(QFile::encodeName(scene).constData(),
                       QFile::encodeName(folder.filePath(QStringLiteral("hardlink"))).constData())
                == 0);
        const QByteArray before = *readFile(scene);
        const auto window = openedWindow();
        QVERIFY(window->openScene(scene));
        SceneExports *exports = window->parts().exports;
        QSignalSpy complaints(exports, &SceneExports::complaint);
        const QString path = folder.filePath(target);

        QVERIFY(!exports->writePicture(path));
        QVERIFY(!exports->writeAnnotatedGrid(path));
        QVERIFY(!exports->writeTrace(path, TraceLevel::Column, TableFormat::Csv));
        QVERIFY(!exports->writeTrace(path, TraceLevel::Pixel, TableFormat::Json));
        QVERIFY(!exports->writeRaster(path));

        QCOMPARE(complaints.size(), 5);
        QVERIFY(complaints[0][0].toString().contains(QStringLiteral("it is the scene itself")));
        QCOMPARE(*readFile(scene), before);
        QVERIFY(exports->writeRaster(folder.filePath(QStringLiteral("raster.txt"))));
    }

    void aTraceIsWrittenBesideTheWindow()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("pixels.csv"));
        const auto window = openedWindow();
        SceneExports *exports = window->parts().exports;
        QSignalSpy notices(exports, &SceneExports::notice);

        QVERIFY(exports->writeTrace(path, TraceLevel::Pixel, TableFormat::Csv));

        // The call is over, the file is not there yet, and a second one would cancel the first.
        QVERIFY(exports->writing().isRunning());
        QVERIFY(!QFile::exists(path));
        QVERIFY(!exports->writeTrace(folder.filePath(QStringLiteral("other.csv")),
                                     TraceLevel::Pixel, TableFormat::Csv));
        QTRY_COMPARE(notices.size(), 1);
        QCOMPARE(notices[0][0].toString(), QStringLiteral("pixels.csv is written."));
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
        QVERIFY(exports->writeTrace(folder.filePath(QStringLiteral("pixels.json")),
                                    TraceLevel::Pixel, TableFormat::Json));

        named<QAbstractButton>(*window, "cancelExport")->click();

        QVERIFY(!exports->writing().isRunning());
        QCOMPARE(notices[0][0].toString(), QStringLiteral("pixels.json was not written."));
        QVERIFY(QThreadPool::globalInstance()->waitForDone());
        QCoreApplication::processEvents();
        QVERIFY(QDir(folder.path()).isEmpty());
        QCOMPARE(notices.size(), 1);
    }

    void anotherSceneForgetsTheMomentAndThePixelOfTheOneBefore()
    {
        const auto window = openedWindow();
        Playhead &playhead = *window->parts().playhead;
        playhead.pick({3, 40});

        action(*window, "newScene")->trigger();
        QVERIFY(!playhead.pickedPixel());
        QCOMPARE(playhead.position(), std::size_t(0));

        window->parts().files->openFile(QStringLiteral(PIXELPLUMB_RESOURCES "/scenes/sliver.json"));
        QVERIFY(playhead.position() > 0 && playhead.position() < playhead.end());
        QCOMPARE(playhead.pickedPixel(),
                 TraceNavigation(*playhead.traced()->trace).pixelOf(playhead.position() - 1));
    }

    void savingAnExampleAsksForAnotherPlace()
    {
        const QString example = QStringLiteral(PIXELPLUMB_RESOURCES "/scenes/sliver.json");
        const QByteArray before = *readFile(example);
        const auto window = openedWindow();
        QVERIFY(window->openScene(example));
        QStringList proposals;
        const auto answer = [&proposals] {
            if (auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget())) {
                proposals.append(dialog->selectedFiles().constFirst());
                dialog->reject();
            }
        };

        QTimer::singleShot(0, answer);
        QVERIFY(!window->parts().files->save());
        // Nor is it proposed once it is merely the last file that was opened.
        window->parts().files->newScene();
        QTimer::singleShot(0, answer);
        QVERIFY(!window->parts().files->save());

        QCOMPARE(proposals.size(), 2);
        QCOMPARE(QFileInfo(proposals[0]).fileName(), QStringLiteral("sliver.json"));
        QCOMPARE(QFileInfo(proposals[1]).fileName(), QStringLiteral("scene.json"));
        for (const QString &proposal : proposals)
            QVERIFY2(QFileInfo(proposal).dir() != QFileInfo(example).dir(), qPrintable(proposal));
        QCOMPARE(*readFile(example), before);
    }

private:
    IsolatedSettings m_settings;
};

QTEST_MAIN(TestWindowFiles)
#include "tst_windowfiles.moc"
