// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/colourtext.h"
#include "core/scene/fileaccess.h"
#include "core/scene/framenames.h"
#include "core/scene/scenefile.h"

namespace pixelplumb {

namespace {

// One primitive a line, so that a difference
// of two scenes reads as a difference of triangles. QJsonDocument would sort the keys and break
// lines.

QByteArray quoted(std::string_view text)
{
    return '"' + QByteArray(text.data(), qsizetype(text.size())) + '"';
}

QByteArray quoted(const QString &text) { return '"' + text.toUtf8() + '"'; }

QByteArray coordinate(Lattice units)
{
    const QString text = coordinateText(units);
    return text.contains(u'/') ? quoted(text) : text.toUtf8();
}

QByteArray frameText(const FrameSpec &frame)
{
    QByteArray text = "{ \"width\": " + QByteArray::number(frame.width)
        + ", \"height\": " + QByteArray::number(frame.height) + ", \"background\": "
        + quoted(colourText(frame.background)) + ", \"origin\": " + quoted(nameOf(frame.origin))
        + ", \"pixelCentre\": " + quoted(nameOf(frame.pixelCentre));
    if (frame.firstColumn != 0 || frame.firstRow != 0) {
        text += ", \"firstPixel\": [" + QByteArray::number(frame.firstColumn) + ", "
            + QByteArray::number(frame.firstRow) + ']';
    }
    return text + " }";
}

QByteArray triangleText(const Triangle &triangle)
{
    QByteArray positions;
    QByteArray colours;
    for (const Vertex &vertex : triangle.vertices) {
        const QByteArray separator = positions.isEmpty() ? "" : ", ";
        positions += separator + '[' + coordinate(vertex.position.x) + ", "
            + coordinate(vertex.position.y) + ']';
        colours += separator + quoted(colourText(vertex.colour));
    }
    return "{ \"triangle\": [" + positions + "], \"colors\": [" + colours + "] }";
}

} // namespace

QByteArray writeScene(const Scene &scene)
{
    QByteArray text = "{\n    \"pixelplumb\": " + QByteArray::number(sceneFormat)
        + ",\n    \"frame\": " + frameText(scene.frame)
        + ",\n    \"method\": " + quoted(std::string_view(scene.method))
        + ",\n    \"arithmetic\": " + quoted(nameOf(scene.settings.arithmetic))
        + ",\n    \"fillRule\": " + quoted(nameOf(scene.settings.fillRule))
        + ",\n    \"rounding\": " + quoted(nameOf(scene.settings.rounding))
        + ",\n    \"primitives\": [";
    const char *separator = "\n        ";
    for (const Triangle &triangle : scene.triangles) {
        text += separator + triangleText(triangle);
        separator = ",\n        ";
    }
    return text + (scene.triangles.empty() ? "]\n}\n" : "\n    ]\n}\n");
}

std::optional<InputError> writeSceneFile(const QString &path, const Scene &scene)
{
    return writeFile(path, writeScene(scene));
}

} // namespace pixelplumb
