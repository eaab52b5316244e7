// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/scene/colourtext.h"
#include "core/scene/fileaccess.h"
#include "core/scene/framenames.h"
#include "core/scene/jsonreader.h"
#include "core/scene/scenefile.h"

namespace pixelplumb {

namespace {

/// Reads the parts of a scene out of a JSON text; errors stay with the JsonReader.
class SceneReader {
public:
    explicit SceneReader(JsonReader &json)
        : m_json(json)
    {
    }

    SceneReading read()
    {
        const JsonNode &root = m_json.root();
        readFormat(root);
        m_json.expectObject(root,
                            {QStringLiteral("pixelplumb"), QStringLiteral("frame"),
                             QStringLiteral("method"), QStringLiteral("arithmetic"),
                             QStringLiteral("fillRule"), QStringLiteral("rounding"),
                             QStringLiteral("primitives")});
        readFrame(root[QStringLiteral("frame")]);
        readSettings(root);
        readPrimitives(root[QStringLiteral("primitives")]);
        return std::move(m_reading);
    }

private:
    /// First of all: a newer file may have keys that this program does not know.
    void readFormat(const JsonNode &root)
    {
        const JsonNode format = root[QStringLiteral("pixelplumb")];
        if (!root.value.isObject() || format.isMissing()) {
            m_json.fail(format, QStringLiteral("no format number: this is no Pixelplumb scene"),
                        QStringLiteral("\"pixelplumb\": %1").arg(sceneFormat));
            return;
        }
        const qint64 number = format.value.toInteger(0);
        if (number > sceneFormat) {
            m_json.fail(format,
                        QStringLiteral("written by a newer Pixelplumb (format %1)").arg(number),
                        QStringLiteral("a format up to %1, the newest that this one reads")
                            .arg(sceneFormat));
            return;
        }
        m_json.integer(format, 1, sceneFormat);
    }

    void readFrame(const JsonNode &node)
    {
        m_json.expectObject(node,
                            {QStringLiteral("width"), QStringLiteral("height"),
                             QStringLiteral("background"), QStringLiteral("origin"),
                             QStringLiteral("pixelCentre"), QStringLiteral("firstPixel")});
        FrameSpec &frame = m_reading.scene.frame;
        const JsonNode width = node[QStringLiteral("width")];
        frame.width = std::int32_t(m_json.integer(width, 1, largestFrameSide));
        frame.height
            = std::int32_t(m_json.integer(node[QStringLiteral("height")], 1, largestFrameSide));
        const qint64 area = qint64(frame.width) * frame.height;
        if (area > largestFrameArea) {
            m_json.fail(width,
                        QStringLiteral("%1 × %2 are %3 pixels")
                            .arg(frame.width)
                            .arg(frame.height)
                            .arg(area),
                        QStringLiteral("at most %1 pixels").arg(largestFrameArea));
        }
        if (const JsonNode background = node[QStringLiteral("background")]; !background.isMissing())
            frame.background = colour(background);
        readChoice(node[QStringLiteral("origin")], allFrameOrigins, frame.origin);
        readChoice(node[QStringLiteral("pixelCentre")], allPixelCentres, frame.pixelCentre);
        if (const JsonNode first = node[QStringLiteral("firstPixel")]; !first.isMissing()) {
            const std::vector<JsonNode> pixel = m_json.array(first, 2);
            frame.firstColumn = std::int32_t(m_json.integer(pixel[0], -largestPixel, largestPixel));
            frame.firstRow = std::int32_t(m_json.integer(pixel[1], -largestPixel, largestPixel));
        }
    }

    void readSettings(const JsonNode &root)
    {
        Scene &scene = m_reading.scene;
        const JsonNode methodNode = root[QStringLiteral("method")];
        const JsonNode ruleNode = root[QStringLiteral("fillRule")];
        if (!methodNode.isMissing())
            scene.method = m_json.string(methodNode).toStdString();
        readChoice(root[QStringLiteral("arithmetic")], allArithmetics, scene.settings.arithmetic);
        readChoice(ruleNode, allFillRules, scene.settings.fillRule);
        readChoice(root[QStringLiteral("rounding")], allByteRoundings, scene.settings.rounding);

        const Method *method = methodNamed(QString::fromStdString(scene.method));
        if (method == nullptr) {
            QStringList ids;
            for (const Method &each : methods())
                ids.append(each.id);
            m_json.fail(methodNode, describe(methodNode), anyOf(ids));
            return;
        }
        if (const QString refusal = method->refusal(scene.settings); !refusal.isEmpty())
            m_json.fail(ruleNode.isMissing() ? root : ruleNode, refusal, {});
    }

