// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scenes/largescenes.h"
#include "tests/support/testprogram.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/messagebar.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenetracer.h"

#include <QSignalSpy>
#include <QtWidgets>

#include <algorithm>

namespace tst_largescenes {

using namespace pixelplumb;

namespace {

void send(Canvas &canvas, QEvent::Type type, const QPointF &position)
{
    const bool isMove = type == QEvent::MouseMove;
    QMouseEvent event(type, position, canvas.mapToGlobal(position),
                      isMove ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
    QApplication::sendEvent(&canvas, &event);
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

} // namespace

/// Scenes with ten thousand triangles and more in the window: shown at once, moved while dragging.
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
                 qPrintable(QString::number(finished))); // of 200, some of them under signs
        QVERIFY2(unfinished >= 190, qPrintable(QString::number(unfinished)));
    }

    void aCrowdedViewHasHandlesOnlyForWhatIsCurrent()
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
        // The handle of the selected vertex is as easy to hit as before.
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

    /// Prints the time from a mouse move to the painted frame; asserts only the order of events,
    /// because machines differ.
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

        // A picture may be painted in the same iteration of the event loop that delivered it.
        int paintsBefore = 0;
        connect(window->parts().previewer, &ScenePreviewer::pictureChanged, &counter,
                [&] { paintsBefore = counter.paints; });

        send(*canvas, QEvent::MouseButtonPress, start);
        std::vector<double> times; // ms
        std::vector<double> guiTimes; // ms of processor time in the GUI thread
        std::vector<double> allTimes; // ms of processor time in all threads
        for (int move = 1; move <= 41; ++move) {
            const qsizetype picturesBefore = drawn.size();
            const double guiBefore = processorTime(CLOCK_THREAD_CPUTIME_ID);
            const double allBefore = processorTime(CLOCK_PROCESS_CPUTIME_ID);
            QElapsedTimer timer;
            timer.start();
            send(*canvas, QEvent::MouseMove, start + QPointF(5 + move % 20, move / 20));
            QVERIFY(waitUntil([&] { return drawn.size() > picturesBefore; }));
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
        QVERIFY(traced.size() >= 1); // the run follows when the mouse rests
        QCOMPARE(window->parts().playhead->traced()->scene, window->parts().document->scene());
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestLargeScenes)

} // namespace tst_largescenes

#include "tst_largescenes.moc"
