// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/geometry/seededrandom.h"
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/diagnose/undecidable.h"
#include "core/grade/pictures/picturediff.h"
#include "core/grade/rounding/linechoice.h"
#include "tests/support/programs/textbookline.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_linemargin {

using namespace pixelplumb;

namespace {

Scene randomLines(SeededRandom &random, const char *method, int side, int lines)
{
    Scene scene;
    scene.method = method;
    scene.frame.width = side;
    scene.frame.height = side;
    for (int i = 0; i < lines; ++i) {
        const auto vertex = [&] {
            return Vertex{latticePixel(random.between(0, side - 1), random.between(0, side - 1)),
                          random.colour()};
        };
        Shape line;
        line.vertices = {vertex(), vertex()};
        scene.shapes.push_back(line);
    }
    return scene;
}

Scene oneLine(const char *method, const LatticePoint &from, const LatticePoint &to)
{
    Scene scene;
    scene.method = method;
    Shape line;
    line.vertices = {{from, {{255, 0, 0}}}, {to, {{0, 0, 255}}}};
    scene.shapes = {line};
    return scene;
}

PictureDiff judged(const Scene &scene, const Picture &found, Arithmetic tolerance)
{
    const Picture right = pictureOf(scene);
    return differenceOf(right, found,
                        undecidablePixels(scene, right, found, {Leeway::Rule, tolerance}));
}

} // namespace

/// Of lines either pixel is right where rounding, or a half, decides; and no other one.
class TestLineMargin : public QObject {
    Q_OBJECT

private slots:
    void aRightProgramIsNeverWrong_data()
    {
        QTest::addColumn<QByteArray>("method");
        for (const char *method : {"line-dda", "line-slope-intercept", "line-parametric",
                                   "line-bresenham-symmetric", "line-bresenham"})
            QTest::newRow(method) << QByteArray(method);
    }
    void aRightProgramIsNeverWrong()
    {
        QFETCH(QByteArray, method);
        SeededRandom random(29);
        std::int64_t open = 0;
        for (int i = 0; i < 40; ++i) {
            const int side = i % 20 == 0 ? 400 : 64;
            const Scene scene = randomLines(random, method.constData(), side, 1 + i % 7);
            for (const Halves halves : allHalves) {
                const PictureDiff single
                    = judged(scene, textbookPicture<float>(scene, halves), Arithmetic::Float32);
                const PictureDiff twofold
                    = judged(scene, textbookPicture<double>(scene, halves), Arithmetic::Float64);
                QCOMPARE(single.differing(), std::int64_t(0));
                QCOMPARE(twofold.differing(), std::int64_t(0));
                open += single.count(Difference::Undecidable);
            }
        }
        QVERIFY(open > 100);
    }

    /// The bound of float64 does not excuse float32, nor that of float32 numbers of 16 bits.
    void beyondItsBoundAProgramIsWrong()
    {
        SeededRandom random(5);
        std::int64_t wrong = 0;
        for (int i = 0; i < 10; ++i) {
            const Scene scene = randomLines(random, "line-dda", 700, 2);
            wrong += judged(scene, textbookPicture<float>(scene, Halves::Up), Arithmetic::Float64)
                         .differing();
        }
        QVERIFY(wrong > 0);
        Scene fixed = oneLine("line-dda", latticePixel(0, 0), latticePixel(1499, 499));
        fixed.frame.width = 1500;
        fixed.frame.height = 500;
        Scene cut = fixed;
        cut.shapes[0].vertices[1].position.y -= 64; // 1/4 px
        QVERIFY(judged(fixed, pictureOf(cut), Arithmetic::Float32).differing() > 0);
    }

    void onePixelOfAStepIsDrawnAndNotTwo_data()
    {
        QTest::addColumn<int>("drawn");
        QTest::newRow("none") << 0;
        QTest::newRow("the lower one") << 1;
        QTest::newRow("the upper one") << 2;
        QTest::newRow("both") << 3;
    }
    void onePixelOfAStepIsDrawnAndNotTwo()
    {
        QFETCH(int, drawn);
        const Scene scene = oneLine("line-dda", latticePixel(1, 1), latticePixel(3, 2));
        Picture found = pictureOf(scene); // at x = 2 y is 3/2
        const auto placeOf
            = [&](int y) { return found.placeOf(2, int(pictureLine(scene.frame, y))); };
        const Colour colour = found.colours[placeOf(2)];
        for (const int y : {1, 2}) {
            const bool isDrawn = (drawn & y) != 0;
            found.covered[placeOf(y)] = isDrawn ? 1 : 0;
            found.colours[placeOf(y)] = isDrawn ? colour : scene.frame.background;
        }
        const std::int64_t wrong = judged(scene, found, Arithmetic::Float32).differing();
        QCOMPARE(wrong > 0, drawn == 0 || drawn == 3);
    }

