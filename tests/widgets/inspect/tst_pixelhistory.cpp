// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/planeweights.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"
#include "tests/support/tracedplayhead.h"
#include "widgets/inspect/pixelhistorypanel.h"
#include "widgets/look/numberformat.h"
#include "widgets/model/pixelhistorymodel.h"

#include <QtTest>
#include <QtWidgets>

#include <cmath>

namespace tst_pixelhistory {

using namespace pixelplumb;

class TestPixelHistory : public QObject {
    Q_OBJECT

private slots:
    void historyKeepsTheModelContract()
    {
        const std::shared_ptr<const TracedScene> traced
            = traceScene(defaultSceneIn(Arithmetic::Float32, 2));
        PixelHistoryModel model;
        const QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(model.rowCount(), 0);

        model.setPixel(traced, QPoint(27, 19));
        model.setPosition(traced->trace->stepCount());
        model.setPixel(traced, QPoint(0, 0));
        model.setPixel(nullptr, std::nullopt);

        QCOMPARE(model.rowCount(), 0);
    }

    void historyOfAWrittenPixelListsChannels()
    {
        const std::shared_ptr<const TracedScene> traced
            = traceScene(defaultSceneIn(Arithmetic::Exact));
        PixelHistoryModel model;

        model.setPixel(traced, QPoint(27, 19));
        model.setPosition(traced->trace->stepCount());

        const PixelAttempt attempt = pixelHistory(*traced, 27, 19).front();
        const QModelIndex written = model.decisiveRow();
        QVERIFY(attempt.written);
        QCOMPARE(written.data().toString(), u"△ 0 wrote it"_s);
        QCOMPARE(written.data(PixelHistoryModel::StepRole).toULongLong(), qulonglong(attempt.step));
        QCOMPARE(model.rowCount(written), 6); // three channels, three edges
        for (int edge = 0; edge < 3; ++edge) {
            const auto at = [&](int column) {
                return model.index(3 + edge, column, written).data().toString();
            };
            QCOMPARE(at(PixelHistoryModel::WhatColumn),
                     u"edge %1"_s.arg(attempt.edgeNames[std::size_t(edge)]));
            QCOMPARE(at(PixelHistoryModel::ByteColumn), u"accepts"_s);
            QVERIFY(at(PixelHistoryModel::ExactColumn).contains(u"px from the edge"_s));
        }
        QCOMPARE(model.index(0, PixelHistoryModel::UsedColumn, written).data().toString(),
                 displayText(attempt.sample->colour[0]));
        QCOMPARE(model.index(0, PixelHistoryModel::ByteColumn, written).data().toString(),
                 u"→ %1"_s.arg(attempt.sample->level[0]));

        model.setPosition(0);
        QCOMPARE(model.decisiveRow().data().toString(), u"△ 0 will write it"_s);
    }

    /// "≈" means the same number in decimals; even exact arithmetic may be wrong through a variant.
    void aColourThatIsNotTheExactOneIsToldWithItsError()
    {
        Scene scene = defaultSceneIn(Arithmetic::Exact);
        std::swap(scene.triangles[0].vertices[0], scene.triangles[0].vertices[2]);
        const auto beside = [&scene] {
            const std::shared_ptr<const TracedScene> traced = traceScene(scene);
            PixelHistoryModel model;
            model.setPixel(traced, QPoint(27, 19));
            const QModelIndex written = model.index(0, 0);
            return model.index(1, PixelHistoryModel::ExactColumn, written).data().toString();
        };
        QVERIFY2(beside().startsWith(u'≈'), qPrintable(beside()));
        scene.settings.variants = scene.settings.variants.with(Variant::UnsortedColours);
        QVERIFY2(beside().startsWith(u"truth "_s), qPrintable(beside()));
        QVERIFY(beside().contains(u"error "_s));
    }

