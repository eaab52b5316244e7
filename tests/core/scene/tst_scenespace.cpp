// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/scenetext.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_scenespace {

using namespace pixelplumb;

namespace {

const QByteArray corners = "[[4, 5], [58, 12], [26, 44]]";
const QByteArray red = "['#ff0000', '#ff0000', '#ff0000']";
const QByteArray camera = "'camera': { 'eye': [0, 0, 5] },";

QByteArray triangleWith(const QByteArray &members)
{
    return "{ \"triangle\": " + corners + ", \"colors\": " + red + ", " + members + " }";
}

Scene sceneFrom(const QByteArray &text)
{
    const Result<SceneReading> reading = readScene(text);
    if (!reading)
        qWarning("%s", qPrintable(reading.error().message()));
    return reading ? reading->scene : Scene();
}

/// Checks that a text is read, and that writing the scene and reading it again gives the same scene
/// and the same bytes.
void comesBack(const QByteArray &text)
{
    const Result<SceneReading> reading = readScene(text);
    QVERIFY2(reading, reading ? "" : qPrintable(reading.error().message()));
    const QByteArray written = writeScene(reading->scene);
    const Result<SceneReading> again = readScene(written);
    QVERIFY2(again, again ? "" : qPrintable(again.error().message() + written));
    QVERIFY2(again->scene == reading->scene, written.constData());
    QCOMPARE(writeScene(again->scene), written);
}

} // namespace

/// The keys of scene files for three dimensions and for the triangles' appearance: each is read and
/// written.
class TestSceneSpace : public QObject {
    Q_OBJECT

private slots:
    void attributesAreReadInTheirOwnFormat()
    {
        const Scene scene = sceneFrom(
            sceneOf("'materials': { 'board': { 'texture': 'checker' } },",
                    triangleWith("'z': [0, '1/4', 1], 'w': [1, 2, 0.5], 'material': 'board', "
                                 "'uv': [[0, 0], [1, 0], ['1/16777216', 1e6]], "
                                 "'normals': [[0, 0, -1], [0, 1, 0], [1, 0, 0]]")));
        QCOMPARE(scene.attributes.size(), std::size_t(1));
        const auto &[first, second, third] = scene.attributes[0].vertices;
        QCOMPARE(second.z, attributeOne / 4);
        QCOMPARE(second.w, 2 * attributeOne);
        QCOMPARE(third.texture[0], Attribute(1));
        QCOMPARE(third.texture[1], 1'000'000 * attributeOne);
        QCOMPARE(first.normal[2], -attributeOne);
        QCOMPARE(scene.attributes[0].material, 0);
        QVERIFY(*scene.appearance.materials[0].texture == checkerTexture());
    }

    void anAttributeThatIsMovedIsReported()
    {
        const Result<SceneReading> reading
            = readScene(sceneOf({}, triangleWith("'z': [0, '1/3', 1]")));
        QVERIFY(reading);
        QCOMPARE(reading->snaps.size(), std::size_t(1));
        QCOMPARE(reading->snaps[0].message(),
                 u"primitives[0].z[1]: 1/3 is read as 5592405/16777216, displaced by "
                 "-1/50331648"_s);
    }

    void ofManyThatAreMovedTheFirstAreReportedAndAllCounted()
    {
        const QByteArray triangle = triangleWith("'z': [0.1, 0.1, 0.1]");
        const Result<SceneReading> reading
            = readScene(sceneOf({}, (triangle + ", ").repeated(999) + triangle));
        QVERIFY(reading);
        QCOMPARE(reading->snaps.size(), std::size_t(3000));
        QVERIFY(reading->snaps[SnapReports::mostKept - 1].message().contains("primitives[333]"));
    }

    void alphaGoesToTheAttributes()
    {
        const Scene scene = sceneFrom(sceneOf(
            {},
            "{ \"triangle\": " + corners + ", 'colors': ['#ff000080', '#00ff00ff', '#0000ff'] }"));
        QCOMPARE(scene.attributes.size(), std::size_t(1));
        QCOMPARE(scene.attributes[0].vertices[0].alpha, std::uint8_t(128));
        QCOMPARE(scene.attributes[0].vertices[1].alpha, std::uint8_t(255));
        QVERIFY(
            writeScene(scene).replace('"', '\'').contains("['#ff000080', '#00ff00', '#0000ff']"));
    }

    void whatSaysNothingNewIsNoAttribute()
    {
        const Scene scene = sceneFrom(sceneOf(
            {}, triangleWith("'z': [0, 0, 0], 'w': [1, 1, 1], 'uv': [[0, 0], [0, 0], [0, 0]]")));
        QVERIFY(scene.attributes.empty());
    }

