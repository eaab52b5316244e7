// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/surfaces.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The distance from a segment to the origin.
double distanceOfSegment(const SpaceVector<double> &a, const SpaceVector<double> &b)
{
    const SpaceVector<double> along = b - a;
    const double length = dot(along, along);
    const double t = length == 0 ? 0 : std::clamp(-dot(a, along) / length, 0.0, 1.0);
    return lengthOf(between(a, b, t));
}

} // namespace

double sphereDistance(double radius, const std::array<int, 2> &segments)
{
    // In the half-plane of a row's middle lines: x is the distance from the axis, y runs along it.
    const double shrinking = circlePoint(0.5, double(segments[0])).cosine;
    const auto middle = [&](int row) {
        const CirclePoint<double> down = circlePoint(double(row), 2.0 * segments[1]);
        return SpaceVector<double>(down.sine * shrinking, down.cosine, 0);
    };
    double nearest = 1;
    for (int row = 0; row < segments[1]; ++row)
        nearest = std::min(nearest, distanceOfSegment(middle(row), middle(row + 1)));
    return std::abs(radius) * (1 - nearest);
}

double patchDistance(const Solid &patch)
{
    constexpr int samples = 8; // along a side of a cell
    const BezierPatch<double> surface(patch);
    const auto columns = double(patch.segments[0]);
    const auto rows = double(patch.segments[1]);
    double largest = 0;
    for (int cell = 0; cell < patch.segments[0] * patch.segments[1]; ++cell) {
        const int i = cell % patch.segments[0];
        const int j = cell / patch.segments[0];
        const auto corner = [&](int right, int up) {
            return surface.point((i + right) / columns, (j + up) / rows);
        };
        const std::array corners = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
        for (int sample = 0; sample <= samples * (samples + 2); ++sample) {
            const double s = double(sample % (samples + 1)) / samples;
            const double t = double(sample / (samples + 1)) / samples; // NOLINT: whole rows
            // On the triangle below the diagonal from the first corner, or above it.
            const SpaceVector<double> flat = s >= t
                ? corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[1])
                : corners[0] + t * (corners[3] - corners[0]) + s * (corners[2] - corners[3]);
            const SpaceVector<double> round = surface.point((i + s) / columns, (j + t) / rows);
            largest = std::max(largest, lengthOf(flat - round));
        }
    }
    return largest;
}

} // namespace pixelplumb