    void whatVerticesCarryIsListedWhereTheSceneCallsForIt()
    {
        Scene scene = defaultSceneIn(Arithmetic::Float32, 2);
        scene.attributes.resize(2); // crossing each other: depths 0, 1, 2 and 2, 1, 0
        scene.attributes[1].triangle = 1;
        for (std::size_t i = 0; i < 3; ++i) {
            scene.attributes[0].vertices[i].z = Attribute(i) * attributeOne;
            scene.attributes[1].vertices[2 - i].z = Attribute(i) * attributeOne;
        }
        const std::shared_ptr<const TracedScene> traced = traceScene(scene);
        const PixelAttempt attempt = pixelHistory(*traced, 27, 19).front();
        QCOMPARE(attempt.carried.size(), std::size_t(1));
        QCOMPARE(attempt.carried[0].title, u"z"_s);
        // From the plane through the vertices' depths 0, 1 and 2.
        const auto weights = oracle::barycentricWeights(traced->primitives.triangles[0], 27, 19);
        const double depth
            = (weights.parts[1].convert_to<double>() + 2 * weights.parts[2].convert_to<double>())
            / weights.whole.convert_to<double>();
        QVERIFY(std::abs(attempt.carried[0].used.toDouble() - depth) < 1e-4);
        QVERIFY(std::abs(attempt.carried[0].exact.toDouble() - depth) < 1e-12);

        PixelHistoryModel model;
        model.setPixel(traced, QPoint(27, 19));
        model.setPosition(traced->trace->stepCount());
        const QModelIndex written = model.index(0, 0);
        QCOMPARE(model.rowCount(written), 7); // three channels, z, three edges
        QCOMPARE(model.index(3, PixelHistoryModel::WhatColumn, written).data().toString(), "z");
        QVERIFY(model.index(3, PixelHistoryModel::ExactColumn, written)
                    .data()
                    .toString()
                    .startsWith(u"exact "_s));

        scene.attributes.clear();
        QVERIFY(pixelHistory(*traceScene(scene), 27, 19).front().carried.empty());
    }

    void theChannelsOfAWriteChangeWithIt()
    {
        PixelHistoryModel model;
        model.setPixel(traceScene(defaultSceneIn(Arithmetic::Exact)), QPoint(27, 20));
        const QModelIndex attempt = model.index(0, 0);
        const std::size_t step = attempt.data(PixelHistoryModel::StepRole).toULongLong();
        model.setPosition(step);
        QStringList wasAhead;
        connect(&model, &QAbstractItemModel::dataChanged, this,
                [&](const QModelIndex &first, const QModelIndex &last) {
                    for (int row = first.row(); first.parent().isValid() && row <= last.row();
                         ++row) {
                        const QModelIndex channel = first.siblingAtRow(row);
                        if (!channel.data(PixelHistoryModel::IsAheadRole).toBool())
                            wasAhead += channel.data().toString();
                    }
                });

        model.setPosition(step + 1);

        QCOMPARE(wasAhead, QStringList({"R", "G", "B"}));
    }

    void historyOfARefusedPixelListsEdges()
    {
        const std::shared_ptr<const TracedScene> traced
            = traceScene(defaultSceneIn(Arithmetic::Exact));
        PixelHistoryModel model;

        model.setPixel(traced, QPoint(4, 4)); // one row below P0

        const QModelIndex refused = model.decisiveRow();
        QCOMPARE(refused.data().toString(), u"△ 0 refuses it"_s);
        QCOMPARE(refused.data(PixelHistoryModel::ReasonRole).toString(),
                 pixelHistory(*traced, 4, 4).front().reason);
        QVERIFY(!refused.data(PixelHistoryModel::StepRole).isValid());
        QCOMPARE(model.rowCount(refused), 3);
        QCOMPARE(model.index(0, PixelHistoryModel::UsedColumn, refused).data().toString(),
                 u"−1 px along column"_s);

        Scene byRows = traced->scene;
        byRows.method = "row-walk";
        model.setPixel(traceScene(byRows), QPoint(4, 4));
        const QModelIndex again = model.decisiveRow();
        QVERIFY(model.index(0, PixelHistoryModel::UsedColumn, again)
                    .data()
                    .toString()
                    .endsWith(u"px along row"_s));
        QVERIFY(again.data(PixelHistoryModel::ReasonRole).toString().contains(u"the row"_s));
    }

