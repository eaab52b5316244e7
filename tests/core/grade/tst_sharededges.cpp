// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/diagnose/tracediff.h"
#include "core/grade/diagnose/undecidable.h"
#include "core/grade/pictures/picturediff.h"
#include "core/grade/rounding/trianglemargin.h"
#include "core/grade/try/studentoutput.h"
#include "core/scan/choicenames.h"
#include "core/scene/scenefile.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_sharededges {

using namespace pixelplumb;

namespace {

/// Triangles of one colour each, with this alpha.
Scene sceneOf(const QByteArrayList &triangles, const QByteArray &alpha = "80",
              const QByteArray &more = {})
{
    constexpr std::array colours = {"#ff0000", "#00ff00", "#0000ff", "#ffffff", "#ff00ff"};
    QByteArrayList primitives;
    for (qsizetype i = 0; i < triangles.size(); ++i) {
        const QByteArray colour = "\"" + QByteArray(colours[std::size_t(i)]) + alpha + "\"";
        primitives += "{\"triangle\": " + triangles[i] + ", \"colors\": ["
            + QByteArrayList(3, colour).join(", ") + "]}";
    }
    return readScene("{\"pixelplumb\": 1, \"frame\": {\"width\": 16, \"height\": 16}, " + more
                     + "\"primitives\": [" + primitives.join(", ") + "]}")
        .value()
        .scene;
}

const QByteArray topLeft = "\"method\": \"interpolate-barycentric\", \"fillRule\": \"top-left\", ";

QByteArrayList fan()
{
    return {"[[2, 2], [10, 2], [6, 6]]", "[[10, 2], [10, 10], [6, 6]]",
            "[[10, 10], [2, 10], [6, 6]]", "[[2, 10], [2, 2], [6, 6]]"};
}
/// The last lies over all others, and its edges meet none of theirs.
QByteArrayList coveredFan() { return fan() << "[[0, 0], [15, 1], [5, 15]]"; }
QByteArrayList quad() { return {"[[2, 2], [10, 2], [10, 10]]", "[[2, 2], [10, 10], [2, 10]]"}; }
QByteArrayList fold() { return {"[[2, 2], [10, 2], [10, 10]]", "[[2, 2], [10, 2], [6, 12]]"}; }

Picture under(Scene scene, FillRule rule, const LatticePoint &towards = latticePixel(-3, -7))
{
    scene.method = "interpolate-barycentric";
    scene.settings.fillRule = rule;
    scene.frame.offScreenPoint = towards;
    return pictureOf(scene);
}

std::int64_t wrongIn(const Scene &scene, const Picture &found, const Margin &margin)
{
    const Scene judged = judgedScene(scene, margin);
    const Picture right = pictureOf(judged);
    return differenceOf(right, found, undecidablePixels(judged, right, found, margin)).differing();
}

/// Rules that give each sample to one triangle.
std::vector<Picture> watertight(const Scene &scene)
{
    std::vector<Picture> pictures = {under(scene, FillRule::TopLeft)};
    for (const auto &[x, y] : {std::pair(-31, 2), {50, 7}, {3, -40}, {9, 61}})
        pictures.push_back(under(scene, FillRule::OffScreenPoint, latticePixel(x, y)));
    return pictures;
}

QString idsOf(const DiagnosisCandidate &candidate) { return candidate.ids().join(u" and "_s); }

} // namespace

