// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/appearancewriter.h"

#include "core/scan/choicenames.h"
#include "core/scene/appearancenames.h"
#include "core/scene/colourtext.h"
#include "core/scene/primitivewriter.h"
#include "core/scene/referredfiles.h"

namespace pixelplumb {

namespace {

QByteArray inQuotes(std::string_view name) { return quotedText(nameText(name).toUtf8()); }

QByteArray inQuotes(const Colour &colour) { return '"' + colourText(colour).toUtf8() + '"'; }

/// ", \"key\": value" where the value is not the default.
template <class Value, class Text>
QByteArray unlessDefault(const char *key, const Value &value, const Value &byDefault,
                         const Text &text)
{
    return value == byDefault ? QByteArray() : QByteArray(", \"") + key + "\": " + text(value);
}

constexpr auto nameInQuotes = [](auto choice) { return inQuotes(nameOf(choice)); };
constexpr auto colourInQuotes = [](const Colour &colour) { return inQuotes(colour); };

/// A choice whose name is a number stands without quotation marks.
constexpr auto nameOrNumber = [](auto choice) {
    const QByteArray name = nameText(nameOf(choice)).toUtf8();
    return name[0] >= '0' && name[0] <= '9' ? name : quotedText(name);
};

QByteArray materialLine(const Material &material, const QString &folder)
{
    const Material byDefault;
    QByteArray text;
    if (material.texture)
        text += ", \"texture\": "
            + quotedText(nameInFolder(material.texture->name, folder).toUtf8());
    text += unlessDefault("filter", material.filter, byDefault.filter, nameInQuotes)
        + unlessDefault("wrap", material.wrap, byDefault.wrap, nameInQuotes)
        + unlessDefault("diffuse", material.diffuse, byDefault.diffuse, colourInQuotes)
        + unlessDefault("specular", material.specular, byDefault.specular, colourInQuotes)
        + unlessDefault("shininess", material.shininess, byDefault.shininess,
                        [](int exponent) { return QByteArray::number(exponent); });
    const QByteArray value = text.isEmpty() ? "{}" : "{ " + text.sliced(2) + " }";
    return quotedText(QByteArray::fromStdString(material.name)) + ": " + value;
}

QByteArray lightLine(const Light &light)
{
    const char *key = light.kind == Light::Kind::Directional ? "direction" : "position";
    return QByteArray("{ \"") + key + "\": " + jsonAttributeText(light.at)
        + ", \"color\": " + inQuotes(light.colour) + " }";
}

/// Elements, each on a line of its own, between brackets.
QByteArray block(const QByteArrayList &lines, char open, char close)
{
    return open + ("\n        " + lines.join(",\n        ") + "\n    ") + close;
}

} // namespace

QByteArray appearanceText(const Appearance &appearance, const QString &folder)
{
    const Appearance byDefault;
    QByteArray text;
    const auto append = [&text](const QByteArray &key, const QByteArray &value) {
        text += ",\n    \"" + key + "\": " + value;
    };
    if (!appearance.materials.empty()) {
        QByteArrayList lines;
        for (const Material &material : appearance.materials)
            lines.append(materialLine(material, folder));
        append("materials", block(lines, '{', '}'));
    }
    if (!appearance.lights.empty()) {
        QByteArrayList lines;
        for (const Light &light : appearance.lights)
            lines.append(lightLine(light));
        append("lights", block(lines, '[', ']'));
    }
    if (appearance.ambient != byDefault.ambient)
        append("ambient", inQuotes(appearance.ambient));
    if (appearance.shading != byDefault.shading)
        append("shading", nameInQuotes(appearance.shading));
    if (appearance.depth != byDefault.depth)
        append("depth", nameInQuotes(appearance.depth));
    if (appearance.depthFormat != byDefault.depthFormat)
        append("depthBits", nameOrNumber(appearance.depthFormat));
    if (appearance.antialiasing != byDefault.antialiasing)
        append("antialiasing", nameOrNumber(appearance.antialiasing));
    return text;
}

} // namespace pixelplumb
