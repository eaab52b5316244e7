// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/geometry/seededrandom.h"
#include "core/grade/diagnose/undecidable.h"
#include "core/grade/pictures/wrongplaces.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace tst_picturediff {

using namespace pixelplumb;

namespace {

const Colour black{{0, 0, 0}};
const Colour red{{255, 0, 0}};
const Colour cyan{{0, 255, 255}};

Scene sceneOf(int side, const std::vector<Triangle> &triangles)
{
    Scene scene;
    scene.frame.width = side;
    scene.frame.height = side;
    scene.triangles = triangles;
    return scene;
}

Triangle triangleOf(std::array<LatticePoint, 3> places, const Colour &colour)
{
    return {{{{places[0], colour}, {places[1], colour}, {places[2], colour}}}};
}

/// The picture as a file holds it: bytes, with a pixel covered if its colour is not the
/// background's.
Picture readBack(const Scene &scene, Picture picture)
{
    coverAllBut(scene.frame.background, picture);
    return picture;
}

PictureDiff judged(const Scene &scene, const Picture &found, const Margin &margin = {Leeway::Edges})
{
    const Picture right = pictureOf(scene);
    return differenceOf(right, found, undecidablePixels(scene, right, found, margin));
}

} // namespace

/// What is the same, what is wrong, and what is neither.
class TestPictureDiff : public QObject {
    Q_OBJECT

private slots:
    void theSideOfWrongPixelsIsTold_data()
    {
        QTest::addColumn<QByteArray>("found");
        QTest::addColumn<QStringList>("places");
        const auto row = [](const char *name, const char *found, const QStringList &places) {
            QTest::newRow(name) << QByteArray(found) << places;
        };
        // The right one:      "......" / ".###.." / ".####." / ".###.." / "......", rows 4 … 0
        row("right", "......\n.###..\n.####.\n.###..\n......\n", {});
        row("right ends missing", "......\n.##...\n.###..\n.##...\n......\n",
            {u"3 pixels are missing: all at the right ends of their rows, in columns 3 to 4 and "
             u"rows "
             "1 to 3"_s});
        row("a column before the first", "......\n####..\n#####.\n####..\n......\n",
            {u"3 pixels are extra: all left of what their rows should have, in column 0, rows 1 to "
             "3"_s});
        row("a row above", "..##..\n.###..\n.####.\n.###..\n......\n",
            {u"2 pixels are extra: all above what their columns should have, in row 4, columns 2 "
             "to 3"_s});
        row("a hole", "......\n.###..\n.#.##.\n.###..\n......\n",
            {u"1 pixel is missing: column 2, row 2"_s});
    }
    void theSideOfWrongPixelsIsTold()
    {
        QFETCH(QByteArray, found);
        QFETCH(QStringList, places);
        const auto right = parsePicture("......\n.###..\n.####.\n.###..\n......\n", u"right"_s);
        const auto picture = parsePicture(found, u"found"_s);
        QVERIFY(right.isOk() && picture.isOk());
        FrameSpec frame;
        frame.width = 6;
        frame.height = 5;
        QCOMPARE(wrongPlaces(differenceOf(*right, *picture), *right, frame), places);
    }

    void everySceneIsItsOwnPicture_data()
    {
        QTest::addColumn<QString>("method");
        for (const char *method :
             {"column-scan", "row-walk", "edge-equations", "barycentric-rectangle"})
            QTest::newRow(method) << QString::fromLatin1(method);
    }
    void everySceneIsItsOwnPicture()
    {
        QFETCH(QString, method);
        SeededRandom random(11);
        for (int i = 0; i < 300; ++i) {
            const auto vertex = [&] {
                return Vertex{latticePixel(random.between(0, 11), random.between(0, 11)),
                              random.between(0, 2) == 0 ? black : random.colour()};
            };
            Scene scene = sceneOf(12,
                                  {Triangle{{{vertex(), vertex(), vertex()}}},
                                   Triangle{{{vertex(), vertex(), vertex()}}}});
            scene.method = method.toStdString();
            const Picture found = readBack(scene, pictureOf(scene));

            const PictureDiff diff = judged(scene, found);

            QCOMPARE(diff.count(Difference::None), std::int64_t(found.size()));
        }
    }

