// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/geometry/seededrandom.h"
#include "core/grade/class/assignment.h"
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/diagnose/undecidable.h"
#include "core/grade/pictures/picturediff.h"
#include "core/grade/try/writtentrace.h"
#include "core/scan/choicenames.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_margin {

using namespace pixelplumb;

namespace {

Triangle triangleOf(std::initializer_list<LatticePoint> points)
{
    Triangle triangle;
    std::size_t i = 0;
    for (const LatticePoint &point : points)
        triangle.vertices[i++] = {point, {{200, 100, 50}}};
    return triangle;
}

Scene sceneOf(std::vector<Triangle> triangles)
{
    Scene scene;
    scene.frame.width = 24;
    scene.frame.height = 24;
    scene.triangles = std::move(triangles);
    return scene;
}

/// Its diagonal, without its ends, has nine samples.
Scene quad()
{
    return sceneOf({triangleOf({latticePixel(2, 2), latticePixel(12, 12), latticePixel(12, 2)}),
                    triangleOf({latticePixel(2, 2), latticePixel(12, 12), latticePixel(2, 12)})});
}

Picture without(const Scene &scene, std::initializer_list<LatticePoint> pixels)
{
    Picture picture = pictureOf(scene);
    for (const auto &[x, y] : pixels) {
        const std::size_t place = picture.placeOf(int(x), int(pictureLine(scene.frame, y)));
        picture.covered[place] = 0;
        picture.colours[place] = scene.frame.background;
    }
    return picture;
}

std::int64_t wrongIn(const Scene &scene, const Picture &found, const Margin &margin)
{
    const Picture right = pictureOf(scene);
    return differenceOf(right, found, undecidablePixels(scene, right, found, margin)).differing();
}

Picture underRule(Scene scene, FillRule rule)
{
    scene.settings.fillRule = rule;
    return pictureOf(scene);
}

/// Three weights in single precision, the third of them 1 − α − β.
Picture byThirdWeight(const Scene &scene)
{
    Picture picture = emptyPicture(scene.frame);
    const auto &[a, b, c] = scene.triangles[0].vertices;
    const auto function = [](const LatticePoint &p, const LatticePoint &q, const LatticePoint &at) {
        const auto px = [](Lattice coordinate) { return float(coordinate) / unitsPerPixel; };
        return (px(q.x) - px(p.x)) * (px(at.y) - px(p.y))
            - (px(q.y) - px(p.y)) * (px(at.x) - px(p.x));
    };
    const float area = function(a.position, b.position, c.position);
    for (int y = 0; y < scene.frame.height; ++y) {
        for (int x = 0; x < scene.frame.width; ++x) {
            const LatticePoint at = latticePixel(x, y);
            const float alpha = function(b.position, c.position, at) / area;
            const float beta = function(c.position, a.position, at) / area;
            const float gamma = 1 - alpha - beta;
            if (alpha < 0 || beta < 0 || gamma < 0)
                continue;
            const std::size_t place = picture.placeOf(x, int(pictureLine(scene.frame, y)));
            picture.covered[place] = 1;
            picture.colours[place] = a.colour;
        }
    }
    return picture;
}

Result<Assignment> assignmentWith(const QByteArray &words)
{
    QByteArray text = "{ 'pixelplumbAssignment': 1, 'name': 'a', " + words
        + " 'scenes': [ { 'name': 'one', 'scene': { 'pixelplumb': 1, 'frame': { 'width': 9, "
          "'height': 9 }, 'primitives': [ { 'triangle': [[1, 1], [1, 7], [7, 1]], 'colors': "
          "['#ff0000', '#ff0000', '#ff0000'] } ] } } ] }";
    return readAssignment(text.replace("'", "\""));
}

} // namespace

