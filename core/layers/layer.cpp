// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layer.h"

#include "core/layers/layers.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pixelplumb {

namespace {

bool hasKind(const Scene &scene, PrimitiveKind kind)
{
    if (kind == PrimitiveKind::Triangle)
        return scene.hasTriangles();
    return std::ranges::any_of(scene.shapes,
                               [kind](const Shape &shape) { return shape.kind == kind; });
}

QString listed(const std::vector<PrimitiveKind> &kinds)
{
    QStringList names;
    for (const PrimitiveKind kind : kinds)
        names.append(nameOf(kind));
    return names.join(u" or "_s);
}

QString titlesOf(const QStringList &ids)
{
    QStringList titles;
    for (const QString &id : ids)
        titles.append(u"“%1”"_s.arg(methodNamed(id)->title));
    return titles.join(u", "_s);
}

void removeDuplicates(std::vector<LayerDrawing::Label> &labels)
{
    auto end = labels.begin();
    for (auto label = labels.begin(); label != labels.end(); ++label) {
        if (std::find(labels.begin(), end, *label) != end)
            continue;
        if (end != label)
            *end = std::move(*label);
        ++end;
    }
    labels.erase(end, labels.end());
}

} // namespace

QString Layer::objection(const Scene &scene) const
{
    if (kinds.empty())
        return {};
    const Method *method = methodNamed(QString::fromStdString(scene.method));
    if (!method)
        return u"there is no method “%1”"_s.arg(QString::fromStdString(scene.method));
    if (!methods.isEmpty() && !methods.contains(method->id))
        return u"“%1” has no such numbers, unlike %2"_s.arg(method->title, titlesOf(methods));
    std::vector<PrimitiveKind> drawn;
    for (const PrimitiveKind kind : kinds) {
        if (method->draws(kind))
            drawn.push_back(kind);
    }
    if (drawn.empty())
        return u"“%1” draws no %2"_s.arg(method->title, listed(kinds));
    if (std::ranges::none_of(drawn, [&](PrimitiveKind kind) { return hasKind(scene, kind); }))
        return u"the scene has no %1"_s.arg(listed(drawn));
    return {};
}

std::span<const Layer> layers()
{
    static const std::array table
        = {verticesLayer(),        boxLayer(),        halfPlanesLayer(), halfPlaneLayer(0),
           halfPlaneLayer(1),      halfPlaneLayer(2), weightsLayer(),    levelsLayer(),
           barycentricAxesLayer(), affineMapLayer(),  isolinesLayer(0),  isolinesLayer(1),
           isolinesLayer(2),       innerEdgesLayer(), edgeTableLayer(),  decisionsLayer(),
           brightnessLayer(),      samplesLayer(),    memoryLayer()};
    return table;
}

const Layer *layerNamed(QStringView id)
{
    const auto found = std::ranges::find(layers(), id, &Layer::id);
    return found == layers().end() ? nullptr : &*found;
}

std::optional<std::size_t> subjectOf(const Layer &layer, const LayerView &view)
{
    if (layer.kinds.empty())
        return 0; // it describes no primitive
    const TracedScene &traced = *view.traced;
    const auto isSubject = [&](std::size_t primitive) {
        const PrimitiveKind kind = traced.primitives.kindOf(primitive);
        return std::ranges::count(layer.kinds, kind) > 0
            && (traced.primitives.isTriangle(primitive)
                    ? traced.method->draws(kind)
                    : traced.method->draws(traced.primitives.shape(primitive)));
    };
    const ScanTrace &trace = *traced.trace;
    if (trace.stepCount() == 0)
        return std::nullopt;
    const std::size_t step = view.position == 0 ? 0 : view.position - 1;
    for (std::size_t next = view.primitive.value_or(trace.stepAt(step).primitive) + 1; next > 0;
         --next) {
        if (isSubject(next - 1))
            return next - 1;
        if (view.primitive)
            break;
    }
    return std::nullopt;
}

LayerDrawing drawingOf(const QStringList &ids, const LayerView &view)
{
    LayerDrawing drawing;
    for (const Layer &layer : layers()) {
        if (!ids.contains(layer.id) || !layer.objection(view.traced->scene).isEmpty())
            continue;
        const auto primitive = subjectOf(layer, view);
        if (!primitive)
            continue;
        const LayerMoment moment{view, *primitive};
        if (layer.kinds.empty() || view.ahead == Ahead::Shown
            || moment.hasDone(moment.trace().indexOfSetUp(*primitive)))
            layer.draw(moment, drawing);
        else
            drawing.notes.append(u"%1: the set-up is still ahead"_s.arg(layer.title));
    }
    drawing.notes.removeDuplicates();
    removeDuplicates(drawing.labels); // of one half-plane next to all three
    return drawing;
}

} // namespace pixelplumb
