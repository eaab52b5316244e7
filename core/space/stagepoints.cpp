// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/stagepoints.h"

#include "core/space/attributenumber.h"
#include "core/space/stagenumbers.h"
#include "core/space/stagevectors.h"

#include <cmath>

namespace pixelplumb {

using namespace Qt::StringLiterals;

void writeCameraPoint(StagePoint &point, const SpaceScene &scene)
{
    using std::acos;
    const Camera &camera = scene.camera;
    const FrameSpec &frame = scene.frame;
    const CameraTransform<double> usedCamera(camera, frame);
    const CameraTransform<ExactReal> exactCamera(camera, frame);
    StageNumberWriter numbers(point.numbers);
    const auto of = [](const char *name) {
        return [name](QChar axis) { return QString::fromLatin1(name) + u'_' + axis; };
    };
    const auto vector = [&](const QString &name, const SpaceVector<double> &used,
                            const SpaceVector<ExactReal> &exact, const Component &formula) {
        numbers.add([&](QChar axis) { return name + u'_' + axis; }, used, &exact, formula);
    };
    const auto place = [&](const QString &name, const Vector3 &at) {
        vector(name, SpaceVector<double>(at), SpaceVector<ExactReal>(at), {});
    };
    const auto given
        = [&](const QString &name, double value) { numbers.add(name, value, ExactReal(value)); };
    place("E", camera.eye);
    place("target", camera.target);
    place("upward", camera.up);
    vector("back", usedCamera.backward(), exactCamera.backward(),
           unitOf(usedCamera.backward(),
                  [](QChar axis) { return u"(E_%1 − target_%1)"_s.arg(axis); }));
    vector("right", usedCamera.right(), exactCamera.right(),
           unitOf(usedCamera.right(), [&](QChar axis) {
               return u'(' + crossFormula(of("upward"), of("back"), axis) + u')';
           }));
    vector("up", usedCamera.up(), exactCamera.up(),
           [&](QChar axis) { return crossFormula(of("back"), of("right"), axis); });
    given("near", camera.near);
    given("far", camera.far);
    given("x_first", frame.firstColumn);
    given("y_first", frame.firstRow);
    given("width", frame.width);
    given("height", frame.height);
    const bool isPerspective = camera.projection == Projection::Perspective;
    if (isPerspective) {
        given("fieldOfView", camera.fieldOfView);
        numbers.add("φ", camera.fieldOfView / 180 * acos(0.0),
                    ExactReal(camera.fieldOfView) / 180 * acos(ExactReal(0)),
                    "fieldOfView/180·π/2");
    } else {
        given("view_height", camera.height);
    }
    const auto used = usedCamera.scale();
    const auto exact = exactCamera.scale();
    numbers.add("scale_y", used.y, exact.y, isPerspective ? u"cos φ/sin φ"_s : u"2/view_height"_s);
    numbers.add("scale_x", used.x, exact.x, "scale_y·height/width");
    numbers.add("scale_z", used.z, exact.z,
                isPerspective ? u"far/(far − near)"_s : u"1/(far − near)"_s);
}

void writeCarried(StagePoint &point, const ClippedCorner<double> &corner,
                  const ClippedCorner<ExactReal> *exact)
{
    StageNumberWriter numbers(point.numbers);
    const auto add = [&](QChar name, double used, const ExactReal *exactly) {
        const QString inside = clipName(QString(name), corner.inside);
        numbers.add(QString(name), used, exactly,
                    corner.isCut()
                        ? u"%1 + t·(%2 − %1)"_s.arg(inside, clipName(QString(name), corner.outside))
                        : inside);
    };
    const ClipVertex<double> &vertex = corner.vertex;
    add(u'u', vertex.texture[0], exact ? &exact->vertex.texture[0] : nullptr);
    add(u'v', vertex.texture[1], exact ? &exact->vertex.texture[1] : nullptr);
    for (std::size_t channel = 0; channel < 3; ++channel)
        add(channelLetters[channel], vertex.levels[channel],
            exact ? &exact->vertex.levels[channel] : nullptr);
    add(u'α', vertex.levels[3], exact ? &exact->vertex.levels[3] : nullptr);
}

void writeSnappedPoint(StagePoint &point, const SnappedCorner &corner,
                       const std::optional<ExactCorner> &exact, int wExponent)
{
    const auto pixels = [](Lattice units) { return double(units) / double(unitsPerPixel); };
    const auto value = [](Attribute attribute) { return double(attribute) / double(attributeOne); };
    const ExactReal exactW
        = exact ? ExactReal(ldexp(exact->vertex.clip.w, wExponent)) : ExactReal();
    StageNumberWriter numbers(point.numbers);
    const auto &[vertex, attributes, loss] = corner;
    numbers.add("x", pixels(vertex.position.x), exact ? &exact->place[0] : nullptr,
                "⌊256·x′ + ½⌋/256");
    numbers.add("y", pixels(vertex.position.y), exact ? &exact->place[1] : nullptr,
                "⌊256·y′ + ½⌋/256");
    numbers.add("z", value(attributes.z), exact ? &exact->z : nullptr,
                "⌊16777216·z_device + ½⌋/16777216");
    // 2^24 times the scale of w.
    const int power = attributeFractionBits + wExponent;
    const QString scaled = power < 0 ? u"w′/%1"_s.arg(std::ldexp(1.0, -power), 0, 'f', 0)
                                     : u"%1·w′"_s.arg(std::ldexp(1.0, power), 0, 'f', 0);
    numbers.add("w", value(attributes.w), exact ? &exactW : nullptr,
                attributes.w > 1 ? u"⌊%1 + ½⌋/16777216"_s.arg(scaled) : QString());
    numbers.add("u", value(attributes.texture[0]), exact ? &exact->vertex.texture[0] : nullptr,
                "⌊16777216·u′ + ½⌋/16777216");
    numbers.add("v", value(attributes.texture[1]), exact ? &exact->vertex.texture[1] : nullptr,
                "⌊16777216·v′ + ½⌋/16777216");
    for (std::size_t channel = 0; channel < 3; ++channel) {
        numbers.add(QString(channelLetters[channel]), vertex.colour.channels[channel],
                    exact ? &exact->vertex.levels[channel] : nullptr,
                    u"⌊%1′ + ½⌋"_s.arg(channelLetters[channel]));
    }
    numbers.add("α", attributes.alpha, exact ? &exact->vertex.levels[3] : nullptr, "⌊α′ + ½⌋");
}

} // namespace pixelplumb
