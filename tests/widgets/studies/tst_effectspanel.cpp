// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/effectswitches.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/studies/cost/effectspanel.h"
#include "widgets/studies/cost/effectstext.h"

#include <QtTest>
#include <QtWidgets>

namespace tst_effectspanel {

using namespace pixelplumb;

namespace {

constexpr int longest = 30'000; // ms; a plan takes some milliseconds

/// Two white triangles that overlap, each half of the frame; the later one is farther away.
Scene overlapping()
{
    Scene scene;
    scene.frame.width = 32;
    scene.frame.height = 24;
    for (std::size_t i = 0; i < 2; ++i) {
        scene.triangles.push_back(triangleAt(2, 2, 28, 2, 2, 20));
        for (Vertex &vertex : scene.triangles.back().vertices)
            vertex.colour = i == 0 ? Colour{{255, 255, 255}} : Colour{{0, 0, 255}};
        TriangleAttributes attributes{i, {}, noMaterial};
        for (VertexAttributes &vertex : attributes.vertices)
            vertex.z = Attribute(i + 1) * attributeOne / 4;
        scene.attributes.push_back(attributes);
    }
    return scene;
}

/// A panel and the objects it follows.
struct Bench {
    explicit Bench(const Scene &scene)
        : panel(&document, &switches)
    {
        document.reset(scene);
    }

    QString cell(Effect effect, int column) const
    {
        const auto *model = named<QTableView>(panel, "effectsTable")->model();
        return model->index(int(effect), column).data().toString();
    }
    QString summary() const { return named<QLabel>(panel, "effectsSummary")->text(); }

    SceneDocument document;
    EffectSwitches switches;
    EffectsPanel panel;
};

/// A visible panel that has planned.
struct PlannedBench : Bench {
    explicit PlannedBench(const Scene &scene = overlapping())
        : Bench(scene)
        , spy(&panel, &EffectsPanel::planned)
    {
        panel.show();
        if (!spy.wait(longest))
            qFatal("no plan");
    }

    QSignalSpy spy;
};

void choose(const Bench &bench, const char *name, int index)
{
    auto *box = named<QComboBox>(bench.panel, name);
    box->setCurrentIndex(index);
    emit box->activated(index);
}

} // namespace

/// The dock that says which effects a scene needs.
class TestEffectsPanel : public QObject {
    Q_OBJECT

private slots:
    void plansOnlyWhatIsSeen()
    {
        Bench bench(overlapping());
        QSignalSpy spy(&bench.panel, &EffectsPanel::planned);
        QVERIFY(!spy.wait(200));

        bench.panel.show();
        QVERIFY(spy.wait(longest));
        QVERIFY(bench.panel.plan());
    }

    void showsVerdictsWithReasonsAndFollowsEdits()
    {
        PlannedBench bench;
        QCOMPARE(bench.cell(Effect::Depth, 1), u"● called for"_s);
        QCOMPARE(bench.cell(Effect::Depth, 3), u"2"_s);
        QVERIFY2(bench.cell(Effect::Depth, 8).contains(u"triangle 1 lies behind"_s),
                 qPrintable(bench.cell(Effect::Depth, 8)));
        QCOMPARE(bench.cell(Effect::Blending, 1), u"○ not called for"_s);
        QCOMPARE(bench.cell(Effect::Blending, 8), u"every alpha is 255: opaque"_s);
        QVERIFY(bench.summary().isEmpty());

        bench.document.deletePrimitive(1);
        QVERIFY(bench.spy.wait(longest));
        QCOMPARE(bench.cell(Effect::Depth, 1), u"○ not called for"_s);
    }

    void theSceneIsGivenTheAntialiasingThatIsChosen()
    {
        Bench bench(overlapping());
        auto *box = named<QComboBox>(bench.panel, "effectsSamples");
        QCOMPARE(box->currentText(), u"1 sample"_s);
        choose(bench, "effectsSamples", 3);
        QCOMPARE(bench.document.scene().appearance.antialiasing, Antialiasing::Area);
        QCOMPARE(box->currentText(), u"exact area"_s);
        choose(bench, "effectsSamples", 1);
        QCOMPARE(bench.document.scene().appearance.antialiasing, Antialiasing::Samples4);
        bench.document.undoStack()->undo();
        QCOMPARE(box->currentText(), u"exact area"_s);
    }

