// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/fieldtexts.h"
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
    const FieldTexts texts(folder, scene.appearance.materials);
    const QByteArrayList surroundings
        = texts.of(scene) + texts.ofOthersThanDefaults(scene.appearance);
    QByteArray text = "{\n    \"pixelplumb\": " + QByteArray::number(sceneFormat) + ",\n    "
        + surroundings.join(",\n    ") + ",\n    \"primitives\": [";
    const char *separator = "\n        ";
    const auto append = [&](const QByteArrayList &fields) {
        text += separator + FieldTexts::inBraces(fields);
        separator = ",\n        ";
    };
    const QByteArrayList isHidden = {"\"hidden\": true"};
    const auto appendHidden = [&](std::size_t index) {
        std::visit([&](const auto &hidden) { append(texts.of(hidden) + isHidden); },
                   scene.hidden[index].primitive);
    };
    const auto appendTriangle = [&](std::size_t index, const TriangleAttributes *attributes) {
        append(texts.of(HiddenTriangle{scene.triangles[index],
                                       attributes ? *attributes : TriangleAttributes()}));
    };
    visitTriangles(scene, appendTriangle, appendHidden);
    for (const Solid &solid : scene.solids)
        append(texts.of(solid) + (solid.isHidden ? isHidden : QByteArrayList()));
    visitShapes(
        scene, [&](std::size_t index) { append(texts.of(scene.shapes[index])); }, appendHidden);
    return text + (text.endsWith('[') ? "]\n}\n" : "\n    ]\n}\n");
}

std::optional<InputError> writeSceneFile(const QString &path, const Scene &scene)
{
    return writeFile(path, writeScene(scene, QFileInfo(filePath(path)).absolutePath()));
}

} // namespace pixelplumb
