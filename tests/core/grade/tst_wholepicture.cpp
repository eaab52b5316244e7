// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/pictures/picturediff.h"
#include "core/scene/scenefile.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QSize>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace tst_wholepicture {

using namespace pixelplumb;

namespace {

constexpr Colour white{{255, 255, 255}};

std::vector<Scene> probes()
{
    std::vector<Scene> scenes;
    for (int i = 1; i <= 3; ++i)
        scenes.push_back(readSceneFile(resource(u"/probes/column-scan-%1.json"_s).arg(i))->scene);
    return scenes;
}

/// A pixel in a frame; `row` is counted as the program does.
struct Place {
    int x = 0, row = 0;
    int width = 0, height = 0;
};
using AddressOf = int (*)(const Place &at); // < 0: not written
using ByteOf = int (*)(double level); // 0 … 1
using SceneChange = void (*)(Scene &scene);

/// A triangle without samples on its edges except the vertices, one of which has a level of 255.
Triangle levelTriangle()
{
    return {{{{latticePixel(3, 2), {{255, 12, 90}}},
              {latticePixel(27, 9), {{31, 200, 255}}},
              {latticePixel(10, 28), {{120, 77, 3}}}}}};
}

/// R, G or B of that triangle's plane by barycentric weights, 0 … 255.
double levelAt(int x, int y, std::size_t channel)
{
    const auto doubled = [](double ax, double ay, double bx, double by, double cx, double cy) {
        return (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    };
    const double whole = doubled(3, 2, 27, 9, 10, 28);
    const double weights[]
        = {doubled(x, y, 27, 9, 10, 28) / whole, doubled(3, 2, x, y, 10, 28) / whole,
           doubled(3, 2, 27, 9, x, y) / whole};
    double level = 0;
    for (std::size_t i = 0; i < 3; ++i)
        level += weights[i] * levelTriangle().vertices[i].colour.channels[channel];
    return level;
}

void move(Scene &scene, double dx, double dy) // px
{
    for (Triangle &triangle : scene.triangles) {
        for (Vertex &vertex : triangle.vertices) {
            vertex.position.x += Lattice(dx * double(unitsPerPixel));
            vertex.position.y += Lattice(dy * double(unitsPerPixel));
        }
    }
}

using Recolouring = Colour (*)(const Colour &right, bool isCovered);

/// The picture as a program would write it: only the colours tell what is covered.
Submission submissionOf(const Scene &scene, Recolouring change)
{
    Picture picture = pictureOf(scene);
    for (std::size_t i = 0; i < picture.size(); ++i)
        picture.colours[i] = change(picture.colours[i], picture.covered[i] != 0);
    coverAllBut(scene.frame.background, picture);
    return {scene, picture};
}

} // namespace

/// What programs do to a picture besides drawing: another frame colour, a mask, nothing.
class TestWholePicture : public QObject {
    Q_OBJECT

private slots:
    void whatIsDoneToAWholePictureIsNamedAlone_data()
    {
        QTest::addColumn<Recolouring>("change");
        const auto row
            = [](const char *name, Recolouring change) { QTest::newRow(name) << change; };
        row("drawn-on-white",
            [](const Colour &right, bool isCovered) { return isCovered ? right : white; });
        row("drawn-in-white-alone",
            [](const Colour &right, bool isCovered) { return isCovered ? white : right; });
        row("nothing-drawn", [](const Colour &, bool) { return Colour(); });
        row("gray-of-the-luma-of-r-g-b", [](const Colour &right, bool) { // as PIL's convert("L")
            const auto &[red, green, blue] = right.channels;
            const auto gray
                = std::uint8_t((19595 * red + 38470 * green + 7471 * blue + 32768) / 65536);
            return Colour{{gray, gray, gray}};
        });
        row("cut-to-5-6-5-bits", [](const Colour &right, bool) {
            return Colour{{std::uint8_t(right.channels[0] & 0xf8),
                           std::uint8_t(right.channels[1] & 0xfc),
                           std::uint8_t(right.channels[2] & 0xf8)}};
        });
        row("cut-to-5-6-5-bits-and-widened-to-all-levels", [](const Colour &right, bool) {
            const auto widened = [](int kept, int bits) { // repeats the highest bits as the lowest
                return std::uint8_t(kept * (1 << (8 - bits)) + kept / (1 << (2 * bits - 8)));
            };
            return Colour{{widened(right.channels[0] / 8, 5), widened(right.channels[1] / 4, 6),
                           widened(right.channels[2] / 8, 5)}};
        });
    }
    void whatIsDoneToAWholePictureIsNamedAlone()
    {
        QFETCH(Recolouring, change);
        std::vector<Submission> submissions;
        for (const Scene &scene : probes()) {
            QCOMPARE(scene.frame.background, Colour());
            submissions.push_back(submissionOf(scene, change));
        }

        const auto diagnosis = diagnose(submissions);

        QVERIFY(diagnosis);
        // Two defects that each draw no triangle together draw none, too.
        const auto alone
            = std::ranges::count_if(diagnosis->candidates, [](const DiagnosisCandidate &candidate) {
                  return candidate.defects.size() == 1;
              });
        QCOMPARE(alone, std::ptrdiff_t(1));
        QCOMPARE(diagnosis->candidates.front().defects.size(), std::size_t(1));
        QCOMPARE(diagnosis->candidates.front().defects.front().id,
                 QString::fromLatin1(QTest::currentDataTag()));
    }

