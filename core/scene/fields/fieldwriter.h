// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/fields/jsonfields.h"
#include "core/scene/scenefile.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <array>
#include <optional>
#include <vector>

namespace pixelplumb {

inline QJsonValue jsonOf(bool value) { return value; }
inline QJsonValue jsonOf(int value) { return value; }
inline QJsonValue jsonOf(std::int64_t value) { return qint64(value); }
/// As text: a JSON number would lose its last digits.
inline QJsonValue jsonOf(std::uint64_t value) { return QString::number(value); }
inline QJsonValue jsonOf(double value) { return value; }
inline QJsonValue jsonOf(const QString &value) { return value; }
inline QJsonValue jsonOf(const QStringList &value) { return QJsonArray::fromStringList(value); }
inline QJsonValue jsonOf(const Scene &scene)
{
    return QJsonDocument::fromJson(writeScene(scene)).object();
}

template <class Enum>
requires std::is_enum_v<Enum> QJsonValue jsonOf(Enum value) { return fileWord(nameOf(value)); }

template <HasFields Part>
QJsonValue jsonOf(const Part &part);

template <class T>
QJsonValue jsonOf(const std::vector<T> &values)
{
    QJsonArray array;
    for (const T &value : values)
        array.append(jsonOf(value));
    return array;
}
template <class T, std::size_t count>
QJsonValue jsonOf(const std::array<T, count> &values)
{
    QJsonArray array;
    for (const T &value : values)
        array.append(jsonOf(value));
    return array;
}

/// Inserts fields into the object; optional ones only where they have a value.
struct FieldWriter {
    QJsonObject &object;

    template <class T>
    void operator()(const char *name, const T &value) const
    {
        object.insert(QLatin1String(name), jsonOf(value));
    }
    template <class T>
    void operator()(const char *name, const std::optional<T> &value) const
    {
        if (value)
            (*this)(name, *value);
    }
};

template <HasFields Part>
QJsonValue jsonOf(const Part &part)
{
    QJsonObject object;
    eachField(part, FieldWriter{object});
    return object;
}

} // namespace pixelplumb
