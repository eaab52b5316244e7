// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/layersurface.h"

#include "widgets/look/signs.h"

namespace pixelplumb {

LayerSurface layerSurface(const ViewMapping &mapping, const QRectF &view, const QPalette &palette)
{
    return {pictureTransform(mapping.frame(), mapping.positionOfDevice(mapping.origin()),
                             cellSideOf(mapping)),
            view, isDark(palette) ? LayerTone::Dark : LayerTone::Light};
}

double cellSideOf(const ViewMapping &mapping)
{
    return mapping.zoom().factor() / mapping.devicePixelRatio();
}

} // namespace pixelplumb
