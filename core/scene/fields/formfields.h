// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <QStringList>

#include <vector>

namespace pixelplumb {

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
