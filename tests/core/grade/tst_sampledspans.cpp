// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seededrandom.h"
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/diagnose/frameconvention.h"
#include "core/grade/diagnose/readconvention.h"
#include "core/grade/diagnose/sampledspans.h"
#include "core/grade/scan/redrawing.h"
#include "core/scan/choicenames.h"
#include "tests/support/casestorun.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_sampledspans {

using namespace pixelplumb;

namespace {

/// Two triangles of a scene whose picture is large.
Scene largeScene(const QString &method, int width, int height)
{
    Scene scene;
    scene.frame.width = width;
    scene.frame.height = height;
    scene.method = method.toStdString();
    const auto at = [&](int x, int y, const Colour &colour) {
        return Vertex{{Lattice(x) * width * unitsPerPixel / 100 + 13,
                       Lattice(y) * height * unitsPerPixel / 100 + 7},
                      colour};
    };
    const Vertex a = at(4, 7, {{230, 20, 60}});
    const Vertex b = at(96, 26, {{40, 210, 90}});
    const Vertex c = at(26, 95, {{70, 90, 255}});
    const Vertex d = at(98, 97, {{250, 240, 30}});
    scene.triangles = {Triangle{{a, b, c}}, Triangle{{b, d, c}}};
    return scene;
}

void addMethods()
{
    QTest::addColumn<QString>("method");
    for (const char *method :
         {"column-scan", "row-walk", "edge-equations", "barycentric-rectangle"})
        QTest::newRow(method) << QString::fromLatin1(method);
}

} // namespace