/// What is left open on edges that triangles share, wherever it is seen.
class TestSharedEdges : public QObject {
    Q_OBJECT

private slots:
    void aWatertightProgramIsNeverWrong_data()
    {
        QTest::addColumn<QByteArrayList>("triangles");
        QTest::newRow("a fan") << fan();
        QTest::newRow("a fan under another triangle") << coveredFan();
        QTest::newRow("a quad") << quad();
        QTest::newRow("both triangles on one side") << fold();
        QTest::newRow("the same triangle twice") << QByteArrayList{quad().front(), quad().front()};
        QTest::newRow("two halves along one edge") << QByteArrayList{
            "[[2, 2], [2, 10], [10, 2]]", "[[2, 2], [4, 2], [4, 0]]", "[[4, 2], [10, 2], [4, 0]]"};
    }
    void aWatertightProgramIsNeverWrong()
    {
        QFETCH(QByteArrayList, triangles);
        for (const QByteArray &rule : {topLeft, QByteArray()}) {
            const Scene scene = sceneOf(triangles, "80", rule);
            for (const Picture &found : watertight(scene)) {
                QCOMPARE(wrongIn(scene, found, {Leeway::Edges}), std::int64_t(0));
                QCOMPARE(wrongIn(scene, found, {Leeway::Once}), std::int64_t(0));
            }
        }
    }

    void whoDrawsAllOrNoneOfThemIsRightUnderEdgesAlone()
    {
        for (const QByteArrayList &triangles : {fan(), coveredFan(), quad()}) {
            for (const QByteArray &rule : {topLeft, QByteArray()}) {
                const Scene scene = sceneOf(triangles, "80", rule);
                for (const FillRule drawn : {FillRule::Closed, FillRule::Open}) {
                    QCOMPARE(wrongIn(scene, under(scene, drawn), {Leeway::Edges}), std::int64_t(0));
                    QVERIFY(wrongIn(scene, under(scene, drawn), {Leeway::Once}) >= 7);
                }
            }
        }
    }

    /// No two of them lie side by side.
    void edgesOnOneSideAreFree()
    {
        const Scene scene = sceneOf(fold());
        for (const FillRule drawn : {FillRule::Closed, FillRule::Open})
            QCOMPARE(wrongIn(scene, under(scene, drawn), {Leeway::Once}), std::int64_t(0));
    }

    void aThirdColourIsWrong()
    {
        const Scene scene = sceneOf(fan());
        Picture found = pictureOf(scene);
        found.colours[found.placeOf(6, int(pictureLine(scene.frame, 6)))] = Colour{{9, 9, 9}};
        QCOMPARE(wrongIn(scene, found, {Leeway::Edges}), std::int64_t(1));
    }

    /// A sample whose level is next to a half may be blended from either byte.
    void blendedLevelsMayBeRounded()
    {
        Scene scene = sceneOf({quad().front()});
        scene.triangles[0].vertices[0].colour = Colour{{0, 0, 0}};
        Scene single = scene;
        single.settings.arithmetic = Arithmetic::Float32;
        single.method = "interpolate-plane";
        QCOMPARE(wrongIn(scene, pictureOf(single), {Leeway::Rule}), std::int64_t(0));
        Picture found = pictureOf(scene);
        Colour &inside = found.colours[found.placeOf(8, int(pictureLine(scene.frame, 4)))];
        inside.channels[0] = std::uint8_t(inside.channels[0] + 2);
        QCOMPARE(wrongIn(scene, found, {Leeway::Rule}), std::int64_t(1));
    }

    /// Picture and trace say the same of a closed program.
    void aClosedSceneIsDrawnOnceToo()
    {
        const Scene closed = sceneOf(quad());
        const Scene judged = judgedScene(closed, {Leeway::Once});
        QCOMPARE(judged.settings.fillRule, FillRule::HalfOpenColumn);
        QCOMPARE(judgedScene(closed, {Leeway::Edges}).settings.fillRule, FillRule::Closed);
        QVERIFY(wrongIn(closed, pictureOf(closed), {Leeway::Once}) >= 7);
        const Scene opaque = sceneOf(quad(), "ff");
        QCOMPARE(judgedScene(opaque, {Leeway::Once}), opaque);
        QCOMPARE(wrongIn(opaque, pictureOf(opaque), {Leeway::Once}), std::int64_t(0));
    }

