// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/explain/pixelhistory.h"
#include "core/runs/explain/stepmoment.h"
#include "core/runs/tracedscene.h"
#include "tests/support/framespec.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_segmentwords {

using namespace pixelplumb;

namespace {

/// A traced triangle with these corners.
std::shared_ptr<const TracedScene> tracedOf(const QString &id,
                                            const std::array<LatticePoint, 3> &corners)
{
    Scene scene;
    scene.frame = frameOf(14, 10);
    scene.method = id.toStdString();
    scene.triangles = {Triangle{
        {{{corners[0], {{255, 0, 0}}}, {corners[1], {{0, 255, 0}}}, {corners[2], {{0, 0, 255}}}}}}};
    return traceScene(scene);
}

/// A triangle without area from (1, 1) to (9, 5), with a vertex between the ends.
std::shared_ptr<const TracedScene> tracedSegment(const QString &id)
{
    return tracedOf(id, {latticePixel(1, 1), latticePixel(9, 5), latticePixel(5, 3)});
}

/// How many steps of a run do a line of these moments.
std::ptrdiff_t momentsOf(const TracedScene &traced, const std::vector<Moment> &moments)
{
    std::ptrdiff_t count = 0;
    for (std::size_t step = 0; step < traced.trace->stepCount(); ++step)
        count += std::ranges::count(moments, momentOf(*traced.trace, step));
    return count;
}

QString reasonAt(const TracedScene &traced, std::int64_t x, std::int64_t y)
{
    return pixelHistory(traced, x, y).at(0).reason;
}

void addEdgeTests()
{
    QTest::addColumn<QString>("id");
    for (const Method &method : methods()) {
        if (std::ranges::any_of(method.pseudocode, [](const PseudocodeLine &line) {
                return line.of == LineOf::Segment && line.text.contains(u"the segment passes"_s);
            }))
            QTest::newRow(qPrintable(method.id)) << method.id;
    }
}

} // namespace

/// A triangle without area is drawn as its segment: no edge decides which samples it owns.
class TestSegmentWords : public QObject {
    Q_OBJECT

private slots:
    void theNumberThatDecidesAboutASegmentIsTold_data() { addEdgeTests(); }
    void theNumberThatDecidesAboutASegmentIsTold()
    {
        QFETCH(QString, id);
        const auto traced = tracedSegment(id);

        QVERIFY2(
            reasonAt(*traced, 3, 2)
                .contains(
                    u"its segment from (1, 1) to (9, 5) passes through the sample: (9 − 1)·(2 − 1) "
                    "− (5 − 1)·(3 − 1) = 0."_s),
            qPrintable(reasonAt(*traced, 3, 2)));
        QVERIFY2(reasonAt(*traced, 4, 2)
                     .contains(
                         u"passes the sample by: (9 − 1)·(2 − 1) − (5 − 1)·(4 − 1) = −4, not 0."_s),
                 qPrintable(reasonAt(*traced, 4, 2)));
        // On the same line, two columns further.
        QVERIFY2(
            reasonAt(*traced, 11, 6)
                .contains(
                    u"lies in line with the sample, (9 − 1)·(6 − 1) − (5 − 1)·(11 − 1) = 0, but "
                    "does not reach it."_s),
            qPrintable(reasonAt(*traced, 11, 6)));
        const auto point
            = tracedOf(id, {latticePixel(4, 4), latticePixel(4, 4), latticePixel(4, 4)});
        QVERIFY(reasonAt(*point, 4, 4)
                    .contains(u"its vertices are all at (4, 4), which is the sample."_s));
        QVERIFY(reasonAt(*point, 5, 4).contains(u"all at (4, 4), which is not the sample."_s));
    }

    void everyStepOfASegmentHasItsDecidingNumber_data() { addEdgeTests(); }
    void everyStepOfASegmentHasItsDecidingNumber()
    {
        QFETCH(QString, id);
        const auto traced = tracedSegment(id);
        const ScanTrace &trace = *traced->trace;
        std::size_t drawn = 0;
        for (std::size_t sample = 0; sample < trace.sampleCount(); ++sample) {
            const PixelChange &change = trace.changes()[sample];
            const QString sentence = explainStep(*traced, trace.indexOfSample(sample)).sentence;
            const std::int64_t number = 8 * (change.y - 1) - 4 * (change.x - 1);
            const bool isOn = number == 0 && change.x >= 1 && change.x <= 9;
            QCOMPARE(change.isWritten(), isOn);
            QVERIFY2(sentence.contains(withMinus(u" = %1"_s.arg(number))), qPrintable(sentence));
            drawn += isOn ? 1 : 0;
        }
        QCOMPARE(drawn, std::size_t(5));
    }

    /// The weights of a segment are 0/0: its listing contains none of their lines.
    void theListingOfASegmentDividesNothing_data() { addEdgeTests(); }
    void theListingOfASegmentDividesNothing()
    {
        QFETCH(QString, id);
        const auto hasLine = [](const Pseudocode &code, const QString &part) {
            return std::ranges::any_of(
                code, [&](const PseudocodeLine &line) { return line.text.contains(part); });
        };
        const auto traced = tracedSegment(id);
        const Pseudocode ofSegment = pseudocodeOf(*traced, 0);
        const auto ofOther
            = tracedOf(id, {latticePixel(1, 1), latticePixel(9, 5), latticePixel(2, 8)});
        const Pseudocode ofArea = pseudocodeOf(*ofOther, 0);
        for (const char *part : {"/f_", "/F", "/D"})
            QVERIFY(!hasLine(ofSegment, QString::fromLatin1(part)));
        const QString segment = u"the segment passes through (x, y)"_s;
        QVERIFY(hasLine(ofSegment, segment));
        QVERIFY(!hasLine(ofArea, segment));
        QVERIFY(hasLine(ofArea, u"if "_s));
        for (const PseudocodeLine &line : ofSegment) {
            const bool isDone = line.of != LineOf::Segment || momentsOf(*traced, line.moments) > 0;
            QVERIFY2(isDone, qPrintable(line.text));
        }
    }
};

PIXELPLUMB_TEST(TestSegmentWords)

} // namespace tst_segmentwords

#include "tst_segmentwords.moc"
