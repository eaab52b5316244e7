// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framebuffer.h"
#include "core/lab/study/familyaccuracy.h"
#include "core/scan/choicenames.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>

namespace tst_straightloops {

using namespace pixelplumb;

namespace {

/// A larger number would take long in the slowest methods.
constexpr std::size_t mostDrawn = 60;

LabFamily familyNamed(const char *id)
{
    FamilyRequest request;
    request.ownScene = std::make_shared<const Scene>(defaultSceneIn(Arithmetic::Exact));
    return *makeFamily(*labFamilyNamed(QString::fromLatin1(id)), request);
}

/// The families whose triangles straight loops may draw.
constexpr const char *drawnFamilies[]
    = {"random-integer", "random-subpixel", "slivers", "ties",     "far",
       "small",          "large",           "mesh",    "own-scene"};

LabContender contenderOf(const StraightLoop &loop)
{
    return pixelplumb::contenderOf(*methodNamed(QString::fromLatin1(loop.method)), loop.arithmetic);
}

Triangle triangleAt(const LatticePoint &a, const LatticePoint &b, const LatticePoint &c)
{
    return {{{{a, {{250, 10, 0}}}, {b, {{0, 200, 90}}}, {c, {{30, 60, 255}}}}}};
}

} // namespace

/// Straight loops against the plain kernels that are compared with them.
class TestStraightLoops : public QObject {
    Q_OBJECT

private slots:
    void eachDrawsThePicturesOfItsKernel_data()
    {
        QTest::addColumn<std::size_t>("index");
        const std::vector<StraightLoop> loops = straightLoops();
        for (std::size_t index = 0; index < loops.size(); ++index)
            QTest::newRow(qPrintable(contenderOf(loops[index]).id)) << index;
    }
    void eachDrawsThePicturesOfItsKernel()
    {
        QFETCH(std::size_t, index);
        const StraightLoop loop = straightLoops()[index];
        const LabContender contender = contenderOf(loop);
        for (const char *id : drawnFamilies) {
            const LabFamily family = familyNamed(id);
            const auto settings = settingsFor(contender, family);
            QVERIFY2(settings, id);
            const LabPicture &picture = family.pictures.front();
            const FrameBuffer byKernel(picture.frame);
            const FrameBuffer byLoop(picture.frame);
            const StraightDraw draw = loop.drawUnder(settings->fillRule, picture.frame.origin);
            QVERIFY2(draw, id);
            Primitives primitives;
            for (const Triangle &triangle : picture.triangles) {
                if (primitives.triangles.size() < mostDrawn
                    && mayDrawStraight(loop, triangle, byLoop.view()))
                    primitives.triangles.push_back(triangle);
            }
            for (const Triangle &triangle : primitives.triangles)
                draw(triangleFor(loop, triangle), rawFrameFor(loop, byLoop.view()));
            contender.runOf(primitives, *settings, byKernel.view()).draw(byKernel.view());
            QVERIFY2(byLoop.image() == byKernel.image(), id);
            // 16.16 draws only whole pixels.
            QVERIFY2(!primitives.triangles.empty() || loop.arithmetic == Arithmetic::Fixed16, id);
        }
    }

    void everyTriangleOfTheMadeFamiliesMayBeDrawn()
    {
        for (const char *id : drawnFamilies) {
            const LabFamily family = familyNamed(id);
            const LabPicture &picture = family.pictures.front();
            const FrameBuffer frame(picture.frame);
            const StraightLoop &loop = *straightLoopOf("column-scan", Arithmetic::Exact);
            QVERIFY2(std::ranges::all_of(picture.triangles,
                                         [&](const Triangle &triangle) {
                                             return mayDrawStraight(loop, triangle, frame.view());
                                         }),
                     id);
        }
    }

    void whatTheyCannotDrawTheyMayNotDraw_data()
    {
        QTest::addColumn<Triangle>("triangle");
        QTest::addColumn<bool>("whole"); ///< whether a loop in 16.16 may draw it
        QTest::addColumn<bool>("any"); ///< whether the others may
        const LatticePoint a = latticePixel(2, 2), b = latticePixel(61, 5),
                           c = latticePixel(20, 45);
        QTest::newRow("2 px inside") << triangleAt(a, b, c) << true << true;
        QTest::newRow("between pixels") << triangleAt({a.x + 1, a.y}, b, c) << false << true;
        QTest::newRow("at the frame's left")
            << triangleAt(latticePixel(1, 2), b, c) << false << false;
        QTest::newRow("at its top") << triangleAt(a, b, latticePixel(20, 46)) << false << false;
        QTest::newRow("without area") << triangleAt(a, b, a) << false << false;
    }
    void whatTheyCannotDrawTheyMayNotDraw()
    {
        QFETCH(Triangle, triangle);
        QFETCH(bool, whole);
        QFETCH(bool, any);
        const FrameBuffer frame{FrameSpec()};
        for (const StraightLoop &loop : straightLoops()) {
            QCOMPARE(mayDrawStraight(loop, triangle, frame.view()),
                     loop.arithmetic == Arithmetic::Fixed16 ? whole : any);
        }
    }

    void aRuleThatNoLoopKeepsHasNone()
    {
        const StraightLoop &columns = *straightLoopOf("column-scan", Arithmetic::Exact);
        const StraightLoop &rows = *straightLoopOf("row-walk", Arithmetic::Exact);
        using enum FrameOrigin;
        QVERIFY(columns.drawUnder(FillRule::HalfOpenColumn, TopLeft));
        QVERIFY(!columns.drawUnder(FillRule::TopLeft, BottomLeft));
        QVERIFY(!columns.drawUnder(FillRule::Open, BottomLeft));
        QVERIFY(rows.drawUnder(FillRule::TopLeft, BottomLeft));
        QVERIFY(!rows.drawUnder(FillRule::TopLeft, TopLeft));
        QVERIFY(!straightLoopOf("barycentric-all", Arithmetic::Exact));
    }
};

PIXELPLUMB_TEST(TestStraightLoops)

} // namespace tst_straightloops

#include "tst_straightloops.moc"
