// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/scenetext.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_spacefaults {

using namespace pixelplumb;

namespace {

const QByteArray corners = "[[4, 5], [58, 12], [26, 44]]";
const QByteArray red = "['#ff0000', '#ff0000', '#ff0000']";
const QByteArray camera = "'camera': { 'eye': [0, 0, 5] },";

QByteArray triangleWith(const QByteArray &members)
{
    return "{ \"triangle\": " + corners + ", \"colors\": " + red + ", " + members + " }";
}

} // namespace

/// Faults in what scene files say about three dimensions and about the triangles' appearance.
class TestSpaceFaults : public QObject {
    Q_OBJECT

private slots:
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

        row("w of 0", sceneOf({}, triangleWith("'w': [1, 0, 1]")),
            "primitives[0].w[1]: w of 0; expected 1/16777216 or more");
        row("w that snaps to 0", sceneOf({}, triangleWith("'w': [1, 1, 1e-9]")),
            "primitives[0].w[2]: w of 0; expected 1/16777216 or more");
        row("w below 0", sceneOf({}, triangleWith("'w': [-1, -1, -1]")),
            "primitives[0].w[0]: w of -1; expected 1/16777216 or more");
        row("z too large", sceneOf({}, triangleWith("'z': [0, 1048577, 0]")),
            "primitives[0].z[1]: 1048577 is outside ±1048576; expected a number such as 1, 0.5 or "
            "1/3 within ±1048576");
        row("z that is no number", sceneOf({}, triangleWith("'z': [0, 'near', 0]")),
            "primitives[0].z[1]: “near” is no number; expected a number such as 1, 0.5 or 1/3 "
            "within ±1048576");
        row("two z", sceneOf({}, triangleWith("'z': [0, 1]")),
            "primitives[0].z: an array of 2; expected an array of 3");
        row("one u", sceneOf({}, triangleWith("'uv': [[0], [0, 0], [0, 0]]")),
            "primitives[0].uv[0]: an array of 1; expected an array of 2");
        row("normal of length 0",
            sceneOf({}, triangleWith("'normals': [[0, 0, 1], [0, 0, 1e-9], [0, 0, 1]]")),
            "primitives[0].normals[1]: a normal of length 0; expected a component of ±1/16777216 "
            "or more");
        row("no materials", sceneOf({}, triangleWith("'material': 'board'")),
            "primitives[0].material: “board”; expected one of the scene's \"materials\", which has "
            "none");
        row("unknown material",
            sceneOf("'materials': { 'tin': {}, 'lead': {} },", triangleWith("'material': 'board'")),
            "primitives[0].material: “board”; expected one of lead, tin");
        row("material twice", with("'materials': { 'tin': {}, 'tin': {} }"),
            "materials.tin: the key is there twice; expected every key once");
        row("blended shape",
            sceneOf({}, "{ 'polygon': [[0, 0], [9, 0], [0, 9]], 'color': '#ff000080' }"),
            "primitives[0].color: “#ff000080” is not opaque, and only triangles are blended; "
            "expected alpha ff, or #rrggbb without alpha");

        row("unknown key of the camera", withCamera("{ 'zoom': 2 }"),
            "camera.zoom: unknown key “zoom”; expected one of projection, eye, target, up, "
            "fieldOfView, height, near, far");
        row("eye = target", withCamera("{ 'eye': [1, 2, 3], 'target': [1, 2, 3] }"),
            "camera: eye and target are one point; expected two points, between which the camera "
            "looks");
        row("up of length 0", withCamera("{ 'up': [0, 0, 0] }"),
            "camera.up: a direction of length 0; expected the direction that is up");
        row("up along the view", withCamera("{ 'up': [0, 0, -3] }"),
            "camera.up: up is parallel to the view from eye to target; expected a direction across "
            "it");
        row("view along the default's up", withCamera("{ 'eye': [0, 5, 0] }"),
            "camera: up is parallel to the view from eye to target; expected a direction across "
            "it");
        row("near of 0", withCamera("{ 'near': 0 }"), "camera.near: 0; expected more than 0");
        row("near = far", withCamera("{ 'near': 3, 'far': 3 }"),
            "camera.far: near 3 and far 3; expected a far plane behind the near one");
        row("near beyond the default far", withCamera("{ 'near': 200 }"),
            "camera: near 200 and far 100; expected a far plane behind the near one");
        row("field of view of 180", withCamera("{ 'fieldOfView': 180 }"),
            "camera.fieldOfView: 180; expected more than 0 and less than 180");
        row("field of view of 0", withCamera("{ 'fieldOfView': 0 }"),
            "camera.fieldOfView: 0; expected more than 0 and less than 180");
        row("height of a perspective", withCamera("{ 'height': 4 }"),
            "camera.height: “height” of a camera that is perspective; expected “fieldOfView”");
        row("angle of an orthographic one",
            withCamera("{ 'projection': 'orthographic', 'fieldOfView': 60 }"),
            "camera.fieldOfView: “fieldOfView” of a camera that is orthographic; expected "
            "“height”");
        row("unknown projection", withCamera("{ 'projection': 'fish-eye' }"),
            "camera.projection: “fish-eye”; expected one of perspective, orthographic");
        row("eye too far", withCamera("{ 'eye': [0, 0, 1e300] }"),
            "camera.eye[2]: 1e300 is outside ±1048576; expected a number such as 1, 0.5 or 1/3 "
            "within ±1048576");

