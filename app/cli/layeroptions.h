// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commandline.h"
#include "core/layers/affineimage.h"
#include "core/scene/scene.h"

#include <QImage>

namespace pixelplumb::cli {

/// What of a run is drawn, and which layers over it.
struct LayerRequest {
    QStringList layers; ///< ids
    std::optional<std::int64_t> position; ///< so many steps are done; none: all
    std::optional<std::int64_t> primitive; ///< of which the layers tell; none: that in hand
    std::optional<Corners> affineImage; ///< of the layer affine-map; none: its first map

    /// Whether the finished picture alone will not do.
    bool asksForRun() const { return position || !layers.isEmpty(); }
};

/// --layers, --position, --triangle and --affine-image.
void addLayerOptions(CommandLine &line);
Result<LayerRequest> layerRequestFrom(const CommandLine &line);

/// The picture at the position with every pixel a square of `scale`, and the layers over it. What
/// they have to say beside the picture, and why one has nothing to show, is said on stderr.
Result<QImage> pictureWithLayers(const Scene &scene, const LayerRequest &request,
                                 std::int64_t scale);

} // namespace pixelplumb::cli
