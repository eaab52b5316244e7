// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/model/playhead.h"
#include "widgets/studies/cost/operationpanel.h"

#include <QtTest>
#include <QtWidgets>

namespace tst_operationsdock {

using namespace pixelplumb;

namespace {

constexpr int longest = 30'000; // ms; a count takes some milliseconds

Scene sceneIn(Arithmetic arithmetic)
{
    Scene scene;
    scene.settings.arithmetic = arithmetic;
    scene.triangles = {triangleAt(3, 4, 50, 10, 20, 40)};
    return scene;
}

} // namespace

/// The dock that counts operations.
class TestOperationsDock : public QObject {
    Q_OBJECT

private slots:
    void showsTheOperationsOfTheCurrentArithmeticOnceItIsSeen()
    {
        Playhead playhead;
        OperationPanel panel(&playhead);
        const auto *table = named<QTableView>(panel, "operationTable")->model();
        QSignalSpy spy(&panel, &OperationPanel::counted);
        playhead.setTraced(traceScene(sceneIn(Arithmetic::Float32)));
        QVERIFY(!spy.wait(200)); // nobody sees it
        QVERIFY(!panel.counts());
        panel.show();
        QVERIFY(spy.wait(longest));
        QCOMPARE(panel.counts()->primitives, std::int64_t(1));
        QCOMPARE(table->headerData(0, Qt::Vertical).toString(), u"divisions"_s);
        QCOMPARE(table->index(0, 0).data().toString(),
                 u"12"_s); // 3 slopes, 9 colour rates
        QCOMPARE(table->index(0, 2).data().toString(), u"0"_s);
        QVERIFY(panel.counts()->of(WorkStage::Pixel, Operation::FloatAddition) > 0);

        playhead.setTraced(traceScene(sceneIn(Arithmetic::Exact)));
        QVERIFY(spy.wait(longest));
        QCOMPARE(panel.counts()->of(WorkStage::Pixel, Operation::FloatAddition), std::int64_t(0));
        const QString summary = named<QLabel>(panel, "operationSummary")->text();
        QVERIFY2(summary.contains(u"exact"_s), qPrintable(summary));
    }

    void saysWhyACurveIsNotCounted()
    {
        Playhead playhead;
        OperationPanel panel(&playhead);
        panel.show();
        Scene scene;
        scene.method = "bezier-subdivision";
        Shape curve;
        curve.kind = PrimitiveKind::Bezier;
        curve.vertices = {{{256, 256}, {}}, {{1500, 3000}, {}}, {{3500, 300}, {}}};
        scene.shapes = {curve};
        playhead.setTraced(traceScene(scene));
        QVERIFY(named<QLabel>(panel, "operationSummary")->text().startsWith(u"Not counted: "_s));
        QCOMPARE(named<QTableView>(panel, "operationTable")->model()->rowCount(), 0);
    }
};

PIXELPLUMB_TEST(TestOperationsDock)

} // namespace tst_operationsdock

#include "tst_operationsdock.moc"
