// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/madestudy.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/lab/labanswers.h"
#include "widgets/lab/labelplaces.h"
#include "widgets/lab/labtable.h"
#include "widgets/lab/labtext.h"
#include "widgets/lab/missplot.h"
#include "widgets/lab/paretoplot.h"

#include <QHeaderView>
#include <QtTest>

#include <cmath>

namespace tst_labplots {

using namespace pixelplumb;

namespace {

std::vector<MadeContender> five()
{
    return {{"column-scan:float32", 2.0, 5221},
            {"cheap", 0.9, 7670},
            {"lucky", 1.6, 0},
            {"proved", 2.1, 0, true},
            {"dear", 8.8, 20}};
}

ParetoPoint positive(double error)
{
    ParetoPoint point;
    point.error = error;
    return point;
}

ParetoChart chartOf(const std::vector<ParetoPoint> &points)
{
    ParetoChart chart;
    chart.points = points;
    return chart;
}

/// The picture of a plot.
template <class Plot, class... Arguments>
QImage shown(const Arguments &...arguments)
{
    Plot plot;
    plot.resize(400, 300);
    plot.setVisible(true);
    plot.show(arguments...);
    return plot.grab().toImage();
}

const ErrorAxis &wrongPixels() { return *errorAxisNamed(u"wrong-pixels"_s); }

} // namespace

/// The charts and the table of the lab, with made-up studies.
class TestLabPlots : public QObject {
    Q_OBJECT

private slots:
    void whatAccuracyCostsIsSaidInWords()
    {
        auto results = madeResults({{"column-scan:float32", 2.0, 5221},
                                    {"column-scan:exact", 2.5, 0},
                                    {"column-scan:fixed32.32", 1.0, 52},
                                    {"row-walk:exact", 3.0, 0}});

        QCOMPARE(priceText(*results, u"f"_s),
                 u"Column scan, relative to float32 (5221 wrong pixels per "
                 "million): exact takes 1.25× the time, 0 wrong; fixed32.32 takes "
                 "0.50× the time, 52.0 wrong."_s);
        results->rows[0].cost.reset();
        QCOMPARE(priceText(*results, u"f"_s), QString());
    }

    void theErrorScaleKnowsTheClassOfEachPlace()
    {
        const ErrorScale scale(chartOf({positive(0.02), positive(700)}));

        QVERIFY(scale.toAxis(ErrorClass::ZeroProved, 0)
                < scale.toAxis(ErrorClass::ZeroObserved, 0));
        QVERIFY(scale.toAxis(ErrorClass::ZeroObserved, 0) < scale.separator());
        double before = scale.separator();
        for (const double error : {0.01, 0.02, 1.0, 35.0, 700.0}) {
            const double axis = scale.toAxis(ErrorClass::Positive, error);
            QVERIFY(axis > before);
            QVERIFY(scale.classAt(axis) == ErrorClass::Positive);
            before = axis;
        }
        for (const ErrorClass zero : {ErrorClass::ZeroObserved, ErrorClass::ZeroProved})
            QVERIFY(scale.classAt(scale.toAxis(zero, 0)) == zero);
        QVERIFY(before < scale.top());
    }

    void theErrorScaleHasBothZerosAndNeverTooManyDecades_data()
    {
        QTest::addColumn<double>("largest");
        QTest::newRow("nothing but zeros") << 0.0;
        QTest::newRow("one error") << 1.0;
        QTest::newRow("five decades") << 1e5;
        QTest::newRow("no number") << qInf();
    }
    void theErrorScaleHasBothZerosAndNeverTooManyDecades()
    {
        QFETCH(double, largest);
        const ErrorScale scale(largest > 0 ? chartOf({positive(1), positive(largest)})
                                           : ParetoChart());
        const auto ticks = scale.ticks(3);

        QVERIFY(ticks.size() >= 3 && ticks.size() <= 6);
        QCOMPARE(ticks[0].label, u"0, proved"_s);
        QCOMPARE(ticks[1].label, u"0, observed"_s);
        for (const ErrorScale::Tick &tick : ticks)
            QVERIFY(tick.axis >= ErrorScale::bottom && tick.axis <= scale.top());
        QVERIFY(scale.toAxis(ErrorClass::Positive, qInf()) <= scale.top());
    }

