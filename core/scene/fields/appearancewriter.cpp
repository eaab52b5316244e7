// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/appearancewriter.h"

#include "core/scan/choicenames.h"
#include "core/scene/fields/appearancefields.h"
#include "core/scene/fields/primitivewriter.h"
#include "core/scene/fields/referredfiles.h"
#include "core/scene/text/colourtext.h"

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

QByteArray textOf(double number, const QString & /*folder*/) { return jsonRealText(number); }

QByteArray textOf(const Vector3 &vector, const QString & /*folder*/)
{
    return jsonRealsText(vector);
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

QString withoutQuotes(const QByteArray &text)
{
    const QString whole = QString::fromUtf8(text);
    return whole.startsWith(u'"') ? whole.sliced(1).chopped(1) : whole;
}

template <class Value>
QStringList choicesOf(const Value & /*value*/)
{
    return {};
}
template <class Choice, class Choices>
QStringList choicesOf(const ChoiceOf<Choice, Choices> &field)
{
    QStringList names;
    for (const auto each : field.all)
        names.append(nameText(nameOf(each)));
    return names;
}

template <class Part>
std::vector<FieldText> fieldTextsOf(const Part &part, Part byDefault, const QString &folder)
{
    std::vector<FieldText> fields;
    const auto add = [&](const char *name, const auto &value) {
        fields.push_back(
            {QLatin1String(name), withoutQuotes(textOf(value, folder)), {}, choicesOf(value)});
    };
    eachField(part, add);
    auto field = fields.begin();
    eachField(std::as_const(byDefault), [&](const char *, const auto &value) {
        field++->byDefault = withoutQuotes(textOf(value, folder));
    });
    return fields;
}

} // namespace

std::vector<FieldText> fieldTexts(const Camera &camera)
{
    Camera byDefault;
    byDefault.projection = camera.projection; // the same fields
    std::vector<FieldText> fields = fieldTextsOf(camera, byDefault, {});
    fields.front().byDefault = nameText(nameOf(Camera().projection));
    return fields;
}

std::vector<FieldText> fieldTexts(const Light &light)
{
    const bool isDirectional = light.kind == Light::Kind::Directional;
    const QString at = QString::fromUtf8(jsonAttributeText(light.at));
    return {{"direction", isDirectional ? at : QString(), {}},
            {"position", isDirectional ? QString() : at, {}},
            {"color", colourText(light.colour), colourText(Light().colour)}};
}

std::vector<FieldText> fieldTexts(const Material &material, const QString &folder)
{
    return fieldTextsOf(material, Material(), folder);
}

std::vector<FieldText> fieldTexts(const Appearance &appearance)
{
    std::vector<FieldText> fields = fieldTextsOf(appearance, Appearance(), {});
    std::erase_if(fields, [](const FieldText &field) {
        return field.name == QLatin1String("materials") || field.name == QLatin1String("lights");
    });
    return fields;
}

QByteArray cameraText(const Camera &camera)
{
    QByteArrayList fields;
    eachField(camera, [&](const char *name, const auto &value) {
        fields.append('"' + QByteArray(name) + "\": " + textOf(value, {}));
    });
    return "{ " + fields.join(", ") + " }";
}

QByteArray appearanceText(const Appearance &appearance, const QString &folder)
{
    return fieldsText(appearance, ",\n    ", folder);
}

} // namespace pixelplumb