    void whatIsWrittenAtAnotherAddressIsNamed_data()
    {
        QTest::addColumn<QSize>("frame");
        QTest::addColumn<AddressOf>("addressOf");
        QTest::addColumn<bool>("fromTop");
        QTest::addColumn<QString>("id");
        const AddressOf byHeight = [](const Place &at) { return at.row * at.height + at.x; };
        const AddressOf byColumns = [](const Place &at) { return at.x * at.height + at.row; };
        const AddressOf exchanged = [](const Place &at) {
            return at.row < at.width && at.x < at.height ? at.x * at.width + at.row : -1;
        };
        for (const QSize size : {QSize(48, 30), QSize(30, 48)}) {
            for (const auto &[from, fromTop] :
                 {std::pair("top", true), std::pair("bottom", false)}) {
                const auto row = [&, fromTop = fromTop](const QString &id, AddressOf addressOf) {
                    QTest::addRow("%s, %d × %d", qPrintable(id), size.width(), size.height())
                        << size << addressOf << fromTop << id;
                };
                const QString end = u"-from-the-%1-on"_s.arg(QLatin1String(from));
                row(u"rows-stored-as-far-apart-as-columns-are-high"_s + end, byHeight);
                row(u"columns-stored-in-place-of-rows"_s + end, byColumns);
                row(fromTop ? u"lines-and-columns-exchanged"_s : u"x-and-y-exchanged"_s, exchanged);
            }
        }
    }
    void whatIsWrittenAtAnotherAddressIsNamed()
    {
        QFETCH(QSize, frame);
        QFETCH(AddressOf, addressOf);
        QFETCH(bool, fromTop);
        QFETCH(QString, id);
        Scene scene;
        scene.frame.width = frame.width();
        scene.frame.height = frame.height();
        scene.triangles = {levelTriangle()};
        const Picture right = pictureOf(scene);
        Picture found = right;
        std::ranges::fill(found.colours, Colour());
        for (int line = 0; line < right.height; ++line) {
            for (int x = 0; x < right.width; ++x) {
                const int row = fromTop ? line : right.height - 1 - line;
                const int address = addressOf({x, row, right.width, right.height});
                if (right.covered[right.placeOf(x, line)] == 0 || address < 0
                    || address >= int(right.size()))
                    continue;
                const int readRow = address / right.width;
                const int readLine = fromTop ? readRow : right.height - 1 - readRow;
                found.colours[found.placeOf(address % right.width, readLine)]
                    = right.colours[right.placeOf(x, line)];
            }
        }
        coverAllBut(Colour(), found);

        const auto diagnosis = diagnose(std::vector{Submission{scene, found}});

        QVERIFY(diagnosis && diagnosis->isExplained());
        QCOMPARE(diagnosis->candidates.front().ids(), QStringList{id});
    }

