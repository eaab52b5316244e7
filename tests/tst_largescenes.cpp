// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenefile.h"
#include "core/trace/tracedscene.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scanning.h"
#include "widgets/canvas.h"
#include "widgets/mainwindow.h"
#include "widgets/messagebar.h"
#include "widgets/playhead.h"
#include "widgets/scenedocument.h"
#include "widgets/scenefiles.h"
#include "widgets/sceneloader.h"
#include "widgets/scenepreviewer.h"
#include "widgets/scenetracer.h"

#include <QApplication>
#include <QDeadlineTimer>
#include <QElapsedTimer>
#include <QFile>
#include <QMouseEvent>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>
#include <utility>

using namespace pixelplumb;

namespace {

constexpr int timeout = 120'000; // ms, for machines that do other work as well

/// Triangles of an expected area anywhere in a frame.
Scene crowd(int triangles, double area, const ScanSettings &settings,
            const FrameSpec &frame = frameOf(1920, 1080))
{
    // Three points of a square of side s make an expected area of 11/144 s² (Alagar 1977).
    const auto side = Lattice(std::sqrt(area * 144 / 11) * unitsPerPixel);
    std::mt19937 random(1);
    std::uniform_int_distribution<Lattice> left(0, frame.width * unitsPerPixel - side);
    std::uniform_int_distribution<Lattice> bottom(0, frame.height * unitsPerPixel - side);
    std::uniform_int_distribution<Lattice> offset(0, side);
    std::uniform_int_distribution<int> level(0, 255);
    Scene scene;
    scene.frame = frame;
    scene.settings = settings;
    for (int i = 0; i < triangles; ++i) {
        Triangle triangle;
        const LatticePoint corner = {left(random), bottom(random)};
        for (Vertex &vertex : triangle.vertices) {
            vertex.position = {corner.x + offset(random), corner.y + offset(random)};
            for (auto &channel : vertex.colour.channels)
                channel = std::uint8_t(level(random));
        }
        scene.triangles.push_back(triangle);
    }
    return scene;
}

constexpr ScanSettings exact{Arithmetic::Exact, FillRule::Closed, ByteRounding::Nearest};
constexpr ScanSettings singles{Arithmetic::Float32, FillRule::Closed, ByteRounding::Nearest};

/// A window whose canvas shows a 1920 × 1080 frame pixel by pixel, with every panel at work.
std::unique_ptr<MainWindow> windowWith(const Scene &scene)
{
    auto window = std::make_unique<MainWindow>();
    window->resize(2700, 1700);
    window->show();
    window->parts().document->reset(scene);
    return window;
}

bool waitForTrace(const MainWindow &window)
{
    return QTest::qWaitFor([&] { return !window.parts().tracer->isRunning(); }, timeout);
}

void send(Canvas &canvas, QEvent::Type type, const QPointF &position)
{
    const bool isMove = type == QEvent::MouseMove;
    QMouseEvent event(type, position, canvas.mapToGlobal(position),
                      isMove ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
    QApplication::sendEvent(&canvas, &event);
}

/// Without QTest's naps of 10 ms between two looks.
template <class Condition>
bool waitUntil(const Condition &isTrue)
{
    QDeadlineTimer deadline(timeout);
    QTimer alarm; // wakes the event loop when nothing else does
    alarm.start(timeout);
    while (!isTrue() && !deadline.hasExpired())
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    return isTrue();
}

double processorTime(clockid_t clock) // ms
{
    timespec time = {};
    clock_gettime(clock, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) / 1e6;
}

double medianOf(std::vector<double> values)
{
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// Counts what is painted on a widget.
class PaintCounter : public QObject {
public:
    explicit PaintCounter(QWidget *widget) { widget->installEventFilter(this); }
    int paints = 0;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        paints += event->type() == QEvent::Paint ? 1 : 0;
        return QObject::eventFilter(watched, event);
    }
};

QString writtenScene(const IsolatedSettings &settings, const QString &name, const Scene &scene)
{
    const QString path = settings.folder() + QLatin1Char('/') + name;
    return writeSceneFile(path, scene) ? QString() : path;
}

} // namespace

/// Scenes of ten thousand triangles and more in the window: seen at once, moved under the hand,
/// read beside the GUI thread.
class TestLargeScenes : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void aLargeSceneIsSeenBeforeItsTraceIsThere()
    {
        const auto window = windowWith({});
        ScenePreviewer *previewer = window->parts().previewer;
        QSignalSpy drawn(previewer, &ScenePreviewer::pictureChanged);
        QSignalSpy traced(window->parts().tracer, &SceneTracer::traced);
        const Scene scene = crowd(4000, 2000, exact);

        window->parts().document->reset(scene);