    void aSwitchTellsWhatChanges()
    {
        PlannedBench bench;
        choose(bench, "depth-switch", int(Forcing::Off));
        QVERIFY(bench.spy.wait(longest));

        QCOMPARE(int(bench.switches.forced()[Effect::Depth]), int(Forcing::Off));
        QVERIFY2(bench.summary().startsWith(u"Forced: depth off; "_s), qPrintable(bench.summary()));
        QVERIFY2(bench.summary().endsWith(u"pixels change, marked on the canvas."_s),
                 qPrintable(bench.summary()));
        QVERIFY(!bench.document.isModified());
        QCOMPARE(bench.document.undoStack()->count(), 0);

        choose(bench, "depth-switch", int(Forcing::AsCalledFor));
        QVERIFY(bench.spy.wait(longest));
        QVERIFY(bench.summary().isEmpty());
    }

    void aNeutralEffectThatIsForcedOnChangesNothing_data()
    {
        QTest::addColumn<QByteArray>("box");
        QTest::newRow("smooth colour") << QByteArray("smooth-colour-switch");
        QTest::newRow("perspective") << QByteArray("perspective-switch");
        QTest::newRow("blending") << QByteArray("blending-switch");
    }
    void aNeutralEffectThatIsForcedOnChangesNothing()
    {
        QFETCH(QByteArray, box);
        PlannedBench bench;
        choose(bench, box, int(Forcing::On));
        QVERIFY(bench.spy.wait(longest));

        QVERIFY2(bench.summary().endsWith(u"on; no pixel changes."_s), qPrintable(bench.summary()));
    }

    void contradictionsAreCalledDefects()
    {
        EffectPlan plan;
        plan.verdicts[Effect::Depth].verdict = Verdict::CalledFor;
        Appearance appearance;
        appearance.forced[Effect::Depth] = Forcing::Off;
        const QString defect = u"defect"_s;
        const auto textOf = [&](Arithmetic arithmetic, std::int64_t changed) {
            return forcingText(plan, appearance, arithmetic, changed);
        };
        QVERIFY(textOf(Arithmetic::Exact, 0).contains(defect));
        QVERIFY(!textOf(Arithmetic::Exact, 1).contains(defect));

        plan.verdicts[Effect::Depth].verdict = Verdict::NotCalledFor;
        QVERIFY(!textOf(Arithmetic::Exact, 0).contains(defect));
        QVERIFY(textOf(Arithmetic::Exact, 1).contains(defect));

        appearance.forced[Effect::Depth] = Forcing::On;
        QVERIFY(textOf(Arithmetic::Exact, 1).contains(defect));
        QVERIFY(!textOf(Arithmetic::Exact, 0).contains(defect));
        QVERIFY(!textOf(Arithmetic::Float32, 1).contains(defect)); // depths may round apart

        plan.verdicts[Effect::Depth].verdict = Verdict::NotRuledOut;
        QVERIFY(!textOf(Arithmetic::Exact, 1).contains(defect));
    }

