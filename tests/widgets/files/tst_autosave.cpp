// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenefile.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/files/autosave.h"
#include "widgets/files/scenefiles.h"
#include "widgets/model/job.h"
#include "widgets/model/scenedocument.h"

#include <QtTest>
#include <QtWidgets>

namespace tst_autosave {

using namespace pixelplumb;

namespace {

/// A document that is saved to a folder whenever it changes.
struct Kept {
    SceneDocument document;
    std::unique_ptr<Autosave> autosave;

    explicit Kept(const QString &folder)
        : autosave(std::make_unique<Autosave>(&document, folder))
    {
        autosave->setRest(std::chrono::milliseconds(1));
        document.reset(Scene());
    }
    /// Changes the document and returns the saved file's path.
    QString change()
    {
        QSignalSpy kept(autosave.get(), &Autosave::kept);
        document.addTriangle(triangleAt(1, 1, 9, 2, 5, 20));
        return kept.wait() ? kept[0][0].toString() : QString();
    }
};

/// Leaves files as a killed run does: no living process holds the lock.
void leave(const QString &folder, const QString &name, const Scene &scene)
{
    QDir().mkpath(folder);
    const QString path = folder + u'/' + name + u".json"_s;
    QVERIFY(!writeSceneFile(path, scene));
    QFile note(path + u".origin"_s);
    QVERIFY(note.open(QIODevice::WriteOnly));
    note.write("/home/someone/mine.json");
}

Scene oneTriangle()
{
    Scene scene;
    scene.triangles = {triangleAt(4, 5, 58, 12, 26, 44)};
    return scene;
}

} // namespace

/// Unsaved scenes survive a crash, and nothing else does.
class TestAutosave : public QObject {
    Q_OBJECT

private slots:
    void aChangedSceneIsKeptUntilItIsSaved()
    {
        const QTemporaryDir folder;
        Kept kept(folder.path());
        const QString path = kept.change();
        const Result<SceneReading> reading = readSceneFile(path);
        QVERIFY(reading);
        QCOMPARE(reading->scene, kept.document.scene());

        kept.document.markSaved();
        QVERIFY(!QFile::exists(path));
        kept.document.undoStack()->undo(); // it differs from the saved scene
        QTRY_VERIFY(QFile::exists(path));
        kept.document.undoStack()->redo();
        QTRY_VERIFY(!QFile::exists(path));
    }

    void aCleanEndLeavesNothing()
    {
        const QTemporaryDir folder;
        {
            Kept kept(folder.path());
            QTest::qWait(30);
            QVERIFY(QDir(folder.path()).isEmpty()); // nothing has changed
            QVERIFY(QFile::exists(kept.change()));
            kept.document.clear();
            QTest::qWait(5); // another file may be in progress
        }
        QVERIFY(jobPool()->waitForDone());
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void aLivingDocumentsFileIsNobodyElses()
    {
        const QTemporaryDir folder;
        Kept first(folder.path());
        const Kept second(folder.path());
        QVERIFY(!first.change().isEmpty());
        QVERIFY(!second.autosave->leftBehind());
    }

    void whatWasLeftBehindIsTakenOnce()
    {
        const QTemporaryDir folder;
        leave(folder.path(), u"dead"_s, oneTriangle());
        Kept first(folder.path());
        const Kept second(folder.path());
        const std::optional<UnsavedScene> left = first.autosave->leftBehind();
        QVERIFY(left);
        QCOMPARE(left->sceneFile, u"/home/someone/mine.json"_s);
        QVERIFY(!second.autosave->leftBehind()); // the first window's user is being asked about it

        first.document.reset(oneTriangle());
        first.autosave->adopt(*left);
        QVERIFY(first.document.isModified());
        QVERIFY(QFile::exists(left->path)); // a second crash loses nothing
        first.document.markSaved();
        QVERIFY(!QFile::exists(left->path));
    }

    void theWindowOffersIt_data()
    {
        QTest::addColumn<QString>("answer");
        QTest::addColumn<bool>("isShown");
        QTest::addColumn<bool>("isLeft");
        QTest::newRow("recover") << u"&Recover"_s << true << true;
        QTest::newRow("discard") << u"&Discard"_s << false << false;
        QTest::newRow("later") << u"&Later"_s << false << true;
    }
    void theWindowOffersIt()
    {
        QFETCH(const QString, answer);
        QFETCH(const bool, isShown);
        QFETCH(const bool, isLeft);
        const IsolatedSettings settings;
        QDir(Autosave::defaultFolder()).removeRecursively();
        leave(Autosave::defaultFolder(), u"dead"_s, oneTriangle());
        const QString path = Autosave::defaultFolder() + u"/dead.json"_s;
        const auto window = openedWindow();

        window->offerRecovery();
        auto *box = named<QMessageBox>(*window, "recoveryDialog");
        QVERIFY(box);
        QVERIFY2(box->text().contains("mine.json"), qPrintable(box->text()));
        for (QAbstractButton *button : box->buttons()) {
            if (button->text() == answer)
                QTest::mouseClick(button, Qt::LeftButton);
        }

        QCOMPARE(window->parts().document->scene() == oneTriangle(), isShown);
        QCOMPARE(window->isWindowModified(), isShown);
        QVERIFY(!isShown || window->parts().files->path().isEmpty()); // never the user's own file
        QCOMPARE(QFile::exists(path), isLeft);
        window->parts().document->markSaved();
        QDir(Autosave::defaultFolder()).removeRecursively();
    }
};

PIXELPLUMB_TEST(TestAutosave)

} // namespace tst_autosave

#include "tst_autosave.moc"
