// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/scene/appearancereader.h"
#include "core/scene/camerareader.h"
#include "core/scene/choicereader.h"
#include "core/scene/colourreader.h"
#include "core/scene/fileaccess.h"
#include "core/scene/framereader.h"
#include "core/scene/jsonplaces.h"
#include "core/scene/jsonsyntax.h"
#include "core/scene/primitivereader.h"
#include "core/scene/scenepieces.h"

#include <QFileInfo>

#include <algorithm>
#include <optional>
#include <span>

namespace pixelplumb {

namespace {

/// Reads the parts of a scene out of a JSON text; errors stay with the JsonReader.
class SceneReader {
public:
    SceneReader(JsonReader &json, const QString &folder, const ProgressListener &listener)
        : m_json(json)
        , m_inHand{{}, ReferredFiles(folder, listener)}
    {
    }

    /// The scene whose primitives stand apart in the text; none where `mayRead`, which is asked
    /// before each, ended the reading.
    template <class MayRead>
    std::optional<Result<SceneReading>> read(const QByteArray &text,
                                             std::span<const QByteArrayView> primitives,
                                             const MayRead &mayRead)
    {
        readSurroundings();
        for (std::size_t index = 0; index < primitives.size() && !m_json.hasFailed(); ++index) {
            const QByteArrayView piece = primitives[index];
            if (!mayRead(index, piece))
                return std::nullopt;
            const JsonExcerpt excerpt{text, elementPath(primitivesKey(), qsizetype(index)),
                                      piece.data() - text.constData()};
            JsonReader json(QByteArray::fromRawData(piece.data(), piece.size()), excerpt);
            if (json.hasFailed())
                return json.error();
            PrimitiveReader(json, m_inHand).read(json.root());
            if (json.hasFailed())
                return json.error();
        }
        chooseMethod(m_json.root());
        if (m_json.hasFailed())
            return m_json.error();
        return Result<SceneReading>(std::move(m_inHand.reading));
    }

    SceneReading read()
    {
        readSurroundings();
        readPrimitives(m_json.root()[primitivesKey()]);
        chooseMethod(m_json.root());
        return std::move(m_inHand.reading);
    }

private:
    static QString primitivesKey() { return QStringLiteral("primitives"); }
    static QString cameraKey() { return QStringLiteral("camera"); }
    static QString motionKey() { return QStringLiteral("motion"); }

    /// Everything but the primitives, and but the choice of a method, which depends on them.
    void readSurroundings()
    {
        const JsonNode &root = m_json.root();
        readFormat(root);
        const QStringList keys = {QStringLiteral("pixelplumb"),
                                  QStringLiteral("frame"),
                                  QStringLiteral("method"),
                                  QStringLiteral("arithmetic"),
                                  QStringLiteral("fillRule"),
                                  QStringLiteral("offScreenPoint"),
                                  QStringLiteral("rounding"),
                                  QStringLiteral("variants"),
                                  cameraKey(),
                                  motionKey()};
        m_json.expectObject(root, keys + appearanceKeys() + QStringList{primitivesKey()});
        m_inHand.reading.scene.frame = readFrame(m_json, root[QStringLiteral("frame")]);
        readSettings(root);
        NumberReader numbers(m_json, m_inHand.reading.snaps);
        Scene &scene = m_inHand.reading.scene;
        if (const JsonNode point = root[QStringLiteral("offScreenPoint")]; !point.isMissing())
            scene.frame.offScreenPoint = numbers.position(point);
        if (const JsonNode camera = root[cameraKey()]; !camera.isMissing())
            scene.camera = readCamera(m_json, numbers, camera);
        if (const JsonNode motion = root[motionKey()]; !motion.isMissing())
            scene.motion = readMotion(numbers, motion);
        scene.appearance = readAppearance(m_json, numbers, m_inHand.files, root);
    }

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

    Motion readMotion(NumberReader &numbers, const JsonNode &node)
    {
        const QString by = QStringLiteral("by");
        const QString frames = QStringLiteral("frames");
        m_json.expectObject(node, {by, frames});
        Motion motion;
        motion.by = numbers.position(node[by]);
        motion.frames = int(m_json.integer(node[frames], 2, largestFrameCount));
        return motion;
    }