        row("materials in a list", with("'materials': []"),
            "materials: an array of 0; expected an object with a material for each name");
        row("unknown key of a material", with("'materials': { 'a': { 'colour': 1 } }"),
            "materials.a.colour: unknown key “colour”; expected one of texture, filter, wrap, "
            "diffuse, specular, shininess");
        row("filter", with("'materials': { 'a': { 'filter': 'cubic' } }"),
            "materials.a.filter: “cubic”; expected one of nearest, bilinear");
        row("wrap", with("'materials': { 'a': { 'wrap': 1 } }"),
            "materials.a.wrap: 1; expected one of repeat, clamp");
        row("shininess", with("'materials': { 'a': { 'shininess': 1025 } }"),
            "materials.a.shininess: 1025; expected an integer from 1 to 1024");
        row("light that shines nowhere", with("'lights': [ { 'direction': [0, 0, 0] } ]"),
            "lights[0].direction: a direction of length 0; expected a component of ±1/16777216 or "
            "more");
        row("light without a place", with("'lights': [ {} ]"),
            "lights[0]: a light without direction and position; expected one of the two");
        row("light with two",
            with("'lights': [ { 'direction': [1, 0, 0], 'position': [1, 0, 0] } ]"),
            "lights[0]: both direction and position; expected one of the two");
        row("nine lights",
            sceneOf("\"lights\": [" + QByteArray("{ \"direction\": [1, 0, 0] },").repeated(8)
                    + "{ \"direction\": [1, 0, 0] }],"),
            "lights: 9 lights; expected at most 8");
        row("shading", with("'shading': 'toon'"),
            "shading: “toon”; expected one of flat, gouraud, phong");
        row("depth", with("'depth': true"), "depth: true; expected one of auto, off, on");
        row("depth bits", with("'depthBits': 8"),
            "depthBits: 8; expected one of exact, 16, 24, 32");
        row("depth bits in quotation marks", with("'depthBits': '16'"),
            "depthBits: “16”; expected one of exact, 16, 24, 32");
        row("antialiasing", with("'antialiasing': 8"),
            "antialiasing: 8; expected one of 1, 4, 16, area");

