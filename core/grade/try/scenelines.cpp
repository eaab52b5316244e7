// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/scenelines.h"

#include "core/frame/framenames.h"
#include "core/scan/choicenames.h"

#include <QTextStream>

namespace pixelplumb {

namespace {

/// A 256th has at most eight decimals.
QString decimalOf(Lattice coordinate)
{
    return QString::number(double(coordinate) / unitsPerPixel, 'g', 17);
}

} // namespace

Result<QByteArray> sceneLines(const Scene &scene)
{
    const FrameSpec &frame = scene.frame;
    const bool holdsMore = !scene.solids.empty() || !scene.shapes.empty()
        || !scene.attributes.empty() || frame.firstColumn != 0 || frame.firstRow != 0;
    if (holdsMore || scene.triangles.empty())
        return InputError{{},
                          u"the scene cannot be told in plain lines"_s,
                          u"triangles alone, in a frame from (0, 0); JSON tells all"_s};
    QByteArray text;
    QTextStream lines(&text);
    const auto writeColour = [&lines](const Colour &colour) {
        for (const std::uint8_t channel : colour.channels)
            lines << ' ' << int(channel);
    };
    lines << "frame " << frame.width << ' ' << frame.height << "\norigin "
          << nameText(nameOf(frame.origin)) << "\ncentre " << nameText(nameOf(frame.pixelCentre))
          << "\nbackground";
    writeColour(frame.background);
    lines << "\nrule " << nameText(nameOf(scene.settings.fillRule)) << '\n';
    for (const Triangle &triangle : scene.triangles) {
        lines << "triangle";
        for (const Vertex &vertex : triangle.vertices) {
            lines << ' ' << decimalOf(vertex.position.x) << ' ' << decimalOf(vertex.position.y);
            writeColour(vertex.colour);
        }
        lines << '\n';
    }
    lines.flush();
    return text;
}

} // namespace pixelplumb
