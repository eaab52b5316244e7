// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/fileaccess.h"
#include "core/scene/scenefile.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scanning.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "tests/support/window/windowsteps.h"
#include "widgets/canvas/canvas.h"
#include "widgets/files/examplefolder.h"
#include "widgets/files/recentfiles.h"
#include "widgets/files/scenefiles.h"
#include "widgets/look/messagebar.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/window/examplesdialog.h"

#include <QTest>
#include <QtWidgets>

namespace tst_windowfiles {

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

/// Scenes opened and saved in the window, and what it asks and reports about them.
class TestWindowFiles : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void unsavedChangesAskBeforeTheWindowCloses()
    {
        const auto window = openedWindow();
        action(*window, "drawTool")->trigger();
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

    void aFileThatAnotherProgramWritesIsTold()
    {
        const auto window = openedWindow();
        const QString path = m_settings.folder() + "/watched.json";
        QVERIFY(window->parts().files->saveTo(path));
        window->parts().document->addTriangle(triangleAt(1, 1, 9, 2, 5, 20));
        QVERIFY(window->parts().files->saveTo(path));
        QTest::qWait(50);
        const auto *bar = named<MessageBar>(*window, "messageBar");
        QVERIFY(!bar->isVisible()); // its own writing is not reported

        const Scene theirs;
        QFile other(path); // not by our functions, which refuse files that this window has read
        QVERIFY(other.open(QIODevice::WriteOnly | QIODevice::Truncate));
        QVERIFY(other.write(writeScene(theirs)) > 0);
        other.close();
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(9),
                                 QFileDevice::FileModificationTime));
        file.close();
        QTRY_VERIFY(bar->isVisible());
        QVERIFY2(bar->text().contains("watched.json"), qPrintable(bar->text()));
        action(*window, "revertScene")->trigger();
        QCOMPARE(window->parts().document->scene(), theirs);
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

    void anotherSceneForgetsTheMomentAndThePixelOfTheOneBefore()
    {
        const auto window = openedWindow();
        Playhead &playhead = *window->parts().playhead;
        playhead.pick({3, 40});

        action(*window, "newScene")->trigger();
        QVERIFY(!playhead.pickedPixel());
        QCOMPARE(playhead.position(), std::size_t(0));

        window->parts().files->openFile(resource(u"/scenes/sliver.json"_s));
        QVERIFY(playhead.position() > 0 && playhead.position() < playhead.end());
        QCOMPARE(playhead.pickedPixel(),
                 TraceNavigation(*playhead.traced()->trace).pixelOf(playhead.position() - 1));
    }

    void whatOthersMadeIsInspectedAndANewSceneDrawn()
    {
        const auto window = openedWindow();
        const Canvas &canvas = *window->parts().canvas;
        const QString example = resource(u"/scenes/sliver.json"_s);
        window->parts().files->openFile(example);
        QVERIFY(canvas.tool() == CanvasTool::Inspect);
        clickPixel(*window, {5, 5});
        QVERIFY(!window->isWindowModified());
        action(*window, "newScene")->trigger();
        QVERIFY(canvas.tool() == CanvasTool::Draw);

        Scene scene;
        scene.triangles = {triangleAt(1, 1, 9, 2, 5, 12)};
        QVERIFY(window->parts().files->showScene(scene)); // a hard case
        QVERIFY(canvas.tool() == CanvasTool::Inspect);
        action(*window, "newScene")->trigger();
        action(*window, "openDefaultScene")->trigger();
        QVERIFY(canvas.tool() == CanvasTool::Inspect);
    }