    void measuresWhatEachEffectCosts()
    {
        Bench bench(overlapping());
        QSignalSpy planned(&bench.panel, &EffectsPanel::planned);
        bench.panel.show();
        QVERIFY(planned.wait(longest));
        QSignalSpy spy(&bench.panel, &EffectsPanel::measured);

        QTest::mouseClick(named<QPushButton>(bench.panel, "effectsMeasure"), Qt::LeftButton);
        QVERIFY(spy.wait(longest));

        const std::optional<EffectTiming> &timing = bench.panel.timing();
        QVERIFY(timing);
        QVERIFY(timing->costs[Effect::Depth]);
        QVERIFY(timing->costs[Effect::Depth]->changed > 0);
        QCOMPARE(timing->costs[Effect::Perspective]->changed, std::int64_t(0));
        QVERIFY(!timing->costs[Effect::Clipping]);
        QVERIFY(!timing->costs[Effect::Texture]); // there are no texels
        QVERIFY(!bench.cell(Effect::Depth, 5).isEmpty());
        // Both triangles cover the same samples: each tests the depth once, the first also writes.
        QCOMPARE(*timing->costs[Effect::Depth]->operations, 3 * timing->pixels);
        QCOMPARE(bench.cell(Effect::Depth, 6), u"3.00"_s);
        QVERIFY(bench.cell(Effect::Texture, 7).isEmpty());
    }

    void aCancelledMeasurementShowsNothing()
    {
        PlannedBench bench;
        bench.panel.measure();
        QVERIFY(named<QPushButton>(bench.panel, "effectsCancel")->isEnabled());
        bench.panel.cancel();

        QVERIFY(!bench.panel.timing());
        QTRY_VERIFY(named<QPushButton>(bench.panel, "effectsMeasure")->isEnabled());
    }

    void aMethodThatCannotIsNamedWithThoseThatCan()
    {
        Scene scene = overlapping();
        scene.method = "row-walk";
        PlannedBench bench(scene);
        QVERIFY2(bench.summary().contains(u"cannot do depth"_s), qPrintable(bench.summary()));
        QVERIFY(bench.summary().contains(u"“Plane equation”"_s));
        QVERIFY(!named<QPushButton>(bench.panel, "effectsMeasure")->isEnabled());
    }

    void theWindowDrawsWhatIsForced()
    {
        const auto window = openedWindow(overlapping());
        auto *playhead = window->findChild<Playhead *>();
        auto *switches = window->findChild<EffectSwitches *>();
        const FrameBuffer asCalledFor(playhead->traced()->scene.frame);
        drawScene(playhead->traced()->scene, asCalledFor);

        switches->force(Effect::Depth, Forcing::Off);

        QTRY_COMPARE(int(playhead->traced()->scene.appearance.forced[Effect::Depth]),
                     int(Forcing::Off));
        const FrameBuffer forced(playhead->traced()->scene.frame);
        drawScene(playhead->traced()->scene, forced);
        QVERIFY(forced.image() != asCalledFor.image());
    }

    void theCanvasMarksWhatForcingChanges()
    {
        const auto window = openedWindow(overlapping());
        auto *canvas = window->findChild<Canvas *>();
        auto *options = window->findChild<DisplayOptions *>();
        auto *switches = window->findChild<EffectSwitches *>();
        auto *playhead = window->findChild<Playhead *>();
        auto *panel = named<EffectsPanel>(*window, "effectsPanel");
        const auto marksAreSeen = [&] {
            options->setDifferencesShown(true);
            const QImage with = canvas->grab().toImage();
            options->setDifferencesShown(false);
            return with != canvas->grab().toImage();
        };
        for (QWidget *hidden = panel; hidden; hidden = hidden->parentWidget())
            hidden->show();
        playhead->seek(playhead->end());
        QVERIFY(!marksAreSeen()); // in exact arithmetic nothing differs from the truth

        switches->force(Effect::Depth, Forcing::Off);
        QTRY_VERIFY_WITH_TIMEOUT(switches->changes(), longest);
        QTRY_COMPARE(int(playhead->traced()->scene.appearance.forced[Effect::Depth]),
                     int(Forcing::Off));
        playhead->seek(playhead->end());
        QVERIFY(switches->changes()->total() > 0);
        QVERIFY(marksAreSeen());

        switches->force(Effect::Depth, Forcing::AsCalledFor);
        QVERIFY(!switches->changes());
        QVERIFY(!marksAreSeen());
    }
};

PIXELPLUMB_TEST(TestEffectsPanel)

} // namespace tst_effectspanel

#include "tst_effectspanel.moc"
