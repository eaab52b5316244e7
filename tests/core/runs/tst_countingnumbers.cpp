// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/scenesformethods.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_countingnumbers {

using namespace pixelplumb;

namespace {

/// How a number changes from one span of a part to the next.
struct Course {
    bool rests = true;
    bool follows = true; ///< the span's position, forward or backward

    void go(const Quantity &from, const Quantity &to, std::int64_t step)
    {
        rests = rests && from == to;
        const double change = to.toDouble() - from.toDouble();
        follows = follows && std::abs(change) == std::abs(double(step));
    }
};

} // namespace

/// The numbers of the group Position stay visible while a student predicts a row: they say which
/// row it is, and nothing that its formulas compute.
class TestCountingNumbers : public QObject {
    Q_OBJECT

private slots:
    void aNumberOfThePositionCountsRows_data()
    {
        QTest::addColumn<QString>("method");
        for (const Method &method : methods())
            QTest::newRow(qPrintable(method.id)) << method.id;
    }
    void aNumberOfThePositionCountsRows()
    {
        QFETCH(QString, method);
        std::vector<Course> courses;
        std::vector<NumberDescription> numbers;
        for (const auto &[name, scene] : scenesForEveryMethod()) {
            const auto traced
                = tracedBy(*methodNamed(method), methodNamed(method)->arithmetics.front(), scene);
            const ScanTrace &trace = *traced->trace;
            numbers = trace.numbers().span;
            courses.resize(numbers.size());
            for (std::size_t span = 1; span < trace.spanCount(); ++span) {
                if (trace.beginsPart(span))
                    continue;
                const std::vector<Quantity> before = trace.span(span - 1).cells;
                const std::vector<Quantity> cells = trace.span(span).cells;
                const std::int64_t step
                    = trace.placeOf(span).coordinate - trace.placeOf(span - 1).coordinate;
                for (std::size_t i = 0; i < cells.size(); ++i) {
                    if (!before[i].isNone() && !cells[i].isNone())
                        courses[i].go(before[i], cells[i], step);
                }
            }
        }
        bool isCounted = false;
        for (std::size_t i = 0; i < courses.size(); ++i) {
            if (numbers[i].group != NumberGroup::Position)
                continue;
            QVERIFY2(courses[i].rests || courses[i].follows, qPrintable(numbers[i].id));
            isCounted = isCounted || courses[i].follows;
        }
        QVERIFY(isCounted); // otherwise nobody knows which row is asked for
    }
};

PIXELPLUMB_TEST(TestCountingNumbers)

} // namespace tst_countingnumbers

#include "tst_countingnumbers.moc"
