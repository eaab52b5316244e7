// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/appearancewriter.h"

#include "core/scan/choicenames.h"
#include "core/scene/appearancefields.h"
#include "core/scene/colourtext.h"
#include "core/scene/primitivewriter.h"
#include "core/scene/referredfiles.h"

namespace pixelplumb {

namespace {

/// Names are quoted, except those that are numbers.
template <class Choice, class Choices>
QByteArray textOf(const ChoiceOf<Choice, Choices> &field, const QString & /*folder*/)
{
    const QByteArray name = nameText(nameOf(field.choice)).toUtf8();
    return name[0] >= '0' && name[0] <= '9' ? name : quotedText(name);
}

QByteArray textOf(const NumberWithin<const int> &field, const QString & /*folder*/)
{
    return QByteArray::number(field.number);
}

QByteArray textOf(const Colour &colour, const QString & /*folder*/)
{
    return quotedText(colourText(colour).toUtf8());
}

QByteArray textOf(const std::shared_ptr<const Texture> &texture, const QString &folder)
{
    return texture ? quotedText(nameInFolder(texture->name, folder).toUtf8()) : QByteArray();
}

/// The fields that differ from their defaults, each after a separator.
template <class Part>
QByteArray fieldsText(const Part &part, const QByteArray &separator, const QString &folder);

QByteArray lightLine(const Light &light)
{
    const char *key = light.kind == Light::Kind::Directional ? "direction" : "position";
    return QByteArray("{ \"") + key + "\": " + jsonAttributeText(light.at)
        + ", \"color\": " + textOf(light.colour, {}) + " }";
}

/// Elements in brackets, each on its own line.
QByteArray block(const QByteArrayList &lines, char open, char close)
{
    return open + ("\n        " + lines.join(",\n        ") + "\n    ") + close;
}

QByteArray textOf(const std::vector<Material> &materials, const QString &folder)
{
    QByteArrayList lines;
    for (const Material &material : materials) {
        const QByteArray fields = fieldsText(material, ", ", folder);
        lines.append(quotedText(QByteArray::fromStdString(material.name))
                     + (fields.isEmpty() ? QByteArray(": {}") : ": { " + fields.sliced(2) + " }"));
    }
    return block(lines, '{', '}');
}

QByteArray textOf(const std::vector<Light> &lights, const QString & /*folder*/)
{
    QByteArrayList lines;
    for (const Light &light : lights)
        lines.append(lightLine(light));
    return block(lines, '[', ']');
}

template <class Part>
QByteArray fieldsText(const Part &part, const QByteArray &separator, const QString &folder)
{
    QByteArrayList defaults;
    const Part byDefault;
    eachField(byDefault,
              [&](const char *, const auto &value) { defaults.append(textOf(value, folder)); });
    QByteArray fields;
    eachField(part, [&](const char *name, const auto &value) {
        if (const QByteArray text = textOf(value, folder); text != defaults.takeFirst())
            fields += separator + '"' + name + "\": " + text;
    });
    return fields;
}

} // namespace

QByteArray appearanceText(const Appearance &appearance, const QString &folder)
{
    return fieldsText(appearance, ",\n    ", folder);
}

} // namespace pixelplumb
