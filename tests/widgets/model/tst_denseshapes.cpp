// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/scenes/largescenes.h"
#include "tests/support/testprogram.h"
#include "widgets/canvas/canvas.h"
#include "widgets/canvas/outlinechoice.h"

#include <random>

namespace tst_denseshapes {

using namespace pixelplumb;

namespace {

/// A scene with one primitive of many corners in a small frame: a random polygon, or letters.
Scene denseScene(PrimitiveKind kind, int count)
{
    Scene scene;
    scene.frame = frameOf(64, 48);
    Shape shape;
    shape.kind = kind;
    if (kind == PrimitiveKind::Text) {
        scene.method = "text-outlines";
        shape.vertices = {{latticePixel(2, 2), {{255, 255, 255}}}};
        shape.textHeight = 12 * unitsPerPixel;
        for (int i = 0; i < count; ++i)
            shape.text += char('a' + i % 26);
    } else {
        scene.method = "polygon-parity";
        shape.fill = ShapeFill::EvenOdd;
        std::mt19937 random(3);
        std::uniform_int_distribution<Lattice> x(0, 64 * unitsPerPixel), y(0, 48 * unitsPerPixel);
        for (int i = 0; i < count; ++i)
            shape.vertices.push_back({{x(random), y(random)}, {{255, 255, 255}}});
    }
    scene.shapes = {shape};
    scene.settings.fillRule = FillRule::TopLeft; // both support it
    return scene;
}

OutlineChoice choiceOf(const MainWindow &window)
{
    const Canvas &canvas = *window.parts().canvas;
    OutlineChoice choice;
    choice.lookUp(*window.parts().document, canvas.mapping(), canvas.view());
    return choice;
}

double windowTime() { return processorTime(CLOCK_THREAD_CPUTIME_ID); }

} // namespace

/// One primitive with very many corners. tst_framepainter counts what is painted of it.
class TestDenseShapes : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    /// The primitive is traced in the background, and its vertices have no handles. Prints the time
    /// that the window's own thread took.
    void aPrimitiveOfManyCornersDoesNotHoldUpTheWindow_data()
    {
        QTest::addColumn<PrimitiveKind>("kind");
        QTest::addColumn<int>("count");
        QTest::newRow("polygon, 30,000 corners") << PrimitiveKind::Polygon << 30'000;
        QTest::newRow("polygon, 100,000 corners") << PrimitiveKind::Polygon << 100'000;
        QTest::newRow("text, 100,000 characters") << PrimitiveKind::Text << 100'000;
    }
    void aPrimitiveOfManyCornersDoesNotHoldUpTheWindow()
    {
        QFETCH(PrimitiveKind, kind);
        QFETCH(int, count);
        const auto window = windowWith({});
        window->parts().document->reset(denseScene(kind, 12));
        QVERIFY(!window->parts().tracer->isRunning()); // a small one is not worth a thread

        const double before = windowTime();
        window->parts().document->reset(denseScene(kind, count));
        const double opened = windowTime();
        QVERIFY(window->parts().tracer->isRunning());
        QVERIFY(waitForTrace(*window));
        const double traced = windowTime();
        window->parts().canvas->grab();
        qInfo("the window's thread: %.0f ms opening, %.0f ms until traced, %.0f ms painting",
              opened - before, traced - opened, windowTime() - traced);

        const OutlineChoice choice = choiceOf(*window);
        QVERIFY(!choice.isCrowded());
        QCOMPARE(choice.hasHandles(0), kind == PrimitiveKind::Text);
    }

    void oneThatIsChosenHasAHandleAmongManyThatHaveNone()
    {
        const auto window = windowWith(denseScene(PrimitiveKind::Polygon, 5'000));
        const Canvas &canvas = *window->parts().canvas;
        SceneDocument &document = *window->parts().document;
        QVERIFY(waitForTrace(*window));
        const VertexRef some{0, 4321};
        const QPointF place = canvas.positionOf(document.vertexAt(some)->position);
        document.selectVertex(some);
        window->parts().canvas->grab();

        QVERIFY(!choiceOf(*window).hasHandles(0));
        QCOMPARE(canvas.vertexAt(place), std::optional(some));
    }

    void aRunOfVeryManyCrossingsIsCutAtItsLimit()
    {
        TraceOptions options;
        options.spanLimit = 2'000;
        const auto traced = traceScene(denseScene(PrimitiveKind::Polygon, 3'000), options);
        // A row meets about a third of the edges, and each four crossings count as a span.
        QVERIFY(traced->trace->isCut());
        QVERIFY(traced->trace->spanCount() < 20);
        options.spanLimit = 100'000;
        QVERIFY(!traceScene(denseScene(PrimitiveKind::Polygon, 3'000), options)->trace->isCut());
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestDenseShapes)

} // namespace tst_denseshapes

#include "tst_denseshapes.moc"
