// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/referredfiles.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/picturereader.h"
#include "tests/support/scenes/scenetext.h"
#include "tests/support/testprogram.h"

#include <QBuffer>
#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

#include <cmath>

namespace tst_referredfiles {

using namespace pixelplumb;

namespace {

const QByteArray camera = "'camera': { 'eye': [0, 0, 5] },";

void write(const QString &path, const QByteArray &content) { QVERIFY(!writeFile(path, content)); }

} // namespace

/// The pictures and meshes that scenes take from other files.
class TestReferredFiles : public QObject {
    Q_OBJECT

private slots:
    void aPictureIsReadFromTheLowestRow()
    {
        const QTemporaryDir folder;
        QImage picture(2, 3, QImage::Format_RGB32);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 2; ++column)
                picture.setPixel(column, row, qRgb(10 * row, column, 7));
        }
        QVERIFY(picture.save(folder.filePath(u"picture.png"_s)));
        const QString path = folder.filePath(u"scene.json"_s);
        write(path,
              sceneOf("'materials': { 'a': { 'texture': 'picture.png' }, 'b': { 'texture': "
                      "'picture.png' } },"));

        const Result<SceneReading> reading = readSceneFile(path);

        QVERIFY2(reading, reading ? "" : qPrintable(reading.error().message()));
        const std::vector<Material> &materials = reading->scene.appearance.materials;
        QCOMPARE(materials[0].texture->width, 2);
        QCOMPARE(materials[0].texture->height, 3);
        QCOMPARE(materials[0].texture->texel(1, 0), (Colour{{20, 1, 7}}));
        QCOMPARE(materials[0].texture->texel(0, 2), (Colour{{0, 0, 7}}));
        QCOMPARE(materials[0].texture, materials[1].texture); // read once
    }

    /// ⌊255·v/greatest + ½⌋, in text and binary, of one byte and of two.
    void levelsAreSpreadOverTheBytesWhateverTheirGreatest()
    {
        const auto greyIn = [](const QByteArray &content) {
            const QImage picture = PictureReader(content).read();
            return picture.isNull() ? -1 : qGreen(picture.pixel(0, 0));
        };
        for (const int greatest : {1, 7, 100, 254, 255, 1000, 65535}) {
            for (int level = 0; level <= greatest; level += std::max(1, greatest / 30)) {
                const QByteArray size = " 1 1 " + QByteArray::number(greatest) + '\n';
                const QByteArray text = QByteArray::number(level) + ' ';
                QByteArray binary(greatest > 255 ? 2 : 1, char(level));
                binary.front() = char(greatest > 255 ? level >> 8 : level);
                const int expected = int(std::floor(255.0 * level / greatest + 0.5));
                QCOMPARE(greyIn("P2" + size + text), expected);
                QCOMPARE(greyIn("P3" + size + text + text + text), expected);
                QCOMPARE(greyIn("P5" + size + binary), expected);
                QCOMPARE(greyIn("P6" + size + binary + binary + binary), expected);
            }
        }
        PictureReader reader("P5 1 1 100 \xc8");
        QVERIFY(reader.read().isNull());
        QCOMPARE(
            reader.fault(),
            u"a broken PGM: a level of 200 in line 1 of its pixels; its header says 100 at most"_s);
    }

    /// Level (x, y) is 257·((37x + 159y + 11xy) mod 256).
    void aPngOf16BitsIsReadAlsoWhereItIsInterlaced()
    {
        const QImage picture
            = PictureReader(QByteArray::fromBase64("iVBORw0KGgoAAAANSUhEUgAAAAUAAAAFEAAAAAGPk5XsAAA"
                                                   "ARklEQVR42mNgYGCYMoWhpubAAQYvLwY5"
                                                   "OQY7uy1btLQYVFXz8xkqK9+/Zzh7FsiaP//8+f//"
                                                   "9fXj4xnu3lVWzsxcv/7rVwB/sRkp1fjSYwAAAABJ"
                                                   "RU5ErkJggg=="))
                  .read();
        QCOMPARE(picture.size(), QSize(5, 5));
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 5; ++x)
                QCOMPARE(qRed(picture.pixel(x, y)), (37 * x + 159 * y + 11 * x * y) % 256);
    }

    void aBmpOfFiveBitsAChannelIsRefused()
    {
        QByteArray file;
        QBuffer buffer(&file);
        QImage(4, 3, QImage::Format_RGB32).save(&buffer, "bmp");
        file[28] = 16;
        QVERIFY(PictureReader(file).fault().contains(u"a BMP of 16 bits a pixel"));
    }

    void aSceneThatIsSavedElsewhereFindsItsFiles()
    {
        const QTemporaryDir folder;
        const QDir below(folder.filePath(u"below"_s));
        QVERIFY(below.mkpath(u"."_s));
        QVERIFY(QImage(4, 4, QImage::Format_RGB32).save(below.filePath(u"p.png"_s)));
        write(below.filePath(u"m.obj"_s), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const QString here = below.filePath(u"scene.json"_s);
        write(here,
              sceneOf(camera + "'materials': { 'a': { 'texture': 'p.png' } },",
                      "{ 'mesh': 'm.obj', 'material': 'a' }"));
        const Result<SceneReading> reading = readSceneFile(here);
        QVERIFY2(reading, reading ? "" : qPrintable(reading.error().message()));

        const QString elsewhere = folder.filePath(u"scene.json"_s);
        QVERIFY(!writeSceneFile(elsewhere, reading->scene));
        const Result<SceneReading> again = readSceneFile(elsewhere);

        QVERIFY2(again, again ? "" : qPrintable(again.error().message()));
        QVERIFY(again->scene == reading->scene);
        const QByteArray written = *readFile(elsewhere);
        QVERIFY2(written.contains("\"below/p.png\"") && written.contains("\"below/m.obj\""),
                 written.constData());
    }

    void whatASceneNamesIsWeighedBeforeItIsRead()
    {
        const QTemporaryDir folder;
        write(folder.filePath(u"a.obj"_s), QByteArray(1000, ' '));
        write(folder.filePath(u"b.png"_s), QByteArray(30, ' '));
        const QByteArray text = sceneOf(
            "'materials': { 'a': { 'texture': 'b.png' }, 'c': { 'texture': 'checker' } },",
            "{ 'mesh': 'a.obj' }, { 'mesh': 'a.obj' }, { 'mesh': 'none.obj' }");
        const QString path = folder.filePath(u"scene.json"_s);
        write(path, text);
        QCOMPARE(bytesToRead(path), text.size() + 1030);
        QCOMPARE(bytesToRead(folder.filePath(u"a.obj"_s)), qint64(1000));
        QCOMPARE(bytesToRead(folder.filePath(u"none.json"_s)), qint64(0));
    }

    void meshReadingReportsProgressAndCanBeStopped()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"scene.json"_s);
        write(path, sceneOf(camera, "{ 'mesh': 'large.obj' }"));
        const QByteArray mesh
            = "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + QByteArray("f 1 2 3\n").repeated(10'000);
        write(folder.filePath(u"large.obj"_s), mesh);
        std::vector<std::int64_t> told;
        QVERIFY(readSceneFile(path, [&](const JobProgress &progress) {
            told.push_back(progress.done);
            return progress.phase == JobPhase::Reading && progress.total == mesh.size();
        }));
        QVERIFY(told.size() > 5);
        QVERIFY(std::ranges::is_sorted(told));
        QVERIFY(told.back() > mesh.size() / 2);

        int calls = 0;
        const auto cancelled
            = readSceneFile(path, [&](const JobProgress &) { return ++calls < 4; });
        QVERIFY(!cancelled);
        QVERIFY(cancelled.error().message().contains(u"the reading was cancelled"_s));
        QCOMPARE(calls, 4);
    }

    void marksRemarksAndLinesThatGoOnAreNoFaults()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"scene.json"_s);
        write(path, sceneOf(camera, "{ 'mesh': 'm.obj' }"));
        write(folder.filePath(u"m.obj"_s),
              "\xEF\xBB\xBFv 0 0 0 # the first\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n 3 # one\n");

        const Result<SceneReading> reading = readSceneFile(path);

        QVERIFY2(reading, reading ? "" : qPrintable(reading.error().message()));
        QCOMPARE(reading->scene.solids[0].mesh->faces.size(), std::size_t(1));
        QCOMPARE(reading->scene.solids[0].mesh->corners.size(), std::size_t(3));
    }

    void aPipeIsNotWaitedFor()
    {
        const QTemporaryDir folder;
        QCOMPARE(::mkfifo(QFile::encodeName(folder.filePath(u"m.obj"_s)), 0600), 0);
        const QString path = folder.filePath(u"scene.json"_s);
        write(path, sceneOf(camera, "{ 'mesh': 'm.obj' }"));

        const Result<SceneReading> reading = readSceneFile(path);

        QVERIFY(!reading);
        QVERIFY2(reading.error().message().contains(u"it is a pipe or a device"_s),
                 qPrintable(reading.error().message()));
    }

    void filesThatCannotBeUsedAreNamed_data()
    {
        QTest::addColumn<QByteArray>("content"); // of the file; null: there is no file
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("message"); // %1: its path
        const auto row
            = [](const char *title, const char *content, const char *name, const char *message) {
                  QTest::newRow(title) << QByteArray(content) << QString::fromLatin1(name)
                                       << QString::fromUtf8(message);
              };
        row("no picture", "", "a.png",
            "materials.a.texture: %1: cannot be read: No such file or directory");
        row("broken picture", "no picture at all", "a.png",
            "materials.a.texture: %1: no picture: Unsupported image format; expected a picture "
            "such "
            "as PNG or JPEG");
        // A header of 5000 x 20 texels without data.
        row("huge picture", "P6 5000 20 255\n", "a.ppm",
            "materials.a.texture: %1: a picture of 5000 × 20; expected at most "
            "4096 × 4096");
        row("no mesh", "", "a.obj",
            "primitives[0].mesh: %1: cannot be read: No such file or directory");
        row("no face", "v 0 0 0\n", "a.obj",
            "primitives[0].mesh: %1: no face; expected a Wavefront OBJ file with lines such as “f "
            "1 2 3”");
        row("index too large", "v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 4\n", "a.obj",
            "primitives[0].mesh: %1, line 5: a face with vertex 4; expected 1 to 3, of those "
            "before the face");
        row("index too small", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4", "a.obj",
            "primitives[0].mesh: %1, line 4: a face with vertex -4; expected 1 to 3, of those "
            "before the face");
        row("index that is no number", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1x 2 3\n", "a.obj",
            "primitives[0].mesh: %1, line 4: a face with a corner “1x”; expected 1, 1/2, 1//3 or "
            "1/2/3");
        row("part that is missing", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/ 2/ 3/\n", "a.obj",
            "primitives[0].mesh: %1, line 4: a face with a corner “1/”; expected 1, 1/2, 1//3 or "
            "1/2/3");
        row("index beyond 32 bits", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4294967299\n", "a.obj",
            "primitives[0].mesh: %1, line 4: a face with a corner “4294967299”; expected 1, "
            "1/2, 1//3 or 1/2/3");
        row("index 0", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "a.obj",
            "primitives[0].mesh: %1, line 4: a face with vertex 0; expected 1 to 3, of those "
            "before the face");
        row("vertices behind the face", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", "a.obj",
            "primitives[0].mesh: %1, line 1: a face with vertex 1; expected one that stands before "
            "the face");
        row("texture point that is not there", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/2 3/1\n",
            "a.obj",
            "primitives[0].mesh: %1, line 5: a face with texture point 2; expected 1 to 1, of "
            "those before the face");
        row("face of two", "v 0 0 0\nv 1 0 0\nf 1 2\n", "a.obj",
            "primitives[0].mesh: %1, line 3: a face of 2; expected 3 corners or more");
        row("not finite", "v 0 0 nan\n", "a.obj",
            "primitives[0].mesh: %1, line 1: “v 0 0 nan”; expected 3 numbers within ±1048576");
        row("infinite", "v 0 1e999 0\n", "a.obj",
            "primitives[0].mesh: %1, line 1: “v 0 1e999 0”; expected 3 numbers within ±1048576");
        row("two numbers", "# a\r\nv 0 1\r\n", "a.obj",
            "primitives[0].mesh: %1, line 2: “v 0 1”; expected 3 numbers within ±1048576");
        row("no number", "v 0 1 zwei\n", "a.obj",
            "primitives[0].mesh: %1, line 1: “v 0 1 zwei”; expected 3 numbers within ±1048576");
        row("normal of length 0", "vn 0 0 0\n", "a.obj",
            "primitives[0].mesh: %1, line 1: a normal of length 0; expected a direction");
    }
    void filesThatCannotBeUsedAreNamed()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, name);
        QFETCH(QString, message);
        const QTemporaryDir folder;
        if (!content.isEmpty())
            write(folder.filePath(name), content);
        const QByteArray quoted = '"' + name.toUtf8() + '"';
        const QByteArray text = name.endsWith(u".obj"_s)
            ? sceneOf(camera, "{ \"mesh\": " + quoted + " }")
            : sceneOf("\"materials\": { \"a\": { \"texture\": " + quoted + " } },");

        const Result<SceneReading> reading = readScene(text, {}, folder.path());

        QVERIFY(!reading);
        const QString error = reading.error().message();
        QVERIFY2(error.endsWith(message.arg(folder.filePath(name))), qPrintable(error));
    }

    void facesOfAMeshBecomeFansAndShareTheirCorners()
    {
        const QTemporaryDir folder;
        write(
            folder.filePath(u"a.obj"_s),
            "o house\nmtllib none.mtl\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2.5e-1 0\nvt 0 1\nvt +1 0.5\n"
            "vn 0 0 1\ng wall\nusemtl none\nf 1//1 2//1 3//1 4//1\nf -4/1 -2/2 -1/1");
        const Scene scene
            = readScene(
                  sceneOf(camera,
                          "{ 'mesh': 'a.obj', 'at': [1, 2, 3], 'scale': 2, 'rotate': [0, 90, 0] }"),
                  {}, folder.path())
                  ->scene;
        QCOMPARE(scene.solids.size(), std::size_t(1));
        const Solid &solid = scene.solids[0];
        QCOMPARE(solid.at, (Vector3{1, 2, 3}));
        QCOMPARE(solid.rotate, (Vector3{0, 90, 0}));
        const Mesh &mesh = *solid.mesh;
        QCOMPARE(mesh.faces.size(), std::size_t(3));
        QCOMPARE(mesh.faces[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
        QCOMPARE(mesh.faces[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
        QCOMPARE(mesh.faces[2], (std::array<std::uint32_t, 3>{4, 5, 6}));
        QCOMPARE(mesh.corners[3].position, (Vector3{0, 0.25, 0}));
        QCOMPARE(mesh.corners[0].normal, (Vector3{0, 0, 1}));
        QCOMPARE(mesh.corners[5].texture, (std::array<double, 2>{1, 0.5}));
        QCOMPARE(mesh.corners[4].normal, Vector3());
    }
};

PIXELPLUMB_TEST(TestReferredFiles)

} // namespace tst_referredfiles

#include "tst_referredfiles.moc"
