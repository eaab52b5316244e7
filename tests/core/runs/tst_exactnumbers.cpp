// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>

namespace tst_exactnumbers {

using namespace pixelplumb;

namespace {

std::shared_ptr<const TracedScene> traced(const char *method, std::int32_t height)
{
    Scene scene;
    scene.frame = frameOf(8, height + 1);
    scene.method = method;
    scene.settings.arithmetic = Arithmetic::Float32;
    scene.triangles = {triangleAt(0, 0, 5, height / 3, 2, height)};
    return traceScene(scene);
}

} // namespace

/// The exact numbers shown next to the rounded ones.
class TestExactNumbers : public QObject {
    Q_OBJECT

private slots:
    void standBesideTheSampleOfTheSamePixel_data()
    {
        QTest::addColumn<QString>("method");
        for (const Method &method : methods()) {
            if (method.draws(PrimitiveKind::Triangle) && method.supports(Arithmetic::Float32)
                && method.supports(Arithmetic::Exact))
                QTest::newRow(qPrintable(method.id)) << method.id;
        }
    }
    void standBesideTheSampleOfTheSamePixel()
    {
        QFETCH(QString, method);
        const auto run = traced(method.toLatin1().constData(), 30);
        for (std::size_t span = 0; span < run->trace->spanCount(); ++span) {
            const std::vector<SampleRecord> samples = run->trace->samples(span);
            const std::vector<ExactSample> exact = exactSamplesOf(*run, span, samples);
            QCOMPARE(exact.size(), samples.size());
            const SpanPlace &place = run->trace->placeOf(span);
            const auto twin = run->exactTrace->spanOn(0, place.axis, place.coordinate);
            const std::vector<SampleRecord> others
                = twin ? run->exactTrace->samples(*twin) : std::vector<SampleRecord>();
            for (std::size_t i = 0; i < samples.size(); ++i) {
                const auto other = std::ranges::find_if(others, [&](const SampleRecord &each) {
                    return each.x == samples[i].x && each.y == samples[i].y;
                });
                for (std::size_t cell = 0; cell < exact[i].cells.size(); ++cell) {
                    const bool isCompared
                        = run->method->numbers.sample[cell].comparison == Comparison::WithExact;
                    QCOMPARE(exact[i].cells[cell],
                             isCompared && other != others.end() ? other->cells[cell] : Quantity());
                }
            }
        }
    }

    /// The exact run may need other effects, whose numbers are in other columns, so numbers are
    /// found by name. q = ¾ + ¼·½ at (1, 0), by hand.
    void areFoundByTheirNamesWhereTheExactRunHasOthers()
    {
        Scene scene;
        scene.frame = frameOf(6, 6);
        scene.method = "column-scan";
        scene.settings.arithmetic = Arithmetic::Float32;
        // The first triangle has no area, no sample and an alpha; the second has perspective.
        scene.triangles = {Triangle{{{{{halfPixel, 0}, {{255, 0, 0}}},
                                      {{3 * halfPixel, unitsPerPixel}, {{0, 255, 0}}},
                                      {{5 * halfPixel, 2 * unitsPerPixel}, {{0, 0, 255}}}}}},
                           triangleAt(0, 0, 4, 0, 0, 4)};
        scene.triangles[1].vertices[1].colour = {{0, 255, 0}};
        scene.attributes.resize(2);
        scene.attributes[1].triangle = 1;
        for (std::size_t i = 0; i < 3; ++i) {
            scene.attributes[0].vertices[i].alpha = 128;
            scene.attributes[1].vertices[i].w = attributeOne << i;
        }
        const auto run = traceScene(scene);
        const auto &numbers = run->trace->numbers().sample;
        const auto column = std::size_t(std::ranges::find(numbers, u"q"_s, &NumberDescription::id)
                                        - numbers.begin());
        bool isFound = false;
        for (std::size_t span = 0; span < run->trace->spanCount(); ++span) {
            const std::vector<SampleRecord> samples = run->trace->samples(span);
            const std::vector<ExactSample> exact = exactSamplesOf(*run, span, samples);
            for (std::size_t i = 0; i < samples.size(); ++i) {
                if (run->trace->primitiveOf(span) != 1 || samples[i].x != 1 || samples[i].y != 0)
                    continue;
                isFound = true;
                QCOMPARE(exact[i].cells.at(column), Quantity::rational(7, 8));
            }
        }
        QVERIFY(isFound);
    }

    void ofALongColumnAreLookedUpInOneWalk()
    {
        const auto run = traced("column-scan", 20000);
        QElapsedTimer timer;
        timer.start();
        for (std::size_t span = 0; span < run->trace->spanCount(); ++span) {
            const std::vector<SampleRecord> samples = run->trace->samples(span);
            QCOMPARE(exactSamplesOf(*run, span, samples).size(), samples.size());
        }
        // Walking the column again for each of its samples would take minutes.
        QVERIFY2(timer.elapsed() < 30000, qPrintable(QString::number(timer.elapsed())));
    }
};

PIXELPLUMB_TEST(TestExactNumbers)

} // namespace tst_exactnumbers

#include "tst_exactnumbers.moc"
