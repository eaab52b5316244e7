// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/space/camera.h"

#include <QByteArray>
#include <QStringList>

#include <vector>

namespace pixelplumb {

/// The lines of a scene file in the folder that say how its triangles look, without defaults;
/// readAppearance() reads them back.
QByteArray appearanceText(const Appearance &appearance, const QString &folder);

/// "{ \"projection\": \"perspective\", … }".
QByteArray cameraText(const Camera &camera);

/// A field of a scene file as a form shows it: texts without their quotation marks.
struct FieldText {
    QString name;
    QString value;
    QString byDefault;
    QStringList choices = {}; ///< empty where others are possible
};

std::vector<FieldText> fieldTexts(const Camera &camera);
std::vector<FieldText> fieldTexts(const Light &light);
std::vector<FieldText> fieldTexts(const Material &material, const QString &folder);
/// Without those of its materials and lights.
std::vector<FieldText> fieldTexts(const Appearance &appearance);

} // namespace pixelplumb
