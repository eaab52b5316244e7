// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/scenes/trianglepictures.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace tst_misprints {

using namespace pixelplumb;

namespace {

QString textOfTest(const QString &file)
{
    QFile source(resource(u"/../tests/"_s) + file);
    return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()) : QString();
}

} // namespace

/// The slides' misprints (resources/misprints.md) in walks along columns, rows and lines, each with
/// the right form; every misprint on the list has a test, here or elsewhere.
class TestMisprints : public QObject {
    Q_OBJECT

private slots:
    void everyMisprintOfTheListHasItsTest()
    {
        QFile file(resource(u"/misprints.md"_s));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString list = QString::fromUtf8(file.readAll());
        // One or more test functions here, or in another named file.
        const QRegularExpression pattern(
            u"\\*\\*Test:\\*\\* ((?:`\\w+`(?: and )?)+)(?:\\s+in\\s+`tests/([\\w/]+\\.cpp)`)?"_s);
        int named = 0;
        for (auto match = pattern.globalMatch(list); match.hasNext(); ++named) {
            const QRegularExpressionMatch test = match.next();
            const QString elsewhere = test.captured(2);
            const QString source = elsewhere.isEmpty() ? QString() : textOfTest(elsewhere);
            for (const QString &slot : test.captured(1).split(u" and "_s)) {
                const QString call = slot.sliced(1).chopped(1) + u"()"_s;
                const bool exists = elsewhere.isEmpty()
                    ? metaObject()->indexOfSlot(call.toLatin1().constData()) >= 0
                    : source.contains(u"void "_s + call);
                QVERIFY2(exists, qPrintable(call));
            }
        }
        QCOMPARE(named, int(list.count(u"\n## "_s)));
    }

    void theLineOfTheFirstSlideIsBelowOnlyWhereItRunsToTheRight()
    {
        // F(x, y) = (x − x₀)·dy − (y − y₀)·dx at a point below the line.
        const auto sideOf = [](double x0, double y0, double x1, double y1, double x, double y) {
            return (x - x0) * (y1 - y0) - (y - y0) * (x1 - x0);
        };
        QVERIFY(sideOf(0, 0, 10, 2, 5, -3) > 0);
        QVERIFY(sideOf(10, 2, 0, 0, 5, -3) < 0);
    }

    void theTrapezoidsMeetAtTheMiddleVertexAndEndAtTheOuterOnes()
    {
        // P₂ lowest, P₃ in the middle, P₁ highest: rows y₂ … y₃ and y₃ … y₁.
        Scene scene;
        scene.method = "row-walk";
        scene.triangles
            = {triangleOf({{latticePixel(12, 30), latticePixel(5, 2), latticePixel(20, 17)}})};
        const auto traced = traceScene(scene);
        std::array<std::int64_t, 2> lowest = {99, 99}, highest = {-99, -99};
        for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
            const SpanPlace &place = traced->trace->placeOf(span);
            const auto part = std::size_t(place.part);
            lowest[part] = std::min(lowest[part], place.coordinate);
            highest[part] = std::max(highest[part], place.coordinate);
        }
        QCOMPARE(highest, (std::array<std::int64_t, 2>{30, 17}));
        QCOMPARE(lowest, (std::array<std::int64_t, 2>{18, 2}));
    }

    void theLeftmostColumnOfHalfCentresIsAtTheCeilingOfItsHalf()
    {
        // Triangle Rasterization slides, "Triangle rasterization implementation guidelines": left =
        // (int)(x_min + .5). A pixel whose centre lies exactly on x_min, here 2.5, belongs to the
        // closed triangle but is left out.
        const double smallest = 2.5;
        QCOMPARE(int(smallest + .5), 3);
        QCOMPARE(int(std::ceil(smallest - .5)), 2);
        // Left of the origin (int) rounds towards 0, so the last column is wrong.
        const double largest = -1.75;
        QCOMPARE(int(largest - .5), -2);
        QCOMPARE(int(std::floor(largest - .5)), -3);
    }

    void bresenhamsTableNeedsTheStrictComparisonAndAllTenSteps()
    {
        // (20, 41)–(30, 44): the table goes up at p₄ = 0.
        const std::array<int, 10> decisions = {-4, 2, -12, -6, 0, -14, -8, -2, 4, -10};
        const std::array<int, 10> rows = {41, 42, 42, 42, 43, 43, 43, 43, 44, 44};
        const int dx = 10, dy = 3;
        int p = 2 * dy - dx, y = 41;
        for (std::size_t k = 0; k < 10; ++k) {
            QCOMPARE(p, decisions[k]);
            const bool staysLow = p < 0; // printed: p_k <= 0
            y += staysLow ? 0 : 1;
            QCOMPARE(y, rows[k]);
            p += staysLow ? 2 * dy : 2 * dy - 2 * dx;
        }
        // "Perform step 4 (Δx − 1) times" would end at (29, 44).
        QCOMPARE(20 + int(rows.size()), 30);
    }
};

PIXELPLUMB_TEST(TestMisprints)

} // namespace tst_misprints

#include "tst_misprints.moc"
