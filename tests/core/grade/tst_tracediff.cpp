// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/tracediff.h"
#include "core/runs/tracedscene.h"
#include "core/scene/scenefile.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>
#include <random>

namespace tst_tracediff {

using namespace pixelplumb;

/// Compares a program's own trace with the exact run: where does the first number differ?
class TestTraceDiff : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const Result<SceneReading> reading = readSceneFile(defaultScene());
        QVERIFY(reading.isOk());
        m_scene = reading->scene;
    }

    void aRightProgramIsRight_data()
    {
        QTest::addColumn<QStringList>("lines");
        QTest::newRow("decimals") << columns(Arithmetic::Exact);
        QTest::newRow("floats") << columns(Arithmetic::Float32);
        QTest::newRow("floats, drawn columns") << spans(m_scene, Arithmetic::Float32, Spans::Drawn);
        QTest::newRow("fractions") << fractions();
        QTest::newRow("nothing") << QStringList();
        QTest::newRow("columns beyond the frame")
            << columns(Arithmetic::Exact) + QStringList{"column 99 1 2", "column -3 1 2"};
        QTest::newRow("levels") << pixels(m_scene, Arithmetic::Exact, Form::Levels);
        QTest::newRow("bytes") << pixels(m_scene, Arithmetic::Exact, Form::Bytes);
        QTest::newRow("both") << columns(Arithmetic::Exact)
                + pixels(m_scene, Arithmetic::Exact, Form::Bytes);
    }
    void aRightProgramIsRight()
    {
        QFETCH(QStringList, lines);
        QCOMPARE(differenceOf(lines), QString());
    }

    void rowsMayBeginAtEitherEnd()
    {
        Scene scene = m_scene;
        scene.method = "row-walk";
        const auto told = [&scene](const QStringList &lines) {
            const auto difference = traceDifferenceOf(
                scene, *parseWrittenTrace(lines.join(u'\n').toUtf8(), scene.frame));
            return difference && *difference ? (*difference)->text : QString();
        };
        QStringList lines = spans(scene, Arithmetic::Exact);
        QCOMPARE(told(lines), QString());
        std::ranges::reverse(lines);
        QCOMPARE(told(lines), QString());
        lines.swapItemsAt(10, 11);
        QVERIFY2(told(lines).contains(u"the order is another"_s), qPrintable(told(lines)));
    }

    void floatsAreNeverWrong_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 0; seed < 60; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void floatsAreNeverWrong()
    {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        std::uniform_int_distribution<int> coordinate(-20 * 256, 80 * 256);
        std::uniform_int_distribution<int> level(0, 255);
        Scene scene = m_scene;
        scene.method = seed % 2 == 0 ? "column-scan" : "row-walk";
        for (Vertex &vertex : scene.triangles[0].vertices) {
            vertex.position = {coordinate(random), coordinate(random)};
            if (seed % 4 < 2) // ties
                vertex.position
                    = latticePixel(floorPixel(vertex.position.x), floorPixel(vertex.position.y));
            for (std::uint8_t &channel : vertex.colour.channels)
                channel = std::uint8_t(level(random));
        }
        // A program that prints only columns it draws may miss one through rounding.
        const QStringList lines
            = spans(scene, Arithmetic::Float32, seed % 5 < 3 ? Spans::Drawn : Spans::All)
            + pixels(scene, Arithmetic::Float32, seed % 3 == 0 ? Form::Bytes : Form::Levels);

        const auto difference
            = traceDifferenceOf(scene, *parseWrittenTrace(lines.join(u'\n').toUtf8(), scene.frame));

        QVERIFY(difference.isOk());
        QCOMPARE(*difference ? (*difference)->text : QString(), QString());
    }

    void floatsThatComeFromFarOutsideAreNeverWrong_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 0; seed < 60; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void floatsThatComeFromFarOutsideAreNeverWrong()
    {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        std::uniform_int_distribution<int> far(-60'000 * 256, -64 * 256);
        std::uniform_int_distribution<int> near(-10 * 256, 70 * 256);
        std::uniform_int_distribution<int> level(0, 255);
        Scene scene = m_scene;
        for (Vertex &vertex : scene.triangles[0].vertices) {
            vertex.position = {near(random), near(random)};
            for (std::uint8_t &channel : vertex.colour.channels)
                channel = std::uint8_t(level(random));
        }
        scene.triangles[0].vertices[0].position = seed % 2 == 0
            ? LatticePoint{far(random), near(random)}
            : LatticePoint{far(random), far(random)};
        const QStringList lines
            = steppedInFloats(scene, seed % 3 == 0 ? Form::Bytes : Form::Levels);

        const auto difference
            = traceDifferenceOf(scene, *parseWrittenTrace(lines.join(u'\n').toUtf8(), scene.frame));

        QVERIFY(difference.isOk());
        QCOMPARE(*difference ? (*difference)->text : QString(), QString());
    }

    void floatsFromFarOutsideAreWrongForThoseWhoComputeInDoubles()
    {
        Scene scene = m_scene;
        scene.triangles[0].vertices[0].position = latticePixel(-40'001, -39'000);
        const QStringList lines = steppedInFloats(scene, Form::Bytes);
        const auto written = parseWrittenTrace(lines.join(u'\n').toUtf8(), m_scene.frame);

        QVERIFY(!traceDifferenceOf(scene, *written).value());
        QVERIFY(traceDifferenceOf(scene, *written, {.tolerance = Arithmetic::Float64}).value());
    }

    void pixelsThatFloatsMayAddOrMissAreMatchedByTheirNumbers()
    {
        Scene scene = m_scene; // two triangles that share a diagonal with ties
        scene.triangles.push_back(scene.triangles.front());
        const std::array<LatticePoint, 4> corners
            = {latticePixel(4, 4), latticePixel(12, 12), latticePixel(12, 4), latticePixel(4, 12)};
        for (std::size_t i = 0; i < 2; ++i) {
            for (Vertex &vertex : scene.triangles[i].vertices)
                vertex.colour = i == 0 ? Colour{{255, 0, 0}} : Colour{{0, 0, 255}};
            scene.triangles[i].vertices[0].position = corners[0];
            scene.triangles[i].vertices[1].position = corners[1];
            scene.triangles[i].vertices[2].position = corners[2 + i];
        }
        QStringList lines = pixels(scene, Arithmetic::Exact, Form::Bytes);
        // The first triangle leaves out a pixel of the diagonal; the trace does not say which
        // triangle draws it.
        QCOMPARE(lines.removeAll(u"pixel 8 8 255 0 0"_s), 1);

        const auto difference = traceDifferenceOf(
            scene, *parseWrittenTrace(lines.join(u'\n').toUtf8(), scene.frame), {Leeway::Edges});

        QVERIFY(difference.isOk());
        QCOMPARE(*difference ? (*difference)->text : QString(), QString());
    }

    void theFirstQuantityThatDiffersIsTold_data()
    {
        QTest::addColumn<QStringList>("lines");
        QTest::addColumn<QString>("difference");
        const QStringList right = columns(Arithmetic::Exact);
        const auto row = [](const char *name, const QStringList &lines, const char *difference) {
            QTest::newRow(name) << lines << QString::fromUtf8(difference);
        };
        const auto with = [&right](int place, const char *line) {
            QStringList lines = right;
            lines[place] = QString::fromLatin1(line);
            return lines;
        };
        // Column 12: y_T = 5 + 8 · 39/22.5 = 18 13/15, y_B = 5 + 8 · 7/54 = 6 1/27.
        row("a number", with(8, "column 12 6.037 18.5"),
            "column 12, y_T: 18.5, should be 18 13/15");
        row("the first of several", with(8, "column 12 6.5 18.5"),
            "column 12, y_B: 6.5, should be 6 1/27");
        row("an integer division", with(8, "column 12 6 18"),
            "column 12, y_B: 6, should be 6 1/27");
        row("a fraction", with(8, "column 12 163/27 284/15"),
            "column 12, y_T: 284/15, should be 18 13/15");
        row("a fraction that is nearly right", with(8, "column 12 163/27 18866667/1000000"),
            "column 12, y_T: 18866667/1000000, should be 18 13/15");
        row("no number", with(8, "column 12 nan 18.867"),
            "column 12, y_B: nan (no number: 0 was divided by 0, or it is computed from such a "
            "one), should be 6 1/27");
        row("infinity", with(8, "column 12 6.037 inf"),
            "column 12, y_T: inf (something was divided by 0, or grew without end), should be 18 "
            "13/15");
        row("another column", with(8, "column 1 6.037 18.867"), "column 1 is there, should not be");
        QStringList missing = right;
        missing.removeAt(8);
        row("a column too few", missing, "column 12 is missing");
        row("an early end", right.first(8), "column 12 is missing");
        QStringList doubled = right;
        doubled.insert(9, right[8]);
        row("a column twice", doubled, "column 12 comes twice, should come once");
        QStringList extra = right;
        extra.prepend(u"column 3 5 5"_s);
        row("a column of none", extra, "column 3 is there, should not be");
        QStringList other = right;
        other.swapItemsAt(8, 9);
        row("another order", other,
            "the numbers are right, the order is another: column 12 comes after column 13, should "
            "come before it");
        row("a byte", {"pixel 5 6 247 2 7"}, "pixel (5, 6), B: 7, should be 6");
        row("a level", {"pixel 4 5 255 0 0", "pixel 5 6 246.7 2.2 6.5"},
            "pixel (5, 6), B: 6.5, should be 6 196/1299");
        row("a row, of the method that has rows", {"row 43 25.5 27.484"},
            "row 43, x_L: 25.5, should be 25 12/13");
    }
    void theFirstQuantityThatDiffersIsTold()
    {
        QFETCH(QStringList, lines);
        QFETCH(QString, difference);
        QCOMPARE(differenceOf(lines), difference);
    }

    void theStepIsThatOfTheNumber()
    {
        QStringList lines = columns(Arithmetic::Exact);
        lines[8] = u"column 12 6.037 18.5"_s;
        const auto written = parseWrittenTrace(lines.join(u'\n').toUtf8(), m_scene.frame);
        const auto difference = traceDifferenceOf(m_scene, *written);
        QVERIFY(difference.isOk() && *difference);
        const auto run = traceScene((*difference)->scene);
        const TraceStep step = run->trace->stepAt((*difference)->step);

        QCOMPARE(int(step.kind), int(StepKind::Span));
        QCOMPARE(run->trace->placeOf(step.span).coordinate, 12);
    }

    void strictlyTheDigitsAloneCount()
    {
        const QStringList lines = {"column 4 5.00001 5"};

        QVERIFY(differenceOf(lines).startsWith(u"column 5"_s));
        QCOMPARE(differenceOf(lines, {Leeway::Strict}), u"column 4, y_B: 5.00001, should be 5"_s);
    }

    void trianglesAreKeptApart()
    {
        Scene scene = m_scene;
        scene.triangles.push_back(scene.triangles.front());
        scene.triangles[1].vertices[0].position = latticePixel(4, 6);
        const auto first = [&](const char *text) {
            const auto difference = traceDifferenceOf(scene, *parseWrittenTrace(text, scene.frame));
            return difference.isOk() && *difference ? (*difference)->text : QString();
        };

        QCOMPARE(first("triangle 1\ncolumn 4 5 5\n"),
                 u"triangle 1, column 4, y_B: 5, should be 6"_s);
        // A tip may be left out, but not the column after it.
        QCOMPARE(first("triangle 1\ncolumn 4 6 6\n"), u"triangle 0, column 5 is missing"_s);
        QCOMPARE(first("triangle 0\ncolumn 4 6 6\n"),
                 u"triangle 0, column 4, y_B: 6, should be 5"_s);
        QCOMPARE(first("triangle 1\ncolumn 63 1 2\n"),
                 u"triangle 1, column 63 is there, should not be"_s);
    }

    void aTriangleThatIsNotThereIsTold()
    {
        const QStringList lines = columns(Arithmetic::Exact);
        const QString named = u"triangle 1 is named, the scene has 1, counted from 0"_s;

        QCOMPARE(differenceOf(QStringList{"triangle 0"} + lines), QString());
        QCOMPARE(differenceOf(lines + QStringList{"triangle 1"}), named);
        QCOMPARE(differenceOf({"triangle 1"}), named);
        QCOMPARE(differenceOf({"triangle 7", "column 4 5 5"}),
                 u"triangle 7, column 4 is there, should not be"_s);
    }

    void linesBeyondTheFrameAreCountedAndNotKept()
    {
        const QByteArray text = "pixel 63 47 1 2 3\npixel 64 0 1 2 3\npixel 0 -1 1 2 3\n"
                                "column 64 1/7 2/7\ncolumn -1 1 2\nrow 48 1 2\nrow 47 1 2.5\n";

        const auto written = parseWrittenTrace(text, m_scene.frame);

        QVERIFY(written.isOk());
        QCOMPARE(written->beyondFrame, 5);
        QCOMPARE(written->lines.size(), 2U);
        QVERIFY(written->kinds.hasPixels && written->kinds.hasColumns && written->kinds.hasRows);
        const std::vector<WrittenNumber> numbers = written->numbersOf(written->lines[1]);
        QCOMPARE(numbers.size(), 2U);
        QCOMPARE(numbers[1].text, u"2.5"_s);
        // The pixel itself is ignored, but it shows that pixels are printed.
        QVERIFY(differenceOf({"pixel 64 0 1 2 3"}).endsWith(u" is missing"_s));
    }

    /// Exact products of Python's fractions have many digits; these are 2 and 2 + 10⁻²⁰.
    void fractionsMayBeLongerThan64Bits()
    {
        const QByteArray text
            = "column 3 4000000000000000000/2000000000000000000 -0/00001\n"
              "column 4 -5070602400912917605986812821504/1267650600228229401496703205376 "
              "200000000000000000001/100000000000000000000\n";

        const auto written = parseWrittenTrace(text, m_scene.frame);

        QVERIFY2(written.isOk(), written.isOk() ? "" : qPrintable(written.error().found));
        const auto first = written->numbersOf(written->lines[0]);
        const auto second = written->numbersOf(written->lines[1]);
        QCOMPARE(first[0].value, Quantity::integer(2));
        QCOMPARE(first[1].value, Quantity::integer(0));
        QCOMPARE(second[0].value, Quantity::integer(-4));
        QCOMPARE(second[1].value.toDouble(), 2.0);
    }

    void aLineIsKeptInFewBytes()
    {
        static_assert(sizeof(WrittenLine) <= 32);
        const qsizetype count = 1 << 16;
        const QByteArray text = QByteArray("pixel 1 1 230 21 4\n").repeated(count);

        const auto written = parseWrittenTrace(text, m_scene.frame);

        QVERIFY(written.isOk());
        QCOMPARE(qsizetype(written->lines.size()), count);
        QCOMPARE(written->text.constData(), text.constData()); // shared, not copied
    }

    void whatNoMethodHasIsAnError()
    {
        QVERIFY(!traceDifferenceOf(m_scene,
                                   *parseWrittenTrace("row 5 1 2\ncolumn 5 1 2\n", m_scene.frame))
                     .isOk());
        Scene lines = m_scene;
        lines.triangles.clear();
        lines.method = "line-bresenham";
        QVERIFY(
            !traceDifferenceOf(lines, *parseWrittenTrace("column 5 1 2\n", lines.frame)).isOk());
    }

private:
    enum class Form { Levels, Bytes };

    QString differenceOf(const QStringList &lines, const Margin &margin = {}) const
    {
        const auto written = parseWrittenTrace(lines.join(u'\n').toUtf8(), m_scene.frame);
        if (!written)
            return written.error().message();
        const auto difference = traceDifferenceOf(m_scene, *written, margin);
        if (!difference)
            return difference.error().message();
        return *difference ? (*difference)->text : QString();
    }

    QStringList columns(Arithmetic arithmetic) const { return spans(m_scene, arithmetic); }

    /// The method's own numbers, in the form in which a program prints them.
    enum class Spans { All, Drawn };
    static QStringList spans(Scene scene, Arithmetic arithmetic, Spans which = Spans::All)
    {
        scene.settings.arithmetic = arithmetic;
        const auto run = traceScene(scene);
        QStringList lines;
        for (std::size_t i = 0; i < run->trace->spanCount(); ++i) {
            const SpanRecord span = run->trace->span(i);
            if (which == Spans::Drawn && span.drawnSamples() == 0)
                continue;
            lines += u"%1 %2 %3 %4"_s
                         .arg(span.place.axis == SpanAxis::Column ? u"column"_s : u"row"_s)
                         .arg(span.place.coordinate)
                         .arg(span.lower.toDouble(), 0, 'g', 6)
                         .arg(span.upper.toDouble(), 0, 'g', 9);
        }
        return lines;
    }

    QStringList fractions() const
    {
        const auto run = traceScene(m_scene);
        QStringList lines;
        const auto text = [](const Quantity &quantity) {
            return toText(quantity.numerator()) + u'/' + toText(quantity.denominator());
        };
        for (std::size_t i = 0; i < run->trace->spanCount(); ++i) {
            const SpanRecord span = run->trace->span(i);
            lines += u"column %1 %2 %3"_s.arg(span.place.coordinate)
                         .arg(text(span.lower), text(span.upper));
        }
        return lines;
    }

    /// A value on an edge from the edge's first column on, and its increment per column.
    struct FloatWalk {
        FloatWalk(const std::array<float, 2> &from, const std::array<float, 2> &to)
            : step((to[1] - from[1]) / (to[0] - from[0]))
            , value(from[1] + (std::ceil(from[0]) - from[0]) * step)
        {
        }

        float step;
        float value;
    };

    /// The values along an edge: y and three levels.
    static std::array<FloatWalk, 4> walksOf(const Vertex &from, const Vertex &to)
    {
        const auto walk = [&](const auto &of) {
            const auto x = [](const Vertex &vertex) { return float(vertex.position.x) / 256; };
            return FloatWalk({x(from), of(from)}, {x(to), of(to)});
        };
        const auto level = [&](std::size_t channel) {
            return walk(
                [channel](const Vertex &vertex) { return float(vertex.colour.channels[channel]); });
        };
        return {walk([](const Vertex &vertex) { return float(vertex.position.y) / 256; }), level(0),
                level(1), level(2)};
    }

    /// An independent program: it walks in float32 from the triangle's first column, wherever the
    /// frame begins, and prints what lies inside the frame.
    static QStringList steppedInFloats(const Scene &scene, Form form)
    {
        auto vertices = scene.triangles[0].vertices;
        std::ranges::sort(vertices, {}, [](const Vertex &vertex) { return vertex.position.x; });
        const auto first = [](const Vertex &vertex) {
            return std::int64_t(std::ceil(double(vertex.position.x) / 256));
        };
        auto across = walksOf(vertices[0], vertices[2]);
        auto along = walksOf(vertices[0], vertices[1]);
        QStringList lines;
        for (std::int64_t x = first(vertices[0]); x * 256 <= vertices[2].position.x; ++x) {
            if (x == first(vertices[1]))
                along = walksOf(vertices[1], vertices[2]);
            if (x >= 0 && x < scene.frame.width)
                lines += column(scene, x, across, along, form);
            for (auto *walks : {&across, &along}) {
                for (FloatWalk &walk : *walks)
                    walk.value += walk.step;
            }
        }
        return lines;
    }

    static QStringList column(const Scene &scene, std::int64_t x,
                              const std::array<FloatWalk, 4> &across,
                              const std::array<FloatWalk, 4> &along, Form form)
    {
        const bool isAcrossBelow = across[0].value < along[0].value;
        const auto &below = isAcrossBelow ? across : along;
        const auto &above = isAcrossBelow ? along : across;
        const float height = above[0].value - below[0].value;
        QStringList lines = {u"column %1 %2 %3"_s.arg(x)
                                 .arg(double(below[0].value), 0, 'g', 9)
                                 .arg(double(above[0].value), 0, 'g', 9)};
        const float start = std::ceil(below[0].value);
        std::array<float, 3> levels = {};
        std::array<float, 3> steps = {};
        for (std::size_t i = 0; i < 3; ++i) {
            steps[i] = height > 0 ? (above[i + 1].value - below[i + 1].value) / height : 0;
            levels[i] = below[i + 1].value + (start - below[0].value) * steps[i];
        }
        for (float y = start; y <= above[0].value; ++y) {
            QString line = u"pixel %1 %2"_s.arg(x).arg(std::int64_t(y));
            for (std::size_t i = 0; i < 3; ++i) {
                line += u' '
                    + (form == Form::Bytes ? QString::number(
                           std::clamp(int(std::floor(double(levels[i]) + 0.5)), 0, 255))
                                           : QString::number(double(levels[i]), 'f', 3));
                levels[i] += steps[i];
            }
            if (y >= 0 && y < float(scene.frame.height))
                lines += line;
        }
        return lines;
    }

    static QStringList pixels(Scene scene, Arithmetic arithmetic, Form form)
    {
        scene.settings.arithmetic = arithmetic;
        const auto run = traceScene(scene);
        QStringList lines;
        for (std::size_t i = 0; i < run->trace->spanCount(); ++i) {
            for (const SampleRecord &sample : run->trace->samples(i)) {
                QString line = u"pixel %1 %2"_s.arg(sample.x).arg(sample.y);
                for (std::size_t channel = 0; channel < 3; ++channel)
                    line += u' '
                        + (form == Form::Bytes
                               ? QString::number(
                                   std::clamp<std::int64_t>(sample.level[channel], 0, 255))
                               : QString::number(sample.colour[channel].toDouble(), 'f', 3));
                lines += line;
            }
        }
        return lines;
    }

    Scene m_scene;
};

PIXELPLUMB_TEST(TestTraceDiff)

} // namespace tst_tracediff

#include "tst_tracediff.moc"