    void anotherFactorThan255IsNamed_data()
    {
        QTest::addColumn<ByteOf>("byteOf");
        QTest::addColumn<QString>("ids");
        const auto row = [](const char *name, ByteOf byteOf, const char *ids) {
            QTest::newRow(name) << byteOf << QString::fromLatin1(ids);
        };
        row(
            "(int)(254 * c + 0.5)", [](double c) { return int(254 * c + 0.5); },
            "levels-times-254");
        row(
            "(int)(254 * c)", [](double c) { return int(254 * c); },
            "rounding-truncate and levels-times-254");
        row(
            "(int)(256 * c), wrapping", [](double c) { return int(256 * c) % 256; },
            "levels-times-256-wrapping");
        row(
            "min(255, (int)(256 * c))", [](double c) { return std::min(255, int(256 * c)); },
            "levels-times-256");
        row(
            "(int)(255.999 * c)", [](double c) { return int(255.999 * c); }, "levels-times-256");
    }
    void anotherFactorThan255IsNamed()
    {
        QFETCH(ByteOf, byteOf);
        QFETCH(QString, ids);
        Scene scene;
        scene.frame.width = 40;
        scene.frame.height = 40;
        scene.triangles = {levelTriangle()};
        Picture found = pictureOf(scene);
        for (int y = 0; y < 40; ++y) {
            for (int x = 0; x < 40; ++x) {
                const std::size_t place = found.placeOf(x, 39 - y);
                for (std::size_t i = 0; i < 3 && found.covered[place] != 0; ++i)
                    found.colours[place].channels[i] = std::uint8_t(byteOf(levelAt(x, y, i) / 255));
            }
        }

        const auto diagnosis = diagnose(std::vector{Submission{scene, found}});

        QVERIFY(diagnosis && diagnosis->isExplained());
        QStringList named;
        for (const DiagnosisCandidate &candidate : diagnosis->candidates)
            named += candidate.ids().join(u" and "_s);
        QCOMPARE(named, QStringList{ids});
    }

    void whatIsDrawnOtherwiseIsNamed_data()
    {
        QTest::addColumn<SceneChange>("change");
        const auto row = [](const char *id, SceneChange change) { QTest::newRow(id) << change; };
        row("only-first-drawn", [](Scene &scene) { scene.triangles.resize(1); });
        row("only-last-drawn", [](Scene &scene) { scene.triangles = {scene.triangles.back()}; });
        row("half-pixel-down-in-x", [](Scene &scene) { move(scene, -0.5, 0); });
        row("half-pixel-up-in-x", [](Scene &scene) { move(scene, 0.5, 0); });
        row("half-pixel-down-in-y", [](Scene &scene) { move(scene, 0, -0.5); });
        row("half-pixel-up-in-y", [](Scene &scene) { move(scene, 0, 0.5); });
        row("flat-second", [](Scene &scene) {
            for (Triangle &triangle : scene.triangles)
                triangle.vertices[0].colour = triangle.vertices[2].colour
                    = triangle.vertices[1].colour;
        });
        row("flat-mean", [](Scene &scene) {
            for (Triangle &triangle : scene.triangles) {
                auto &[a, b, c] = triangle.vertices;
                for (std::size_t i = 0; i < 3; ++i)
                    a.colour.channels[i] = std::uint8_t(std::lround(
                        (a.colour.channels[i] + b.colour.channels[i] + c.colour.channels[i])
                        / 3.0));
                b.colour = c.colour = a.colour;
            }
        });
    }
    void whatIsDrawnOtherwiseIsNamed()
    {
        QFETCH(SceneChange, change);
        std::vector<Submission> submissions;
        for (const Scene &scene : probes()) {
            Scene changed = scene;
            change(changed);
            submissions.push_back({scene, pictureOf(changed)});
        }

        const auto diagnosis = diagnose(submissions);

        QVERIFY(diagnosis && diagnosis->isExplained());
        QCOMPARE(diagnosis->candidates.front().ids(),
                 QStringList{QString::fromLatin1(QTest::currentDataTag())});
    }

    void onWhiteADefectOfTheDrawingIsNamedBesideTheBackground()
    {
        std::vector<Submission> submissions;
        for (Scene scene : probes()) {
            const Scene right = scene;
            scene.settings.variants = scene.settings.variants.with(Variant::DivisorPlusOne);
            submissions.push_back(submissionOf(scene, [](const Colour &drawn, bool isCovered) {
                return isCovered ? drawn : white;
            }));
            submissions.back().scene = right;
        }

        const auto diagnosis = diagnose(submissions);

        QVERIFY(diagnosis);
        QCOMPARE(diagnosis->candidates.size(), std::size_t(1));
        QStringList ids;
        for (const Defect &defect : diagnosis->candidates.front().defects)
            ids += defect.id;
        QCOMPARE(ids, QStringList({"divisor-plus-one", "drawn-on-white"}));
    }

