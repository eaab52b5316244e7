// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/formulaexplanation.h"
#include "core/runs/sceneplan.h"
#include "core/runs/tracedscene.h"
#include "core/scan/choicenames.h"
#include "core/scene/scenefile.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <random>

namespace tst_numberrows {

using namespace pixelplumb;

namespace {

/// The examples that call for effects.
std::vector<Scene> scenesWithEffects()
{
    std::vector<Scene> all;
    const QDir folder(resource(QStringLiteral("/scenes")));
    for (const QString &name : folder.entryList({QStringLiteral("*.json")})) {
        Scene scene = readSceneFile(folder.filePath(name))->scene;
        if (!planOf(scene).isPlain())
            all.push_back(std::move(scene));
    }
    return all;
}

/// The program's examples that call for nothing beyond colour, and a scene of several kinds with
/// triangles that have no area.
std::vector<Scene> scenes()
{
    std::vector<Scene> all;
    const QDir folder(resource(QStringLiteral("/scenes")));
    for (const QString &name : folder.entryList({QStringLiteral("*.json")}))
        if (Scene scene = readSceneFile(folder.filePath(name))->scene; planOf(scene).isPlain())
            all.push_back(std::move(scene));
    const auto triangle = [](std::array<LatticePoint, 3> points) {
        return Triangle{
            {{{points[0], {{255, 0, 0}}}, {points[1], {{0, 255, 0}}}, {points[2], {{0, 0, 255}}}}}};
    };
    Scene mixed = all.front();
    mixed.triangles
        = {triangle({latticePixel(1, 1), latticePixel(9, 9), latticePixel(5, 5)}),
           triangle({latticePixel(3, 1), latticePixel(3, 8), latticePixel(3, 5)}),
           triangle({latticePixel(2, 6), latticePixel(9, 6), latticePixel(2, 6)}),
           triangle({latticePixel(4, 4), latticePixel(4, 4), latticePixel(4, 4)}),
           triangle({LatticePoint{100, 300}, LatticePoint{2600, 900}, LatticePoint{700, 2500}}),
           triangle({latticePixel(-70000, 2), latticePixel(70000, 3), latticePixel(0, 70000)})};
    all.push_back(mixed);
    return all;
}

QStringList idsOf(const std::vector<NumberDescription> &numbers)
{
    QStringList ids;
    for (const NumberDescription &number : numbers)
        ids.append(number.id);
    return ids;
}

/// Some thirty of a run's spans are looked at.
std::size_t strideOf(const ScanTrace &trace) { return 1 + trace.spanCount() / 30; }

/// Whether the words describe these numbers, each in its place.
bool describe(const StepWords &words, const std::vector<NumberDescription> &numbers)
{
    return idsOf(words.numbers) == idsOf(numbers);
}

/// Calls `check` with the run of each scene under one method, in each of its arithmetics and, in
/// the first of them, under each of its rules.
template <class Check>
void forEachRun(const QString &id, const Check &check, const std::vector<Scene> &all = scenes())
{
    const Method &method = *methodNamed(id);
    for (Scene scene : all) {
        scene.method = id.toStdString();
        for (const Arithmetic arithmetic : method.arithmetics) {
            for (const FillRule rule : method.fillRules) {
                if (arithmetic != method.arithmetics.front() && rule != method.fillRules.front())
                    continue;
                scene.settings.arithmetic = arithmetic;
                scene.settings.fillRule = rule;
                if (!objectionTo(scene).isEmpty())
                    continue;
                TraceOptions options;
                options.sampleLimit = 2000;
                check(*traceScene(scene, options));
            }
        }
    }
}

/// The two edges that a triangle's column or row crosses at the sample line, by their positions
/// there, px: an independent statement of the bounds.
struct Crossing {
    QString edge;
    double at = 0;
};

std::vector<Crossing> crossingsOf(const TracedScene &traced, std::size_t span)
{
    const SpanRecord record = traced.trace->span(span);
    const SetUpRecord setUp = traced.trace->setUp(record.primitive);
    const Triangle &triangle = traced.primitives.triangles[record.primitive];
    const bool isRow = record.place.axis == SpanAxis::Row;
    const auto across = [&](int corner) {
        const LatticePoint &point
            = triangle.vertices[std::size_t(setUp.order[std::size_t(corner)])].position;
        return double(isRow ? point.y : point.x) / 256;
    };
    const auto along = [&](int corner) {
        const LatticePoint &point
            = triangle.vertices[std::size_t(setUp.order[std::size_t(corner)])].position;
        return double(isRow ? point.x : point.y) / 256;
    };
    std::vector<Crossing> crossings;
    const auto place = double(record.place.coordinate);
    for (const auto &[a, b, name] :
         {std::tuple(0, 1, "L₀₁"), std::tuple(1, 2, "L₁₂"), std::tuple(0, 2, "L₀₂")}) {
        const double from = across(a), to = across(b);
        if (from == to || place < std::min(from, to) || place > std::max(from, to))
            continue;
        crossings.push_back({QString::fromUtf8(name),
                             along(a) + (place - from) / (to - from) * (along(b) - along(a))});
    }
    return crossings;
}

} // namespace

/// A number is one row: what it is called and how it is read cannot part.
class TestNumberRows : public QObject {
    Q_OBJECT

private:
    void addMethods()
    {
        QTest::addColumn<QString>("id");
        for (const Method &method : methods())
            QTest::newRow(qPrintable(method.id)) << method.id;
    }

private slots:
    void everyRecordHasACellForEachDescription_data() { addMethods(); }
    void everyRecordHasACellForEachDescription()
    {
        QFETCH(QString, id);
        const auto check = [](const TracedScene &traced) {
            const ScanTrace &trace = *traced.trace;
            const TraceNumbers &numbers = trace.numbers();
            for (std::size_t i = 0; i < trace.primitiveCount(); ++i) {
                QCOMPARE(trace.setUp(i).cells.size(), numbers.setUp.size());
                QVERIFY(describe(trace.setUpWords(i), numbers.setUp));
            }
            for (std::size_t span = 0; span < trace.spanCount(); span += strideOf(trace)) {
                QCOMPARE(trace.span(span).cells.size(), numbers.span.size());
                QVERIFY(describe(trace.spanWords(span), numbers.span));
                for (const SampleRecord &sample : trace.samples(span))
                    QCOMPARE(sample.cells.size(), numbers.sample.size());
                if (trace.firstSampleOf(span) < trace.endSampleOf(span))
                    QVERIFY(describe(trace.sampleWords(span, 0), numbers.sample));
            }
        };
        forEachRun(id, check);
        forEachRun(id, check, scenesWithEffects());
    }

