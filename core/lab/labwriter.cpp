// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/labfields.h"
#include "core/lab/labfile.h"
#include "core/scene/scenefile.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <vector>

namespace pixelplumb {

namespace {

QJsonValue jsonOf(bool value) { return value; }
QJsonValue jsonOf(int value) { return value; }
QJsonValue jsonOf(std::int64_t value) { return qint64(value); }
/// A number of JSON would lose its last digits.
QJsonValue jsonOf(std::uint64_t value) { return QString::number(value); }
QJsonValue jsonOf(double value) { return value; }
QJsonValue jsonOf(const QString &value) { return value; }
QJsonValue jsonOf(const QStringList &value) { return QJsonArray::fromStringList(value); }
QJsonValue jsonOf(const Scene &scene)
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

/// What was not measured is left out.
struct Members {
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
    eachField(part, Members{object});
    return object;
}

} // namespace

QByteArray writeStudy(const Study &study)
{
    QJsonObject object = jsonOf(study).toObject();
    object.insert(QStringLiteral("pixelplumbLab"), labFileVersion);
    object.insert(QStringLiteral("warnings"), QJsonArray::fromStringList(warningsOf(study)));
    return QJsonDocument(object).toJson();
}

QByteArray writeAccuracy(const Study &study)
{
    QJsonArray rows;
    for (const LabRow &row : study.rows)
        rows.append(jsonOf(row.withoutTimes()));
    return QJsonDocument(rows).toJson();
}

} // namespace pixelplumb
