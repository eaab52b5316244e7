// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/scenetext.h"

#include <QRandomGenerator>

namespace pixelplumb {

QByteArray sceneWith(const QByteArray &members)
{
    return "{\n  \"pixelplumb\": 1,\n  \"frame\": { \"width\": 64, \"height\": 48 },\n" + members
        + "\n}\n";
}

QByteArray sceneOfTriangleAt(const QByteArray &firstX)
{
    return sceneWith(
        "  \"primitives\": [\n    { \"triangle\": [[" + firstX
        + ", 5], [58, 12], [26, 44]], \"colors\": [\"#ff0000\", \"#00ff00\", \"#0000ff\"] }\n  ]");
}

QByteArray sceneOf(const QByteArray &members, const QByteArray &primitives)
{
    return sceneWith(members + "\n'primitives': [" + primitives + "]").replace('\'', '"');
}

QString errorOf(const QByteArray &text)
{
    const Result<SceneReading> reading = readScene(text);
    return reading ? u"no error"_s : reading.error().message();
}

QString faultOf(const QByteArray &text)
{
    const QString error = errorOf(text);
    if (!error.startsWith(u"line "_s))
        return error;
    const qsizetype column = error.indexOf(u',') + 1;
    return error.sliced(error.indexOf(u',', column) + 2);
}

Scene randomScene(quint32 seed)
{
    QRandomGenerator random(seed);
    const auto chosen = [&](const auto &choices) {
        return choices[std::size_t(random.bounded(int(choices.size())))];
    };
    const auto coordinate = [&] {
        const qint64 largest = random.bounded(2) == 0 ? 64 * unitsPerPixel : largestCoordinate;
        return Lattice(random.bounded(qint64(-largest), qint64(largest + 1)));
    };
    const auto colour = [&] {
        return Colour{{std::uint8_t(random.bounded(256)), std::uint8_t(random.bounded(256)),
                       std::uint8_t(random.bounded(256))}};
    };
    Scene scene;
    scene.frame.width = random.bounded(1, largestFrameSide + 1);
    scene.frame.height = random.bounded(1, 100);
    scene.frame.background = colour();
    scene.frame.origin = random.bounded(2) == 0 ? FrameOrigin::BottomLeft : FrameOrigin::TopLeft;
    scene.frame.pixelCentre = random.bounded(2) == 0 ? PixelCentre::Integer : PixelCentre::Half;
    const auto firstPixel = [&] {
        return std::int32_t(random.bounded(qint64(-largestPixel), qint64(largestPixel + 1)));
    };
    scene.frame.firstColumn = random.bounded(2) == 0 ? 0 : firstPixel();
    scene.frame.firstRow = random.bounded(2) == 0 ? 0 : firstPixel();
    scene.settings.arithmetic = chosen(allArithmetics);
    scene.settings.fillRule = random.bounded(2) == 0 ? FillRule::Closed : FillRule::HalfOpenColumn;
    scene.settings.rounding = chosen(allByteRoundings);
    scene.triangles.resize(std::size_t(random.bounded(5)));
    for (Triangle &triangle : scene.triangles) {
        for (Vertex &vertex : triangle.vertices)
            vertex = {{coordinate(), coordinate()}, colour()};
    }
    if (random.bounded(2) == 0)
        scene.frame.offScreenPoint = {coordinate(), coordinate()};
    for (std::size_t place = 0; place <= scene.triangles.size(); ++place) {
        for (quint32 hidden = random.bounded(4); hidden > 2; --hidden) {
            HiddenTriangle triangle;
            for (Vertex &vertex : triangle.triangle.vertices)
                vertex = {{coordinate(), coordinate()}, colour()};
            scene.hidden.push_back({place, triangle});
        }
    }
    return scene;
}

} // namespace pixelplumb