        QVERIFY(drawn.wait(timeout));
        QCOMPARE(traced.size(), 0);
        QVERIFY(previewer->picture());
        FrameBuffer whole(scene.frame);
        drawScene(scene, whole);
        QVERIFY(previewer->picture()->drawn().copy() == whole.copy());
    }

    void aWholeTraceTakesThePreviewsPlace()
    {
        const auto window = windowWith(crowd(2500, 100, exact));
        QVERIFY(waitForTrace(*window));
        QVERIFY(!window->parts().playhead->traced()->trace->isCut());
        QVERIFY(!window->parts().previewer->picture());
    }

    void aCutRunSaysHowFarItGoesAndShowsTheFinishedPicture()
    {
        const Scene scene = crowd(9000, 1500, exact);
        const auto window = windowWith(scene);
        Canvas *canvas = window->parts().canvas;
        Playhead *playhead = window->parts().playhead;
        canvas->setZoom(1);
        QVERIFY(waitForTrace(*window));
        QVERIFY(playhead->traced()->trace->isCut());
        const QString steps = QLocale().toString(qulonglong(playhead->end()));
        const QString told = window->parts().messageBar->text();
        QVERIFY2(told.contains(steps), qPrintable(told));
        QTRY_VERIFY(window->parts().previewer->picture());

        FrameBuffer whole(scene.frame);
        drawScene(scene, whole);
        playhead->seek(playhead->end());
        const QImage atEnd = canvas->grab().toImage();
        playhead->seek(playhead->end() - 1);
        const QImage before = canvas->grab().toImage();
        int finished = 0;
        int unfinished = 0;
        for (int x = 100; x < 1900; x += 90) {
            for (int y = 100; y < 1000; y += 90) {
                const QPoint at
                    = (canvas->positionOf(QPoint(x, y)) * atEnd.devicePixelRatio()).toPoint();
                finished += atEnd.pixel(at) == *whole.view().at(x, y) ? 1 : 0;
                unfinished += before.pixel(at) == *playhead->frame()->view().at(x, y) ? 1 : 0;
            }
        }
        QVERIFY2(finished >= 190,
                 qPrintable(QString::number(finished))); // of 200, some under signs
        QVERIFY2(unfinished >= 190, qPrintable(QString::number(unfinished)));
    }

    void aCrowdedViewHasHandlesOnlyForWhatIsInHand()
    {
        const auto window = windowWith(crowd(5000, 100, exact));
        Canvas *canvas = window->parts().canvas;
        canvas->setZoom(1);
        QVERIFY(waitForTrace(*window));
        canvas->grab();
        const VertexRef some{1234, 1};
        const QPointF place
            = canvas->positionOf(window->parts().document->vertexAt(some)->position);
        QCOMPARE(canvas->vertexAt(place).has_value(), true);
        window->parts().document->selectVertex(some);
        // The handle of the selected vertex is as easy to hit as ever.
        const auto near = canvas->vertexAt(place + QPointF(0.5, 0.5));
        QVERIFY(near.has_value());
        window->parts().document->selectVertex(std::nullopt);

        OutlineChoice choice;
        choice.lookUp(*window->parts().document, canvas->mapping(), canvas->view());
        QVERIFY(choice.isCrowded());
        QCOMPARE(choice.primitives({some, VertexRef{7, 0}, 1234}), (std::vector<int>{7, 1234}));
        QVERIFY(choice.primitives({}).empty());
    }

    void closerUpEveryTriangleInViewIsOutlined()
    {
        const auto window = windowWith(crowd(5000, 100, exact));
        Canvas *canvas = window->parts().canvas;
        canvas->setZoom(16);
        OutlineChoice choice;
        choice.lookUp(*window->parts().document, canvas->mapping(), canvas->view());
        QVERIFY(!choice.isCrowded());
        QVERIFY(!choice.primitives({}).empty());
        QVERIFY(choice.primitives({}).size() < 300);
    }

