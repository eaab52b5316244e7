// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layer.h"

/// The rows of the table of layers.
namespace pixelplumb {

/// The primitive itself.
Layer verticesLayer();
/// The bounding box: raw, rounded as the slides print it, and clipped.
Layer boxLayer();
/// Where the edge functions are positive, with the normals <A, B>: all three, and one by one, 0
/// … 2.
Layer halfPlanesLayer();
Layer halfPlaneLayer(std::size_t edge);
/// What decides a sample, and what colours it, as numbers in the cells.
Layer weightsLayer();
Layer levelsLayer();
/// The oblique axes of β and γ, and the points whose weights everyone should know.
Layer barycentricAxesLayer();
/// Where an affine map takes the triangle, and the weights that it leaves.
Layer affineMapLayer();
/// The plane of a channel, 0 … 2, as contour lines.
Layer isolinesLayer(std::size_t channel);
/// For polygons: their triangles, and the rows by parity.
Layer innerEdgesLayer();
Layer edgeTableLayer();
/// The numbers by which a line or a circle goes on.
Layer decisionsLayer();
/// How many pixels a line has per pixel of its length.
Layer brightnessLayer();
/// For every pixel.
Layer samplesLayer();
Layer memoryLayer();

} // namespace pixelplumb