    void theCameraIsReadWithItsDefaults()
    {
        const Scene plain = sceneFrom(sceneOf("'camera': {},"));
        QVERIFY(plain.camera == Camera());
        const Scene scene
            = sceneFrom(sceneOf("'camera': { 'projection': 'orthographic', 'eye': [1, '1/4', 3.5], "
                                "'target': [0, 1, 0], "
                                "'up': [1, 0, 0], 'height': 3, 'near': 0.5, 'far': 20 },"));
        QVERIFY(scene.camera.has_value());
        QCOMPARE(scene.camera->projection, Projection::Orthographic);
        QCOMPARE(scene.camera->eye, (Vector3{1, 0.25, 3.5}));
        QCOMPARE(scene.camera->height, 3.0);
        QCOMPARE(scene.camera->far, 20.0);
    }

    void materialsAndLightsAreRead()
    {
        const Scene scene = sceneFrom(sceneOf(
            "'materials': { 'tin': { 'filter': 'bilinear', 'wrap': 'clamp', 'diffuse': '#102030', "
            "'specular': '#405060', 'shininess': 7 }, 'plain': {} }, "
            "'lights': [ { 'direction': [1, -1, '-1/2'] }, "
            "{ 'position': [0, 3, 0], 'color': '#ff8000' } ], "
            "'ambient': '#111213', 'shading': 'gouraud', 'depth': 'on', 'depthBits': 16, "
            "'antialiasing': 'area',"));
        const Appearance &appearance = scene.appearance;
        QCOMPARE(appearance.materials.size(), std::size_t(2)); // in the order of their names
        QCOMPARE(appearance.materials[0].name, std::string("plain"));
        const Material &tin = appearance.materials[1];
        QCOMPARE(tin.filter, TextureFilter::Bilinear);
        QCOMPARE(tin.wrap, TextureWrap::Clamp);
        QCOMPARE(tin.diffuse, (Colour{{16, 32, 48}}));
        QCOMPARE(tin.specular, (Colour{{64, 80, 96}}));
        QCOMPARE(tin.shininess, 7);
        QVERIFY(!tin.texture);
        QCOMPARE(appearance.lights.size(), std::size_t(2));
        QCOMPARE(appearance.lights[0].kind, Light::Kind::Directional);
        QCOMPARE(appearance.lights[0].at[2], -attributeOne / 2);
        QCOMPARE(appearance.lights[1].kind, Light::Kind::Positional);
        QCOMPARE(appearance.lights[1].colour, (Colour{{255, 128, 0}}));
        QCOMPARE(appearance.ambient, (Colour{{17, 18, 19}}));
        QCOMPARE(appearance.shading, Shading::Gouraud);
        QCOMPARE(appearance.depth, DepthUse::On);
        QCOMPARE(appearance.depthFormat, DepthFormat::Bits16);
        QCOMPARE(appearance.antialiasing, Antialiasing::Area);
    }

    void solidsAreRead()
    {
        const Scene scene = sceneFrom(sceneOf(
            camera,
            "{ 'triangle3': [[0, 0, 0], [1, 0, 0], [0, 1, '1/2']], 'colors': ['#ff000080', "
            "'#00ff00', '#0000ff'], "
            "'uv': [[0, 0], [1, 0], [0, 1]], 'normals': [[0, 0, 1], [0, 0, 2], [0, 3, 0]] }, "
            "{ 'polygon3': [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], 'color': '#112233' }, "
            "{ 'plane': [[-1, 0, 0], [1, 0, 0], [-1, 0, 2]], 'color': '#ff000040' }, "
            "{ 'sphere': [0, 1, 0], 'radius': 0.25, 'segments': [5, 4] }, "
            "{ 'sphere': [0, 1, 0], 'radius': 1 }, "
            "{ 'patch': [[[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], [[0, 1, 0], [1, 1, 1], [2, "
            "1, 0], [3, 1, 0]], "
            "[[0, 2, 0], [1, 2, 0], [2, 2, 0], [3, 2, 0]], [[0, 3, 0], [1, 3, 0], [2, 3, 0], [3, "
            "3, 9]]] }"));
        QCOMPARE(scene.solids.size(), std::size_t(6));
        QCOMPARE(scene.solids[0].corners[2].position, (Vector3{0, 1, 0.5}));
        QCOMPARE(scene.solids[0].corners[0].alpha, std::uint8_t(128));
        QCOMPARE(scene.solids[0].corners[1].normal, (Vector3{0, 0, 2}));
        QCOMPARE(scene.solids[0].corners[2].texture, (std::array<double, 2>{0, 1}));
        QCOMPARE(scene.solids[1].corners[3].colour, (Colour{{17, 34, 51}}));
        QCOMPARE(scene.solids[2].alpha, std::uint8_t(64));
        QCOMPARE(scene.solids[3].segments, (std::array<int, 2>{5, 4}));
        QCOMPARE(scene.solids[3].radius, 0.25);
        QCOMPARE(scene.solids[4].segments, (std::array<int, 2>{16, 8}));
        QCOMPARE(scene.solids[5].segments, (std::array<int, 2>{8, 8}));
        QCOMPARE(scene.solids[5].corners[15].position, (Vector3{3, 3, 9}));
    }

