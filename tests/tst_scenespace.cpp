// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileaccess.h"
#include "core/scene/solidlimits.h"
#include "tests/support/scenetext.h"

#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

using namespace pixelplumb;

namespace {

const QByteArray corners = "[[4, 5], [58, 12], [26, 44]]";
const QByteArray red = R"(["#ff0000", "#ff0000", "#ff0000"])";
const QByteArray camera = R"("camera": { "eye": [0, 0, 5] }, )";

QByteArray sceneOf(const QByteArray &members, const QByteArray &primitive = {})
{
    return sceneWith(members + "\n\"primitives\": [" + primitive + "]");
}

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

/// Whether a text is read, and what is written of it is read as the same scene and written as the
/// same bytes.
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

/// The message without line and column, which the faults' own test looks at.
QString complaint(const QByteArray &text)
{
    const QString error = errorOf(text);
    const qsizetype end = error.startsWith(QStringLiteral("line "))
        ? error.indexOf(QStringLiteral(", "), error.indexOf(u',') + 1) + 2
        : 0;
    return error.sliced(end);
}

void write(const QString &path, const QByteArray &content) { QVERIFY(!writeFile(path, content)); }

} // namespace

/// What scene files say of three dimensions and of how triangles look: every key read, written and
/// refused.
class TestSceneSpace : public QObject {
    Q_OBJECT

private slots:
    void attributesAreReadInTheirOwnFormat()
    {
        const Scene scene = sceneFrom(
            sceneOf(R"("materials": { "board": { "texture": "checker" } },)",
                    triangleWith(R"("z": [0, "1/4", 1], "w": [1, 2, 0.5], "material": "board",
                                    "uv": [[0, 0], [1, 0], ["1/16777216", 1e6]],
                                    "normals": [[0, 0, -1], [0, 1, 0], [1, 0, 0]])")));
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
            = readScene(sceneOf({}, triangleWith(R"("z": [0, "1/3", 1])")));
        QVERIFY(reading);
        QCOMPARE(reading->snaps.size(), std::size_t(1));
        QCOMPARE(reading->snaps[0].message(),
                 QStringLiteral("primitives[0].z[1]: 1/3 is read as 5592405/16777216, displaced by "
                                "-1/50331648"));
    }

    void alphaGoesToTheAttributes()
    {
        const Scene scene
            = sceneFrom(sceneOf({},
                                "{ \"triangle\": " + corners
                                    + R"(, "colors": ["#ff000080", "#00ff00ff", "#0000ff"] })"));
        QCOMPARE(scene.attributes.size(), std::size_t(1));
        QCOMPARE(scene.attributes[0].vertices[0].alpha, std::uint8_t(128));
        QCOMPARE(scene.attributes[0].vertices[1].alpha, std::uint8_t(255));
        QVERIFY(writeScene(scene).contains(R"(["#ff000080", "#00ff00", "#0000ff"])"));
    }

    void whatSaysNothingNewIsNoAttribute()
    {
        const Scene scene = sceneFrom(sceneOf(
            {}, triangleWith(R"("z": [0, 0, 0], "w": [1, 1, 1], "uv": [[0, 0], [0, 0], [0, 0]])")));
        QVERIFY(scene.attributes.empty());
    }

    void theCameraIsReadWithItsDefaults()
    {
        const Scene plain = sceneFrom(sceneOf(R"("camera": {},)"));
        QVERIFY(plain.camera == Camera());
        const Scene scene = sceneFrom(sceneOf(
            R"("camera": { "projection": "orthographic", "eye": [1, "1/4", 3.5], "target": [0, 1, 0],
                "up": [1, 0, 0], "height": 3, "near": 0.5, "far": 20 },)"));
        QVERIFY(scene.camera.has_value());
        QCOMPARE(scene.camera->projection, Projection::Orthographic);
        QCOMPARE(scene.camera->eye, (Vector3{1, 0.25, 3.5}));
        QCOMPARE(scene.camera->height, 3.0);
        QCOMPARE(scene.camera->far, 20.0);
    }

    void materialsAndLightsAreRead()
    {
        const Scene scene = sceneFrom(sceneOf(R"(
            "materials": { "tin": { "filter": "bilinear", "wrap": "clamp", "diffuse": "#102030",
                                    "specular": "#405060", "shininess": 7 }, "plain": {} },
            "lights": [ { "direction": [1, -1, "-1/2"] },
                        { "position": [0, 3, 0], "color": "#ff8000" } ],
            "ambient": "#111213", "shading": "gouraud", "depth": "on", "depthBits": 16,
            "antialiasing": "area",)"));
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
        const Scene scene = sceneFrom(sceneOf(camera, R"(
            { "triangle3": [[0, 0, 0], [1, 0, 0], [0, 1, "1/2"]], "colors": ["#ff000080", "#00ff00", "#0000ff"],
              "uv": [[0, 0], [1, 0], [0, 1]], "normals": [[0, 0, 1], [0, 0, 2], [0, 3, 0]] },
            { "polygon3": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], "color": "#112233" },
            { "plane": [[-1, 0, 0], [1, 0, 0], [-1, 0, 2]], "color": "#ff000040" },
            { "sphere": [0, 1, 0], "radius": 0.25, "segments": [5, 4] },
            { "sphere": [0, 1, 0], "radius": 1 },
            { "patch": [[[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], [[0, 1, 0], [1, 1, 1], [2, 1, 0], [3, 1, 0]],
                        [[0, 2, 0], [1, 2, 0], [2, 2, 0], [3, 2, 0]], [[0, 3, 0], [1, 3, 0], [2, 3, 0], [3, 3, 9]]] })"));
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
            sceneOf({}, triangleWith(R"("z": [0.1, -3, 1048576], "w": ["1/3", 2, 1e-6],
                 "uv": [[0.7, 0.3], [-1, 1e5], [0, 0]], "normals": [[0, 0, 1], [0.6, 0.8, 0], [1e-7, 0, 0]])")));
        row("alpha",
            sceneOf({},
                    "{ \"triangle\": " + corners
                        + R"(, "colors": ["#ff000000", "#00ff0001", "#0000fffe"] })"));
        row("perspective", sceneOf(R"("camera": { "eye": [0.1, 1e-3, 3], "fieldOfView": 44.5 },)"));
        row("orthographic",
            sceneOf(R"("camera": { "projection": "orthographic", "height": "1/3" },)"));
        row("materials",
            sceneOf(R"("materials": { "a \"b\" {": { "texture": "checker", "diffuse": "#123456" },
                 "ünder": { "shininess": 1024, "wrap": "clamp" }, "none": {} },)"));
        row("lights",
            sceneOf(
                R"("lights": [ { "direction": [0.1, 0, 0] }, { "position": [1, 2, 3], "color": "#010203" } ],
                 "ambient": "#000000", "shading": "flat",)"));
        for (const char *depth : {"\"auto\"", "\"off\"", "\"on\""})
            row(depth, sceneOf(QByteArray("\"depth\": ") + depth + ","));
        for (const char *bits : {"\"exact\"", "16", "24", "32"})
            row(bits, sceneOf(QByteArray("\"depthBits\": ") + bits + ","));
        for (const char *samples : {"1", "4", "\"area\""})
            row(samples, sceneOf(QByteArray("\"antialiasing\": ") + samples + ","));
        row("solids, then shapes", sceneOf(camera + R"("materials": { "m": {} },)", R"(
              { "triangle": [[0, 0], [9, 0], [0, 9]], "colors": ["#000000", "#000000", "#000000"] },
              { "triangle3": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "material": "m" },
              { "polygon3": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], "colors": ["#000000", "#000000", "#000000", "#00000001"] },
              { "plane": [[-1, 0, 0], [1, 0, 0], [-1, 0, 2]], "material": "m", "color": "#abcdef" },
              { "sphere": [0, 1, 0.1], "radius": "1/3" },
              { "patch": [[[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], [[0, 1, 0], [1, 1, 1], [2, 1, 0], [3, 1, 0]],
                          [[0, 2, 0], [1, 2, 0], [2, 2, 0], [3, 2, 0]], [[0, 3, 0], [1, 3, 0], [2, 3, 0], [3, 3, 9]]] },
              { "line": [[0, 0], [5, 5]], "colors": ["#ffffff", "#ffffff"] })"));
    }
    void whatIsWrittenIsReadBackAsTheSame()
    {
        QFETCH(QByteArray, text);
        comesBack(text);
    }

    void everyFaultSaysWhereAndWhatWasExpected_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *name, const QByteArray &text, const char *message) {
            QTest::newRow(name) << text << QString::fromUtf8(message);
        };
        const auto withCamera = [](const char *members) {
            return sceneOf(QByteArray("\"camera\": ") + members + ",");
        };
        const auto withSolid = [](const char *solid) { return sceneOf(camera, solid); };
        const auto with = [](const char *members) { return sceneOf(QByteArray(members) + ","); };

        row("w of 0", sceneOf({}, triangleWith(R"("w": [1, 0, 1])")),
            "primitives[0].w[1]: w of 0; expected 1/16777216 or more");
        row("w that snaps to 0", sceneOf({}, triangleWith(R"("w": [1, 1, 1e-9])")),
            "primitives[0].w[2]: w of 0; expected 1/16777216 or more");
        row("w below 0", sceneOf({}, triangleWith(R"("w": [-1, -1, -1])")),
            "primitives[0].w[0]: w of -1; expected 1/16777216 or more");
        row("z too large", sceneOf({}, triangleWith(R"("z": [0, 1048577, 0])")),
            "primitives[0].z[1]: 1048577 is outside ±1048576; expected a number such as 1, 0.5 or "
            "1/3 within ±1048576");
        row("z that is no number", sceneOf({}, triangleWith(R"("z": [0, "near", 0])")),
            "primitives[0].z[1]: “near” is no number; expected a number such as 1, 0.5 or 1/3 "
            "within ±1048576");
        row("two z", sceneOf({}, triangleWith(R"("z": [0, 1])")),
            "primitives[0].z: an array of 2; expected an array of 3");
        row("one u", sceneOf({}, triangleWith(R"("uv": [[0], [0, 0], [0, 0]])")),
            "primitives[0].uv[0]: an array of 1; expected an array of 2");
        row("normal of length 0",
            sceneOf({}, triangleWith(R"("normals": [[0, 0, 1], [0, 0, 1e-9], [0, 0, 1]])")),
            "primitives[0].normals[1]: a normal of length 0; expected a component of ±1/16777216 "
            "or more");
        row("no materials", sceneOf({}, triangleWith(R"("material": "board")")),
            "primitives[0].material: “board”; expected one of the scene's \"materials\", which has "
            "none");
        row("unknown material",
            sceneOf(R"("materials": { "tin": {}, "lead": {} },)",
                    triangleWith(R"("material": "board")")),
            "primitives[0].material: “board”; expected one of lead, tin");
        row("material twice", with(R"("materials": { "tin": {}, "tin": {} })"),
            "materials.tin: the key is there twice; expected every key once");
        row("blended shape",
            sceneOf({}, R"({ "polygon": [[0, 0], [9, 0], [0, 9]], "color": "#ff000080" })"),
            "primitives[0].color: “#ff000080” is not opaque, and only triangles are blended; "
            "expected alpha ff, or #rrggbb without alpha");

        row("unknown key of the camera", withCamera(R"({ "zoom": 2 })"),
            "camera.zoom: unknown key “zoom”; expected one of projection, eye, target, up, "
            "fieldOfView, height, near, far");
        row("eye = target", withCamera(R"({ "eye": [1, 2, 3], "target": [1, 2, 3] })"),
            "camera: eye and target are one point; expected two points, between which the camera "
            "looks");
        row("up of length 0", withCamera(R"({ "up": [0, 0, 0] })"),
            "camera.up: a direction of length 0; expected the direction that is up");
        row("up along the view", withCamera(R"({ "up": [0, 0, -3] })"),
            "camera.up: up is parallel to the view from eye to target; expected a direction across "
            "it");
        row("view along the default's up", withCamera(R"({ "eye": [0, 5, 0] })"),
            "camera: up is parallel to the view from eye to target; expected a direction across "
            "it");
        row("near of 0", withCamera(R"({ "near": 0 })"), "camera.near: 0; expected more than 0");
        row("near = far", withCamera(R"({ "near": 3, "far": 3 })"),
            "camera.far: near 3 and far 3; expected a far plane behind the near one");
        row("near beyond the default far", withCamera(R"({ "near": 200 })"),
            "camera: near 200 and far 100; expected a far plane behind the near one");
        row("field of view of 180", withCamera(R"({ "fieldOfView": 180 })"),
            "camera.fieldOfView: 180; expected more than 0 and less than 180");
        row("field of view of 0", withCamera(R"({ "fieldOfView": 0 })"),
            "camera.fieldOfView: 0; expected more than 0 and less than 180");
        row("height of a perspective", withCamera(R"({ "height": 4 })"),
            "camera.height: “height” of a camera that is perspective; expected “fieldOfView”");
        row("angle of an orthographic one",
            withCamera(R"({ "projection": "orthographic", "fieldOfView": 60 })"),
            "camera.fieldOfView: “fieldOfView” of a camera that is orthographic; expected "
            "“height”");
        row("unknown projection", withCamera(R"({ "projection": "fish-eye" })"),
            "camera.projection: “fish-eye”; expected one of perspective, orthographic");
        row("eye too far", withCamera(R"({ "eye": [0, 0, 1e300] })"),
            "camera.eye[2]: 1e+300 is outside ±1048576; expected a number such as 1, 0.5 or 1/3 "
            "within ±1048576");

        row("materials in a list", with(R"("materials": [])"),
            "materials: an array of 0; expected an object with a material for each name");
        row("unknown key of a material", with(R"("materials": { "a": { "colour": 1 } })"),
            "materials.a.colour: unknown key “colour”; expected one of texture, filter, wrap, "
            "diffuse, specular, shininess");
        row("filter", with(R"("materials": { "a": { "filter": "cubic" } })"),
            "materials.a.filter: “cubic”; expected one of nearest, bilinear");
        row("wrap", with(R"("materials": { "a": { "wrap": 1 } })"),
            "materials.a.wrap: 1; expected one of repeat, clamp");
        row("shininess", with(R"("materials": { "a": { "shininess": 1025 } })"),
            "materials.a.shininess: 1025; expected an integer from 1 to 1024");
        row("light that shines nowhere", with(R"("lights": [ { "direction": [0, 0, 0] } ])"),
            "lights[0].direction: a direction of length 0; expected a component of ±1/16777216 or "
            "more");
        row("light without a place", with(R"("lights": [ {} ])"),
            "lights[0]: a light without direction and position; expected one of the two");
        row("light with two",
            with(R"("lights": [ { "direction": [1, 0, 0], "position": [1, 0, 0] } ])"),
            "lights[0]: both direction and position; expected one of the two");
        row("nine lights",
            sceneOf("\"lights\": [" + QByteArray("{ \"direction\": [1, 0, 0] },").repeated(8)
                    + "{ \"direction\": [1, 0, 0] }],"),
            "lights: 9 lights; expected at most 8");
        row("shading", with(R"("shading": "toon")"),
            "shading: “toon”; expected one of flat, gouraud, phong");
        row("depth", with(R"("depth": true)"), "depth: true; expected one of auto, off, on");
        row("depth bits", with(R"("depthBits": 8)"),
            "depthBits: 8; expected one of exact, 16, 24, 32");
        row("depth bits in quotation marks", with(R"("depthBits": "16")"),
            "depthBits: “16”; expected one of exact, 16, 24, 32");
        row("antialiasing", with(R"("antialiasing": 8)"),
            "antialiasing: 8; expected one of 1, 4, 16, area");

        row("no camera", sceneOf({}, R"({ "sphere": [0, 0, 0], "radius": 1 })"),
            "primitives[0].sphere: a sphere in a scene without a camera; expected a key \"camera\" "
            "of the scene: { \"eye\": [0, 0, 5], … }");
        row("solid after a shape",
            withSolid(R"({ "line": [[0, 0], [5, 5]], "colors": ["#ffffff", "#ffffff"] },
                         { "sphere": [0, 0, 0], "radius": 1 })"),
            "primitives[1].sphere: a sphere after a shape of the frame; expected triangles, then "
            "what is seen through the camera, then shapes");
        row("triangle after a solid", withSolid(R"({ "sphere": [0, 0, 0], "radius": 1 },
                         { "triangle": [[0, 0], [9, 0], [0, 9]], "colors": ["#000000", "#000000", "#000000"] })"),
            "primitives[1].triangle: a triangle after another primitive; expected all triangles "
            "first: they are drawn before the others");
        row("unknown key of a solid", withSolid(R"({ "sphere": [0, 0, 0], "radii": 1 })"),
            "primitives[0].radii: unknown key “radii”; expected one of sphere, material, color, "
            "radius, segments");
        row("radius below 0", withSolid(R"({ "sphere": [0, 0, 0], "radius": -1 })"),
            "primitives[0].radius: a radius of -1; expected more than 0");
        row("no radius", withSolid(R"({ "sphere": [0, 0, 0] })"),
            "primitives[0].radius: nothing; expected a number such as 1, 0.5 or 1/3 within "
            "±1048576");
        row("two segments around",
            withSolid(R"({ "sphere": [0, 0, 0], "radius": 1, "segments": [2, 8] })"),
            "primitives[0].segments[0]: 2; expected an integer from 3 to 1024");
        row("one segment along",
            withSolid(R"({ "sphere": [0, 0, 0], "radius": 1, "segments": [3, 1] })"),
            "primitives[0].segments[1]: 1; expected an integer from 2 to 1024");
        row("too many segments",
            withSolid(R"({ "sphere": [0, 0, 0], "radius": 1, "segments": [1025, 8] })"),
            "primitives[0].segments[0]: 1025; expected an integer from 3 to 1024");
        row("a sphere that reaches too far",
            withSolid(R"({ "sphere": [0, 0, 1000000], "radius": 100000 })"),
            "primitives[0].sphere: it reaches to 1.1e+06; expected all of it within ±1048576");
        row("two corners", withSolid(R"({ "polygon3": [[0, 0, 0], [1, 0, 0]] })"),
            "primitives[0].polygon3: an array of 2; expected an array of 3 points or more");
        row("a corner of two numbers",
            withSolid(R"({ "triangle3": [[0, 0], [1, 0, 0], [0, 1, 0]] })"),
            "primitives[0].triangle3[0]: an array of 2; expected an array of 3");
        row("polygon on a line", withSolid(R"({ "polygon3": [[0, 0, 0], [1, 1, 1], [3, 3, 3]] })"),
            "primitives[0].polygon3: corners on one line; expected a polygon with an area");
        row("polygon that is bent",
            withSolid(R"({ "polygon3": [[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]] })"),
            "primitives[0].polygon3: corners that are not in one plane; expected a polygon in one "
            "plane");
        row("polygon that is concave",
            withSolid(R"({ "polygon3": [[0, 0, 0], [4, 0, 0], [1, 1, 0], [0, 4, 0]] })"),
            "primitives[0].polygon3: a polygon that is not convex; expected a convex one; others "
            "are made of several");
        row("pentagram",
            withSolid(
                R"({ "polygon3": [[0, 3, 0], [2, -3, 0], [-3, 1, 0], [3, 1, 0], [-2, -3, 0]] })"),
            "primitives[0].polygon3: a polygon that is not convex; expected a convex one; others "
            "are made of several");
        row("plane on a line", withSolid(R"({ "plane": [[0, 0, 0], [1, 1, 1], [3, 3, 3]] })"),
            "primitives[0].plane: three points on one line; expected three that span a plane");
        row("three rows of a patch", withSolid(R"({ "patch": [[], [], []] })"),
            "primitives[0].patch: an array of 3; expected an array of 4");
        row("color and colors",
            withSolid(R"({ "triangle3": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "color": "#ffffff",
                           "colors": ["#ffffff", "#ffffff", "#ffffff"] })"),
            "primitives[0].colors: both color and colors; expected one of the two");
        row("two colours of three",
            withSolid(
                R"({ "triangle3": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "colors": ["#ffffff", "#ffffff"] })"),
            "primitives[0].colors: an array of 2; expected an array of 3");
        row("solid's normal of length 0",
            withSolid(
                R"({ "triangle3": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "normals": [[0, 0, 1], [0, 0, 0], [0, 0, 1]] })"),
            "primitives[0].normals[1]: a normal of length 0; expected a direction");
        row("mesh that is no name", withSolid(R"({ "mesh": 5 })"),
            "primitives[0].mesh: 5; expected a string");
        row("no primitive", withSolid(R"({ })"),
            "primitives[0]: no primitive is named; expected one of triangle, points, line, circle, "
            "ellipse, bezier, polygon, text, triangle3, polygon3, plane, sphere, patch, mesh");
    }
    void everyFaultSaysWhereAndWhatWasExpected()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);
        QCOMPARE(complaint(text), message);
    }

    void memoryIsSaidBeforeItIsTaken()
    {
        const QByteArray sphere
            = R"({ "sphere": [0, 0, 0], "radius": 1, "segments": [1024, 1024] })";
        QVERIFY(readScene(sceneOf(camera, sphere)));
        const QString error = complaint(sceneOf(camera, sphere + ", " + sphere));
        QVERIFY2(error.startsWith(QStringLiteral(
                     "primitives[1].sphere: the scene's solids are cut into 4190208 triangles, ")),
                 qPrintable(error));
        QVERIFY2(error.endsWith(QStringLiteral(" MiB; expected at most 2097152 triangles")),
                 qPrintable(error));
    }

    void largeFilesAreReadByPiecesWithAllOfIt()
    {
        QByteArray primitives;
        for (int i = 0; i < 8'000; ++i)
            primitives += triangleWith(R"("z": [0, 0.5, 1], "material": "b")") + ",\n";
        const QByteArray members
            = camera + R"("materials": { "a": {}, "b": {} }, "depthBits": 24,)";
        const QByteArray text = sceneOf(
            members, primitives + R"({ "sphere": [0, 0, 0], "radius": 1, "material": "a" })");
        QVERIFY(text.size() > largestWholeText);
        const Scene scene = sceneFrom(text);
        QCOMPARE(scene.triangles.size(), std::size_t(8'000));
        QCOMPARE(scene.attributes.size(), std::size_t(8'000));
        QCOMPARE(scene.attributes.back().material, 1);
        QCOMPARE(scene.solids.size(), std::size_t(1));
        QCOMPARE(scene.appearance.depthFormat, DepthFormat::Bits24);
        QVERIFY(sceneFrom(writeScene(scene)) == scene);

        QCOMPARE(complaint(sceneOf(members, primitives + R"({ "sphere": [0, 0], "radius": 1 })")),
                 QStringLiteral("primitives[8000].sphere: an array of 2; expected an array of 3"));
        QCOMPARE(complaint(sceneOf(R"("camera": { "near": -1 },)", primitives + "{}")),
                 QStringLiteral("camera.near: -1; expected more than 0"));
    }

    void aPictureIsReadFromTheLowestRow()
    {
        const QTemporaryDir folder;
        QImage picture(2, 3, QImage::Format_RGB32);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 2; ++column)
                picture.setPixel(column, row, qRgb(10 * row, column, 7));
        }
        QVERIFY(picture.save(folder.filePath(QStringLiteral("picture.png"))));
        const QString path = folder.filePath(QStringLiteral("scene.json"));
        write(
            path,
            sceneOf(
                R"("materials": { "a": { "texture": "picture.png" }, "b": { "texture": "picture.png" } },)"));

        const Result<SceneReading> reading = readSceneFile(path);

        QVERIFY2(reading, reading ? "" : qPrintable(reading.error().message()));
        const std::vector<Material> &materials = reading->scene.appearance.materials;
        QCOMPARE(materials[0].texture->width, 2);
        QCOMPARE(materials[0].texture->height, 3);
        QCOMPARE(materials[0].texture->texel(1, 0), (Colour{{20, 1, 7}}));
        QCOMPARE(materials[0].texture->texel(0, 2), (Colour{{0, 0, 7}}));
        QCOMPARE(materials[0].texture, materials[1].texture); // read once
    }

    void aSceneThatIsSavedElsewhereFindsItsFiles()
    {
        const QTemporaryDir folder;
        const QDir below(folder.filePath(QStringLiteral("below")));
        QVERIFY(below.mkpath(QStringLiteral(".")));
        QVERIFY(QImage(4, 4, QImage::Format_RGB32).save(below.filePath(QStringLiteral("p.png"))));
        write(below.filePath(QStringLiteral("m.obj")), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const QString here = below.filePath(QStringLiteral("scene.json"));
        write(here,
              sceneOf(camera + R"("materials": { "a": { "texture": "p.png" } },)",
                      R"({ "mesh": "m.obj", "material": "a" })"));
        const Result<SceneReading> reading = readSceneFile(here);
        QVERIFY2(reading, reading ? "" : qPrintable(reading.error().message()));

        const QString elsewhere = folder.filePath(QStringLiteral("scene.json"));
        QVERIFY(!writeSceneFile(elsewhere, reading->scene));
        const Result<SceneReading> again = readSceneFile(elsewhere);

        QVERIFY2(again, again ? "" : qPrintable(again.error().message()));
        QVERIFY(again->scene == reading->scene);
        const QByteArray written = *readFile(elsewhere);
        QVERIFY2(written.contains("\"below/p.png\"") && written.contains("\"below/m.obj\""),
                 written.constData());
    }

    void filesThatCannotBeUsedAreNamed_data()
    {
        QTest::addColumn<QByteArray>("content"); // of the file; none: there is no file
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
        // A header of 5000 x 20 texels, and nothing behind it.
        row("huge picture", "P6 5000 20 255\n", "a.ppm",
            "materials.a.texture: %1: a picture of 5000 × 20, 0 MiB of texels; expected at most "
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
        const QByteArray text = name.endsWith(QStringLiteral(".obj"))
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
            folder.filePath(QStringLiteral("a.obj")),
            "o house\nmtllib none.mtl\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2.5e-1 0\nvt 0 1\nvt +1 0.5\n"
            "vn 0 0 1\ng wall\nusemtl none\nf 1//1 2//1 3//1 4//1\nf -4/1 -2/2 -1/1 # a comment");
        const Scene scene
            = readScene(
                  sceneOf(
                      camera,
                      R"({ "mesh": "a.obj", "at": [1, 2, 3], "scale": 2, "rotate": [0, 90, 0] })"),
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

QTEST_GUILESS_MAIN(TestSceneSpace)
#include "tst_scenespace.moc"
