// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/pixelhistory.h"
#include "core/runs/explain/stepmoment.h"
#include "core/runs/tracedscene.h"
#include "tests/support/scenes/scenesformethods.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_variantwords {

using namespace pixelplumb;

namespace {

VariantSet only(Variant variant) { return VariantSet().with(variant); }

/// The line of the slides' table: p_k = 0 at k = 4, where it enters column 25.
Scene slideLine(VariantSet variants)
{
    Scene scene;
    scene.frame.width = 40;
    scene.frame.height = 50;
    scene.method = "line-bresenham";
    scene.settings.variants = variants;
    scene.shapes = {lineAt(20, 41, 30, 44)};
    return scene;
}

std::size_t stepOfColumn(const TracedScene &traced, std::int64_t column)
{
    const ScanTrace &trace = *traced.trace;
    std::size_t span = 0;
    while (trace.placeOf(span).coordinate != column)
        ++span;
    return trace.indexOfSpan(span);
}

/// The lines of the pseudocode that a step does.
QStringList currentLines(const TracedScene &traced, std::size_t step)
{
    const Moment moment = momentOf(*traced.trace, step);
    QStringList lines;
    for (const PseudocodeLine &line : pseudocodeOf(traced, 0)) {
        if (std::ranges::find(line.moments, moment) != line.moments.end())
            lines += line.text;
    }
    return lines;
}

std::vector<std::int64_t> columnsMarked(const TracedScene &traced, MarkKind kind)
{
    std::vector<std::int64_t> columns;
    for (const TraceMark &mark : traced.marks) {
        if (mark.kind == kind)
            columns.push_back(
                traced.trace->placeOf(traced.trace->stepAt(mark.step).span).coordinate);
    }
    return columns;
}

Scene triangleScene(const char *method, VariantSet variants = {})
{
    Scene scene;
    scene.frame.width = 64;
    scene.frame.height = 48;
    scene.method = method;
    scene.settings.variants = variants;
    scene.triangles = {{{{{latticePixel(4, 5), {{255, 0, 0}}},
                          {latticePixel(58, 12), {{0, 255, 0}}},
                          {latticePixel(26, 44), {{0, 0, 255}}}}}}};
    return scene;
}

} // namespace