    void onAnyOtherColourADefectOfTheDrawingIsNamedBesideTheBackground_data()
    {
        QTest::addColumn<bool>("isRight");
        QTest::addColumn<QStringList>("ids");
        QTest::newRow("drawn right") << true << QStringList{"drawn-on-64-64-64"};
        QTest::newRow("drawn wrong")
            << false << QStringList{"divisor-plus-one", "drawn-on-64-64-64"};
    }
    void onAnyOtherColourADefectOfTheDrawingIsNamedBesideTheBackground()
    {
        QFETCH(bool, isRight);
        QFETCH(QStringList, ids);
        std::vector<Submission> submissions;
        for (const Scene &right : probes()) {
            Scene scene = right;
            if (!isRight)
                scene.settings.variants = scene.settings.variants.with(Variant::DivisorPlusOne);
            submissions.push_back(submissionOf(scene, [](const Colour &drawn, bool isCovered) {
                return isCovered ? drawn : Colour{{64, 64, 64}};
            }));
            submissions.back().scene = right;
        }

        const auto diagnosis = diagnose(submissions);

        QVERIFY(diagnosis && diagnosis->isExplained());
        QCOMPARE(diagnosis->candidates.size(), std::size_t(1));
        QCOMPARE(diagnosis->candidates.front().ids(), ids);
        const PictureDiff diff
            = differenceOf(pictureOf(submissions.front().scene), submissions.front().picture);
        QCOMPARE(diff.causes.front().name, u"drawn on (64, 64, 64) in place of black"_s);
    }

    /// The order of scenes with different backgrounds does not matter.
    void anotherBackgroundThanThoseOfTheScenesIsTold()
    {
        std::vector<Submission> submissions;
        for (const std::uint8_t level : {0, 64}) {
            Scene scene = probes().front();
            scene.frame.background = Colour{{level, level, level}};
            submissions.push_back(submissionOf(scene, [](const Colour &drawn, bool isCovered) {
                return isCovered ? drawn : Colour{{192, 128, 0}};
            }));
            submissions.back().scene = scene;
        }

        const auto diagnosis = diagnose(submissions);

        QVERIFY(diagnosis && !diagnosis->candidates.empty());
        QCOMPARE(diagnosis->candidates.front().sentences(&Defect::forAssistant),
                 QStringList(u"Done to the whole picture: drawn on (192, 128, 0) in "
                             "place of black or (64, 64, 64)."_s));
    }

    void anEnlargedPictureIsSaidToBeOne()
    {
        QCOMPARE(sizeHint({512, 384}, {64, 48}), u", 8 times as many each way, as if enlarged"_s);
        for (const QSize other : {QSize(64, 48), QSize(128, 48), QSize(100, 75), QSize(32, 24)})
            QCOMPARE(sizeHint(other, {64, 48}), QString());
        QCOMPARE(sizeHint({48, 64}, {64, 48}), u", as if width and height were exchanged"_s);
        QCOMPARE(sizeHint({48, 48}, {48, 48}), QString());

        QTemporaryDir folder;
        const QString small = folder.filePath(u"small.png"_s);
        const QString large = folder.filePath(u"large.png"_s);
        const QString scene = resource(u"/probes/column-scan-1.json"_s);
        QCOMPARE(run({u"render"_s, scene, u"-o"_s, small}).exitCode, 0);
        QCOMPARE(run({u"render"_s, scene, u"--scale"_s, u"3"_s, u"-o"_s, large}).exitCode, 0);
        const ProgramRun result = run({u"diff"_s, small, large});
        QCOMPARE(result.exitCode, 3);
        QVERIFY2(result.messages.contains("3 times as many each way, as if enlarged"),
                 result.messages.constData());
    }
};

PIXELPLUMB_TEST(TestWholePicture)

} // namespace tst_wholepicture

#include "tst_wholepicture.moc"
