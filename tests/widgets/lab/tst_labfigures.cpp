// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/madestudy.h"
#include "tests/support/testprogram.h"
#include "widgets/lab/labfiltermenu.h"
#include "widgets/lab/labmarks.h"
#include "widgets/lab/labtext.h"
#include "widgets/lab/missplot.h"
#include "widgets/lab/paretoplot.h"

#include <QTest>
#include <QtWidgets>

namespace tst_labfigures {

using namespace pixelplumb;

namespace {

const ErrorAxis &wrongPixels() { return *errorAxisNamed(u"wrong-pixels"_s); }

/// Two plain kernels and their SIMD twins; measured on a busy machine by a command without spaces
/// at which it could be broken.
std::shared_ptr<Study> twins()
{
    auto results = madeResults({{"column-scan:float32", 2.0, 5221},
                                {"column-scan:exact", 4.0, 0, true},
                                {"column-scan:float32:fast", 0.4, 5221},
                                {"column-scan:exact:fast", 0.5, 0, true}});
    results->command += u" --contender "_s + QString(400, u'x');
    results->conditions.load = 7;
    results->conditions.flags = u"-O0"_s;
    results->conditions.buildType = u"Release"_s;
    return results;
}

template <class Plot>
std::unique_ptr<Plot> shownPlot(const QSize &size = {800, 420})
{
    auto plot = std::make_unique<Plot>();
    plot->resize(size);
    plot->setVisible(true);
    return plot;
}

std::unique_ptr<ParetoPlot> paretoOfTwins(const QSize &size = {800, 420})
{
    auto plot = shownPlot<ParetoPlot>(size);
    plot->show(twins(), u"f"_s, wrongPixels());
    return plot;
}

/// All texts of a drawing, concatenated.
QString textsOf(LabPlot &plot) { return QString::fromUtf8(plot.svg({})); }

enum class Chart { Pareto, Misses };

std::unique_ptr<LabPlot> chartOf(Chart chart)
{
    const auto results = twins();
    const QString family = u"f"_s;
    switch (chart) {
    case Chart::Pareto:
        return paretoOfTwins();
    case Chart::Misses: {
        auto plot = shownPlot<MissPlot>();
        plot->show(results, family, u"column-scan:float32"_s);
        return plot;
    }
    }
    return nullptr;
}

} // namespace

/// What the lab's charts distinguish, and what they print on paper.
class TestLabFigures : public QObject {
    Q_OBJECT

private slots:
    void theLegendTellsPlainFromSimd()
    {
        const QString texts = textsOf(*paretoOfTwins());

        for (const char *key : {"best plain kernels", "best SIMD kernels", "SIMD kernel"})
            QVERIFY2(texts.contains(QLatin1String(key)), key);
        auto plain = shownPlot<ParetoPlot>();
        plain->show(madeResults({{"column-scan:float32", 2.0, 5221}}), u"f"_s, wrongPixels());
        QVERIFY(!textsOf(*plain).contains(u"SIMD"_s));
    }

    void eachMarkMeansOneThing()
    {
        const QPalette palette = qApp->palette();
        for (const Arithmetic arithmetic : allArithmetics) {
            const QCPScatterStyle plain = kernelDot(arithmetic, LabKernel::Plain, palette);
            const QCPScatterStyle loop = straightLoopDot(arithmetic, palette);
            QVERIFY(plain.brush() != loop.brush()); // a straight loop is hollow
            QCOMPARE(plain.shape(), loop.shape());
            QCOMPARE(kernelDot(arithmetic, LabKernel::Fast, palette).shape(),
                     QCPScatterStyle::ssCustom);
        }
    }

    void aZeroSaysWhatIsProvedAndWhatIsTested()
    {
        const auto plot = paretoOfTwins();
        const auto textOf = [&plot](const char *id) {
            return plot->textAt(*plot->positionOf(QLatin1String(id)));
        };

        QVERIFY(textOf("column-scan:exact").contains(u"by proof: all triangles"_s));
        QVERIFY(textOf("column-scan:exact:fast").contains(u"this is not proved"_s));
        const double plainRow = plot->positionOf(u"column-scan:exact"_s)->y();
        const double simdRow = plot->positionOf(u"column-scan:exact:fast"_s)->y();
        QVERIFY(plainRow > simdRow);
        QCOMPARE(plot->textAt({20, plainRow}), errorClassText(ErrorClass::ZeroProved));
        QCOMPARE(plot->textAt({20, simdRow}), errorClassText(ErrorClass::ZeroTested));
        QVERIFY(textsOf(*plot).contains(u"0, tested"_s));
    }

    void theErrorScaleHasARowForWhatIsTested()
    {
        const ErrorScale scale(paretoOf(*twins(), u"f"_s, wrongPixels()));

        QCOMPARE(scale.ticks(3)[2].label, u"0, tested"_s);
        double before = ErrorScale::bottom;
        for (const ErrorClass zero :
             {ErrorClass::ZeroProved, ErrorClass::ZeroTested, ErrorClass::ZeroObserved}) {
            const double axis = scale.toAxis(zero, 0);
            QVERIFY(axis > before);
            QVERIFY(scale.classAt(axis) == zero);
            before = axis;
        }
        QVERIFY(scale.classAt(scale.separator() + 0.1) == ErrorClass::Positive);
    }