    /// The window opens in the middle of a run, ready to be looked at.
    void theFirstClickPicksAPixelAndKeysOfMethodsLeaveNothingToSave()
    {
        const auto window = openedWindow();
        const Playhead &playhead = *window->parts().playhead;
        const std::size_t position = playhead.position();

        clickPixel(*window, {20, 12});

        QCOMPARE(playhead.pickedPixel(), std::optional(QPoint(20, 12)));
        QCOMPARE(playhead.position(), position);
        QVERIFY(window->parts().document->pendingVertices().empty());
        const std::string first = window->parts().document->scene().method;
        for (int digit = Qt::Key_9; digit >= Qt::Key_2; --digit) {
            QTest::keyClick(window->parts().canvas, Qt::Key(digit));
            QVERIFY(window->parts().document->scene().method != first);
            QVERIFY2(!window->isWindowModified(), QByteArray::number(digit - Qt::Key_0));
        }
        QVERIFY(window->parts().document->undoStack()->canUndo());
        window->parts().files->askAboutChanges = [] {
            QTest::qFail("asks about a change that nobody made", __FILE__, __LINE__);
            return UnsavedChanges::Discard;
        };
        QVERIFY(window->close());
    }

    /// What is saved then is the current method; a change of the scene is still a change.
    void aSceneIsSavedWithItsMethodAndChangesCountAfterAnotherOne()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"scene.json"_s);
        const auto window = openedWindow();
        SceneDocument &document = *window->parts().document;
        document.setMethod("row-walk");
        QVERIFY(window->parts().files->saveTo(path));
        QCOMPARE(readSceneFile(path)->scene.method, std::string("row-walk"));

        document.setMethod("column-scan");
        QVERIFY(!document.isModified());
        document.setVertexColour({0, 0}, {{1, 2, 3}});
        document.setMethod("row-walk");
        QVERIFY(document.isModified());
        document.undoStack()->undo();
        document.undoStack()->undo();
        QVERIFY(!document.isModified());
    }

    void aSceneThatIsOpenedIsSeenWholeAlsoWhenItIsOfTheSameSize()
    {
        const auto window = openedWindow();
        Canvas &canvas = *window->parts().canvas;
        // Whether the view is as it would be fitted now.
        const auto isSeenWhole = [&] {
            if (!waitForRun(*window))
                return false;
            const ViewMapping there = canvas.mapping();
            canvas.fitToView();
            return there == canvas.mapping();
        };
        const auto zoomIn = [&canvas] {
            canvas.setZoom(4 * canvas.zoom());
            QTest::keyClick(&canvas, Qt::Key_Right, Qt::ShiftModifier);
        };
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"scene.json"_s);
        QVERIFY(window->parts().files->saveTo(path));

        zoomIn();
        QVERIFY(!isSeenWhole());
        zoomIn();
        window->parts().files->openFile(path);
        QVERIFY(isSeenWhole());
        zoomIn();
        action(*window, "openDefaultScene")->trigger();
        QVERIFY(isSeenWhole());
        zoomIn();
        Scene same = window->parts().document->scene();
        same.triangles.front().vertices[0].colour = {{9, 9, 9}};
        QVERIFY(window->parts().files->showScene(same)); // a hard case
        QVERIFY(isSeenWhole());
        zoomIn();
        action(*window, "newScene")->trigger();
        QVERIFY(isSeenWhole());
    }

    void openRecentIsGreyUntilAFileWasOpened()
    {
        const auto window = openedWindow();
        const QAction *menu = named<QMenu>(*window, "recentMenu")->menuAction();
        QVERIFY(!menu->isEnabled());
        window->parts().recent->add(u"/tmp/triangle.json"_s);
        QVERIFY(menu->isEnabled());
        window->parts().recent->clear();
        QVERIFY(!menu->isEnabled());
    }

    void everyExampleHasALineAndAPictureAndOpens()
    {
        const auto window = openedWindow();
        action(*window, "showExamples")->trigger();
        auto *dialog = named<ExamplesDialog>(*window, "examplesDialog");
        auto *list = named<QListWidget>(*dialog, "examplesList");
        const std::vector<Example> all = examples();
        QVERIFY(all.size() > 20);
        QCOMPARE(all.front().title, "Default"); // the assignment's
        for (const Example &example : all)
            QVERIFY2(!example.line.isEmpty(), qPrintable(example.path));
        QVERIFY(list->count() > int(all.size()) + 10); // the families of hard cases
        QTRY_COMPARE_WITH_TIMEOUT(dialog->picturesLeft(), 0, 60'000);
        for (int row = 0; row < list->count(); ++row) {
            const QPixmap picture = list->item(row)->icon().pixmap(list->iconSize());
            QVERIFY2(picture.toImage().pixelColor(picture.rect().center()).alpha() > 0,
                     qPrintable(list->item(row)->text()));
        }
        list->setCurrentRow(1);
        QTest::keyClick(list, Qt::Key_Return);
        QTRY_COMPARE(window->parts().files->path(), all[1].path);
    }

    void visiblePicturesAreDrawnFirstAndOthersSayThatTheyArePending()
    {
        const auto window = openedWindow();
        action(*window, "showExamples")->trigger();
        auto *dialog = named<ExamplesDialog>(*window, "examplesDialog");
        auto *list = named<QListWidget>(*dialog, "examplesList");
        const int last = list->count() - 1;
        const auto wordsOf = [&](int row) {
            return list->item(row)->data(Qt::AccessibleDescriptionRole).toString();
        };
        QVERIFY(!dialog->isDrawn(last));
        QCOMPARE(wordsOf(last), "Picture to be drawn");
        const QPixmap instead = list->item(last)->icon().pixmap(list->iconSize());
        QVERIFY(instead.toImage().pixelColor(0, 0).alpha() > 0);

        list->scrollToBottom();

        QTRY_VERIFY_WITH_TIMEOUT(dialog->isDrawn(last), 60'000);
        QVERIFY(dialog->picturesLeft() > list->count() / 2);
        QCOMPARE(wordsOf(last), QString());
    }

    void aFamilyOfHardCasesOpensItsDock()
    {
        const auto window = openedWindow();
        action(*window, "showExamples")->trigger();
        auto *list = named<QListWidget>(*window, "examplesList");
        const QString text = list->item(list->count() - 1)->text();
        list->setCurrentRow(list->count() - 1);
        QTest::keyClick(list, Qt::Key_Return);

        QTRY_VERIFY(named<QWidget>(*window, "hardCasesDock")->isVisible());
        const auto *tree = named<QTreeWidget>(*window, "hardCasesTree");
        QVERIFY2(text.contains(tree->currentItem()->parent()->text(0)), qPrintable(text));
    }

    void savingAnExampleAsksForAnotherPlace()
    {
        const QString example = resource(u"/scenes/sliver.json"_s);
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
        // Nor is its name proposed once it is merely the last file that was opened.
        window->parts().files->newScene();
        QTimer::singleShot(0, answer);
        QVERIFY(!window->parts().files->save());

        QCOMPARE(proposals.size(), 2);
        QCOMPARE(QFileInfo(proposals[0]).fileName(), u"sliver.json"_s);
        QCOMPARE(QFileInfo(proposals[1]).fileName(), u"scene.json"_s);
        for (const QString &proposal : proposals)
            QVERIFY2(QFileInfo(proposal).dir() != QFileInfo(example).dir(), qPrintable(proposal));
        QCOMPARE(*readFile(example), before);
    }

    void aSceneWithoutAFileIsProposedAFolderThatExists_data()
    {
        QTest::addColumn<bool>("hasDocuments");
        QTest::newRow("documents") << true;
        QTest::newRow("home, where there are no documents") << false;
    }
    void aSceneWithoutAFileIsProposedAFolderThatExists()
    {
        QFETCH(bool, hasDocuments);
        const QTemporaryDir home;
        const QByteArray before = qgetenv("HOME");
        const auto restore = qScopeGuard([before] { qputenv("HOME", before); });
        qputenv("HOME", QFile::encodeName(home.path()));
        if (hasDocuments)
            QVERIFY(QDir(home.path()).mkdir(u"Documents"_s));
        const auto window = openedWindow();
        action(*window, "drawTool")->trigger();
        clickPixel(*window, {10, 40});
        QString proposal;
        QTimer::singleShot(0, window.get(), [&proposal] {
            if (auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget())) {
                proposal = dialog->selectedFiles().constFirst();
                dialog->reject();
            }
        });

        QVERIFY(!window->parts().files->save());

        QCOMPARE(proposal,
                 home.filePath(hasDocuments ? u"Documents/scene.json"_s : u"scene.json"_s));
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestWindowFiles)

} // namespace tst_windowfiles

#include "tst_windowfiles.moc"