    void historyCountsTheRefusalsThatItDoesNotList()
    {
        const std::shared_ptr<const TracedScene> traced
            = traceScene(defaultSceneIn(Arithmetic::Exact, PixelHistoryModel::listedRefusals + 5));
        PixelHistoryModel model;

        model.setPixel(traced, QPoint(0, 47));

        QCOMPARE(model.rowCount(), PixelHistoryModel::listedRefusals + 1);
        QCOMPARE(model.index(model.rowCount() - 1, 0).data().toString(),
                 u"and 5 more that refuse it"_s);
    }

    void theCurrentAttemptIsChosen()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact, 3));
        PixelHistoryPanel panel(&playhead);
        panel.show();
        playhead.pick(QPoint(27, 19));
        const auto *tree = panel.findChild<QTreeView *>(u"pixelHistoryTree"_s);
        const QAbstractItemModel *attempts = tree->model();
        for (const int row : {1, 0, 2}) {
            const std::size_t step
                = attempts->index(row, 0).data(PixelHistoryModel::StepRole).toULongLong();
            playhead.seekToPixelStep(step);
            QCOMPARE(tree->currentIndex().row(), row);
            QVERIFY(!tree->currentIndex().parent().isValid());
        }
    }

    void historyRunsToTheWritesOfThePickedPixel()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        PixelHistoryPanel panel(&playhead);
        panel.show();
        playhead.pick(QPoint(27, 19));

        QTest::mouseClick(panel.findChild<QToolButton *>(u"runToNextWrite"_s), Qt::LeftButton);
        QCOMPARE(playhead.currentPixel(), QPoint(27, 19));

        playhead.seek(playhead.end());
        playhead.pick(QPoint(27, 19));
        QTest::mouseClick(panel.findChild<QToolButton *>(u"runToPreviousWrite"_s), Qt::LeftButton);
        QCOMPARE(playhead.currentPixel(), QPoint(27, 19));
    }

    void historyNamesPixelColourAndTruth()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        PixelHistoryPanel panel(&playhead);
        panel.show();
        playhead.pick(QPoint(27, 19));
        const auto *heading = panel.findChild<QLabel *>(u"pixelHistoryHeading"_s);
        const QString truth = QColor::fromRgb(*playhead.traced()->truth.view().at(27, 19)).name();

        QVERIFY(heading->text().contains(u"(27, 19)"_s));
        QVERIFY(heading->text().contains(u"#000000"_s));
        QVERIFY(heading->text().contains(truth));

        playhead.seek(playhead.end());
        playhead.pick(QPoint(27, 19));
        QVERIFY(!heading->text().contains(u"#000000"_s));
    }

    /// The panel at its size in a window of 1366 × 768.
    void aLongReasonIsSeenWholeAndNoColumnIsCutOff()
    {
        Playhead playhead;
        PixelHistoryPanel panel(&playhead);
        panel.resize(490, 300);
        panel.show();
        playhead.setTraced(
            traceScene(sceneOf(lineAt(8, 6, 12, 4), "line-bresenham", frameOf(16, 8))));
        playhead.pick(QPoint(9, 5));

        const auto *reason = panel.findChild<QLabel *>(u"pixelHistoryReason"_s);
        const auto *area = panel.findChild<QScrollArea *>(u"pixelHistoryReasonArea"_s);
        QVERIFY(reason->text().contains(u"A tie: "_s));
        QVERIFY(reason->heightForWidth(area->viewport()->width())
                > 4 * reason->fontMetrics().lineSpacing());
        QVERIFY(area->height() >= reason->heightForWidth(area->viewport()->width()));

        playhead.setTraced(traceScene(defaultSceneIn(Arithmetic::Exact)));
        playhead.pick(QPoint(9, 5));
        const auto *tree = panel.findChild<QTreeView *>(u"pixelHistoryTree"_s);
        for (const int width : {490, 200}) {
            panel.resize(width, 300);
            const int total = tree->header()->length();
            QVERIFY(total >= tree->viewport()->width());
            // A table that does not fit can be scrolled.
            QCOMPARE(tree->horizontalScrollBar()->maximum() > 0, total > tree->viewport()->width());
            QVERIFY(width == 490 || total > tree->viewport()->width());
        }
    }
};

PIXELPLUMB_TEST(TestPixelHistory)

} // namespace tst_pixelhistory

#include "tst_pixelhistory.moc"