    void everyStepIsExplained_data() { addMethods(); }
    void everyStepIsExplained()
    {
        QFETCH(QString, id);
        forEachRun(id, [](const TracedScene &traced) {
            const ScanTrace &trace = *traced.trace;
            for (std::size_t step = 0; step < trace.stepCount();
                 step += trace.stepAt(step).kind == StepKind::SetUp ? 1 : 11) {
                const Explanation explanation = explainStep(traced, step);
                QVERIFY(!explanation.heading.isEmpty());
                QVERIFY(!explanation.sentence.isEmpty());
            }
        });
    }

    void titlesFollowTheSettingsAlone_data() { addMethods(); }
    void titlesFollowTheSettingsAlone()
    {
        QFETCH(QString, id);
        forEachRun(id, [](const TracedScene &traced) {
            QStringList titles;
            for (std::size_t span = 0; span < traced.trace->spanCount();
                 span += strideOf(*traced.trace)) {
                QStringList here;
                for (const NumberDescription &number : traced.trace->spanWords(span).numbers)
                    here.append(number.title);
                if (span == 0)
                    titles = here;
                QCOMPARE(here, titles);
            }
        });
    }

    void everyNumberHasItsOwnNameInFiles_data() { addMethods(); }
    void everyNumberHasItsOwnNameInFiles()
    {
        QFETCH(QString, id);
        const Method &method = *methodNamed(id);
        for (const auto *numbers :
             {&method.numbers.setUp, &method.numbers.span, &method.numbers.sample}) {
            const QStringList ids = idsOf(*numbers);
            QCOMPARE(QSet<QString>(ids.begin(), ids.end()).size(), ids.size());
        }
    }

