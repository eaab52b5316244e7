// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/partwriter.h"

#include "core/scan/choicenames.h"
#include "core/scene/fields/primitivewriter.h"
#include "core/scene/fields/referredfiles.h"
#include "core/scene/fields/scenefields.h"
#include "core/scene/text/colourtext.h"

namespace pixelplumb {

namespace {

/// Elements in brackets, each on its own line.
QByteArray block(const QByteArrayList &lines, char open, char close)
{
    return open + ("\n        " + lines.join(",\n        ") + "\n    ") + close;
}

/// Writes fields by their lists. A field of which there is nothing to say has an empty text.
class FieldTexts {
public:
    /// folder: that of the scene's file, relative to which textures are named.
    explicit FieldTexts(QString folder)
        : m_folder(std::move(folder))
    {
    }

    /// "\"name\": value" of each field.
    template <class Part>
    QByteArrayList of(const Part &part) const
    {
        QByteArrayList fields;
        eachField(part, [&](const char *name, const auto &value) {
            if (const QByteArray text = textOf(value); !text.isEmpty())
                fields.append('"' + QByteArray(name) + "\": " + text);
        });
        return fields;
    }
    /// Without those that have their defaults.
    template <class Part>
    QByteArrayList ofOthersThanDefaults(const Part &part) const
    {
        QByteArrayList fields = of(part);
        const QByteArrayList defaults = of(Part());
        fields.removeIf([&](const QByteArray &field) { return defaults.contains(field); });
        return fields;
    }

    template <class Value>
    QByteArray textOf(const Required<Value> &field) const
    {
        return textOf(field.value);
    }
    template <class Value>
    QByteArray textOf(const std::optional<Value> &value) const
    {
        return value ? textOf(*value) : QByteArray();
    }
    /// Names are quoted, except those that are numbers.
    template <class Choice, class Choices>
    QByteArray textOf(const ChoiceOf<Choice, Choices> &field) const
    {
        const QByteArray name = nameText(nameOf(field.choice)).toUtf8();
        return name[0] >= '0' && name[0] <= '9' ? name : quotedText(name);
    }
    template <class Number>
    QByteArray textOf(const NumberWithin<Number> &field) const
    {
        return QByteArray::number(field.number);
    }
    template <class Number>
    QByteArray textOf(const NumberBetween<Number> &field) const
    {
        return jsonRealText(field.number);
    }
    template <class Frame>
    QByteArray textOf(const FirstPixelOf<Frame> &field) const
    {
        const auto &[column, row] = std::pair(field.frame.firstColumn, field.frame.firstRow);
        return column == 0 && row == 0
            ? QByteArray()
            : '[' + QByteArray::number(column) + ", " + QByteArray::number(row) + ']';
    }
    QByteArray textOf(const std::string &text) const
    {
        return quotedText(QByteArray::fromStdString(text));
    }
    QByteArray textOf(const Colour &colour) const
    {
        return quotedText(colourText(colour).toUtf8());
    }
    QByteArray textOf(const LatticePoint &point) const { return jsonPointText(point); }
    QByteArray textOf(const std::array<Attribute, 3> &at) const { return jsonAttributeText(at); }
    QByteArray textOf(const Vector3 &vector) const { return jsonRealsText(vector); }
    QByteArray textOf(const std::shared_ptr<const Texture> &texture) const
    {
        return texture ? quotedText(nameInFolder(texture->name, m_folder).toUtf8()) : QByteArray();
    }
    QByteArray textOf(VariantSet variants) const
    {
        QByteArrayList names;
        for (const Variant variant : variantsIn(variants))
            names.append(quotedText(nameText(nameOf(variant)).toUtf8()));
        return names.isEmpty() ? QByteArray() : '[' + names.join(", ") + ']';
    }
    QByteArray textOf(const std::vector<Material> &materials) const
    {
        QByteArrayList lines;
        for (const Material &material : materials) {
            const QByteArrayList fields = ofOthersThanDefaults(material);
            lines.append(quotedText(QByteArray::fromStdString(material.name)) + ": "
                         + (fields.isEmpty() ? "{}" : inBraces(fields)));
        }
        return block(lines, '{', '}');
    }
    QByteArray textOf(const std::vector<Light> &lights) const
    {
        QByteArrayList lines;
        for (const Light &light : lights)
            lines.append(inBraces(of(light)));
        return block(lines, '[', ']');
    }
    QByteArray textOf(const FrameSpec &frame) const { return inBraces(of(frame)); }
    QByteArray textOf(const Camera &camera) const { return inBraces(of(camera)); }
    QByteArray textOf(const Motion &motion) const { return inBraces(of(motion)); }

private:
    static QByteArray inBraces(const QByteArrayList &fields)
    {
        return "{ " + fields.join(", ") + " }";
    }

    QString m_folder;
};

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
    const FieldTexts texts(folder);
    std::vector<FieldText> fields;
    const auto add = [&](const char *name, const auto &value) {
        fields.push_back(
            {QLatin1String(name), withoutQuotes(texts.textOf(value)), {}, choicesOf(value)});
    };
    eachField(part, add);
    auto field = fields.begin();
    eachField(std::as_const(byDefault), [&](const char *, const auto &value) {
        field++->byDefault = withoutQuotes(texts.textOf(value));
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

QByteArray surroundingsText(const Scene &scene, const QString &folder)
{
    const FieldTexts texts(folder);
    return (texts.of(scene) + texts.ofOthersThanDefaults(scene.appearance)).join(",\n    ");
}

} // namespace pixelplumb
