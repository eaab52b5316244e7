// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/oldgrades.h"

#include "core/frame/framebuffer.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace pixelplumb {

namespace {

const QString lineKey = QStringLiteral("line");

/// None where it is in frame coordinates, or nobody knows of which frame it is.
std::optional<QJsonObject> framePixelOf(const QJsonObject &scene, const Assignment &assignment)
{
    const QJsonObject pixel = scene[QStringLiteral("firstDifference")].toObject();
    const auto asked = std::ranges::find(
        assignment.scenes, scene[QStringLiteral("scene")].toString(), &AssignedScene::name);
    if (!pixel.contains(lineKey) || asked == assignment.scenes.end())
        return std::nullopt;
    const FrameSpec &frame = asked->scene.frame;
    const QString x = QStringLiteral("x");
    return QJsonObject{
        {x, frame.firstColumn + pixel[x].toInt()},
        {QStringLiteral("y"), qint64(rowOfPictureLine(frame, pixel[lineKey].toInt()))}};
}

} // namespace

QByteArray inFrameCoordinates(const QByteArray &grade, const Assignment &assignment)
{
    QJsonObject object = QJsonDocument::fromJson(grade).object();
    QJsonArray scenes = object[QStringLiteral("scenes")].toArray();
    bool isOld = false;
    for (qsizetype i = 0; i < scenes.size(); ++i) {
        QJsonObject scene = scenes[i].toObject();
        if (const auto pixel = framePixelOf(scene, assignment)) {
            scene[QStringLiteral("firstDifference")] = *pixel;
            scenes[i] = scene;
            isOld = true;
        }
    }
    if (!isOld)
        return grade;
    object[QStringLiteral("scenes")] = scenes;
    return QJsonDocument(object).toJson();
}

} // namespace pixelplumb