    void whatIsWrittenIsReadBackAsTheSame_data()
    {
        QTest::addColumn<QByteArray>("text");
        const auto row
            = [](const char *name, const QByteArray &text) { QTest::newRow(name) << text; };
        row("attributes",
            sceneOf({},
                    triangleWith("'z': [0.1, -3, 1048576], 'w': ['1/3', 2, 1e-6], "
                                 "'uv': [[0.7, 0.3], [-1, 1e5], [0, 0]], 'normals': [[0, 0, 1], "
                                 "[0.6, 0.8, 0], [1e-7, 0, 0]]")));
        row("alpha",
            sceneOf({},
                    "{ \"triangle\": " + corners
                        + ", 'colors': ['#ff000000', '#00ff0001', '#0000fffe'] }"));
        row("perspective", sceneOf("'camera': { 'eye': [0.1, 1e-3, 3], 'fieldOfView': 44.5 },"));
        row("orthographic",
            sceneOf("'camera': { 'projection': 'orthographic', 'height': '1/3' },"));
        row("materials",
            sceneOf(
                "'materials': { 'a \\\"b\\\" {': { 'texture': 'checker', 'diffuse': '#123456' }, "
                "'ünder': { 'shininess': 1024, 'wrap': 'clamp' }, 'none': {} },"));
        row("lights",
            sceneOf("'lights': [ { 'direction': [0.1, 0, 0] }, { 'position': [1, 2, 3], 'color': "
                    "'#010203' } ], "
                    "'ambient': '#000000', 'shading': 'flat',"));
        for (const char *depth : {"\"auto\"", "\"off\"", "\"on\""})
            row(depth, sceneOf(QByteArray("\"depth\": ") + depth + ","));
        for (const char *bits : {"\"exact\"", "16", "24", "32"})
            row(bits, sceneOf(QByteArray("\"depthBits\": ") + bits + ","));
        for (const char *samples : {"1", "4", "\"area\""})
            row(samples, sceneOf(QByteArray("\"antialiasing\": ") + samples + ","));
        row("solids, then shapes",
            sceneOf(camera + "'materials': { 'm': {} },",
                    "{ 'triangle': [[0, 0], [9, 0], [0, 9]], 'colors': ['#000000', '#000000', "
                    "'#000000'] }, "
                    "{ 'triangle3': [[0, 0, 0], [1, 0, 0], [0, 1, 0]], 'material': 'm' }, "
                    "{ 'polygon3': [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], 'colors': "
                    "['#000000', '#000000', '#000000', '#00000001'] }, "
                    "{ 'plane': [[-1, 0, 0], [1, 0, 0], [-1, 0, 2]], 'material': 'm', 'color': "
                    "'#abcdef' }, "
                    "{ 'sphere': [0, 1, 0.1], 'radius': '1/3' }, "
                    "{ 'patch': [[[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], [[0, 1, 0], [1, 1, "
                    "1], [2, 1, 0], [3, 1, 0]], "
                    "[[0, 2, 0], [1, 2, 0], [2, 2, 0], [3, 2, 0]], [[0, 3, 0], [1, 3, 0], [2, 3, "
                    "0], [3, 3, 9]]] }, "
                    "{ 'line': [[0, 0], [5, 5]], 'colors': ['#ffffff', '#ffffff'] }"));
    }
    void whatIsWrittenIsReadBackAsTheSame()
    {
        QFETCH(QByteArray, text);
        comesBack(text);
    }

    void largeFilesAreReadByPiecesWithAllOfIt()
    {
        QByteArray primitives;
        for (int i = 0; i < 10'000; ++i)
            primitives += triangleWith("'z': [0, 0.5, 1], 'material': 'b'") + ",\n";
        const QByteArray members = camera + "'materials': { 'a': {}, 'b': {} }, 'depthBits': 24,";
        const QByteArray text = sceneOf(
            members, primitives + "{ 'sphere': [0, 0, 0], 'radius': 1, 'material': 'a' }");
        QVERIFY(text.size() > shortText);
        const Scene scene = sceneFrom(text);
        QCOMPARE(scene.triangles.size(), std::size_t(10'000));
        QCOMPARE(scene.attributes.size(), std::size_t(10'000));
        QCOMPARE(scene.attributes.back().material, 1);
        QCOMPARE(scene.solids.size(), std::size_t(1));
        QCOMPARE(scene.appearance.depthFormat, DepthFormat::Bits24);
        QVERIFY(sceneFrom(writeScene(scene)) == scene);

        QCOMPARE(faultOf(sceneOf(members, primitives + "{ 'sphere': [0, 0], 'radius': 1 }")),
                 u"primitives[10000].sphere: an array of 2; expected an array of 3"_s);
        QCOMPARE(faultOf(sceneOf("'camera': { 'near': -1 },", primitives + "{}")),
                 u"camera.near: -1; expected more than 0"_s);
    }
};

PIXELPLUMB_TEST(TestSceneSpace)

} // namespace tst_scenespace

#include "tst_scenespace.moc"
