// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerdrawing.h"
#include "core/layers/layermoment.h"

#include <span>

namespace pixelplumb {

/// A figure of the course texts, drawn over a person's own scene from the numbers of its run: a row
/// of the table of layers.
struct Layer {
    QString id; ///< "half-planes"
    QString title; ///< in menus: "Half-planes"
    QString toolTip; ///< what it shows, and where its numbers come from
    QString source; ///< course text and slide, by the names of resources/sources.md
    /// Of what it has something to say; empty: of every pixel.
    std::vector<PrimitiveKind> kinds = {};
    /// The ids of the methods whose numbers it shows; empty: of all that draw these kinds.
    QStringList methods = {};
    void (*draw)(const LayerMoment &moment, LayerDrawing &drawing);

    /// Why it has nothing to show of a scene under its method, as a sentence without its stop;
    /// empty when it has.
    QString objection(const Scene &scene) const;
};

/// Every layer, in the order of the menu.
std::span<const Layer> layers();
/// Null when there is no such layer.
const Layer *layerNamed(QStringView id);

/// The primitive in hand, or the last one before it of which a layer has something to say; none
/// where there is no such one.
std::optional<std::size_t> subjectOf(const Layer &layer, const LayerView &view);

/// What the layers with these ids draw of a moment, each of its subject. Unknown ids, and layers
/// with an objection, draw nothing.
LayerDrawing drawingOf(const QStringList &ids, const LayerView &view);

} // namespace pixelplumb
