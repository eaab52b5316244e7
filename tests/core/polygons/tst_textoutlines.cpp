// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/textoutlines.h"
#include "core/runs/explain/rejectedprimitives.h"
#include "tests/support/scenes/polygons.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <cmath>
#include <future>

namespace tst_textoutlines {

using namespace pixelplumb;

namespace {

Shape textOf(const char *words, const LatticePoint &start, Lattice height)
{
    Shape text;
    text.kind = PrimitiveKind::Text;
    text.vertices = {{start, green}};
    text.text = words;
    text.textHeight = height;
    return text;
}

} // namespace

/// Text as outlines (Rasterization slides, "Output Primitives"), filled by the polygon kernel.
class TestTextOutlines : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (textFontFile().isEmpty())
            QSKIP("DejaVu Sans is not installed (fonts-dejavu-core)");
    }

    void eachGlyphIsItsOutlinesFilledByWinding()
    {
        for (const char *words : {"A", "g", "8", "%", "Ag8%", "Å∮ß"}) {
            for (const Lattice height : {Lattice(9 * 256), Lattice(30 * 256 + 77)}) {
                const Scene scene = sceneOf({textOf(words, {300, 2200}, height)}, frameOf(120, 40),
                                            "text-outlines");
                const auto traced = traceScene(scene);
                QCOMPARE(traced->differences.total(), 0);
                QVERIFY(traced->trace->writtenCount() > 10);
                QCOMPARE(drawn(scene), truthOf(scene));
            }
        }
    }

    /// A long text's outlines take hundreds of megabytes.
    void threadsThatAskAtOnceShareThem()
    {
        const Shape text = textOf(std::string(10'000, 'a').c_str(), {0, 0}, 2560);
        const auto ask = [&text] { return sharedOutlinesOf(text); };
        auto one = std::async(std::launch::async, ask);
        auto other = std::async(std::launch::async, ask);
        QCOMPARE(one.get(), other.get());
    }

    void aTextWithoutAMarkIsSaidToHaveNoOutline()
    {
        for (const char *words : {"", " ", "   ", "\u2003"}) {
            const Scene scene
                = sceneOf({textOf(words, {300, 2200}, 2304)}, frameOf(60, 40), "text-outlines");
            const auto rejected = rejectedPrimitives(SceneRun(scene));
            QCOMPARE(rejected.size(), std::size_t(1));
            QVERIFY(rejected.front().rejection == PrimitiveRejection::NoOutline);
            QVERIFY(rejected.front().message().contains(u"has no outline"_s));
        }
    }

    void aTextIsTheSamePictureAsThePolygonOfItsOutlines()
    {
        const Shape text = textOf("Ag8%", latticePixel(2, 9), 30 * 256);
        const Shape polygon = outlinesOf(text).polygon;
        QCOMPARE(polygon.fill, ShapeFill::NonZero);
        QCOMPARE(polygon.laterContours.size() + 1, std::size_t(2 + 2 + 3 + 5));
        const Scene asText = sceneOf({text}, frameOf(100, 40), "text-outlines");
        const Scene asPolygon = sceneOf({polygon}, frameOf(100, 40), "polygon-parity");
        const Scene asTriangles = sceneOf({polygon}, frameOf(100, 40), "polygon-delaunay");
        QCOMPARE(drawn(asText), drawn(asPolygon));
        QCOMPARE(drawn(asTriangles), drawn(asPolygon));
    }

    void theFootOfASmallLFallsBetweenTwoRows()
    {
        // The L of DejaVu Sans: a stem from 201 to 403 and a foot up to 170, in 1/2048 em.
        QCOMPARE(drawn(sceneOf({textOf("L", latticePixel(0, 0), 12 * 256)}, frameOf(8, 10),
                               "text-outlines")),
                 u"........\n"
                 "..#.....\n"
                 "..#.....\n"
                 "..#.....\n"
                 "..#.....\n"
                 "..#.....\n"
                 "..#.....\n"
                 "..#.....\n"
                 "..#.....\n"
                 "........\n"_s);
    }

    void textStandsUprightWhereYGrowsDownward()
    {
        Scene upward = sceneOf({textOf("Ag", latticePixel(2, 12), 20 * 256)}, frameOf(40, 40),
                               "text-outlines");
        Scene downward = upward;
        downward.frame.origin = FrameOrigin::TopLeft;
        // The middle line of an odd frame would be its own mirror image; here row 12 becomes 27,
        // and the rule for samples on the boundary is mirrored with the frame.
        downward.shapes = {textOf("Ag", {2 * 256, 27 * 256}, 20 * 256)};
        const QStringList up = drawn(upward).split(u'\n', Qt::SkipEmptyParts);
        QStringList down = drawn(downward).split(u'\n', Qt::SkipEmptyParts);
        std::ranges::reverse(down);
        int different = 0;
        for (int line = 0; line < 40; ++line) {
            for (int x = 0; x < 40; ++x)
                different += int(up[line][x] != down[line][x]);
        }
        QVERIFY(different < 30); // of about 250 pixels: only those whose samples lie on an outline
        QCOMPARE(drawn(downward), truthOf(downward));
    }

    void theEmIsTheHeightAndAdvancesAddUp()
    {
        // No rounding on the way: at 2048 units per em, every font unit is one lattice unit.
        const Shape one = outlinesOf(textOf("A", {0, 0}, 2048)).polygon;
        const Shape second = outlinesOf(textOf("AA", {0, 0}, 2048)).polygon;
        QCOMPARE(second.vertices.size(), 2 * one.vertices.size());
        for (std::size_t i = 0; i < one.vertices.size(); ++i) {
            const LatticePoint &first = one.vertices[i].position;
            const LatticePoint &next = second.vertices[one.vertices.size() + i].position;
            QCOMPARE(next.x - first.x, Lattice(1401));
            QCOMPARE(next.y, first.y);
        }
    }

    void theNextGlyphStandsAtTheAdvance()
    {
        const Lattice em = 64 * unitsPerPixel;
        const Lattice advance = advanceOf(textOf("l", {0, 0}, em));
        const auto last = [&](const char *words) {
            return outlinesOf(textOf(words, {0, 0}, em)).polygon.vertices.back().position.x;
        };

        // To within a lattice unit: points are rounded, the advance is truncated.
        QVERIFY(std::abs(double(last("lA") - last("A") - advance)) <= 1);
        QCOMPARE(advanceOf(textOf("l", {0, 0}, -em)), advance);
        QCOMPARE(advanceOf(textOf("", {0, 0}, em)), Lattice(0));
    }

    void chordsLeaveTheirCurvesByAtMostAThirtySecondOfAPixel()
    {
        // An outline at 64 times the size has finer chords; its points lie near those of the coarse
        // one.
        const Shape coarse = outlinesOf(textOf("o", {0, 0}, 40 * 256)).polygon;
        const Shape fine = outlinesOf(textOf("o", {0, 0}, 40 * 256 * 64)).polygon;
        double farthest = 0;
        for (const Vertex &vertex : fine.vertices) {
            const double x = double(vertex.position.x) / 64;
            const double y = double(vertex.position.y) / 64;
            double nearest = 1e9;
            std::size_t first = 0;
            for (std::size_t i = 0; i < coarse.vertices.size(); ++i) {
                const bool ends = i + 1 == coarse.vertices.size()
                    || std::ranges::find(coarse.laterContours, i + 1) != coarse.laterContours.end();
                const LatticePoint a = coarse.vertices[i].position;
                const LatticePoint b = coarse.vertices[ends ? first : i + 1].position;
                if (ends)
                    first = i + 1;
                const double dx = double(b.x - a.x);
                const double dy = double(b.y - a.y);
                const double length = dx * dx + dy * dy;
                const double t = length > 0
                    ? std::clamp(((x - double(a.x)) * dx + (y - double(a.y)) * dy) / length, 0., 1.)
                    : 0;
                nearest = std::min(nearest,
                                   std::hypot(x - double(a.x) - t * dx, y - double(a.y) - t * dy));
            }
            farthest = std::max(farthest, nearest);
        }
        QVERIFY2(farthest <= 256. / 32 + 1, qPrintable(QString::number(farthest)));
        QVERIFY(farthest > 1); // otherwise the bound is not tested
    }

    void aTextBeyondTheLatticeIsRefused()
    {
        const auto rejectionOfText = [](const Shape &text) {
            return traceScene(sceneOf({text}, frameOf(9, 9), "text-outlines"))
                ->trace->setUp(0)
                .rejection;
        };
        QCOMPARE(rejectionOfText(textOf("WWW", {0, 0}, largestCoordinate)),
                 PrimitiveRejection::OutlineTooLarge);
        QCOMPARE(rejectionOfText(textOf("W", {largestCoordinate, 0}, 256)),
                 PrimitiveRejection::OutlineTooLarge);
        QCOMPARE(rejectionOfText(textOf("", {0, 0}, 256)), PrimitiveRejection::NoOutline);
    }
};

PIXELPLUMB_TEST(TestTextOutlines)

} // namespace tst_textoutlines

#include "tst_textoutlines.moc"