    /// Prints how long a move of the mouse takes to the painted frame; asserts only the order of
    /// events, because machines differ.
    void everyMoveOfADragIsDrawnAndPainted_data()
    {
        QTest::addColumn<double>("area");
        QTest::addColumn<ScanSettings>("settings");
        QTest::newRow("100 px, exact") << 100.0 << exact;
        QTest::newRow("100 px, float32 with differences") << 100.0 << singles;
        QTest::newRow("1000 px, exact") << 1000.0 << exact;
        QTest::newRow("1000 px, float32 with differences") << 1000.0 << singles;
    }
    void everyMoveOfADragIsDrawnAndPainted()
    {
        QFETCH(double, area);
        QFETCH(ScanSettings, settings);
        const auto window = windowWith(crowd(10'000, area, settings));
        Canvas *canvas = window->parts().canvas;
        canvas->setZoom(1);
        QVERIFY(waitForTrace(*window));
        QCoreApplication::processEvents();
        const LatticePoint corner = window->parts().document->vertexAt({9999, 0})->position;
        const QPointF start = canvas->positionOf(corner);
        QVERIFY(canvas->view().contains(start));
        PaintCounter counter(canvas);
        QSignalSpy drawn(window->parts().previewer, &ScenePreviewer::pictureChanged);
        QSignalSpy traced(window->parts().tracer, &SceneTracer::traced);

        send(*canvas, QEvent::MouseButtonPress, start);
        std::vector<double> times; // ms
        std::vector<double> guiTimes; // ms of a processor in the GUI thread
        std::vector<double> allTimes; // the same in all threads
        for (int move = 1; move <= 41; ++move) {
            const qsizetype picturesBefore = drawn.size();
            const double guiBefore = processorTime(CLOCK_THREAD_CPUTIME_ID);
            const double allBefore = processorTime(CLOCK_PROCESS_CPUTIME_ID);
            QElapsedTimer timer;
            timer.start();
            send(*canvas, QEvent::MouseMove, start + QPointF(5 + move % 20, move / 20));
            QVERIFY(waitUntil([&] { return drawn.size() > picturesBefore; }));
            const int paintsBefore = counter.paints;
            QVERIFY(waitUntil([&] { return counter.paints > paintsBefore; }));
            times.push_back(double(timer.nsecsElapsed()) / 1e6);
            guiTimes.push_back(processorTime(CLOCK_THREAD_CPUTIME_ID) - guiBefore);
            allTimes.push_back(processorTime(CLOCK_PROCESS_CPUTIME_ID) - allBefore);
        }
        send(*canvas, QEvent::MouseButtonRelease, start + QPointF(6, 2));

        qInfo("from a move to the painted frame: median %.1f ms, least %.1f ms; processors work "
              "%.1f ms for it, %.1f ms of these in the GUI thread",
              medianOf(times), *std::ranges::min_element(times), medianOf(allTimes),
              medianOf(guiTimes));
        QVERIFY(waitForTrace(*window));
        QVERIFY(traced.size() >= 1); // the run follows when the hand rests
        QCOMPARE(window->parts().playhead->traced()->scene, window->parts().document->scene());
    }

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

    /// Prints how long the GUI thread works at most between two looks at its events; a machine that
    /// does other work makes it wait longer.
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

    void openingCanBeCancelled()
    {
        const QString path = writtenScene(m_settings, "large.json", crowd(12'000, 100, exact));
        const auto window = windowWith(crowd(1, 100, exact));
        const Scene before = window->parts().document->scene();
        QSignalSpy ended(window->parts().files, &SceneFiles::loadingFailed);
        window->openScene(path);

        QTest::mouseClick(window->findChild<QWidget *>("cancelLoad"), Qt::LeftButton);

        QVERIFY(ended.wait(timeout));
        QCOMPARE(window->parts().document->scene(), before);
        QVERIFY(!window->parts().files->isLoading());
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

    void aNewSceneEndsTheOpeningOfALargeOne()
    {
        const QString path = writtenScene(m_settings, "large.json", crowd(12'000, 100, exact));
        const auto window = windowWith(crowd(1, 100, exact));
        window->openScene(path);
        window->parts().files->newScene();

        QTRY_VERIFY_WITH_TIMEOUT(!window->parts().files->isLoading(), timeout);
        QCOMPARE(window->parts().document->primitiveCount(), 0);
        QCOMPARE(window->parts().files->displayName(), "untitled");
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

    void closingTheWindowEndsTheOpening()
    {
        const QString path = writtenScene(m_settings, "large.json", crowd(12'000, 100, exact));
        auto window = windowWith({});
        window->openScene(path);
        QVERIFY(window->close());
        window.reset(); // waits for the reader, which is told to stop
    }

    void readingTellsHowFarItIsAndStopsWhenItIsToldTo()
    {
        const QByteArray text = writeScene(crowd(12'000, 100, exact));
        QVERIFY(text.size() > largestWholeText);
        std::vector<qsizetype> told;
        ReadOptions options;
        options.progress = [&](qsizetype bytesRead, qsizetype bytes) {
            told.push_back(bytesRead);
            return bytes == text.size();
        };
        QVERIFY(readScene(text, options));
        QVERIFY(told.size() > 5);
        QVERIFY(std::ranges::is_sorted(told));
        QVERIFY(told.back() > text.size() / 2 && told.back() < text.size());

        int calls = 0;
        options.progress = [&](qsizetype, qsizetype) { return ++calls < 4; };
        QVERIFY(!readScene(text, options));
        QCOMPARE(calls, 4);
    }

private:
    IsolatedSettings m_settings;
};

QTEST_MAIN(TestLargeScenes)
#include "tst_largescenes.moc"
