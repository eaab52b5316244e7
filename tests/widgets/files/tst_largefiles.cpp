// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenefile.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scenes/largescenes.h"
#include "tests/support/testprogram.h"
#include "widgets/files/scenefiles.h"
#include "widgets/look/messagebar.h"
#include "widgets/model/playhead.h"

#include <QSignalSpy>
#include <QtWidgets>

#include <algorithm>
#include <utility>

namespace tst_largefiles {

using namespace pixelplumb;

namespace {

QString writtenScene(const IsolatedSettings &settings, const QString &name, const Scene &scene)
{
    const QString path = settings.folder() + QLatin1Char('/') + name;
    return writeSceneFile(path, scene) ? QString() : path;
}

} // namespace

/// Files of large scenes are read and written in the background.
class TestLargeFiles : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void aLargeFileIsReadBesideTheWindow()
    {
        const Scene scene = crowd(12'000, 100, exact);
        const QString path = writtenScene(m_settings, "large.json", scene);
        const auto window = windowWith(crowd(1, 100, exact));
        const Scene before = window->parts().document->scene();
        QSignalSpy loaded(window->parts().files, &SceneFiles::loaded);

        QVERIFY(window->openScene(path));

        QVERIFY(window->parts().files->isLoading());
        QVERIFY(window->findChild<QProgressBar *>("loadProgress")->isVisible());
        QCOMPARE(window->parts().document->scene(), before);
        QVERIFY(loaded.wait(timeout));
        QVERIFY(window->parts().document->scene() == scene);
        QVERIFY(!window->parts().document->isModified());
        QVERIFY(window->windowTitle().startsWith("large.json"));
        QVERIFY(!window->findChild<QProgressBar *>("loadProgress")->isVisible());
    }

