// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/counting/operationtable.h"
#include "core/lab/counting/standardexamples.h"
#include "core/scan/choicenames.h"
#include "tests/support/countedbyhand.h"
#include "tests/support/scenes/scenesformethods.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <numeric>

namespace tst_operationcountruns {

using namespace pixelplumb;
using enum pixelplumb::Operation;

/// Counted runs of every method: they draw its picture, end when asked to, and are shown as a
/// table.
class TestOperationCountRuns : public QObject {
    Q_OBJECT

private slots:
    void theSetUpWeighsInASmallTriangle()
    {
        const Method &method = *methodNamed(u"column-scan");
        const std::vector<StandardExample> examples = standardExamplesFor(method);
        QCOMPARE(examples.size(), std::size_t(2));
        for (const Arithmetic arithmetic : method.arithmetics) {
            const auto large = countOperations(method, arithmetic, examples[0]);
            const auto small = countOperations(method, arithmetic, examples[1]);
            QVERIFY(large->setUpShare() < 0.1);
            QVERIFY(small->setUpShare() > 0.2);
        }
    }

    void everyMethodButTheCurvesIsCountedOnItsExample()
    {
        for (const Method &method : methods()) {
            if (method.id == u"bezier-subdivision"_s || method.id == u"stroke-coverage"_s) {
                QVERIFY(!isCounted(method));
                QVERIFY(!countingGap(method, Arithmetic::Exact).isEmpty());
                continue;
            }
            QVERIFY2(isCounted(method),
                     qPrintable(method.id
                                + u" has no row in core/lab/counting/countedtriangles.cpp or "
                                  "countedshapes.cpp"_s));
            for (const StandardExample &example : standardExamplesFor(method)) {
                for (const Arithmetic arithmetic : method.arithmetics) {
                    const auto counts = countOperations(method, arithmetic, example);
                    QVERIFY2(counts && counts->pixels > 0 && counts->total() > 0,
                             qPrintable(method.id));
                }
            }
        }
    }

    void aCountedRunDrawsThePicture_data()
    {
        QTest::addColumn<QString>("id");
        for (const Method &method : methods()) {
            if (isCounted(method))
                QTest::newRow(qPrintable(method.id)) << method.id;
        }
    }
    void aCountedRunDrawsThePicture()
    {
        QFETCH(QString, id);
        const Method &method = *methodNamed(id);
        for (const auto &[name, scene] : scenesForEveryMethod()) {
            for (const Arithmetic arithmetic : method.arithmetics) {
                for (const FillRule rule : method.fillRules) {
                    const ScanSettings settings = {arithmetic, rule, scene.settings.rounding};
                    const Primitives primitives = primitivesOnSamples(scene);
                    const FrameBuffer drawn(scene.frame);
                    const FrameBuffer counted(scene.frame);
                    Run(&method, primitives, settings, drawn.view(), Kernels::Plain)
                        .draw(drawn.view());
                    const auto counts
                        = countOperations(method, settings, primitives, counted.view());
                    QVERIFY2(drawn.image() == counted.image(),
                             qPrintable(u"%1 in %2, %3"_s.arg(name, nameText(nameOf(arithmetic)),
                                                              nameText(nameOf(rule)))));
                    const OperationRow totals = counts->totals();
                    QCOMPARE(counts->total(),
                             counts->total(WorkStage::SetUp) + counts->total(WorkStage::Span)
                                 + counts->total(WorkStage::Pixel));
                    QCOMPARE(std::accumulate(totals.begin(), totals.end(), std::int64_t(0)),
                             counts->total());
                }
            }
        }
    }

    void theListenerEndsACount()
    {
        const FrameBuffer frame(square(side));
        int asked = 0;
        const auto counts
            = countOperations(*methodNamed(u"column-scan"), {}, tentTriangle(), frame.view(),
                              [&](const JobProgress &) { return ++asked > 1; });
        QVERIFY(!counts);
        QCOMPARE(asked, 1);
    }

    void theTableLeavesOutWhatNeverOccursAndEndsWithTheSum()
    {
        OperationCounts counts;
        counts.primitives = 2;
        counts.spans = 4;
        counts.pixels = 3;
        counts.refused = 1;
        counts.stages[0][std::size_t(Division)] = 6;
        counts.stages[1][std::size_t(FloatAddition)] = 5;
        counts.stages[2][std::size_t(FloatAddition)] = 8;
        QCOMPARE(
            operationTableText(counts),
            (QStringList{"                       a set-up      a span    a sample         all",
                         "divisions                     3           0           0           6",
                         "float additions               0        1.25           2          13",
                         "all                           3        1.25           2          19"}));
        QCOMPARE(countsText(counts),
                 u"2 set-ups, 4 spans, 3 pixels, 1 sample refused, 19 operations"_s);
    }
};

PIXELPLUMB_TEST(TestOperationCountRuns)

} // namespace tst_operationcountruns

#include "tst_operationcountruns.moc"
