// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/scene/scene.h"

namespace pixelplumb {

/// What is laid side by side or put to the test: a method under its settings, or the truth.
struct Contender {
    const Method *method = nullptr; ///< null: the oracle
    ScanSettings settings;

    bool isTruth() const { return method == nullptr; }
    /// "column-scan float64 closed", "truth closed"
    QString name() const;

    friend bool operator==(const Contender &, const Contender &) = default;
};

/// The method under the settings as far as it has them: instead of an arithmetic or a fill rule
/// that it does not have, its own first one.
Contender contenderFor(const Method &method, const ScanSettings &wanted);

/// The scene as the contender draws it; the truth of a scene is that of the scene's own method.
Scene sceneFor(const Scene &scene, const Contender &contender);

/// The primitives that the contender draws: those of its method's kinds, and for the truth all.
Primitives primitivesFor(Primitives primitives, const Contender &contender);
/// One of the primitives, with what a triangle carries.
Primitives aloneOf(const Primitives &primitives, std::size_t index);

} // namespace pixelplumb
