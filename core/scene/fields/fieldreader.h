// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/fields/jsonfields.h"
#include "core/scene/scenefile.h"
#include "core/scene/text/jsonreader.h"

#include <QJsonDocument>

#include <limits>

namespace pixelplumb {

/// Reads parts of a file by their lists of fields; errors stay with the JsonReader.
class FieldReader {
public:
    explicit FieldReader(JsonReader &json)
        : m_json(json)
    {
    }

    void read(const JsonNode &node, bool &value) { value = m_json.boolean(node); }
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
            m_json.fail(node, describe(node), "a whole number as text");
    }
    void read(const JsonNode &node, double &value)
    {
        if (!node.isNumber())
            m_json.fail(node, describe(node), "a number");
        value = node.toDouble(0);
    }
    void read(const JsonNode &node, QString &value) { value = m_json.string(node); }
    void read(const JsonNode &node, QStringList &value)
    {
        value.clear();
        for (const JsonNode &each : m_json.array(node))
            value.append(m_json.string(each));
    }
    void read(const JsonNode &node, Scene &scene) { scene = readScene(m_json, node); }

    template <class Enum>
    requires std::is_enum_v<Enum>
    void read(const JsonNode &node, Enum &value)
    {
        QStringList words;
        for (const Enum each : FileWords<Enum>::all) {
            words.append(fileWord(nameOf(each)));
            if (node.toString() == words.back()) {
                value = each;
                return;
            }
        }
        m_json.fail(node, describe(node), u"one of "_s + words.join(u", "_s));
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

    /// `more`: further keys that are allowed, read elsewhere or not at all.
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
    template <class T>
    void readMember(const JsonNode &node, std::optional<T> &value)
    {
        value.reset();
        if (!node.isMissing())
            readMember(node, value.emplace());
    }

    JsonReader &m_json;
};

} // namespace pixelplumb