    void dotsStandByTheirCostAndTheirError()
    {
        ParetoPlot plot;
        plot.resize(700, 400);
        plot.setVisible(true);
        plot.show(madeResults(five()), u"f"_s, wrongPixels());

        const auto at = [&plot](const char *id) { return *plot.positionOf(QLatin1String(id)); };
        QVERIFY(at("cheap").x() < at("lucky").x());
        QVERIFY(at("lucky").x() < at("column-scan:float32").x());
        QVERIFY(at("proved").x() < at("dear").x());
        // A logarithmic axis: 0.9 to 1.8 is the same distance as 2 to 4.
        const double perOctave = (at("dear").x() - at("cheap").x()) / std::log2(8.8 / 0.9);
        QVERIFY(std::abs(at("column-scan:float32").x() - at("cheap").x()
                         - perOctave * std::log2(2 / 0.9))
                < 1.5);
        QVERIFY(at("cheap").y() < at("dear").y()); // lower is more exact
        QVERIFY(at("dear").y() < at("lucky").y());
        QVERIFY(at("lucky").y() < at("proved").y());
        QVERIFY(!plot.positionOf(u"nobody"_s));
    }

    void aClickOnADotNamesItsContender()
    {
        ParetoPlot plot;
        plot.resize(700, 400);
        plot.setVisible(true);
        plot.show(madeResults(five()), u"f"_s, wrongPixels());
        QSignalSpy spy(&plot, &ParetoPlot::contenderClicked);
        auto *inner = plot.findChild<QWidget *>();

        const QPointF dot = *plot.positionOf(u"dear"_s);
        QTest::mouseClick(inner, Qt::LeftButton, {}, inner->mapFrom(&plot, dot.toPoint()));
        QCOMPARE(spy.takeFirst().constFirst().toString(), u"dear"_s);
        QTest::mouseClick(inner, Qt::LeftButton, {}, QPoint(2, 2));
        QVERIFY(spy.isEmpty());
    }

    void theTextOfADotSaysWhatIsKnown()
    {
        ParetoPlot plot;
        plot.resize(700, 400);
        plot.setVisible(true);
        plot.show(madeResults(five()), u"f"_s, wrongPixels());

        const auto textOf
            = [&plot](const char *id) { return plot.textAt(*plot.positionOf(QLatin1String(id))); };
        QVERIFY2(textOf("dear").contains(u"20 of 1000000 pixels wrong"_s),
                 qPrintable(textOf("dear")));
        QVERIFY(textOf("dear").contains(u"8.80 (7.92 … 9.68) ns a pixel, ×4.40"_s));
        QVERIFY(textOf("proved").contains(u"by proof: all triangles"_s));
        QVERIFY(textOf("lucky").contains(u"observed over 1000000 pixels"_s));
        QVERIFY(plot.textAt({1, 1}).isEmpty());
    }

    void oneContenderIsDrawnWhereItIsJudgedAndNothingElsewhere_data()
    {
        QTest::addColumn<QString>("family");
        QTest::addColumn<bool>("isJudged");
        QTest::newRow("judged and timed") << "f" << true;
        QTest::newRow("judged alone") << "g" << true;
        QTest::newRow("no such family") << "no such" << false;
    }
    void oneContenderIsDrawnWhereItIsJudgedAndNothingElsewhere()
    {
        QFETCH(QString, family);
        QFETCH(bool, isJudged);
        const QString only = u"only"_s;
        const SharedResults none = madeResults({});
        for (const std::int64_t wrong : {0, 3}) {
            const SharedResults one = madeResults({{"only", 2.0, wrong}});
            ParetoPlot pareto;
            pareto.show(one, family, wrongPixels());
            QCOMPARE(pareto.positionOf(only).has_value(), isJudged);
            QCOMPARE(shown<ParetoPlot>(one, family, wrongPixels())
                         != shown<ParetoPlot>(none, family, wrongPixels()),
                     isJudged);
            QCOMPARE(shown<MissPlot>(one, family, only) != shown<MissPlot>(none, family, only),
                     isJudged);
        }
    }

