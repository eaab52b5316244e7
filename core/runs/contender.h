// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/scene/scene.h"

namespace pixelplumb {

/// What is compared side by side or tested: a method under its settings, or the truth.
struct Contender {
    const Method *method = nullptr; ///< null: the oracle
    ScanSettings settings;

    bool isTruth() const { return method == nullptr; }
    /// "column-scan float64 closed", "truth closed"
    QString name() const;

    friend bool operator==(const Contender &, const Contender &) = default;
};

/// The method under the settings as far as it supports them: it replaces an unsupported arithmetic
/// or fill rule by its own first one.
Contender contenderFor(const Method &method, const ScanSettings &wanted);

/// The scene as the contender draws it; for the truth the scene keeps its own method.
Scene sceneFor(const Scene &scene, const Contender &contender);

/// One of the primitives, with a triangle's attributes.
Primitives aloneOf(const Primitives &primitives, std::size_t index);

} // namespace pixelplumb