    /// Prints the longest time that the GUI thread works without processing events; a busy machine
    /// makes it wait longer.
    void theWindowAnswersWhileALargeSceneIsOpenedAndTraced()
    {
        const Scene scene = crowd(100'000, 30, exact);
        const QString path = writtenScene(m_settings, "large.json", scene);
        const auto window = windowWith(crowd(1, 100, exact));
        QSignalSpy loaded(window->parts().files, &SceneFiles::loaded);
        QSignalSpy traced(window->parts().tracer, &SceneTracer::traced);
        double longest = 0; // ms
        double last = processorTime(CLOCK_THREAD_CPUTIME_ID);
        QTimer beat;
        connect(&beat, &QTimer::timeout, this, [&] {
            const double now = processorTime(CLOCK_THREAD_CPUTIME_ID);
            longest = std::max(longest, now - last);
            last = now;
        });
        beat.start(0);
        window->openScene(path);
        QVERIFY(waitUntil([&] { return loaded.size() == 1; }));
        const double opening = std::exchange(longest, 0.0);
        QVERIFY(waitUntil([&] { return !traced.isEmpty(); }));
        const double tracing = std::exchange(longest, 0.0);
        window->parts().playhead->pick({500, 500});
        for (int i = 0; i < 20; ++i)
            QCoreApplication::processEvents();
        qInfo("the GUI thread works at most %.1f ms while opening, %.1f ms until it is traced, "
              "%.1f ms after that",
              opening, tracing, longest);
        QVERIFY(window->parts().document->scene() == scene);
    }

    void openingEndsByItsButtonByANewSceneAndWithTheWindow()
    {
        const QString path = writtenScene(m_settings, "large.json", crowd(12'000, 100, exact));
        auto window = windowWith(crowd(1, 100, exact));
        const Scene before = window->parts().document->scene();
        QSignalSpy ended(window->parts().files, &SceneFiles::loadingFailed);
        window->openScene(path);

        QTest::mouseClick(window->findChild<QWidget *>("cancelLoad"), Qt::LeftButton);

        QCOMPARE(ended.size(), 1);
        QCOMPARE(window->parts().document->scene(), before);
        QVERIFY(!window->parts().files->isLoading());

        window->openScene(path);
        window->parts().files->newScene();
        QTRY_VERIFY_WITH_TIMEOUT(!window->parts().files->isLoading(), timeout);
        QCOMPARE(window->parts().document->primitiveCount(), 0);
        QCOMPARE(window->parts().files->displayName(), "untitled");

        window->openScene(path);
        QVERIFY(window->close());
        window.reset(); // the reader is told to stop
    }

    void theFileThatIsOpenedLastIsTheOneThatIsShown()
    {
        const Scene second = crowd(12'001, 100, exact);
        const QString first = writtenScene(m_settings, "a.json", crowd(12'000, 100, exact));
        const QString last = writtenScene(m_settings, "b.json", second);
        const auto window = windowWith({});
        QSignalSpy loaded(window->parts().files, &SceneFiles::loaded);
        window->openScene(first);
        window->openScene(last);

        QVERIFY(loaded.wait(timeout));
        QVERIFY(window->parts().document->scene() == second);
        QCOMPARE(window->parts().files->displayName(), "b.json");
    }

    void whatWasEditedMeanwhileIsAskedAbout()
    {
        const QString path = writtenScene(m_settings, "large.json", crowd(12'000, 100, exact));
        const auto window = windowWith(crowd(1, 100, exact));
        int asked = 0;
        window->parts().files->askAboutChanges = [&asked] {
            ++asked;
            return UnsavedChanges::Cancel;
        };
        QSignalSpy ended(window->parts().files, &SceneFiles::loadingFailed);
        window->openScene(path);
        window->parts().document->addTriangle(triangleAt(1, 2, 30, 4, 5, 60));

        QVERIFY(ended.wait(timeout));
        QCOMPARE(asked, 1);
        QCOMPARE(window->parts().document->primitiveCount(), 2);
    }

    void aFaultInALargeFileIsToldWithItsPlace()
    {
        QByteArray text = writeScene(crowd(12'000, 100, exact));
        text.replace(text.lastIndexOf("triangle"), 8, "triangel");
        const QString path = m_settings.folder() + "/faulty.json";
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        file.close();
        const auto window = windowWith(crowd(1, 100, exact));
        QSignalSpy ended(window->parts().files, &SceneFiles::loadingFailed);
        window->openScene(path);

        QVERIFY(ended.wait(timeout));
        const QString told = window->parts().messageBar->text();
        QVERIFY2(told.contains("faulty.json") && told.contains("primitives[11999]"),
                 qPrintable(told));
        QCOMPARE(window->parts().document->primitiveCount(), 1);
    }

    void aLargeSceneIsSavedBesideTheWindow()
    {
        const Scene scene = crowd(12'000, 100, exact);
        const auto window = windowWith(scene);
        SceneDocument *document = window->parts().document;
        document->addTriangle(triangleAt(1, 2, 30, 4, 5, 60));
        const QString path = m_settings.folder() + "/saved.json";

        QVERIFY(window->parts().files->saveTo(path));

        QVERIFY(document->isModified()); // until the file is whole
        QVERIFY(window->findChild<QProgressBar *>("saveProgress")->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!document->isModified(), timeout);
        QVERIFY(!window->findChild<QProgressBar *>("saveProgress")->isVisible());
        QVERIFY(readSceneFile(path)->scene == document->scene());
        QVERIFY(window->windowTitle().startsWith("saved.json"));

        const Scene saved = document->scene();
        QVERIFY(window->parts().files->saveTo(path));
        document->addTriangle(triangleAt(1, 2, 30, 4, 5, 61)); // meanwhile
        QTRY_VERIFY_WITH_TIMEOUT(!window->parts().files->saving().isRunning(), timeout);
        QVERIFY(document->isModified());
        QVERIFY(readSceneFile(path)->scene == saved);
    }

    void nothingReplacesASceneBeforeItsFileIsWhole()
    {
        const auto window = windowWith(crowd(12'000, 100, exact));
        SceneDocument *document = window->parts().document;
        SceneFiles *files = window->parts().files;
        const QString path = m_settings.folder() + "/saved.json";
        QVERIFY(files->saveTo(path));
        QVERIFY(files->mayReplace()); // waits for the file in a dialog
        QVERIFY(!files->saving().isRunning());

        document->addTriangle(triangleAt(1, 2, 30, 4, 5, 60));
        files->askAboutChanges = [] { return UnsavedChanges::Save; };
        QVERIFY(files->mayReplace());
        QVERIFY(readSceneFile(path)->scene == document->scene());
    }

    void aLargeSceneThatCannotBeSavedIsComplainedAbout()
    {
        const auto window = windowWith(crowd(12'000, 100, exact));
        window->parts().document->addTriangle(triangleAt(1, 2, 30, 4, 5, 60));
        window->parts().files->askAboutChanges = [] { return UnsavedChanges::Discard; };
        QVERIFY(window->parts().files->saveTo(m_settings.folder() + "/no/such/folder.json"));
        QTRY_VERIFY_WITH_TIMEOUT(!window->parts().files->saving().isRunning(), timeout);
        QVERIFY(window->parts().document->isModified());
        QVERIFY(window->parts().messageBar->text().contains("folder.json"));
    }

    void readingTellsHowFarItIsAndStopsWhenItIsToldTo()
    {
        const QByteArray text = writeScene(crowd(12'000, 100, exact));
        QVERIFY(text.size() > shortText);
        std::vector<std::int64_t> told;
        QVERIFY(readScene(text, [&](const JobProgress &progress) {
            told.push_back(progress.done);
            return progress.phase == JobPhase::Reading && progress.total == text.size();
        }));
        QVERIFY(told.size() > 5);
        QVERIFY(std::ranges::is_sorted(told));
        QVERIFY(told.back() > text.size() / 2 && told.back() < text.size());

        int calls = 0;
        QVERIFY(!readScene(text, [&](const JobProgress &) { return ++calls < 4; }));
        QCOMPARE(calls, 4);
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestLargeFiles)

} // namespace tst_largefiles

#include "tst_largefiles.moc"