/// Each leeway leaves open what its name says, and nothing else.
class TestMargin : public QObject {
    Q_OBJECT

private slots:
    void anEdgeThatNothingRoundsIsTheRules_data()
    {
        QTest::addColumn<Leeway>("leeway");
        QTest::addColumn<std::int64_t>("wrong");
        QTest::newRow("strict") << Leeway::Strict << std::int64_t(11);
        QTest::newRow("rule") << Leeway::Rule << std::int64_t(11);
        QTest::newRow("edges") << Leeway::Edges << std::int64_t(0);
        QTest::newRow("once") << Leeway::Once << std::int64_t(0);
    }
    void anEdgeThatNothingRoundsIsTheRules()
    {
        QFETCH(Leeway, leeway);
        QFETCH(std::int64_t, wrong);
        const Scene scene
            = sceneOf({triangleOf({latticePixel(3, 4), latticePixel(3, 14), latticePixel(13, 9)})});
        Picture found = pictureOf(scene);
        for (int y = 4; y <= 14; ++y) {
            const std::size_t place = found.placeOf(3, int(pictureLine(scene.frame, y)));
            found.covered[place] = 0;
            found.colours[place] = scene.frame.background;
        }
        const std::int64_t left = wrongIn(scene, found, {leeway});
        // A third weight, 1 − α − β, may round some of the samples away.
        if (leeway == Leeway::Rule)
            QVERIFY(left >= 2 && left <= wrong);
        else
            QCOMPARE(left, wrong);
        const auto verdict = diagnose(std::vector{Submission{scene, found}}, {}, {leeway})->verdict;
        QCOMPARE(verdict, wrong > 0 ? DiagnosisVerdict::Wrong : DiagnosisVerdict::Undecidable);
    }

    void aHoleBetweenTwoTrianglesIsWrong_data()
    {
        QTest::addColumn<Leeway>("leeway");
        QTest::addColumn<bool>("isWrong");
        QTest::newRow("strict") << Leeway::Strict << true;
        QTest::newRow("rule") << Leeway::Rule << true;
        QTest::newRow("edges") << Leeway::Edges << false;
        QTest::newRow("once") << Leeway::Once << true;
    }
    void aHoleBetweenTwoTrianglesIsWrong()
    {
        QFETCH(Leeway, leeway);
        QFETCH(bool, isWrong);
        for (const FillRule rule : {FillRule::Closed, FillRule::HalfOpenColumn}) {
            Scene scene = quad();
            scene.settings.fillRule = rule;
            QCOMPARE(wrongIn(scene, without(scene, {{7, 7}}), {leeway}) > 0, isWrong);
        }
        const std::int64_t open = wrongIn(quad(), underRule(quad(), FillRule::Open), {leeway});
        QVERIFY(isWrong ? open >= 9 : open == 0);
    }

    void whoeverOwnsASharedEdgeIsRightUnderOnce()
    {
        for (const FillRule rule : {FillRule::Closed, FillRule::HalfOpenColumn, FillRule::TopLeft})
            QCOMPARE(wrongIn(quad(), underRule(quad(), rule), {Leeway::Once}), std::int64_t(0));
        const QByteArray once = "triangle 0\npixel 7 7 200 100 50\n";
        const QByteArray twice = once + "triangle 1\npixel 7 7 200 100 50\n";
        const auto told = [](const QByteArray &lines, Leeway leeway) {
            const auto written = parseWrittenTrace(allBut77() + lines, quad().frame);
            const auto difference = traceDifferenceOf(quad(), *written, {leeway});
            return *difference ? (*difference)->text : QString();
        };
        QCOMPARE(told(once, Leeway::Once), QString());
        QCOMPARE(told(twice, Leeway::Edges), QString());
        QCOMPARE(told(twice, Leeway::Once),
                 u"pixel (7, 7) lies on an edge that triangles share: drawn twice, "
                 "should be drawn once"_s);
        QVERIFY(told({}, Leeway::Once).contains(u"not drawn"_s));
    }

    void aThirdWeightIsNeverWrong()
    {
        SeededRandom random(41);
        std::int64_t differing = 0;
        for (int i = 0; i < 200; ++i) {
            const Lattice unit = i % 2 == 0 ? unitsPerPixel : 1;
            const auto vertex = [&] {
                const auto place = [&] { return random.between(0, 23 * 256 / unit) * unit; };
                return LatticePoint{place(), place()};
            };
            const Scene scene = sceneOf({triangleOf({vertex(), vertex(), vertex()})});
            if (doubledArea(scene.triangles[0]) == 0)
                continue;
            const Picture found = byThirdWeight(scene);
            differing += differingPixels(pictureOf(scene), found);
            QCOMPARE(wrongIn(scene, found, {}), std::int64_t(0));
        }
        QVERIFY(differing > 0);
    }

