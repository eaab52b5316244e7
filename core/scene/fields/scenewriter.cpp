// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/partwriter.h"
#include "core/scene/fields/primitivewriter.h"
#include "core/scene/fields/solidwriter.h"
#include "core/scene/fileorder.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/filepath.h"
#include "core/scene/scenefile.h"

#include <QFileInfo>

namespace pixelplumb {

// One primitive per line, so that a diff of two scenes is a diff of primitives. QJsonDocument would
// sort the keys and break lines.

QByteArray writeScene(const Scene &scene, const QString &folder)
{
    QByteArray text = "{\n    \"pixelplumb\": " + QByteArray::number(sceneFormat) + ",\n    "
        + surroundingsText(scene, folder) + ",\n    \"primitives\": [";
    const char *separator = "\n        ";
    const auto append = [&](const QByteArray &primitive) {
        text += separator + primitive;
        separator = ",\n        ";
    };
    const auto appendHidden = [&](std::size_t index) {
        append(primitiveText(scene.hidden[index], scene.appearance.materials));
    };
    const auto appendTriangle = [&](std::size_t index, const TriangleAttributes *attributes) {
        append(primitiveText(scene.triangles[index], attributes, scene.appearance.materials));
    };
    visitTriangles(scene, appendTriangle, appendHidden);
    for (const Solid &solid : scene.solids)
        append(primitiveText(solid, scene.appearance.materials, folder));
    visitShapes(
        scene, [&](std::size_t index) { append(primitiveText(scene.shapes[index])); },
        appendHidden);
    return text + (text.endsWith('[') ? "]\n}\n" : "\n    ]\n}\n");
}

std::optional<InputError> writeSceneFile(const QString &path, const Scene &scene)
{
    return writeFile(path, writeScene(scene, QFileInfo(filePath(path)).absolutePath()));
}

} // namespace pixelplumb
