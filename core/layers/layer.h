// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerdrawing.h"
#include "core/layers/layermoment.h"

#include <functional>
#include <span>

namespace pixelplumb {

/// A figure of the course texts, drawn over the user's own scene with the numbers of its run: a row
/// of the table of layers.
struct Layer {
    QString id; ///< "half-planes"
    QString title; ///< in menus: "Half-planes"
    QString toolTip; ///< what it shows, and where its numbers come from
    QString source; ///< course text and slide, by the names of resources/sources.md
    /// The kinds that it has something to say about; empty: every pixel.
    std::vector<PrimitiveKind> kinds = {};
    /// The ids of the methods whose numbers it shows; empty: of all that draw these kinds.
    QStringList methods = {};
    std::function<void(const LayerMoment &moment, LayerDrawing &drawing)> draw;

    /// Why it has nothing to show for a scene under its method, as a sentence without its full
    /// stop; empty if it has.
    QString objection(const Scene &scene) const;
};

/// Every layer, in the order of the menu.
std::span<const Layer> layers();
/// Null if there is no such layer.
const Layer *layerNamed(QStringView id);

/// The current primitive, or the last one before it that the layer has something to say about; none
/// if there is none.
std::optional<std::size_t> subjectOf(const Layer &layer, const LayerView &view);

/// What the layers with these ids draw at a moment, each for its subject. Unknown ids, and layers
/// with an objection, draw nothing.
LayerDrawing drawingOf(const QStringList &ids, const LayerView &view);

} // namespace pixelplumb
