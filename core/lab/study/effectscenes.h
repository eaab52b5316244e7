// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <optional>
#include <vector>

/// The scenes of the study of effects: the same on every machine.
namespace pixelplumb::effectscenes {

/// One way to draw a scene.
struct Way {
    QString name;
    Scene scene;
    std::optional<double> distance = {}; ///< between a surface and its triangles
    std::optional<double> brightness = {}; ///< of a line, per pixel of its length
    std::optional<Scene> truth = {}; ///< if it is not the group's
};

/// A scene drawn in several ways, and the truth that judges them.
struct Group {
    QString name;
    std::vector<Way> ways;
    Scene truth;
};

std::vector<Group> all();

} // namespace pixelplumb::effectscenes