    void aTriangleInTheBackgroundsColourHasFullPoints()
    {
        QTemporaryDir folder;
        const auto path
            = [&](const char *name) { return folder.filePath(QString::fromLatin1(name)); };
        const char *scene = R"({ "pixelplumb": 1, "frame": { "width": 6, "height": 6 },
            "primitives": [ { "triangle": [[0, 0], [5, 1], [1, 5]],
                              "colors": ["#000000", "#000000", "#000000"] } ] })";
        const char *assignment = R"({ "pixelplumbAssignment": 1, "name": "black",
            "scenes": [ { "name": "min", "scene": "min.json" } ] })";
        QVERIFY(!writeFile(path("min.json"), scene));
        QVERIFY(!writeFile(path("a.json"), assignment));
        QVERIFY(QDir(folder.path()).mkpath(u"subs/one"_s));
        QCOMPARE(run({"render", path("min.json"), "-o", path("subs/one/min.ppm")}).exitCode, 0);

        const ProgramRun told = run({"diff", path("min.json"), path("subs/one/min.ppm")});
        const ProgramRun graded
            = run({"grade", path("subs"), "--assignment", path("a.json"), "-o", path("out")});

        QCOMPARE(told.exitCode, 0);
        QCOMPARE(QString::fromUtf8(told.output), u"6 × 6 pixels: 36 same\n"_s);
        QVERIFY2(graded.exitCode == 0, graded.messages.constData());
        const auto results = QJsonDocument::fromJson(*readFile(path("out/results.json")));
        QCOMPARE(results[u"submissions"_s][0][u"score"_s].toDouble(),
                 results[u"max_score"_s].toDouble());
    }

    void edgeOwnershipIsOpenButNotTheColour_data()
    {
        QTest::addColumn<QByteArray>("repainted");
        QTest::addColumn<Difference>("verdict");
        QTest::addColumn<Arithmetic>("tolerance");
        for (const Arithmetic tolerance : {Arithmetic::Exact, Arithmetic::Float32}) {
            const auto row = [&](const char *colour, Difference verdict) {
                QTest::addRow("%s, %s", colour, nameOf(tolerance).data())
                    << QByteArray(colour) << verdict << tolerance;
            };
            row("black", Difference::Undecidable);
            row("red", Difference::None);
            row("cyan", Difference::Colour);
        }
    }
    void edgeOwnershipIsOpenButNotTheColour()
    {
        QFETCH(QByteArray, repainted);
        QFETCH(Difference, verdict);
        QFETCH(Arithmetic, tolerance);
        const Colour colour = repainted == "black" ? black : repainted == "red" ? red : cyan;
        const Scene scene = sceneOf(
            12, {triangleOf({latticePixel(1, 1), latticePixel(1, 10), latticePixel(10, 1)}, red)});
        Picture found = pictureOf(scene);
        const auto ties = tiesOf(scene);
        for (std::size_t place = 0; place < ties.size(); ++place) {
            if (ties[place] != 0)
                found.colours[place] = colour;
        }

        const PictureDiff diff = judged(scene, readBack(scene, found), {Leeway::Edges, tolerance});

        QCOMPARE(std::ranges::count(ties, 1), std::ptrdiff_t(27));
        QCOMPARE(diff.count(verdict), std::int64_t(verdict == Difference::None ? 144 : 27));
        QCOMPARE(diff.count(Difference::None),
                 std::int64_t(verdict == Difference::None ? 144 : 117));
    }

    void onASharedEdgeEitherTriangleMayHaveTheSample_data()
    {
        QTest::addColumn<bool>("isBlended");
        QTest::newRow("opaque") << false;
        QTest::newRow("blended") << true;
    }
    void onASharedEdgeEitherTriangleMayHaveTheSample()
    {
        QFETCH(bool, isBlended);
        Scene scene = sceneOf(
            12,
            {triangleOf({latticePixel(2, 2), latticePixel(10, 10), latticePixel(10, 2)}, red),
             triangleOf({latticePixel(2, 2), latticePixel(10, 10), latticePixel(2, 10)}, cyan)});
        scene.settings.fillRule = FillRule::HalfOpenColumn;
        for (std::size_t triangle = 0; isBlended && triangle < 2; ++triangle) {
            TriangleAttributes &attributes = scene.attributes.emplace_back();
            attributes.triangle = triangle;
            for (VertexAttributes &vertex : attributes.vertices)
                vertex.alpha = 128;
        }
        const Picture right = pictureOf(scene);
        const auto place = right.placeOf(5, pictureLine(scene.frame, 5)); // on the diagonal
        const auto verdictOf = [&](const Colour &colour) {
            Picture found = right;
            found.colours[place] = colour;
            return judged(scene, readBack(scene, found)).verdicts[place];
        };

        const Colour ofOne = right.colours[right.placeOf(6, pictureLine(scene.frame, 4))];
        const Colour ofOther = right.colours[right.placeOf(4, pictureLine(scene.frame, 6))];

        QVERIFY(ofOne != ofOther);
        QVERIFY(verdictOf(ofOne) != Difference::Colour);
        QVERIFY(verdictOf(ofOther) != Difference::Colour);
        QCOMPARE(verdictOf(black), Difference::Undecidable);
        QCOMPARE(verdictOf({{10, 20, 30}}), Difference::Colour);
    }

    void whatLiesBelowAnEdgeStaysThere()
    {
        // The second triangle's edge lies inside the first triangle.
        const Scene scene = sceneOf(
            12,
            {triangleOf({latticePixel(0, 0), latticePixel(0, 11), latticePixel(11, 0)}, red),
             triangleOf({latticePixel(2, 2), latticePixel(2, 5), latticePixel(5, 2)}, cyan)});
        const Picture right = pictureOf(scene);
        const auto place = right.placeOf(3, pictureLine(scene.frame, 2));
        const auto verdictOf = [&](const Colour &colour) {
            Picture found = right;
            found.colours[place] = colour;
            return judged(scene, readBack(scene, found)).verdicts[place];
        };

        QCOMPARE(verdictOf(cyan), Difference::None);
        QCOMPARE(verdictOf(red), Difference::Undecidable);
        QCOMPARE(verdictOf(black), Difference::Missing);
    }
};

PIXELPLUMB_TEST(TestPictureDiff)

} // namespace tst_picturediff

#include "tst_picturediff.moc"