/// A large picture is searched by some of its spans, and any is refused before it is drawn whole.
class TestSampledSpans : public QObject {
    Q_OBJECT

private slots:
    void everyDefectIsDrawnInSpansAsInTheWhole_data() { addMethods(); }
    void everyDefectIsDrawnInSpansAsInTheWhole()
    {
        QFETCH(QString, method);
        const Scene scene = largeScene(method, 256, 144);
        DefectPictures pictures({scene});
        const Picture right = *pictures.picture(0, {});
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < pictures.defects().size(); ++i)
            places.push_back(i);
        int told = 0;
        for (const std::size_t place : casesToRun(places)) {
            const auto drawn = pictures.picture(0, {place});
            if (!drawn || *drawn == right)
                continue;
            const std::vector<FoundPicture> found = {{0, *drawn}};
            const SampledSpans spans(pictures, found);
            QVERIFY(spans.areSampled());
            const std::int64_t differing = differingPixels(right, *drawn);
            const auto itself = spans.distance({place}, differing);
            const auto theRight = spans.distance({}, differing);
            QVERIFY(theRight && *theRight == differing);
            if (!itself)
                continue;
            QVERIFY2(*itself == 0, qPrintable(pictures.defects()[place].id));
            ++told;
        }
        QVERIFY(told > 8);
    }

    void whatWasNotLookedAtIsTold()
    {
        const auto sampledOf = [](int width, int height) {
            const Scene scene = largeScene(u"column-scan"_s, width, height);
            Picture found = pictureOf(scene);
            for (std::size_t place = 0; place < found.size(); place += 7)
                found.colours[place].channels[0] ^= 85;
            return diagnose(std::vector{Submission{scene, found}})->sampled;
        };
        const auto large = sampledOf(256, 144);
        QVERIFY(large);
        QCOMPARE(sampledText(*large),
                 u"sets that only come near were looked for in 16 of 256 columns or rows: a nearer "
                 "one may be missing"_s);
        QVERIFY(!sampledOf(64, 48));
    }

    void aSmallPictureIsDrawnWhole()
    {
        const Scene scene = largeScene(u"column-scan"_s, 64, 48);
        DefectPictures pictures({scene});
        Picture found = *pictures.picture(0, {});
        found.colours[found.placeOf(20, 20)] = {};
        const std::vector<FoundPicture> all = {{0, found}};
        QVERIFY(!SampledSpans(pictures, all).areSampled());
    }

    void whatIsRefusedDiffersByTheLimit_data() { addMethods(); }
    void whatIsRefusedDiffersByTheLimit()
    {
        QFETCH(QString, method);
        const Scene scene = largeScene(method, 64, 48);
        DefectPictures whole({scene});
        DefectPictures refused({scene});
        const auto most = std::int64_t(whole.defects().size()) - 1;
        SeededRandom random(5);
        const auto any = [&] { return std::size_t(random.between(0, most)); };
        std::vector<FoundPicture> found = {{0, *whole.picture(0, {any()})}};
        for (std::size_t place = 0; place < found[0].picture.size(); place += 3)
            found[0].picture.colours[place].channels[1] ^= 9;
        PictureMatcher matcher(refused, found, {});
        for (int i = 0; i < 600; ++i) {
            const std::size_t one = any();
            const std::size_t other = any();
            const DefectSet set{std::min(one, other), std::max(one, other)};
            const bool isPair
                = one != other && canBeTogether(whole.defects()[one], whole.defects()[other]);
            const auto picture = isPair ? whole.picture(0, set) : nullptr;
            const std::int64_t limit = random.between(1, 2000);
            if (picture)
                QCOMPARE(matcher.distance(set, limit),
                         differingPixels(*picture, found[0].picture, limit));
        }
    }

    void chosenSpansOfARedrawingAreThoseOfTheWhole_data() { addMethods(); }
    void chosenSpansOfARedrawingAreThoseOfTheWhole()
    {
        QFETCH(QString, method);
        Scene scene = largeScene(method, 64, 48);
        scene.frame.firstColumn = 3;
        scene.frame.firstRow = -2;
        const ChosenSpans chosen{methodNamed(method)->spanAxis, {5, 6, 17, 30, 44}};
        for (const Defect &defect : defectsFor(scene)) {
            if (!defect.redrawing)
                continue;
            const Picture whole = redrawn(scene, *defect.redrawing);
            QVERIFY2(redrawn(scene, *defect.redrawing, &chosen)
                         == partOf(whole, scene.frame, chosen),
                     qPrintable(defect.id));
        }
        QVERIFY(pictureOf(scene, chosen) == partOf(pictureOf(scene), scene.frame, chosen));
    }

    void theConventionOfALargePictureIsReadOffSomeColumns()
    {
        Scene scene = largeScene(u"column-scan"_s, 256, 144);
        const auto between = [](int x, int y) { // pixels, where another centre has samples
            return Vertex{
                {Lattice(x) * unitsPerPixel + halfPixel, Lattice(y) * unitsPerPixel + halfPixel},
                {{90, 200, 10}}};
        };
        scene.triangles.push_back({{between(40, 20), between(200, 20), between(40, 100)}});
        Scene read = sceneIn(scene, FrameConvention::OtherBoth);
        read.settings.fillRule = FillRule::HalfOpenColumn;
        Picture found = pictureOf(read);
        for (std::size_t place = 0; place < found.size(); place += 9)
            found.colours[place].channels[1] ^= 9;
        DefectPictures pictures({scene});
        const std::vector<FoundPicture> all = {{0, found}};
        const auto convention = readConvention(pictures, all);
        QVERIFY(convention.has_value());
        QStringList told;
        for (const Defect &defect : convention->told)
            told += defect.id;
        QCOMPARE(told,
                 (QStringList{"other-origin-and-centre",
                              u"rule-"_s + nameText(nameOf(read.settings.fillRule))}));
        // Whole, the 79 other conventions would be that many pictures.
        QVERIFY(pictures.work().pixels < 20 * std::int64_t(found.size()));
    }

    /// The work is counted: less than drawing each defect once, and a thousandth of all pairs.
    void aLargePictureTakesFewPictures_data()
    {
        QTest::addColumn<int>("every"); // every so many rows are wrong
        QTest::newRow("half of it wrong") << 2;
        QTest::newRow("little of it wrong") << 97;
    }
    void aLargePictureTakesFewPictures()
    {
        QFETCH(int, every);
        const Scene scene = largeScene(u"column-scan"_s, 256, 144);
        Picture found = pictureOf(scene);
        for (std::size_t place = 0; place < found.size(); ++place) {
            if (found.covered[place] != 0 && place % std::size_t(every) == 0)
                found.colours[place].channels[1] ^= 9;
        }
        const auto diagnosis = diagnose(std::vector{Submission{scene, found}});
        QVERIFY(!diagnosis->isExplained());
        const std::size_t defects = defectsFor(scene).size();
        QVERIFY(std::size_t(diagnosis->work.pictures) < 3 * defects);
    }
};

PIXELPLUMB_TEST(TestSampledSpans)

} // namespace tst_sampledspans

#include "tst_sampledspans.moc"