/// What is said about a run that departs from the right algorithm, and about ties and vertices.
class TestVariantWords : public QObject {
    Q_OBJECT

private slots:
    void everyVariantChangesItsLineOfThePseudocode_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<Variant>("variant");
        for (const Method &method : methods()) {
            for (const Variant variant : method.variants)
                QTest::addRow("%s, %s", qPrintable(method.id), nameOf(variant).data())
                    << method.id << variant;
        }
    }
    void everyVariantChangesItsLineOfThePseudocode()
    {
        QFETCH(QString, id);
        QFETCH(Variant, variant);
        const Method &method = *methodNamed(id);
        Scene scene = scenesForEveryMethod().back().second;
        scene.settings.variants = only(variant);
        const auto traced = tracedBy(method, method.arithmetics.front(), scene);
        QVERIFY(traced->scene.settings.variants == only(variant));

        const Pseudocode varied = pseudocodeOf(*traced, 0);
        const Pseudocode plain
            = underRule(linesOf(LineOf::Area, method.pseudocode), scene.settings.fillRule);

        QCOMPARE(varied.size(), plain.size());
        const auto changed = std::ranges::mismatch(varied, plain, {}, &PseudocodeLine::text,
                                                   &PseudocodeLine::text);
        QVERIFY(changed.in1 != varied.end());
    }

    void aTieThatStaysIsOnTheLineThatSaysSo()
    {
        const auto right = traceScene(slideLine({}));
        const auto printed = traceScene(slideLine(only(Variant::StayAtZero)));

        QCOMPARE(currentLines(*right, stepOfColumn(*right, 25)).last(),
                 u"else: y ← y + s; p ← p + 2Δy − 2Δx"_s);
        QCOMPARE(currentLines(*printed, stepOfColumn(*printed, 25)).last(),
                 u"else if p ≤ 0: p ← p + 2Δy"_s);
    }

    void aLineHalfWayBetweenTwoPixelsIsATie_data()
    {
        QTest::addColumn<QString>("method");
        for (const char *id :
             {"line-bresenham", "line-bresenham-symmetric", "line-dda", "line-slope-intercept"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }
    void aLineHalfWayBetweenTwoPixelsIsATie()
    {
        QFETCH(QString, method);
        Scene scene = slideLine({});
        scene.method = method.toStdString();

        const auto columns = columnsMarked(*traceScene(scene), MarkKind::Tie);

        // 41 + 3/10·5 = 42 1/2
        QCOMPARE(columns, std::vector<std::int64_t>{25});
    }

    void theFramesBorderIsNoVertex()
    {
        Scene scene = triangleScene("barycentric-all");
        for (const char *method : {"barycentric-all", "barycentric-rectangle"}) {
            scene.method = method;
            QCOMPARE(columnsMarked(*traceScene(scene), MarkKind::PartBegins),
                     (std::vector<std::int64_t>{4, 26, 58}));
        }
    }

    /// Nor is a column next to the triangle, a whole pixel away from its vertex.
    void aColumnBesideATriangleIsNoVertex()
    {
        Scene scene = triangleScene("barycentric-all");
        scene.frame.firstColumn = 3;
        scene.frame.width = 57; // to 59
        QCOMPARE(columnsMarked(*traceScene(scene), MarkKind::PartBegins),
                 (std::vector<std::int64_t>{4, 26, 58}));
    }

    void aPixelThatIsNotTestedTellsWhatIsAndByWhichVariant()
    {
        // The box's right side becomes (int)(58 − ½) = 57.
        const auto traced = traceScene(triangleScene("edge-equations", only(Variant::RoundedBox)));

        const QString reason = pixelHistory(*traced, 58, 12).front().reason;

        QVERIFY2(reason.contains(u"in this row the kernel tests only the samples 4 … 57"),
                 qPrintable(reason));
        QVERIFY2(reason.contains(u"“Rounded box”: left = (int)"), qPrintable(reason));
    }

    /// The box reaches from the column −4 to 3, of which the frame has a part.
    void ofABoxThatTheFrameCutsThePartInTheFrameIsTold()
    {
        Scene scene = triangleScene("edge-equations");
        scene.frame = frameOf(8, 8);
        scene.triangles = {Triangle{
            {{{latticePixel(-4, 1), {}}, {latticePixel(3, 1), {}}, {latticePixel(-4, 6), {}}}}}};
        const auto traced = traceScene(scene);
        for (const auto &[y, told] :
             {std::pair(6,
                        u"the box of the vertices, of which the columns 0 … 3 are in the frame."),
              {7, u"the box of the vertices, of which the rows 1 … 6 are in the frame."}}) {
            const QString reason = pixelHistory(*traced, 5, y).front().reason;
            QVERIFY2(reason.contains(told), qPrintable(reason));
        }
    }

    void ofSeveralVariantsOnlyThoseAreBlamedWithoutWhichThePixelIsAnother()
    {
        Scene scene = sceneOf(lineAt(20, 41, 30, 44), "line-bresenham", frameOf(64, 48));
        const auto reasonAt = [&](VariantSet variants, int x, int y) {
            scene.settings.variants = variants;
            return pixelHistory(*traceScene(scene), x, y).front().reason;
        };
        const VariantSet both = VariantSet().with(Variant::StayAtZero).with(Variant::OneStepShort);

        const QString extra = reasonAt(both, 25, 42); // p = 0 there
        QVERIFY2(extra.contains(u"p ≤ 0") && !extra.contains(u"Δx − 1"), qPrintable(extra));
        const QString missing = reasonAt(both, 30, 44); // the last
        QVERIFY2(!missing.contains(u"p ≤ 0") && missing.contains(u"Δx − 1"), qPrintable(missing));
    }
};

PIXELPLUMB_TEST(TestVariantWords)

} // namespace tst_variantwords

#include "tst_variantwords.moc"