    void whatNoHalfDecidesStaysWrong()
    {
        SeededRandom random(11);
        for (int i = 0; i < 40; ++i) {
            const Scene scene = randomLines(random, "line-dda", 64, 1);
            const Picture right = pictureOf(scene);
            for (const LineChoice &choice :
                 lineChoices(scene.shapes[0], scene, Arithmetic::Float32)) {
                if (choice.pixels.size() > 1)
                    continue;
                const auto &[x, y] = choice.pixels[0];
                Picture found = right;
                const std::size_t place = found.placeOf(int(x), int(pictureLine(scene.frame, y)));
                found.covered[place] = 0;
                found.colours[place] = scene.frame.background;
                QVERIFY(judged(scene, found, Arithmetic::Float32).differing() > 0);
            }
        }
    }

    void whoRoundsHalvesDownIsNamedAndNotWrong_data()
    {
        QTest::addColumn<QByteArray>("method");
        for (const char *method : {"line-dda", "line-slope-intercept", "line-parametric"})
            QTest::newRow(method) << QByteArray(method);
    }
    void whoRoundsHalvesDownIsNamedAndNotWrong()
    {
        QFETCH(QByteArray, method);
        Scene scene = oneLine(method.constData(), latticePixel(1, 1), latticePixel(17, 9));
        scene.shapes.push_back(
            oneLine(method.constData(), latticePixel(30, 2), latticePixel(22, 18)).shapes[0]);
        const std::vector<Submission> submissions
            = {{scene, textbookPicture<double>(scene, Halves::Down)}};

        const Diagnosis diagnosis = *diagnose(submissions);

        QCOMPARE(nameOf(diagnosis.verdict), u"undecidable"_s);
        QCOMPARE(diagnosis.candidates.size(), std::size_t(1));
        QCOMPARE(diagnosis.candidates.front().rightAlone(), QStringList(u"rounds-halves-down"_s));
    }

    /// Three lines by Bresenham from their first ends, and each column filled between them.
    void aFilledOutlineHasItsTiesEitherWay()
    {
        SeededRandom random(17);
        std::int64_t open = 0;
        for (int i = 0; i < 60; ++i) {
            Scene scene;
            scene.method = "midpoint-outline-fill";
            const Colour colour = random.colour();
            const auto vertex = [&] {
                return Vertex{latticePixel(random.between(0, 30), random.between(0, 30)), colour};
            };
            scene.triangles = {Triangle{{vertex(), vertex(), vertex()}}};
            for (const VariantSet tie : {VariantSet(), VariantSet().with(Variant::StayAtZero)}) {
                Scene outline = scene;
                outline.method = "line-bresenham";
                outline.settings.variants = tie;
                outline.triangles.clear();
                for (std::size_t edge = 0; edge < 3; ++edge) {
                    Shape line;
                    line.vertices = {scene.triangles[0].vertices[edge],
                                     scene.triangles[0].vertices[(edge + 1) % 3]};
                    outline.shapes.push_back(line);
                }
                Picture found = pictureOf(outline);
                fillColumns(found, colour);
                const PictureDiff diff = judged(scene, found, Arithmetic::Float32);
                QCOMPARE(diff.differing(), std::int64_t(0));
                open += diff.count(Difference::Undecidable);
            }
            Picture larger = pictureOf(scene);
            for (std::size_t place = larger.size(); place-- > 1;) {
                if (larger.covered[place - 1] != 0) {
                    larger.covered[place] = 1;
                    larger.colours[place] = colour;
                }
            }
            QVERIFY(judged(scene, larger, Arithmetic::Float32).differing() > 0);
        }
        QVERIFY(open > 20);
    }

private:
    static void fillColumns(Picture &picture, const Colour &colour)
    {
        for (int x = 0; x < picture.width; ++x) {
            int first = picture.height;
            int last = -1;
            for (int line = 0; line < picture.height; ++line) {
                if (picture.covered[picture.placeOf(x, line)] == 0)
                    continue;
                first = std::min(first, line);
                last = line;
            }
            for (int line = first; line <= last; ++line) {
                picture.covered[picture.placeOf(x, line)] = 1;
                picture.colours[picture.placeOf(x, line)] = colour;
            }
        }
    }
};

PIXELPLUMB_TEST(TestLineMargin)

} // namespace tst_linemargin

#include "tst_linemargin.moc"