    /// The third weight of a vertex is never below 0, so that no right program loses all of an
    /// edge.
    void anEdgeThatIsWhollyMissingIsWrong()
    {
        Scene scene = sceneOf(
            {triangleOf({latticePixel(11, 12), latticePixel(58, 7), latticePixel(58, 40)})});
        scene.frame.width = 64;
        scene.frame.height = 48;
        Picture found = pictureOf(scene);
        for (int y = 7; y <= 40; ++y) {
            const std::size_t place = found.placeOf(58, pictureLine(scene.frame, y));
            found.covered[place] = 0;
            found.colours[place] = scene.frame.background;
        }
        QVERIFY(wrongIn(scene, found, {}) >= 2);
        const Diagnosis diagnosis = *diagnose(std::vector{Submission{scene, found}});
        QCOMPARE(nameOf(diagnosis.verdict), u"wrong"_s);
        QVERIFY(diagnosis.isExplained());
    }

    /// Weights that sum to 0.9999 make 224 into 223.
    void aHandfulOfLevelsProvesNoDefect()
    {
        Scene scene = quad();
        for (Triangle &triangle : scene.triangles) {
            for (Vertex &vertex : triangle.vertices)
                vertex.colour = Colour{{224, 96, 0}};
        }
        Picture found = pictureOf(scene);
        for (Colour &colour : found.colours) {
            if (colour.channels[0] == 224)
                colour = Colour{{223, 95, 0}};
        }
        const auto flat = diagnose(std::vector{Submission{scene, found}});
        QCOMPARE(flat->verdict, DiagnosisVerdict::Wrong);
        QCOMPARE(flat->candidates.size(), std::size_t(0));

        scene.triangles[0].vertices[1].colour = Colour{{0, 255, 255}};
        Scene cut = scene;
        cut.settings.rounding = ByteRounding::Truncate;
        const auto smooth = diagnose(std::vector{Submission{scene, pictureOf(cut)}});
        QCOMPARE(smooth->candidates.front().ids(), QStringList(u"rounding-truncate"_s));
    }

    void anAssignmentSaysItByTheSameNames()
    {
        QCOMPARE(assignmentWith({})->margin, (Margin{Leeway::Rule, Arithmetic::Float32}));
        for (const Leeway leeway : allLeeways) {
            const QByteArray word = nameText(nameOf(leeway)).toLatin1();
            QCOMPARE(assignmentWith("'leeway': '" + word + "',")->margin.leeway, leeway);
        }
        const QString refusal = assignmentWith("'leeway': 'float32',").error().message();
        QVERIFY2(refusal.contains(u"strict"_s), qPrintable(refusal));
        QVERIFY(!assignmentWith("'tolerance': 'exact',"));
        QVERIFY(assignmentWith("'winding': 'clockwise',"));
        const auto other = assignmentWith("'winding': 'counter-clockwise',");
        QVERIFY(!other);
        QVERIFY2(other.error().message().contains(u"not counter-clockwise"_s),
                 qPrintable(other.error().message()));
    }

private:
    /// What the quad draws, as a trace of its first triangle and the rest of its second.
    static QByteArray allBut77()
    {
        QByteArray lines = "triangle 0\n";
        const auto line = [](int x, int y) {
            return "pixel " + QByteArray::number(x) + ' ' + QByteArray::number(y) + " 200 100 50\n";
        };
        for (int x = 2; x <= 12; ++x) {
            for (int y = 2; y <= x; ++y)
                lines += x == 7 && y == 7 ? QByteArray() : line(x, y);
        }
        lines += "triangle 1\n";
        for (int x = 2; x <= 12; ++x) {
            for (int y = x + 1; y <= 12; ++y)
                lines += line(x, y);
        }
        return lines;
    }
};

PIXELPLUMB_TEST(TestMargin)

} // namespace tst_margin

#include "tst_margin.moc"