    void everyNumberHasItsOwnMeaning_data() { addMethods(); }
    void everyNumberHasItsOwnMeaning()
    {
        QFETCH(QString, id);
        const Method &method = *methodNamed(id);
        for (const auto *numbers :
             {&method.numbers.setUp, &method.numbers.span, &method.numbers.sample}) {
            QMap<QString, QString> idByMeaning;
            for (const NumberDescription &number : *numbers) {
                QVERIFY2(!idByMeaning.contains(number.toolTip),
                         qPrintable(number.id + u' ' + idByMeaning.value(number.toolTip) + u' '
                                    + number.toolTip));
                idByMeaning.insert(number.toolTip, number.id);
                static const QRegularExpression gap(QStringLiteral("[{}%#]"));
                QVERIFY2(!number.toolTip.contains(gap), qPrintable(number.toolTip));
            }
        }
    }

    void anEdgeWalksWordsNameTheEdgesThatBoundTheSpan_data()
    {
        QTest::addColumn<QString>("id");
        for (const char *id :
             {"column-scan", "column-scan-constant-rate", "column-scan-bias", "row-walk"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }
    void anEdgeWalksWordsNameTheEdgesThatBoundTheSpan()
    {
        QFETCH(QString, id);
        std::mt19937 random(20);
        std::uniform_int_distribution<Lattice> within(-600, 6000);
        const QRegularExpression edgeName(QStringLiteral("L[₀₁₂]{2}"));
        int compared = 0;
        for (int run = 0; run < 60; ++run) {
            Scene scene;
            scene.frame.width = scene.frame.height = 20;
            scene.method = id.toStdString();
            Triangle triangle;
            for (Vertex &vertex : triangle.vertices)
                vertex = {{within(random), within(random)}, {{255, 0, 0}}};
            scene.triangles = {triangle};
            const auto traced = traceScene(scene);
            for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
                const SpanRecord record = traced->trace->span(span);
                const std::vector<Crossing> crossings = crossingsOf(*traced, span);
                for (const NumberDescription &number : traced->trace->spanWords(span).numbers) {
                    const bool isLower = number.subject == NumberSubject::LowerEdge
                        || number.subject == NumberSubject::LeftEdge;
                    const auto match = edgeName.match(number.toolTip);
                    if (number.subject == NumberSubject::General || !match.hasMatch()
                        || number.group != NumberGroup::Span)
                        continue;
                    const double bound = (isLower ? record.lower : record.upper).toDouble();
                    const auto found
                        = std::ranges::find(crossings, match.captured(), &Crossing::edge);
                    QVERIFY2(found != crossings.end(), qPrintable(number.toolTip));
                    QVERIFY2(std::abs(found->at - bound) < 1e-9, qPrintable(number.toolTip));
                    ++compared;
                }
            }
        }
        QVERIFY2(compared > 500, qPrintable(QString::number(compared)));
    }

    void aFormulaShowsTheBranchThatWasTaken()
    {
        Scene scene;
        scene.triangles = {Triangle{{{{latticePixel(2, 1), {{255, 0, 0}}},
                                      {latticePixel(40, 11), {{0, 255, 0}}},
                                      {latticePixel(13, 37), {{0, 0, 255}}}}}}};
        const auto lastRow = [&](FillRule rule) {
            scene.settings.fillRule = rule;
            const auto traced = traceScene(scene);
            const auto numbers = traced->trace->spanWords(3).numbers;
            return std::ranges::find(numbers, QStringLiteral("last_row"), &NumberDescription::id)
                ->formula;
        };
        QCOMPARE(lastRow(FillRule::Closed), QStringLiteral("last row = ⌊y_T⌋"));
        QCOMPARE(lastRow(FillRule::HalfOpenColumn), QStringLiteral("last row = ⌈y_T⌉ − 1"));

        scene.settings.fillRule = FillRule::Closed;
        const auto traced = traceScene(scene);
        const auto upper
            = [&](std::size_t span) { return traced->trace->spanWords(span).numbers[4].formula; };
        QCOMPARE(upper(0), QStringLiteral("y_T ← y₀"));
        QCOMPARE(upper(1), QStringLiteral("y_T ← y_T′ + m₀₁"));
        QCOMPARE(upper(11), QStringLiteral("y_T ← y₁"));
        QCOMPARE(upper(12), QStringLiteral("y_T ← y_T′ + m₁₂"));
        QVERIFY(!traced->trace->spanWords(11).event.isEmpty());
        QVERIFY(traced->trace->spanWords(12).event.isEmpty());
    }
};

PIXELPLUMB_TEST(TestNumberRows)

} // namespace tst_numberrows

#include "tst_numberrows.moc"
