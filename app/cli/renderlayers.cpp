// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commandline.h"
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "core/layers/layer.h"
#include "core/layers/layerpainter.h"
#include "core/scene/scenefile.h"
#include "core/scene/text/coordinatetext.h"

#include <QPainter>

namespace pixelplumb::cli {

namespace {

const QString layersOption = u"layers"_s;
const QString positionOption = u"position"_s;
const QString triangleOption = u"triangle"_s;
const QString imageOption = u"affine-image"_s;
const QString affineLayer = u"affine-map"_s;

QStringList layerNames()
{
    QStringList names;
    for (const Layer &layer : layers())
        names.append(layer.id);
    return names;
}

/// Reads "40,12 10,8 30,40"; snapped coordinates are reported on stderr.
Corners cornersFrom(const QString &text)
{
    const InputError refused{u"--"_s + imageOption, text,
                             u"three points such as “40,12 10,8 30,40”"_s};
    const QStringList points = text.split(u' ', Qt::SkipEmptyParts);
    Corners corners;
    QStringList reports;
    if (points.size() != qsizetype(corners.size()))
        refuse(refused);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const QStringList coordinates = points[qsizetype(i)].split(u',');
        if (coordinates.size() != 2)
            refuse(refused);
        const auto x = parseCoordinate(coordinates[0]);
        const auto y = parseCoordinate(coordinates[1]);
        if (!x || !y)
            refuse(refused);
        corners[i] = {x->units, y->units};
        const QString place = u"--%1, point %2, "_s.arg(imageOption).arg(i + 1);
        if (x->isDisplaced())
            reports += SnapReport{place + u'x', coordinates[0], *x, &coordinateFormat}.message();
        if (y->isDisplaced())
            reports += SnapReport{place + u'y', coordinates[1], *y, &coordinateFormat}.message();
    }
    for (const QString &report : reports)
        sayLine(report);
    return corners;
}

/// Where the affine-map layer takes its triangle.
std::optional<AffineImage> imageOf(const LayerRequest &request, const LayerView &view)
{
    const std::optional<std::size_t> triangle
        = request.affineImage ? subjectOf(*layerNamed(affineLayer), view) : std::nullopt;
    return triangle ? std::optional(AffineImage{*triangle, *request.affineImage}) : std::nullopt;
}

void paintLayers(QImage &picture, const LayerRequest &request, const LayerView &view)
{
    for (const QString &id : request.layers) {
        if (const QString why = layerNamed(id)->objection(view.traced->scene); !why.isEmpty())
            sayLine(u"--layers %1: %2"_s.arg(id, why));
    }
    const LayerDrawing drawing = drawingOf(request.layers, view);
    for (const QString &note : drawing.notes)
        sayLine(note);
    const FrameSpec &frame = view.traced->scene.frame;
    const bool isDark = QColor::fromRgb(packed(frame.background)).lightness() < 128;
    QPainter painter(&picture);
    const QStringList omissions
        = LayerPainter().paint(painter, drawing,
                               {pictureTransform(frame, {}, view.cell), picture.rect(),
                                isDark ? LayerTone::Dark : LayerTone::Light});
    for (const QString &omission : omissions)
        sayLine(omission);
}

} // namespace

void addLayerOptions(CommandLine &line)
{
    const QString number = u"number"_s;
    line.addOption(
        {layersOption,
         u"Draw figures of the course texts over the picture, from the numbers of the run; "
         "separated by commas, any of: %1."_s.arg(layerNames().join(u", "_s)),
         u"names"_s});
    line.addOption(
        {positionOption,
         u"Draw the picture as it is when this many steps of the run are done; all if left out."_s,
         number});
    line.addOption(
        {triangleOption,
         u"Draw the layers of this primitive, counted from 0, in place of that of the last step."_s,
         number});
    line.addOption(
        {imageOption,
         u"Where the layer affine-map takes the triangle's corners, in the order of the file: "
         "three points of x,y px."_s,
         u"points"_s});
}

LayerRequest layerRequestFrom(const CommandLine &line)
{
    LayerRequest request;
    const QString place = u"--"_s + layersOption;
    if (line.isSet(layersOption))
        request.layers = line.value(layersOption).split(u',');
    for (const QString &id : request.layers) {
        if (!layerNamed(id))
            refuseUnknown(place, u"layer"_s, id, layerNames());
        if (request.layers.count(id) > 1)
            refuse({place, u"“%1” is named twice"_s.arg(id), u"each layer once"_s});
    }
    request.position = wholeNumberOf(line, positionOption, {});
    request.primitive = wholeNumberOf(line, triangleOption, {});
    if (request.primitive && request.layers.isEmpty())
        refuse({u"--"_s + triangleOption, u"there are no layers to tell of it"_s, place});
    if (!line.isSet(imageOption))
        return request;
    if (!request.layers.contains(affineLayer))
        refuse(
            {u"--"_s + imageOption, u"there is no layer to draw it"_s, u"--layers affine-map"_s});
    request.affineImage = cornersFrom(line.value(imageOption));
    return request;
}

QImage pictureWithLayers(const SceneRun &run, const LayerRequest &request, std::int64_t scale)
{
    const auto traced = tracedWithProgress(run);
    const ScanTrace &trace = *traced->trace;
    if (request.position && std::size_t(*request.position) > trace.stepCount())
        refuse({u"--"_s + positionOption, QString::number(*request.position),
                u"an integer from 0 to %1"_s.arg(trace.stepCount())});
    if (request.primitive)
        wholeNumber(u"--"_s + triangleOption, QString::number(*request.primitive),
                    primitivesOf(trace));
    LayerView view;
    view.traced = traced.get();
    view.position = request.position ? std::size_t(*request.position) : trace.stepCount();
    view.seen = samplesOf(windowOf(run.scene.frame));
    view.cell = double(scale);
    if (request.primitive)
        view.primitive = std::size_t(*request.primitive);
    view.image = imageOf(request, view);
    TraceCursor cursor(trace, run.scene.frame);
    cursor.seek(view.position);
    QImage picture = enlarged(cursor.frame().copy(), scale);
    paintLayers(picture, request, view);
    return picture;
}

} // namespace pixelplumb::cli
