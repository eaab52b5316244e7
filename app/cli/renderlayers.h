// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/layers/affineimage.h"
#include "core/scene/scene.h"

#include <QImage>

namespace pixelplumb::cli {

/// How much of a run is drawn, and which layers over it.
struct LayerRequest {
    QStringList layers; ///< ids
    std::optional<std::int64_t> position; ///< how many steps are done; none: all
    std::optional<std::int64_t> primitive; ///< that the layers describe; none: the current one
    std::optional<Corners> affineImage; ///< of the layer affine-map; none: its first map

    /// Whether the finished picture alone is not enough.
    bool asksForRun() const { return position || !layers.isEmpty(); }
};

/// --layers, --position, --triangle and --affine-image.
void addLayerOptions(CommandLine &line);
Result<LayerRequest> layerRequestFrom(const CommandLine &line);

/// The picture at the position, each pixel a square of `scale` pixels a side, with the layers over
/// it. Texts that belong to the layers, and why one shows nothing, go to stderr.
Result<QImage> pictureWithLayers(const Scene &scene, const LayerRequest &request,
                                 std::int64_t scale);

} // namespace pixelplumb::cli