    void readPrimitives(const JsonNode &node)
    {
        const std::vector<JsonNode> primitives = m_json.array(node);
        m_reading.scene.triangles.reserve(primitives.size());
        for (const JsonNode &primitive : primitives) {
            if (m_json.hasFailed())
                return;
            m_json.expectObject(primitive, {QStringLiteral("triangle"), QStringLiteral("colors")});
            m_reading.scene.triangles.push_back(triangle(primitive));
        }
    }

    Triangle triangle(const JsonNode &primitive)
    {
        Triangle result;
        const std::vector<JsonNode> vertices
            = m_json.array(primitive[QStringLiteral("triangle")], 3);
        const std::vector<JsonNode> colours = m_json.array(primitive[QStringLiteral("colors")], 3);
        for (std::size_t index = 0; index < 3; ++index) {
            const std::vector<JsonNode> position = m_json.array(vertices[index], 2);
            result.vertices[index].position.x = coordinate(position[0], index, Axis::X);
            result.vertices[index].position.y = coordinate(position[1], index, Axis::Y);
            result.vertices[index].colour = colour(colours[index]);
        }
        return result;
    }

    Lattice coordinate(const JsonNode &node, std::size_t vertex, Axis axis)
    {
        if (!node.value.isDouble() && !node.value.isString()) {
            m_json.fail(node, describe(node), coordinateExpectation());
            return 0;
        }
        const QString written
            = node.value.isString() ? node.value.toString() : numberText(node.value);
        const Result<SnappedCoordinate> snapped = parseCoordinate(written);
        if (!snapped) {
            m_json.fail(node, snapped.error().found, snapped.error().expected);
            return 0;
        }
        if (snapped->isDisplaced())
            m_reading.snaps.push_back(
                {m_reading.scene.triangles.size(), vertex, axis, written, *snapped});
        return snapped->units;
    }

    Colour colour(const JsonNode &node)
    {
        const Result<Colour> result = parseColour(m_json.string(node));
        if (result)
            return *result;
        m_json.fail(node, result.error().found, result.error().expected);
        return {};
    }

    static QString anyOf(const QStringList &names)
    {
        return names.size() == 1 ? names.front()
                                 : QStringLiteral("one of ") + names.join(QStringLiteral(", "));
    }

    /// A choice that keeps its default where the key is missing.
    template <class Choice, std::size_t Count>
    void readChoice(const JsonNode &node, const std::array<Choice, Count> &choices, Choice &choice)
    {
        if (node.isMissing())
            return;
        QStringList names;
        for (const Choice each : choices) {
            const std::string_view name = nameOf(each);
            names.append(QString::fromUtf8(name.data(), qsizetype(name.size())));
            if (node.value.toString() == names.back()) {
                choice = each;
                return;
            }
        }
        m_json.fail(node, describe(node), anyOf(names));
    }

    JsonReader &m_json;
    SceneReading m_reading;
};

} // namespace

QString SnapReport::message() const
{
    return QStringLiteral("primitives[%1].triangle[%2][%3]: %4 is drawn at %5, displaced by %6 px")
        .arg(primitive)
        .arg(vertex)
        .arg(axis == Axis::X ? 0 : 1)
        .arg(written, coordinateText(snapped.units), toText(snapped.displacement));
}

Result<SceneReading> readScene(const QByteArray &text)
{
    JsonReader json(text);
    if (json.hasFailed())
        return json.error();
    SceneReading reading = SceneReader(json).read();
    if (json.hasFailed())
        return json.error();
    return reading;
}

Result<SceneReading> readSceneFile(const QString &path)
{
    const Result<QByteArray> text = readFile(path);
    if (!text)
        return text.error();
    Result<SceneReading> reading = readScene(*text);
    if (reading)
        return reading;
    InputError error = reading.error();
    error.place = error.place.isEmpty() ? path : path + QStringLiteral(", ") + error.place;
    return error;
}

} // namespace pixelplumb