    /// A column walk in single precision ends there at 38 and a little, the next edge begins at 38.
    void theMiddleVertexOfARoundedEdgeIsOpen()
    {
        Scene scene;
        scene.frame.width = scene.frame.height = 48;
        scene.settings.fillRule = FillRule::HalfOpenColumn;
        const Triangle triangle{
            {{{latticePixel(14, 30), {}}, {latticePixel(34, 38), {}}, {latticePixel(38, 17), {}}}}};
        const TriangleMargin margin(triangle, scene, {});
        QCOMPARE(margin.containmentOf(34, 38), Containment::Undecided);
        QCOMPARE(margin.containmentOf(34, 37), Containment::Inside);
        QCOMPARE(margin.containmentOf(34, 39), Containment::Outside);
    }

    void fewDigitsStandForEveryLevelWithinThem_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<int>("byte");
        // The level at (1, 0) is 49/20 = 2.45.
        QTest::newRow("one digit") << QByteArray("pixel 1 0 2.5 2.5 2.5\n") << 2;
        QTest::newRow("two digits") << QByteArray("pixel 1 0 2.45 2.45 2.45\n") << 2;
        QTest::newRow("beyond its digits") << QByteArray("pixel 1 0 2.51 2.51 2.51\n") << 3;
        QTest::newRow("a byte") << QByteArray("pixel 1 0 3 3 3\n") << 3;
    }
    void fewDigitsStandForEveryLevelWithinThem()
    {
        QFETCH(QByteArray, line);
        QFETCH(int, byte);
        Scene scene = sceneOf({"[[0, 0], [20, 0], [0, 20]]"}, {});
        scene.triangles[0].vertices[0].colour = Colour{{0, 0, 0}};
        scene.triangles[0].vertices[1].colour = Colour{{49, 49, 49}};
        scene.triangles[0].vertices[2].colour = Colour{{0, 0, 0}};
        const Picture picture = *readStudentOutput(line, scene)->picture;
        const Colour &found = picture.colours[picture.placeOf(1, 15)];
        QCOMPARE(int(found.channels[0]), byte);
    }

    /// The picture is by another rule, its colours are exchanged.
    void aDefectIsToldApartFromTheChoiceOfAnOwner()
    {
        const Scene scene = sceneOf({"[[1, 1], [13, 1], [13, 13]]", "[[1, 1], [13, 13], [1, 13]]"},
                                    "ff", "\"method\": \"edge-equations\", ");
        for (const FillRule rule : {FillRule::TopLeft, FillRule::Open}) {
            Scene other = scene;
            other.settings.fillRule = rule;
            Picture found = pictureOf(other);
            for (Colour &colour : found.colours)
                std::swap(colour.channels[0], colour.channels[2]);
            const auto diagnosis
                = diagnose(std::vector{Submission{scene, found}}, {}, {Leeway::Edges});
            QCOMPARE(diagnosis->verdict, DiagnosisVerdict::Wrong);
            QCOMPARE(idsOf(diagnosis->candidates.front()), u"channels-bgr-in-place-of-rgb"_s);
        }
    }

    void noMistakeIsNamedWhereAllIsOpen()
    {
        const Scene scene = sceneOf(quad(), "ff", "\"method\": \"edge-equations\", ");
        Scene other = scene;
        for (const FillRule rule : {FillRule::TopLeft, FillRule::HalfOpenColumn}) {
            other.settings.fillRule = rule;
            const Submission submission{scene, pictureOf(other)};
            const auto diagnosis = diagnose(std::vector{submission}, {}, {Leeway::Edges});
            QCOMPARE(diagnosis->verdict, DiagnosisVerdict::Undecidable);
            for (const DiagnosisCandidate &candidate : diagnosis->candidates) {
                for (const Defect &defect : candidate.defects)
                    QVERIFY2(defect.isRightAlone || defect.choice == QLatin1String(ruleChoice),
                             qPrintable(idsOf(candidate)));
            }
        }
    }
};

PIXELPLUMB_TEST(TestSharedEdges)

} // namespace tst_sharededges

#include "tst_sharededges.moc"
