// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/traceexport.h"
#include "core/runs/tracedscene.h"
#include "tests/support/testprogram.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <random>

namespace tst_numberrows {

using namespace pixelplumb;

namespace {

/// The two edges that a triangle's column or row crosses, by their positions there (px): computed
/// independently of the bounds.
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

/// A number has one row: its name and its reading cannot diverge.
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
    void everyNumberHasItsOwnNameInFiles_data() { addMethods(); }
    void everyNumberHasItsOwnNameInFiles()
    {
        QFETCH(QString, id);
        const Method &method = *methodNamed(id);
        // The columns of every method's sample table; a method may describe the same numbers.
        const QSet<QString> shared = {u"primitive"_s, u"x"_s, u"y"_s, u"R"_s, u"G"_s, u"B"_s};
        for (const auto &[level, numbers] :
             {std::pair(TraceLevel::SetUp, &method.numbers.setUp),
              std::pair(TraceLevel::Column, &method.numbers.span),
              std::pair(TraceLevel::Pixel, &method.numbers.sample)}) {
            const QStringList ofAllMethods = traceColumnNames({}, level);
            QStringList own;
            for (const NumberDescription &number : *numbers) {
                QVERIFY2(!own.contains(number.id), qPrintable(number.id));
                QVERIFY2(shared.contains(number.id) || !ofAllMethods.contains(number.id),
                         qPrintable(number.id));
                own.append(number.id);
            }
            QStringList all = traceColumnNames(method.numbers, level);
            QCOMPARE(all.removeDuplicates(), qsizetype(0));
            for (const QString &name : own)
                QVERIFY2(all.contains(name), qPrintable(name));
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
                static const QRegularExpression gap(u"[{}%#]"_s);
                QVERIFY2(!number.toolTip.contains(gap), qPrintable(number.toolTip));
            }
        }
    }

    /// y points upward in one scene and downward in the other. Only the turn of a polygon's
    /// contours is counted as seen on the screen.
    void noWordHoldsForOneDirectionOfYAlone_data() { addMethods(); }
    void noWordHoldsForOneDirectionOfYAlone()
    {
        QFETCH(QString, id);
        const Method &method = *methodNamed(id);
        QStringList texts = {method.summary};
        for (const PseudocodeLine &line : method.pseudocode)
            texts += line.text;
        for (const auto *numbers :
             {&method.numbers.setUp, &method.numbers.span, &method.numbers.sample}) {
            for (const NumberDescription &number : *numbers)
                texts += number.toolTip;
        }
        static const QRegularExpression asSeen(
            u"\\b(lower (edge|end|one|row|left|right)|upper (edge|end|one|row|left|right)|"
            "lowest|highest|upwards?|downwards?|(walks|interpolates) down|(row|pixel) "
            "(above|below)|"
            "(?<!counter-)clockwise)\\b"_s);
        for (const QString &text : texts) {
            const bool countsTurns = text.contains(QRegularExpression(u"[Cc]rossing|winding"_s));
            QVERIFY2(countsTurns || !text.contains(asSeen), qPrintable(text));
        }
    }

    void colourRatesAreLevelsForEachStep()
    {
        for (const Method &method : methods()) {
            if (!method.draws(PrimitiveKind::Triangle))
                continue; // b_R is a number of a polygon's right edge
            for (const auto *numbers : {&method.numbers.setUp, &method.numbers.span}) {
                for (const NumberDescription &number : *numbers) {
                    static const QRegularExpression rate(
                        u"^([ab]_|Δ|δ)[RGB](_[xy])?([₀₁₂]{2})?$"_s);
                    if (number.title.contains(rate))
                        QVERIFY2(number.unit.startsWith(u"levels/"_s),
                                 qPrintable(method.id + u' ' + number.title));
                }
            }
        }
        const auto &plane = methodNamed(u"interpolate-plane"_s)->numbers.setUp;
        const auto unitOf = [&plane](const char *title) {
            return std::ranges::find(plane, QString::fromLatin1(title), &NumberDescription::title)
                ->unit;
        };
        // a = −A/C: levels·px over px².
        QCOMPARE(unitOf("a_R"), u"levels/px"_s);
        QCOMPARE(unitOf("b_R"), u"levels/px"_s);
        QCOMPARE(unitOf("c_R"), u"levels"_s);
        QCOMPARE(unitOf("A_R"), u"levels·px"_s);
        QCOMPARE(unitOf("C_R"), u"px²"_s);
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
        const QRegularExpression edgeName(u"L[₀₁₂]{2}"_s);
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
            return std::ranges::find(numbers, u"last_row"_s, &NumberDescription::id)->formula;
        };
        QCOMPARE(lastRow(FillRule::Closed), u"last row = ⌊y_T⌋"_s);
        QCOMPARE(lastRow(FillRule::HalfOpenColumn), u"last row = ⌈y_T⌉ − 1"_s);

        scene.settings.fillRule = FillRule::Closed;
        const auto traced = traceScene(scene);
        const auto upper
            = [&](std::size_t span) { return traced->trace->spanWords(span).numbers[4].formula; };
        QCOMPARE(upper(0), u"y_T ← y₀"_s);
        QCOMPARE(upper(1), u"y_T ← y_T′ + m₀₁"_s);
        QCOMPARE(upper(11), u"y_T ← y₁"_s);
        QCOMPARE(upper(12), u"y_T ← y_T′ + m₁₂"_s);
        QVERIFY(!traced->trace->spanWords(11).event.isEmpty());
        QVERIFY(traced->trace->spanWords(12).event.isEmpty());
    }
};

PIXELPLUMB_TEST(TestNumberRows)

} // namespace tst_numberrows

#include "tst_numberrows.moc"
