// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/formfields.h"

#include "core/scene/fields/fieldtexts.h"

namespace pixelplumb {

namespace {

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
std::vector<FieldText> fieldTextsOf(const Part &part, Part byDefault, const QString &folder = {})
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
    std::vector<FieldText> fields = fieldTextsOf(camera, byDefault);
    fields.front().byDefault = nameText(nameOf(Camera().projection));
    return fields;
}

std::vector<FieldText> fieldTexts(const Light &light)
{
    const bool isDirectional = light.kind == Light::Kind::Directional;
    const QString at = QString::fromUtf8(FieldTexts().textOf(light.at));
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
    std::vector<FieldText> fields = fieldTextsOf(appearance, Appearance());
    std::erase_if(fields, [](const FieldText &field) {
        return field.name == QLatin1String("materials") || field.name == QLatin1String("lights");
    });
    return fields;
}

} // namespace pixelplumb
