// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/scene/fields/partreader.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/filepath.h"
#include "core/scene/text/choicereader.h"
#include "core/scene/text/jsonreader.h"

#include <QFileInfo>

#include <cmath>
#include <functional>

namespace pixelplumb {

namespace {

constexpr auto primitivesKey = "primitives";

/// Reads the parts of a scene from JSON; errors stay with the JsonReader.
class SceneReader {
public:
    using MayGoOn = std::function<bool(qint64 offset)>;

    SceneReader(JsonReader &json, ReferredFiles files, MayGoOn mayGoOn)
        : m_json(json)
        , m_mayGoOn(std::move(mayGoOn))
        , m_current{{}, std::move(files)}
    {
    }

    /// The choice of a method comes last, since it depends on the primitives.
    SceneReading read()
    {
        const JsonNode root = m_json.root();
        readFormat(root);
        m_json.expectObject(
            root, QStringList{"pixelplumb"} + surroundingKeys() + QStringList{primitivesKey});
        readSurroundings(m_json, m_current);
        readPrimitives(root[primitivesKey]);
        chooseMethod(root);
        return std::move(m_current.reading);
    }

private:
    /// Checked first: a newer file may have keys that this program does not know.
    void readFormat(const JsonNode &root)
    {
        const JsonNode format = root["pixelplumb"];
        if (const JsonNode other = root["pixelplumbAssignment"]; !other.isMissing()) {
            m_json.fail(other, "this is an assignment, by which submissions are graded", "a scene");
            return;
        }
        if (!root.isObject() || format.isMissing()) {
            m_json.fail(format, "no format number: this is no Pixelplumb scene",
                        u"\"pixelplumb\": %1"_s.arg(sceneFormat));
            return;
        }
        const qint64 number = format.toInteger(0);
        if (number > sceneFormat) {
            m_json.fail(format, u"written by a newer Pixelplumb (format %1)"_s.arg(number),
                        u"a format up to %1, the newest that this one reads"_s.arg(sceneFormat));
            return;
        }
        m_json.integer(format, 1, sceneFormat);
    }

    /// Before every 1024 primitives the listener is asked whether to go on.
    void readPrimitives(const JsonNode &node)
    {
        constexpr qsizetype betweenProgress = 1024;
        if (!node.isArray())
            m_json.fail(node, describe(node), "an array");
        const QString path = node.path();
        qsizetype index = 0;
        node.visitElements([&](const JsonNode &primitive) {
            if (index % betweenProgress == 0 && !m_mayGoOn(primitive.offset()))
                m_json.fail(readingCancelled({}));
            if (m_json.hasFailed())
                return false;
            JsonReader json(m_json, primitive, elementPath(path, index++));
            readPrimitive(json, m_current, json.root());
            if (json.hasFailed())
                m_json.fail(json.error());
            return !json.hasFailed();
        });
    }

    /// The method that the scene names, or methodFor() it.
    void chooseMethod(const JsonNode &root)
    {
        Scene &scene = m_current.reading.scene;
        const JsonNode node = root["method"];
        OpenSettings &open = m_current.reading.open;
        open = {node.isMissing(), root["arithmetic"].isMissing(), root["fillRule"].isMissing()};
        const Method *method = nullptr;
        if (open.method) {
            method = &methodFor(scene, open);
        } else {
            method = methodNamed(QString::fromStdString(scene.method));
            if (method == nullptr) {
                QStringList ids;
                for (const Method &each : methods())
                    ids.append(each.id);
                m_json.fail(node, describe(node), anyOf(ids));
                return;
            }
        }
        scene.method = method->id.toStdString();
        scene.settings = settledFor(*method, scene.settings, open);
        const QString refusal = method->refusal(scene.settings);
        if (!refusal.isEmpty() && open.method)
            m_json.fail(root[open.fillRule ? u"arithmetic"_s : u"fillRule"_s],
                        refusalOfAll(scene, open), {});
        else if (!refusal.isEmpty())
            m_json.fail(refusedNode(*method, root), refusal, {});
    }

    /// The node of the setting that the method does not support.
    JsonNode refusedNode(const Method &method, const JsonNode &root) const
    {
        const ScanSettings &settings = m_current.reading.scene.settings;
        if (!method.supports(settings.arithmetic))
            return root["arithmetic"];
        return root[method.supports(settings.fillRule) ? u"variants"_s : u"fillRule"_s];
    }

    JsonReader &m_json;
    MayGoOn m_mayGoOn;
    CurrentScene m_current;
};

} // namespace

QString SnapReport::message() const
{
    // Smaller ones are kept as the smallest double.
    const bool isTiny = std::abs(snapped.displacement.toDouble()) < 1e-300;
    return u"%1: %2 is %3 %4, displaced by %5%6"_s.arg(
        place, written, QLatin1String(format->use), numberText(snapped.units, *format),
        isTiny ? u"less than 1e-300"_s : toText(snapped.displacement), QLatin1String(format->unit));
}

Result<SceneReading> readScene(const QByteArray &text, const ProgressListener &listener,
                               const QString &folder)
{
    const auto mayGoOn = [&](qint64 offset) {
        return text.size() <= shortText
            || goesOn(listener, {JobPhase::Reading, offset, text.size()});
    };
    if (!mayGoOn(0))
        return readingCancelled({});
    JsonReader json(text, primitivesKey);
    if (json.hasFailed())
        return json.error();
    SceneReading reading = SceneReader(json, ReferredFiles(folder, listener), mayGoOn).read();
    if (json.hasFailed())
        return json.error();
    return reading;
}

Scene readScene(JsonReader &json, const JsonNode &node, const QString &folder)
{
    JsonReader part(json, node, node.path(), primitivesKey);
    const auto mayGoOn = [](qint64) { return true; };
    SceneReading reading = SceneReader(part, ReferredFiles(folder, {}), mayGoOn).read();
    if (part.hasFailed())
        json.fail(part.error());
    return reading.scene;
}

Result<SceneReading> readSceneFile(const QString &path, const ProgressListener &listener)
{
    const Result<QByteArray> text = readRegularFile(path);
    if (!text)
        return text.error();
    Result<SceneReading> reading
        = readScene(*text, listener, QFileInfo(filePath(path)).absolutePath());
    if (reading)
        return reading;
    return errorIn(path, reading.error());
}

} // namespace pixelplumb
