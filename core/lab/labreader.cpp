// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/labfields.h"
#include "core/lab/labfile.h"
#include "core/scene/jsonreader.h"
#include "core/scene/scenefile.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <limits>

namespace pixelplumb {

namespace {

/// Reads into parts of a study; errors stay with the JsonReader.
class LabReader {
public:
    LabReader(JsonReader &json, int version)
        : m_json(json)
        , m_version(version)
    {
    }

    void read(const JsonNode &node, bool &value)
    {
        if (!node.value.isBool())
            m_json.fail(node, describe(node), QStringLiteral("true or false"));
        value = node.value.toBool();
    }
    void read(const JsonNode &node, int &value)
    {
        value = int(
            m_json.integer(node, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
    }
    void read(const JsonNode &node, std::int64_t &value)
    {
        value = m_json.integer(node, std::numeric_limits<qint64>::min(),
                               std::numeric_limits<qint64>::max());
    }
    void read(const JsonNode &node, std::uint64_t &value)
    {
        bool isNumber = false;
        value = m_json.string(node).toULongLong(&isNumber);
        if (!isNumber)
            m_json.fail(node, describe(node), QStringLiteral("a whole number as text"));
    }
    void read(const JsonNode &node, double &value)
    {
        if (!node.value.isDouble())
            m_json.fail(node, describe(node), QStringLiteral("a number"));
        value = node.value.toDouble();
    }
    void read(const JsonNode &node, QString &value) { value = m_json.string(node); }
    void read(const JsonNode &node, QStringList &value)
    {
        value.clear();
        for (const JsonNode &each : m_json.array(node))
            value.append(m_json.string(each));
    }
    void read(const JsonNode &node, Scene &scene)
    {
        const auto reading
            = readScene(QJsonDocument(node.value.toObject()).toJson(QJsonDocument::Compact));
        if (reading)
            scene = reading->scene;
        else
            m_json.fail(node, reading.error().message(), QStringLiteral("a scene"));
    }

    template <class Enum>
    requires std::is_enum_v<Enum>
    void read(const JsonNode &node, Enum &value)
    {
        QStringList words;
        for (const Enum each : FileWords<Enum>::all) {
            words.append(fileWord(nameOf(each)));
            if (node.value.toString() == words.back()) {
                value = each;
                return;
            }
        }
        m_json.fail(node, describe(node),
                    QStringLiteral("one of ") + words.join(QStringLiteral(", ")));
    }
    template <class T>
    void read(const JsonNode &node, std::vector<T> &values)
    {
        values.clear();
        for (const JsonNode &each : m_json.array(node))
            read(each, values.emplace_back());
    }
    template <class T, std::size_t count>
    void read(const JsonNode &node, std::array<T, count> &values)
    {
        const std::vector<JsonNode> nodes = m_json.array(node, qsizetype(count));
        for (std::size_t i = 0; i < std::min(count, nodes.size()); ++i)
            read(nodes[i], values[i]);
    }
    template <HasFields Part>
    void read(const JsonNode &node, Part &part)
    {
        readMembers(node, part, {});
    }

    /// `more`: keys that are read elsewhere, or by nobody.
    template <HasFields Part>
    void readMembers(const JsonNode &node, Part &part, const QStringList &more)
    {
        QStringList keys = more;
        eachField(part, [&](const char *name, const auto &) { keys.append(QLatin1String(name)); });
        m_json.expectObject(node, keys);
        eachField(part, [&](const char *name, auto &value) {
            readMember(node[QLatin1String(name)], value);
        });
    }

private:
    template <class T>
    void readMember(const JsonNode &node, T &value)
    {
        if (!m_json.hasFailed())
            read(node, value);
    }
    /// What an earlier version did not have.
    template <class T>
    requires std::same_as<T, DriftCurve> || std::same_as<T, SizeCurve>
    void readMember(const JsonNode &node, std::vector<T> &curves)
    {
        if ((m_version >= 2 || !node.isMissing()) && !m_json.hasFailed())
            read(node, curves);
    }
    void readMember(const JsonNode &node, std::vector<EffectRow> &effects)
    {
        if ((m_version >= 3 || !node.isMissing()) && !m_json.hasFailed())
            read(node, effects);
    }
    void readMember(const JsonNode &node, LabKernel &kernel)
    {
        if (m_version >= 2 || !node.isMissing())
            readMember<LabKernel>(node, kernel);
    }
    template <class T>
    void readMember(const JsonNode &node, std::optional<T> &value)
    {
        value.reset();
        if (!node.isMissing())
            readMember(node, value.emplace());
    }

    JsonReader &m_json;
    int m_version; ///< of the file
};

} // namespace

Result<Study> readStudy(const QByteArray &text)
{
    JsonReader json(text);
    if (json.hasFailed())
        return json.error();
    const QString versionKey = QStringLiteral("pixelplumbLab");
    const JsonNode version = json.root()[versionKey];
    const QString expected
        = QStringLiteral("1 to %1, the versions of a lab's file").arg(labFileVersion);
    if (json.root().value.isObject() && version.isMissing()) {
        json.fail(json.root(), QStringLiteral("no “%1”").arg(versionKey), expected);
        return json.error();
    }
    Study study;
    const int written = version.value.toInt();
    if (written < 1 || written > labFileVersion)
        json.fail(version, describe(version), expected);
    else
        LabReader(json, written)
            .readMembers(json.root(), study, {versionKey, QStringLiteral("warnings")});
    if (json.hasFailed())
        return json.error();
    if (written == 1) {
        for (StudyContender &contender : study.contenders)
            contender.kernel = kernelOf(contender.id);
    }
    return study;
}

} // namespace pixelplumb
