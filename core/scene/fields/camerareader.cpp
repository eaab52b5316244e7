// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/camerareader.h"

#include "core/scene/appearancenames.h"
#include "core/scene/text/choicereader.h"
#include "core/space/spacevector.h"

#include <limits>

namespace pixelplumb {

namespace {

/// Directions count as parallel when the sine of their angle is smaller.
constexpr double smallestSine = 1e-9;

/// A number between two bounds, both excluded.
double numberBetween(JsonReader &json, NumberReader &numbers, const JsonNode &node, double above,
                     double below, double byDefault)
{
    if (node.isMissing())
        return byDefault;
    const double value = numbers.real(node);
    if (!(value > above && value < below))
        json.fail(node, describe(node),
                  std::isinf(below)
                      ? QStringLiteral("more than %1").arg(above)
                      : QStringLiteral("more than %1 and less than %2").arg(above).arg(below));
    return value;
}

void checkDirections(JsonReader &json, const JsonNode &node, const Camera &camera)
{
    using Vector = SpaceVector<double>;
    const Vector sight = Vector(camera.target) - Vector(camera.eye);
    const Vector upwards(camera.up);
    const JsonNode up = node["up"];
    if (sight.isZero())
        json.fail(node, "eye and target are one point",
                  "two points, between which the camera looks");
    if (upwards.isZero())
        json.fail(up, "a direction of length 0", "the direction that is up");
    if (lengthOf(cross(sight, upwards)) <= smallestSine * lengthOf(sight) * lengthOf(upwards))
        json.fail(up.isMissing() ? node : up, "up is parallel to the view from eye to target",
                  "a direction across it");
}

} // namespace

Camera readCamera(JsonReader &json, NumberReader &numbers, const JsonNode &node)
{
    constexpr double endless = std::numeric_limits<double>::infinity();
    json.expectObject(
        node, {"projection", "eye", "target", "up", "fieldOfView", "height", "near", "far"});
    Camera camera;
    readChoice(json, node["projection"], allProjections, camera.projection);
    const auto readVector = [&](const char *key, Vector3 &vector) {
        if (const JsonNode value = node[key]; !value.isMissing())
            vector = numbers.vector(value);
    };
    readVector("eye", camera.eye);
    readVector("target", camera.target);
    readVector("up", camera.up);
    const bool isPerspective = camera.projection == Projection::Perspective;
    const auto own = QLatin1String(isPerspective ? "fieldOfView" : "height");
    const auto others = QLatin1String(isPerspective ? "height" : "fieldOfView");
    if (const JsonNode foreign = node[others]; !foreign.isMissing())
        json.fail(foreign,
                  QStringLiteral("“%1” of a camera that is %2")
                      .arg(others, nameText(nameOf(camera.projection))),
                  QStringLiteral("“%1”").arg(own));
    camera.fieldOfView
        = numberBetween(json, numbers, node["fieldOfView"], 0, 180, camera.fieldOfView);
    camera.height = numberBetween(json, numbers, node["height"], 0, endless, camera.height);
    const JsonNode far = node["far"];
    camera.near = numberBetween(json, numbers, node["near"], 0, endless, camera.near);
    camera.far = numberBetween(json, numbers, far, 0, endless, camera.far);
    if (camera.far <= camera.near)
        json.fail(far.isMissing() ? node : far,
                  QStringLiteral("near %1 and far %2").arg(camera.near).arg(camera.far),
                  "a far plane behind the near one");
    checkDirections(json, node, camera);
    return camera;
}

} // namespace pixelplumb
