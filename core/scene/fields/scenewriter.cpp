// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framenames.h"
#include "core/scene/fields/appearancewriter.h"
#include "core/scene/fields/primitivewriter.h"
#include "core/scene/fields/solidwriter.h"
#include "core/scene/fileorder.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/filepath.h"
#include "core/scene/scenefile.h"
#include "core/scene/text/colourtext.h"

#include <QFileInfo>

namespace pixelplumb {

namespace {

// One primitive per line, so that a diff of two scenes is a diff of primitives. QJsonDocument would
// sort the keys and break lines.

QByteArray quoted(std::string_view text)
{
    return quotedText(QByteArray(text.data(), qsizetype(text.size())));
}

QByteArray quoted(const QString &text) { return quotedText(text.toUtf8()); }

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

/// Written only where the scene sets its own off-screen point.
QByteArray offScreenText(const FrameSpec &frame)
{
    return frame.offScreenPoint
        ? ",\n    \"offScreenPoint\": " + jsonPointText(*frame.offScreenPoint)
        : QByteArray();
}

QByteArray motionText(const Motion &motion)
{
    return "{ \"by\": " + jsonPointText(motion.by)
        + ", \"frames\": " + QByteArray::number(motion.frames) + " }";
}

/// Written only where the scene departs from the right algorithm.
QByteArray variantsText(VariantSet variants)
{
    if (variants.isEmpty())
        return {};
    QByteArray names;
    for (const Variant variant : variantsIn(variants))
        names += (names.isEmpty() ? "" : ", ") + quoted(nameOf(variant));
    return ",\n    \"variants\": [" + names + ']';
}

} // namespace

QByteArray writeScene(const Scene &scene, const QString &folder)
{
    QByteArray text = "{\n    \"pixelplumb\": " + QByteArray::number(sceneFormat)
        + ",\n    \"frame\": " + frameText(scene.frame)
        + ",\n    \"method\": " + quoted(std::string_view(scene.method))
        + ",\n    \"arithmetic\": " + quoted(nameOf(scene.settings.arithmetic))
        + ",\n    \"fillRule\": " + quoted(nameOf(scene.settings.fillRule))
        + offScreenText(scene.frame) + ",\n    \"rounding\": "
        + quoted(nameOf(scene.settings.rounding)) + variantsText(scene.settings.variants);
    if (scene.camera)
        text += ",\n    \"camera\": " + cameraText(*scene.camera);
    if (scene.motion)
        text += ",\n    \"motion\": " + motionText(*scene.motion);
    text += appearanceText(scene.appearance, folder) + ",\n    \"primitives\": [";
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