    void labelsCoverNeitherEachOtherNorDots()
    {
        std::vector<LabelledDot> dots;
        for (int i = 0; i < 30; ++i)
            dots.push_back({{40.0 + i * 37 % 290, 30.0 + i * 53 % 140}, {80, 14}});
        const QRectF area(0, 0, 400, 200);

        const auto places = placeLabels(dots, {area, {coveredBy({200, 100})}, {}});

        std::vector<QRectF> there;
        for (const auto &place : places) {
            if (!place)
                continue;
            QVERIFY(area.contains(*place));
            for (const QRectF &other : there)
                QVERIFY(!other.intersects(*place));
            for (const LabelledDot &dot : dots)
                QVERIFY(!place->contains(dot.centre));
            QVERIFY(!place->contains({200, 100}));
            there.push_back(*place);
        }
        QVERIFY(places.front());
        QVERIFY(there.size() >= 8);
    }

    void aLabelKeepsOffALineWhereItCan()
    {
        const std::vector<LabelledDot> dots = {{{50, 100}, {80, 14}}};
        const QRectF area(0, 0, 200, 200);
        const QRectF right(60, 99, 140, 2); // a line through the first choice

        const auto free = placeLabels(dots, {area, {}, {}});
        const auto lined = placeLabels(dots, {area, {}, {right}});
        const auto beside = placeLabels(dots, {area, {}, {right}, LabelArea::Sides::Beside});

        QVERIFY(free[0] && free[0]->intersects(right));
        QVERIFY(lined[0] && !lined[0]->intersects(right));
        QVERIFY(beside[0] && beside[0]->intersects(right)); // there is no other position
    }

    void missesStandOnTheirSides()
    {
        QVERIFY(MissPlot::placeOf(MissPlot::Side::Missing, 3)
                == -MissPlot::placeOf(MissPlot::Side::Extra, 3));
        QVERIFY(MissPlot::placeOf(MissPlot::Side::Extra, 0)
                < MissPlot::placeOf(MissPlot::Side::Extra, 1));
        const auto results = madeResults({{"one", 1, 0}});
        AccuracyFigures &figures = *results->rows.front().accuracy;
        figures.misses.extra[4] = 17;
        figures.tiesMissing = 5;
        MissPlot plot;
        plot.resize(700, 300);
        plot.setVisible(true);
        plot.show(results, u"f"_s, u"one"_s);
        QStringList found;
        for (int x = 0; x < plot.width(); ++x) {
            const QString text = plot.textAt(QPointF(x, 100));
            if (!text.isEmpty() && !found.contains(text))
                found.append(text);
        }
        QCOMPARE(found,
                 (QStringList{"ties, missing: exactly on the boundary: 5",
                              "extra, 10⁻⁴ to 10⁻³ px outside: 17"}));
    }

    void costPartsAreTheFitsOverThePixels()
    {
        const auto results = madeResults({{"scan", 2, 0}, {"row-walk:exact", 2, 0}});
        const Study &study = *results;

        // 20·10/1000, 3·200/1000 (300 rows for a row walk), 0.5
        QVERIFY(*costPartsOf(study, study.rows[0]) == (CostParts{0.2, 0.6, 0.5}));
        QVERIFY(*costPartsOf(study, study.rows[1]) == (CostParts{0.2, 0.9, 0.5}));
    }

    void theTableSortsByFiguresAndKeepsItsRow()
    {
        LabTable table;
        const QAbstractItemModelTester tester(table.model());
        table.show(madeResults(five()), u"f"_s);
        QCOMPARE(table.model()->rowCount(), 5);
        table.select(u"lucky"_s);
        const int costs = 2;
        QCOMPARE(table.model()->headerData(costs, Qt::Horizontal).toString(), u"ns a pixel"_s);

        QTest::mouseClick(table.horizontalHeader()->viewport(), Qt::LeftButton, {},
                          {table.horizontalHeader()->sectionViewportPosition(costs) + 12, 8});
        table.sortByColumn(costs, Qt::AscendingOrder);

        QStringList order;
        for (int row = 0; row < 5; ++row)
            order.append(table.model()->index(row, 0).data().toString());
        QCOMPARE(order, (QStringList{"cheap", "lucky", "column-scan:float32", "proved", "dear"}));
        QCOMPARE(table.selected(), u"lucky"_s);
    }
};

PIXELPLUMB_TEST(TestLabPlots)

} // namespace tst_labplots

#include "tst_labplots.moc"