    void readSettings(const JsonNode &root)
    {
        Scene &scene = m_inHand.reading.scene;
        readChoice(m_json, root[QStringLiteral("arithmetic")], allArithmetics,
                   scene.settings.arithmetic);
        readChoice(m_json, root[QStringLiteral("fillRule")], allFillRules, scene.settings.fillRule);
        readChoice(m_json, root[QStringLiteral("rounding")], allByteRoundings,
                   scene.settings.rounding);
        scene.settings.variants = readVariants(m_json, root[QStringLiteral("variants")]);
    }

    void readPrimitives(const JsonNode &node)
    {
        const std::vector<JsonNode> primitives = m_json.array(node);
        PrimitiveReader reader(m_json, m_inHand);
        for (const JsonNode &primitive : primitives) {
            if (m_json.hasFailed())
                return;
            reader.read(primitive);
        }
    }

    /// The method that the scene names, or methodFor() it.
    void chooseMethod(const JsonNode &root)
    {
        Scene &scene = m_inHand.reading.scene;
        const JsonNode node = root[QStringLiteral("method")];
        OpenSettings &open = m_inHand.reading.open;
        open = {node.isMissing(), root[QStringLiteral("arithmetic")].isMissing(),
                root[QStringLiteral("fillRule")].isMissing()};
        const Method *method = nullptr;
        if (open.method) {
            method = &methodFor(scene, open);
        } else {
            method = methodNamed(m_json.string(node));
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
        if (const QString refusal = method->refusal(scene.settings); !refusal.isEmpty())
            m_json.fail(refusedNode(*method, root), refusal, {});
    }

    /// Which of the settings the method does not keep.
    JsonNode refusedNode(const Method &method, const JsonNode &root) const
    {
        const ScanSettings &settings = m_inHand.reading.scene.settings;
        if (!method.supports(settings.arithmetic))
            return root[QStringLiteral("arithmetic")];
        return root[method.supports(settings.fillRule) ? QStringLiteral("variants")
                                                       : QStringLiteral("fillRule")];
    }

    JsonReader &m_json;
    SceneInHand m_inHand;
};

constexpr std::size_t primitivesBetweenProgress = 1024;

/// A document of a million triangles would take gigabytes: its primitives are read one by one.
/// None where the text has no primitives that could be told apart.
std::optional<Result<SceneReading>> readByPieces(const QByteArray &text,
                                                 const ProgressListener &listener,
                                                 const QString &folder)
{
    const InputError cancelled = readingCancelled({});
    const auto mayGoOn = [&](const char *place) {
        return goesOn(listener, {JobPhase::Reading, place - text.constData(), text.size()});
    };
    if (!mayGoOn(text.constData()))
        return cancelled;
    const std::optional<ScenePieces> pieces = piecesOf(text);
    if (!pieces)
        return std::nullopt;
    JsonReader json(pieces->frame, {text, {}, 0, pieces->gapAt, pieces->gap});
    if (json.hasFailed())
        return json.error();
    const auto mayRead = [&](std::size_t index, QByteArrayView piece) {
        return index % primitivesBetweenProgress != 0 || mayGoOn(piece.data());
    };
    const auto reading
        = SceneReader(json, folder, listener).read(text, pieces->primitives, mayRead);
    return reading ? reading : cancelled;
}

} // namespace

QString SnapReport::message() const
{
    return QStringLiteral("%1: %2 is %3 %4, displaced by %5%6")
        .arg(place, written, QLatin1String(format->use), numberText(snapped.units, *format),
             toText(snapped.displacement), QLatin1String(format->unit));
}

Result<SceneReading> readScene(const QByteArray &text, const ProgressListener &listener,
                               const QString &folder)
{
    if (text.size() > largestWholeText) {
        // Where it is no JSON that is known at once, before anything is built of it.
        if (const auto error = jsonSyntaxError(text))
            return *error;
        if (auto reading = readByPieces(text, listener, folder))
            return std::move(*reading);
    }
    JsonReader json(text);
    if (json.hasFailed())
        return json.error();
    SceneReading reading = SceneReader(json, folder, listener).read();
    if (json.hasFailed())
        return json.error();
    return reading;
}

Result<SceneReading> readSceneFile(const QString &path, const ProgressListener &listener)
{
    const Result<QByteArray> text = readRegularFile(path);
    if (!text)
        return text.error();
    Result<SceneReading> reading = readScene(*text, listener, QFileInfo(path).absolutePath());
    if (reading)
        return reading;
    return errorIn(path, reading.error());
}

} // namespace pixelplumb