    void whatIsJudgedWaitsForItsTimeAtTheLeft()
    {
        const auto results = twins();
        results->isComplete = false;
        results->rows[0].cost.reset();
        results->rows[1].cost.reset();
        const auto plot = shownPlot<ParetoPlot>();
        plot->show(results, u"f"_s, wrongPixels());
        const auto at = [&plot](const char *id) { return *plot->positionOf(QLatin1String(id)); };

        QVERIFY(at("column-scan:float32").x() < at("column-scan:float32:fast").x());
        QCOMPARE(at("column-scan:float32").y(), at("column-scan:float32:fast").y());
        QVERIFY(plot->textAt(at("column-scan:float32")).contains(u"5221 of 1000000"_s));
        QVERIFY(plot->textAt(at("column-scan:exact"))
                    .contains(u"its time is measured once all of this family are judged"_s));
        QVERIFY(textsOf(*plot).contains(u"not timed (yet)"_s));
    }

    void waitingDotsOfOneErrorStandSideBySide()
    {
        const auto plot = shownPlot<ParetoPlot>();
        plot->show(madeResults({{"a", 1, 7}, {"b", 1, 7}, {"c", 1, 7}}), u"g"_s, wrongPixels());
        const auto at = [&plot](const char *id) { return *plot->positionOf(QLatin1String(id)); };

        QVERIFY(at("a").x() + 10 < at("b").x());
        QVERIFY(at("b").x() + 10 < at("c").x());
        QCOMPARE(at("a").y(), at("c").y());
    }

    void aLowChartKeepsItsHeightForTheDots()
    {
        const auto plot = paretoOfTwins({560, 120});
        const double decades = plot->positionOf(u"column-scan:exact"_s)->y()
            - plot->positionOf(u"column-scan:float32"_s)->y();

        QVERIFY2(decades > 55, qPrintable(QString::number(decades)));
    }

    void whoIsLeftOutIsInNoChart_data()
    {
        QTest::addColumn<QString>("out");
        QTest::addColumn<QStringList>("left");
        QTest::newRow("nobody") << QString()
                                << QStringList{"column-scan:float32", "column-scan:exact",
                                               "column-scan:float32:fast",
                                               "column-scan:exact:fast"};
        QTest::newRow("an arithmetic")
            << "float32" << QStringList{"column-scan:exact", "column-scan:exact:fast"};
        QTest::newRow("a kernel") << "SIMD"
                                  << QStringList{"column-scan:float32", "column-scan:exact"};
        QTest::newRow("a method") << "column-scan" << QStringList{};
    }
    void whoIsLeftOutIsInNoChart()
    {
        QFETCH(QString, out);
        QFETCH(QStringList, left);
        const auto results = filtered(twins(), LabFilter{{out}});

        QStringList contenders;
        for (const StudyContender &contender : results->contenders)
            contenders.append(contender.id);
        QCOMPARE(contenders, left);
        QCOMPARE(results->rows.size(), std::size_t(2 * left.size()));
    }

    void longWordsAreBrokenAndNoneIsLost()
    {
        const QFont font = qApp->font();
        const QString text = u"a few words and "_s + QString(300, u'w');

        const QStringList lines = wrappedLines(text, font, 200);

        for (const QString &line : lines)
            QVERIFY(QFontMetricsF(font).horizontalAdvance(line) <= 200);
        QCOMPARE(lines.join(QString()).remove(u' '), QString(text).remove(u' '));
        QVERIFY(lines.first().endsWith(u"and"_s));
    }

    void everyChartCarriesItsConditionsOnPaper_data()
    {
        QTest::addColumn<Chart>("chart");
        QTest::addColumn<QString>("title");
        QTest::newRow("pareto") << Chart::Pareto << u"Cost against error: Family f"_s;
        QTest::newRow("misses") << Chart::Misses
                                << u"Distances of missed samples from the boundary: Family f; "
                                   "column-scan:float32"_s;
    }

    void everyChartCarriesItsConditionsOnPaper()
    {
        QFETCH(Chart, chart);
        QFETCH(QString, title);
        const auto plot = chartOf(chart);
        const Study study = *twins();

        const QString svg = QString::fromUtf8(plot->svg(figureOrigin(study)));
        const QImage png = QImage::fromData(plot->png(figureOrigin(study)));

        // As drawn: after the description, and on separate lines.
        const QString drawn = svg.mid(svg.indexOf(u"</desc>"_s));
        for (const QString &part :
             {title, u"a processor, 0 processors"_s,
              u"pixelplumb-cli lab --quick --seed 1 --contender"_s,
              u"⚠ Other programs were running when this began (load average 7.00)."_s,
              u"⚠ This build is hardly optimised (-O0): its times say little."_s})
            QVERIFY2(drawn.contains(part.toHtmlEscaped()), qPrintable(part));
        QVERIFY(warningsOf(study).size() >= 2);
        QVERIFY(png.width() == 1920 && png.height() >= 1280);
    }
};

PIXELPLUMB_TEST(TestLabFigures)

} // namespace tst_labfigures

#include "tst_labfigures.moc"
