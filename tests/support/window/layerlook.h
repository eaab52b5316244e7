// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layer.h"

#include <memory>

/// Shared helpers of the layer tests: a run to look at, and the texts of a drawing.
namespace pixelplumb {

/// The whole frame of a run, zoomed in until the cells show numbers.
struct Look {
    explicit Look(const Scene &scene)
        : traced(traceScene(scene))
    {
        view.traced = traced.get();
        view.position = traced->trace->stepCount();
        view.seen = samplesOf(windowOf(scene.frame));
        view.cell = 32;
    }

    LayerDrawing drawing(const char *layer) const
    {
        return drawingOf({QString::fromLatin1(layer)}, view);
    }

    std::shared_ptr<const TracedScene> traced;
    LayerView view;
};

inline QStringList textsOf(const std::vector<LayerDrawing::Label> &labels)
{
    QStringList texts;
    for (const LayerDrawing::Label &label : labels)
        texts.append(label.text);
    return texts;
}

/// The numbers in a pixel's cell, from top to bottom.
inline QStringList textsIn(const LayerDrawing &drawing, std::int64_t x, std::int64_t y)
{
    QStringList texts;
    for (const LayerDrawing::CellText &text : drawing.cells) {
        if (text.x == x && text.y == y)
            texts.append(text.text);
    }
    return texts;
}

} // namespace pixelplumb
