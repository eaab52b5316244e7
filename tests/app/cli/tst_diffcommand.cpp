// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seededrandom.h"
#include "core/grade/picturediff.h"
#include "core/grade/undecidable.h"
#include "core/scene/fileaccess.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QBuffer>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace tst_diffcommand {

using namespace pixelplumb;

/// Pictures against pictures and against scenes, from the command line.
class TestDiffCommand : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        QCOMPARE(run({"render", defaultScene(), "-o", path("right.png")}).exitCode, 0);
        m_right = QImage(path("right.png")).convertToFormat(QImage::Format_RGB32);
        QCOMPARE(m_right.size(), QSize(64, 48));
    }

    void aSceneIsItsOwnPicture_data()
    {
        QTest::addColumn<QString>("suffix");
        for (const char *suffix : {"png", "bmp", "ppm"})
            QTest::newRow(suffix) << QString::fromLatin1(suffix);
    }
    void aSceneIsItsOwnPicture()
    {
        QFETCH(QString, suffix);
        const QString picture = m_folder.filePath(QStringLiteral("same.") + suffix);
        QCOMPARE(run({"render", defaultScene(), "-o", picture}).exitCode, 0);

        const ProgramRun result = run({"diff", defaultScene(), picture});

        QCOMPARE(result.exitCode, 0);
        QCOMPARE(QString::fromUtf8(result.output), QStringLiteral("64 × 48 pixels: 3072 same\n"));
    }

    void whatIsComparedIsNeverReplaced()
    {
        QVERIFY(m_right.mirrored(false, true).save(path("found.png")));
        for (const char *side : {"right.png", "found.png"}) {
            const QByteArray before = *readFile(path(side));
            const ProgramRun result
                = run({"diff", path("right.png"), path("found.png"), "-o", path(side)});
            QCOMPARE(result.exitCode, 2);
            QVERIFY2(result.messages.contains("is the input"), result.messages.constData());
            QCOMPARE(*readFile(path(side)), before);
        }
    }

    void aRasterIsComparedByWhatIsCovered()
    {
        const QByteArray raster = run({"render", defaultScene(), "--ascii"}).output;

        QCOMPARE(run({"diff", defaultScene(), "-"}, raster).exitCode, 0);

        const qsizetype covered = raster.indexOf('#');
        QByteArray other = raster;
        other[covered] = '.';
        other[raster.indexOf('.')] = '#';
        const ProgramRun result = run({"diff", defaultScene(), "-", "--ascii"}, other);
        QCOMPARE(result.exitCode, 1);
        QByteArray expected = raster;
        expected[covered] = '?';
        expected[raster.indexOf('.')] = '!';
        const QByteArray marked = result.output.sliced(result.output.indexOf('\n') + 1);
        QCOMPARE(marked, expected);
    }

    void theCauseOfAWholePictureIsNamed_data()
    {
        QTest::addColumn<QImage>("picture");
        QTest::addColumn<QString>("cause");
        QTest::newRow("upside down") << m_right.mirrored(false, true) << "upside down";
        QTest::newRow("mirrored") << m_right.mirrored(true, false) << "left and right exchanged";
        QTest::newRow("channels") << m_right.rgbSwapped() << "channels BGR in place of RGB";
        QTest::newRow("decoded") << decoded(m_right) << "decoded from sRGB once too often";
        QTest::newRow("shifted") << m_right.copy(-1, 2, 64, 48)
                                 << "shifted by 1 to the right and 2 up";
    }
    void theCauseOfAWholePictureIsNamed()
    {
        QFETCH(QImage, picture);
        QFETCH(QString, cause);
        // What a copy takes from outside is transparent black, as is the scene's background.
        QVERIFY(picture.save(path("changed.png")));

        const ProgramRun result = run({"diff", defaultScene(), path("changed.png"), "--json"});

        QCOMPARE(result.exitCode, 1);
        const QJsonArray causes
            = QJsonDocument::fromJson(result.output)[QStringLiteral("causes")].toArray();
        QVERIFY2(!causes.isEmpty(), result.output.constData());
        QCOMPARE(causes[0][QStringLiteral("cause")].toString(), cause);
        QCOMPARE(causes[0][QStringLiteral("left")].toInt(), 0);
    }

    void oneWrongPixelHasNoCause()
    {
        QImage picture = m_right;
        const QPoint inside = firstCovered();
        picture.setPixel(inside, picture.pixel(inside) ^ 0x00050000);
        QVERIFY(picture.save(path("one.png")));

        const ProgramRun result
            = run({"diff", defaultScene(), path("one.png"), "-o", path("marked.png")});

        QCOMPARE(result.exitCode, 1);
        const QString output = QString::fromUtf8(result.output);
        QVERIFY2(
            output.startsWith(QStringLiteral("64 × 48 pixels: 3071 same, 1 colour; a byte by ")),
            qPrintable(output));
        QCOMPARE(output.count(u'\n'), qsizetype(1));
        const QImage marked(path("marked.png"));
        QCOMPARE(marked.pixel(inside), qRgb(204, 121, 167));
    }

    void ofASampleOnAnEdgeNothingIsDecided()
    {
        const QByteArray scene = R"({ "pixelplumb": 1, "frame": { "width": 6, "height": 5 },
            "primitives": [ { "triangle": [[1, 1], [4, 1], [1, 3]],
                              "colors": ["#ffffff", "#ffffff", "#ffffff"] } ] })";
        QFile file(path("edge.json"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(scene) > 0);
        file.close();

        // (1, 1) lies on two edges: another rule would leave it out.
        const ProgramRun result = run({"diff", path("edge.json"), "-", "--ascii"},
                                      "......\n.#....\n.##...\n..###.\n......\n");

        QCOMPARE(result.exitCode, 0);
        QVERIFY2(result.output.contains("\n......\n.#....\n.##...\n.=###.\n......\n"),
                 result.output.constData());
    }

    void aRightProgramIsNeverWrong_data()
    {
        QTest::addColumn<Arithmetic>("arithmetic");
        for (const char *method :
             {"column-scan", "row-walk", "edge-equations", "barycentric-rectangle"}) {
            QTest::addRow("%s float32", method) << Arithmetic::Float32;
            QTest::addRow("%s float64", method) << Arithmetic::Float64;
        }
    }
    void aRightProgramIsNeverWrong()
    {
        QFETCH(Arithmetic, arithmetic);
        const QByteArray method = QByteArray(QTest::currentDataTag()).split(' ').front();
        SeededRandom random(7);
        std::int64_t differing = 0;
        std::int64_t wrong = 0;
        for (int i = 0; i < 100; ++i) {
            Scene scene;
            scene.method = method.toStdString();
            const int side = i % 6 == 0 ? 200 : 48;
            scene.frame.width = side;
            scene.frame.height = side;
            constexpr std::array<Lattice, 3> units = {256, 128, 1};
            const Lattice unit = units[std::size_t(random.between(0, 2))];
            const auto place
                = [&] { return random.between(-20, std::int64_t(side) * 256 / unit + 20) * unit; };
            const auto vertex = [&] { return Vertex{{place(), place()}, random.colour()}; };
            Triangle triangle{{vertex(), vertex(), vertex()}};
            if (i % 5 == 0) // a sliver
                triangle.vertices[2].position
                    = {triangle.vertices[1].position.x + unit, triangle.vertices[1].position.y};
            scene.triangles = {triangle};
            const Picture right = pictureOf(scene);
            scene.settings.arithmetic = arithmetic;
            const Picture found = pictureOf(scene);
            scene.settings.arithmetic = Arithmetic::Exact;
            const auto undecidable = undecidablePixels(scene, right, found, arithmetic);
            differing += differingPixels(right, found);
            wrong += differenceOf(right, found, undecidable).differing();
        }
        QCOMPARE(wrong, std::int64_t(0));
        QVERIFY(differing > 0 || arithmetic == Arithmetic::Float64);
    }

    void whatIsWrongByAPixelOrALevelStaysWrong()
    {
        Scene scene;
        SeededRandom random(3);
        std::int64_t wrong = 0;
        std::int64_t changed = 0;
        for (int i = 0; i < 50; ++i) {
            const auto vertex = [&] {
                return Vertex{latticePixel(random.between(1, 60), random.between(1, 46)),
                              random.colour()};
            };
            scene.triangles = {{{vertex(), vertex(), vertex()}}};
            if (doubledArea(scene.triangles.front()) == 0)
                continue;
            const Picture right = pictureOf(scene);
            Picture found = right;
            for (std::size_t place = 0; place < found.size(); ++place) {
                if (right.covered[place] != 0)
                    found.colours[place].channels[0] ^= 2;
                else if (place > 0 && right.covered[place - 1] != 0)
                    found.colours[place] = right.colours[place - 1]; // one beyond the right bound
                else
                    continue;
                ++changed;
            }
            coverAllBut(scene.frame.background, found);
            wrong += differenceOf(right, found,
                                  undecidablePixels(scene, right, found, Arithmetic::Float32))
                         .differing();
        }
        QVERIFY(changed > 5000);
        // Undecidable are ties and pixels at the tips, where spans are thin.
        QVERIFY2(wrong * 100 >= changed * 95, qPrintable(QString::number(wrong)));
    }

    void whatIsDrawnTwiceIsToldWhereItIsBlended_data()
    {
        QTest::addColumn<QByteArray>("alpha");
        QTest::addColumn<int>("twice");
        QTest::newRow("blended") << QByteArray("80")
                                 << 8; // of the diagonal, whose last one has no owner
        QTest::newRow("opaque") << QByteArray("ff") << 0;
    }
    void whatIsDrawnTwiceIsToldWhereItIsBlended()
    {
        QFETCH(QByteArray, alpha);
        QFETCH(int, twice);
        const QByteArray colour = "\"#c04020" + alpha + "\"";
        const QByteArray colours = "\"colors\": [" + colour + ',' + colour + ',' + colour + "] }";
        QFile scene(path("twice.json"));
        QVERIFY(scene.open(QIODevice::WriteOnly));
        scene.write(R"({ "pixelplumb": 1, "frame": { "width": 12, "height": 12 },
                         "fillRule": "half-open-column", "primitives": [
                         { "triangle": [[2, 2], [10, 10], [10, 2]], )"
                    + colours + R"(, { "triangle": [[2, 2], [10, 10], [2, 10]], )" + colours
                    + " ] }");
        scene.close();
        QCOMPARE(
            run({"render", path("twice.json"), "--fill-rule", "closed", "-o", path("twice.png")})
                .exitCode,
            0);

        const ProgramRun told = run({"diff", path("twice.json"), path("twice.png")});
        const ProgramRun json = run({"diff", path("twice.json"), path("twice.png"), "--json"});

        QCOMPARE(told.output.contains("drawn twice: 8 pixels"), twice > 0);
        QCOMPARE(QJsonDocument::fromJson(json.output)[QStringLiteral("drawnTwice")].toInt(-1),
                 twice);
    }

    void sizesThatDifferAreToldApart()
    {
        const ProgramRun result = run({"diff", defaultScene(), "-"}, "##\n..\n");

        QCOMPARE(result.exitCode, 3);
        QVERIFY2(result.messages.contains("has 64 × 48 pixels, - has 2 × 2"),
                 result.messages.constData());
    }

    void refusesWhatIsNoPicture_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QByteArray>("message");
        QTest::newRow("nothing") << QByteArray() << QByteArray("-: it is empty; expected PNG, PPM");
        QTest::newRow("words") << QByteArray("no picture at all") << QByteArray("-: no picture");
        QTest::newRow("a list in JSON") << QByteArray(" []")
                                        << QByteArray("-: a list in JSON is no scene; expected "
                                                      "PNG, PPM, BMP, or a raster of # and ., or a "
                                                      "scene as a JSON object");
        const QByteArray signature("\x89PNG\r\n\x1a\n");
        QTest::newRow("cut") << signature
                             << QByteArray("-: no picture: a PNG that ends early, at byte 8");
        const QByteArray whole = pngOfOnePixel();
        QTest::newRow("cut in its pixels")
            << whole.left(whole.indexOf("IDAT") + 8)
            << QByteArray("-: no picture: a PNG that ends early, in IDAT at byte ");
        QByteArray damaged = whole;
        damaged[signature.size() + 8 + 3] = 2; // another width than its checksum is of
        QTest::newRow("damaged")
            << damaged << QByteArray("-: no picture: a broken PNG: the checksum of IHDR at byte 8");
        QTest::newRow("a PNG of a colour type that is none")
            << QByteArray::fromHex(
                   "89504e470d0a1a0a0000000d4948445200000001000000010709000000c526430e0000000c49444"
                   "154789c63484c4a0600024e0127c0619e190000000049454e44ae426082")
            << QByteArray("-: no picture: a broken PNG: its header says colour type 9 of 7 bits, "
                          "which is none");
        QTest::newRow("a PNG without pixels")
            << QByteArray::fromHex("89504e470d0a1a0a0000000d494844520000000100000001080200000090775"
                                   "3de0000000049454e44ae426082")
            << QByteArray("-: no picture: a broken PNG: it has no pixels (IDAT)");
        QTest::newRow("a PNG without its palette")
            << QByteArray::fromHex(
                   "89504e470d0a1a0a0000000d494844520000000100000001080300000028cb34bb0000000c49444"
                   "154789c63484c4a0600024e0127c0619e190000000049454e44ae426082")
            << QByteArray("-: no picture: a broken PNG: its palette (PLTE) is missing");
        QTest::newRow("a PNG of pixels that are not deflated")
            << QByteArray::fromHex(
                   "89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de0000000749444"
                   "154727562626973681beeae010000000049454e44ae426082")
            << QByteArray("-: no picture: a broken PNG: its pixels (IDAT) are not deflated");
        QTest::newRow("a PNG whose pixels end early")
            << QByteArray::fromHex(
                   "89504e470d0a1a0a0000000d4948445200000002000000020802000000fdd49a730000000f49444"
                   "1"
                   "54789c63e01291d330b20100023700d35b5651d80000000049454e44ae426082")
            << QByteArray(
                   "-: no picture: a broken PNG: its pixels (IDAT) end early, at byte 7 of 14");
        QTest::newRow("a PNG whose pixels are cut")
            << QByteArray::fromHex("89504e470d0a1a0a0000000d4948445200000002000000020802000000fdd49"
                                   "a7300000007494441"
                                   "54789c6360800246557df4690000000049454e44ae426082")
            << QByteArray("-: no picture: a broken PNG: its pixels (IDAT) end early");
        const QByteArray bitmap = bmpOf(QImage(5, 3, QImage::Format_RGB32));
        QTest::newRow("a BMP cut by a byte")
            << bitmap.chopped(1)
            << QByteArray(
                   "-: no picture: a BMP that ends early, 1 of 48 bytes of pixels are missing");
        QTest::newRow("a BMP cut in its header")
            << bitmap.left(30) << QByteArray("-: no picture: a BMP that ends early, in its header");
        QTest::newRow("a PPM cut by a byte")
            << QByteArray("P6 2 1 255\n12345")
            << QByteArray(
                   "-: no picture: a PPM that ends early, 1 of 6 bytes of pixels are missing");
        QTest::newRow("ragged") << QByteArray("##\n#\n") << QByteArray("-: ");
        QTest::newRow("broken scene") << QByteArray("{ \"pixelplumb\": 1 ") << QByteArray("-, ");
    }
    void refusesWhatIsNoPicture()
    {
        QFETCH(QByteArray, content);
        QFETCH(QByteArray, message);

        const ProgramRun result = run({"diff", defaultScene(), "-"}, content);

        QCOMPARE(result.exitCode, 2);
        QVERIFY2(result.messages.contains(message), result.messages.constData());
        QVERIFY2(!result.messages.contains("libpng"), result.messages.constData());
    }

private:
    static QByteArray bmpOf(const QImage &image)
    {
        QByteArray content;
        QBuffer buffer(&content);
        image.save(&buffer, "bmp");
        return content;
    }

    static QByteArray pngOfOnePixel()
    {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QImage(1, 1, QImage::Format_RGB32).save(&buffer, "PNG");
        return bytes;
    }
    static QImage decoded(QImage picture)
    {
        const auto level = [](int byte) {
            const double encoded = byte / 255.0;
            const double linear
                = encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
            return int(std::lround(255 * linear));
        };
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QRgb pixel = picture.pixel(x, y);
                picture.setPixel(
                    x, y, qRgb(level(qRed(pixel)), level(qGreen(pixel)), level(qBlue(pixel))));
            }
        }
        return picture;
    }

    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    QPoint firstCovered() const
    {
        for (int y = 0; y < m_right.height(); ++y) {
            for (int x = 0; x < m_right.width(); ++x) {
                if (m_right.pixel(x, y) != m_right.pixel(0, 0))
                    return {x, y};
            }
        }
        return {};
    }

    QTemporaryDir m_folder;
    QImage m_right;
};

PIXELPLUMB_TEST(TestDiffCommand)

} // namespace tst_diffcommand

#include "tst_diffcommand.moc"
