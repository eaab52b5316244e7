// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/files.h"
#include "app/cli/options.h"
#include "core/layers/layer.h"
#include "core/layers/layerpainter.h"
#include "core/scene/scenefile.h"
#include "core/scene/text/coordinatetext.h"

#include <QPainter>

namespace pixelplumb::cli {

namespace {

const QString layersOption = QStringLiteral("layers");
const QString positionOption = QStringLiteral("position");
const QString triangleOption = QStringLiteral("triangle");
const QString imageOption = QStringLiteral("affine-image");
const QString affineLayer = QStringLiteral("affine-map");

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
    const InputError refused{QStringLiteral("--") + imageOption, text,
                             QStringLiteral("three points such as “40,12 10,8 30,40”")};
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
        const QString place = QStringLiteral("--%1, point %2, ").arg(imageOption).arg(i + 1);
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
            sayLine(QStringLiteral("--layers %1: %2").arg(id, why));
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
    const QString number = QStringLiteral("number");
    line.addOption({layersOption,
                    QStringLiteral("Draw figures of the course texts over the picture, from the "
                                   "numbers of the run; separated by commas, any of: %1.")
                        .arg(layerNames().join(QStringLiteral(", "))),
                    QStringLiteral("names")});
    line.addOption({positionOption,
                    QStringLiteral("Draw the picture as it is when this many steps of the run are "
                                   "done; all if left out."),
                    number});
    line.addOption({triangleOption,
                    QStringLiteral("Draw the layers of this primitive, counted from 0, in place of "
                                   "that of the last step."),
                    number});
    line.addOption({imageOption,
                    QStringLiteral("Where the layer affine-map takes the triangle's corners, in "
                                   "the order of the file: three points of x,y px."),
                    QStringLiteral("points")});
}

LayerRequest layerRequestFrom(const CommandLine &line)
{
    LayerRequest request;
    const QString place = QStringLiteral("--") + layersOption;
    if (line.isSet(layersOption))
        request.layers = line.value(layersOption).split(u',');
    for (const QString &id : request.layers) {
        if (!layerNamed(id))
            refuseUnknown(place, QStringLiteral("layer"), id, layerNames());
        if (request.layers.count(id) > 1)
            refuse({place, QStringLiteral("“%1” is named twice").arg(id),
                    QStringLiteral("each layer once")});
    }
    request.position = wholeNumberOf(line, positionOption, {});
    request.primitive = wholeNumberOf(line, triangleOption, {});
    if (request.primitive && request.layers.isEmpty())
        refuse({QStringLiteral("--") + triangleOption,
                QStringLiteral("there are no layers to tell of it"), place});
    if (!line.isSet(imageOption))
        return request;
    if (!request.layers.contains(affineLayer))
        refuse({QStringLiteral("--") + imageOption, QStringLiteral("there is no layer to draw it"),
                QStringLiteral("--layers affine-map")});
    request.affineImage = cornersFrom(line.value(imageOption));
    return request;
}

QImage pictureWithLayers(const SceneRun &run, const LayerRequest &request, std::int64_t scale)
{
    const auto traced = tracedWithProgress(run);
    const ScanTrace &trace = *traced->trace;
    if (request.position && std::size_t(*request.position) > trace.stepCount())
        refuse({QStringLiteral("--") + positionOption, QString::number(*request.position),
                QStringLiteral("an integer from 0 to %1").arg(trace.stepCount())});
    if (request.primitive)
        wholeNumber(QStringLiteral("--") + triangleOption, QString::number(*request.primitive),
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