        row("no camera", sceneOf({}, "{ 'sphere': [0, 0, 0], 'radius': 1 }"),
            "primitives[0].sphere: a sphere in a scene without a camera; expected a key \"camera\" "
            "of the scene: { \"eye\": [0, 0, 5], … }");
        row("solid after a shape",
            withSolid("{ 'line': [[0, 0], [5, 5]], 'colors': ['#ffffff', '#ffffff'] }, "
                      "{ 'sphere': [0, 0, 0], 'radius': 1 }"),
            "primitives[1].sphere: a sphere after a shape of the frame; expected triangles, then "
            "what is seen through the camera, then shapes");
        row("triangle after a solid",
            withSolid("{ 'sphere': [0, 0, 0], 'radius': 1 }, "
                      "{ 'triangle': [[0, 0], [9, 0], [0, 9]], 'colors': ['#000000', '#000000', "
                      "'#000000'] }"),
            "primitives[1].triangle: a triangle after another primitive; expected all triangles "
            "first: they are drawn before the others");
        row("unknown key of a solid", withSolid("{ 'sphere': [0, 0, 0], 'radii': 1 }"),
            "primitives[0].radii: unknown key “radii”; expected one of sphere, material, color, "
            "radius, segments, hidden");
        row("radius below 0", withSolid("{ 'sphere': [0, 0, 0], 'radius': -1 }"),
            "primitives[0].radius: a radius of -1; expected more than 0");
        row("no radius", withSolid("{ 'sphere': [0, 0, 0] }"),
            "primitives[0].radius: nothing; expected a number such as 1, 0.5 or 1/3 within "
            "±1048576");
        row("two segments around",
            withSolid("{ 'sphere': [0, 0, 0], 'radius': 1, 'segments': [2, 8] }"),
            "primitives[0].segments[0]: 2; expected an integer from 3 to 1024");
        row("one segment along",
            withSolid("{ 'sphere': [0, 0, 0], 'radius': 1, 'segments': [3, 1] }"),
            "primitives[0].segments[1]: 1; expected an integer from 2 to 1024");
        row("too many segments",
            withSolid("{ 'sphere': [0, 0, 0], 'radius': 1, 'segments': [1025, 8] }"),
            "primitives[0].segments[0]: 1025; expected an integer from 3 to 1024");
        row("a sphere that reaches too far",
            withSolid("{ 'sphere': [0, 0, 1000000], 'radius': 100000 }"),
            "primitives[0].sphere: it reaches to 1.1e+06; expected all of it within ±1048576");
        row("two corners", withSolid("{ 'polygon3': [[0, 0, 0], [1, 0, 0]] }"),
            "primitives[0].polygon3: an array of 2; expected an array of 3 points or more");
        row("a corner of two numbers", withSolid("{ 'triangle3': [[0, 0], [1, 0, 0], [0, 1, 0]] }"),
            "primitives[0].triangle3[0]: an array of 2; expected an array of 3");
        row("polygon on a line", withSolid("{ 'polygon3': [[0, 0, 0], [1, 1, 1], [3, 3, 3]] }"),
            "primitives[0].polygon3: corners on one line; expected a polygon with an area");
        row("polygon that is bent",
            withSolid("{ 'polygon3': [[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]] }"),
            "primitives[0].polygon3: corners that are not in one plane; expected a polygon in one "
            "plane");
        row("polygon that is concave",
            withSolid("{ 'polygon3': [[0, 0, 0], [4, 0, 0], [1, 1, 0], [0, 4, 0]] }"),
            "primitives[0].polygon3: a polygon that is not convex; expected a convex one; others "
            "are made of several");
        row("pentagram",
            withSolid(
                "{ 'polygon3': [[0, 3, 0], [2, -3, 0], [-3, 1, 0], [3, 1, 0], [-2, -3, 0]] }"),
            "primitives[0].polygon3: a polygon that is not convex; expected a convex one; others "
            "are made of several");
        row("plane on a line", withSolid("{ 'plane': [[0, 0, 0], [1, 1, 1], [3, 3, 3]] }"),
            "primitives[0].plane: three points on one line; expected three that span a plane");
        row("three rows of a patch", withSolid("{ 'patch': [[], [], []] }"),
            "primitives[0].patch: an array of 3; expected an array of 4");
        row("color and colors",
            withSolid("{ 'triangle3': [[0, 0, 0], [1, 0, 0], [0, 1, 0]], 'color': '#ffffff', "
                      "'colors': ['#ffffff', '#ffffff', '#ffffff'] }"),
            "primitives[0].colors: both color and colors; expected one of the two");
        row("two colours of three",
            withSolid("{ 'triangle3': [[0, 0, 0], [1, 0, 0], [0, 1, 0]], 'colors': ['#ffffff', "
                      "'#ffffff'] }"),
            "primitives[0].colors: an array of 2; expected an array of 3");
        row("solid's normal of length 0",
            withSolid("{ 'triangle3': [[0, 0, 0], [1, 0, 0], [0, 1, 0]], 'normals': [[0, 0, 1], "
                      "[0, 0, 0], [0, 0, 1]] }"),
            "primitives[0].normals[1]: a normal of length 0; expected a direction");
        row("mesh that is no name", withSolid("{ 'mesh': 5 }"),
            "primitives[0].mesh: 5; expected a string");
        row("no primitive", withSolid("{ }"),
            "primitives[0]: no primitive is named; expected one of triangle, points, line, circle, "
            "ellipse, bezier, polygon, text, triangle3, polygon3, plane, sphere, patch, mesh");
    }
    void everyFaultSaysWhereAndWhatWasExpected()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);
        QCOMPARE(faultOf(text), message);
    }

    void memoryIsReportedBeforeAllocation()
    {
        const QByteArray sphere = "{ 'sphere': [0, 0, 0], 'radius': 1, 'segments': [1024, 1024] }";
        QVERIFY(readScene(sceneOf(camera, sphere)));
        const QString error = faultOf(sceneOf(camera, sphere + ", " + sphere));
        QVERIFY2(error.startsWith(QStringLiteral(
                     "primitives[1].sphere: the scene's solids are cut into 4190208 triangles, ")),
                 qPrintable(error));
        QVERIFY2(error.endsWith(QStringLiteral(" MiB; expected at most 2097152 triangles")),
                 qPrintable(error));
    }
};

PIXELPLUMB_TEST(TestSpaceFaults)

} // namespace tst_spacefaults

#include "tst_spacefaults.moc"
