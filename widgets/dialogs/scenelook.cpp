// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dialogs/scenelook.h"

#include "core/scene/fields/fieldtexts.h"
#include "core/scene/fields/formfields.h"
#include "core/scene/scenefile.h"

#include <QRegularExpression>

#include <algorithm>

namespace pixelplumb {

namespace {

using Textures = std::map<QString, std::shared_ptr<const Texture>>;

const QString textureKey = u"texture"_s;

constexpr int isListRole = SceneLook::keyRole + 1; ///< bool: whether a value is a list of numbers

const QStringList listKeys = {u"eye"_s, u"target"_s, u"up"_s, u"direction"_s, u"position"_s};

struct KeyWords {
    const char *key;
    const char *words;
};

constexpr KeyWords keyWords[] = {
    {"projection", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Projection")},
    {"eye", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Eye (x, y, z)")},
    {"target", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Looks at (x, y, z)")},
    {"up", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Upward (x, y, z)")},
    {"fieldOfView", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Field of view, degrees")},
    {"height", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Height of the view")},
    {"near", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Near plane")},
    {"far", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Far plane")},
    {"texture", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Texture")},
    {"filter", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Texture filter")},
    {"wrap", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Beyond the texture's border")},
    {"diffuse", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Diffuse colour")},
    {"specular", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Specular colour")},
    {"shininess", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Shininess")},
    {"direction", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Direction (x, y, z)")},
    {"position", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Position (x, y, z)")},
    {"color", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Colour")},
    {"ambient", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Ambient light")},
    {"shading", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Shading")},
    {"depth", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Depth test")},
    {"depthBits", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Bits of depth")},
    {"antialiasing", QT_TRANSLATE_NOOP("pixelplumb::SceneLook", "Samples per pixel")},
};

/// A key in words; the key where there are none.
QString wordsOf(const QString &key)
{
    const auto found = std::ranges::find_if(
        keyWords, [&key](const KeyWords &each) { return key == QLatin1String(each.key); });
    return found != std::end(keyWords) ? SceneLook::tr(found->words) : key;
}

/// A number as it is, all else as text.
QByteArray jsonText(const QString &value)
{
    static const QRegularExpression bare(u"^-?\\d+(\\.\\d+)?([eE][-+]?\\d+)?$"_s);
    return bare.match(value).hasMatch() ? value.toUtf8() : quotedText(value.toUtf8());
}

/// "[0, 1, 6]" as it is edited: "0, 1, 6".
QString withoutBrackets(QString list)
{
    if (list.startsWith(u'[') && list.endsWith(u']'))
        list = list.sliced(1, list.size() - 2);
    return list.remove(u'"');
}

QByteArray jsonList(const QString &value)
{
    QByteArrayList numbers;
    for (const QString &each : withoutBrackets(value).split(u','))
        numbers += jsonText(each.trimmed());
    return "[" + numbers.join(", ") + "]";
}

void addField(QStandardItem *parent, const FieldText &field)
{
    const bool isList = std::ranges::find(listKeys, field.name) != listKeys.end();
    const auto shown
        = [isList](const QString &text) { return isList ? withoutBrackets(text) : text; };
    auto *key = new QStandardItem(wordsOf(field.name));
    auto *value
        = new QStandardItem(field.value == field.byDefault ? QString() : shown(field.value));
    auto *byDefault = new QStandardItem(shown(field.byDefault));
    key->setData(field.name, SceneLook::keyRole);
    key->setToolTip(SceneLook::tr("“%1” in a scene file").arg(field.name));
    value->setData(field.choices, SceneLook::choicesRole);
    value->setData(isList, isListRole);
    key->setEditable(false);
    byDefault->setEditable(false);
    byDefault->setEnabled(false); // pale
    parent->appendRow({key, value, byDefault});
}

void addFields(QStandardItem *parent, const std::vector<FieldText> &fields)
{
    for (const FieldText &field : fields)
        addField(parent, field);
}

QString valueIn(const QStandardItem &part, int row)
{
    const QStandardItem *cell = part.child(row, SceneLook::Value);
    return cell ? cell->text().trimmed() : QString();
}

QString keyIn(const QStandardItem &part, int row)
{
    return part.child(row, SceneLook::Key)->data(SceneLook::keyRole).toString();
}

QByteArray jsonIn(const QStandardItem &part, int row)
{
    const QString value = valueIn(part, row);
    if (part.child(row, SceneLook::Value)->data(isListRole).toBool())
        return jsonList(value);
    return keyIn(part, row) == textureKey ? quotedText(value.toUtf8()) : jsonText(value);
}

QString textureNameIn(const QStandardItem &material)
{
    for (int row = 0; row < material.rowCount(); ++row) {
        if (keyIn(material, row) == textureKey)
            return valueIn(material, row);
    }
    return {};
}

/// "\"near\": 2, …": the fields that have a value, without the textures that are known.
QByteArray fieldsText(const QStandardItem &part, const Textures &known)
{
    QByteArrayList fields;
    for (int row = 0; row < part.rowCount(); ++row) {
        const QString key = keyIn(part, row);
        const QString value = valueIn(part, row);
        if (!value.isEmpty() && !(key == textureKey && known.contains(value)))
            fields.append(quotedText(key.toUtf8()) + ": " + jsonIn(part, row));
    }
    return fields.join(", ");
}

/// How many of the first materials the scene's primitives name.
std::size_t usedMaterialsOf(const Scene &scene)
{
    int used = 0;
    for (const TriangleAttributes &attributes : scene.attributes)
        used = std::max(used, attributes.material + 1);
    for (const Solid &solid : scene.solids)
        used = std::max(used, solid.material + 1);
    return scene.hidden.empty() ? std::size_t(used) : scene.appearance.materials.size();
}

} // namespace

SceneLook::SceneLook(const Scene &scene, const QString &folder, QObject *parent)
    : QStandardItemModel(0, 3, parent)
    , m_folder(folder)
    , m_forced(scene.appearance.forced)
    , m_usedMaterials(usedMaterialsOf(scene))
{
    setHorizontalHeaderLabels({tr("setting"), tr("value"), tr("default")});
    m_camera = addPart(invisibleRootItem(), u"camera"_s, tr("Camera"));
    m_camera->setCheckState(scene.camera ? Qt::Checked : Qt::Unchecked);
    m_camera->setCheckable(scene.solids.empty()); // these need a camera
    addFields(m_camera, fieldTexts(scene.camera.value_or(Camera())));
    m_materials = addPart(invisibleRootItem(), u"materials"_s, tr("Materials"));
    for (const Material &material : scene.appearance.materials)
        addMaterial(material);
    m_lights = addPart(invisibleRootItem(), u"lights"_s, tr("Lights"));
    for (const Light &light : scene.appearance.lights)
        addFields(addPart(m_lights, {}, {}), fieldTexts(light));
    nameLights();
    addFields(invisibleRootItem(), fieldTexts(scene.appearance));
}

QStandardItem *SceneLook::addPart(QStandardItem *parent, const QString &key, const QString &words)
{
    auto *part = new QStandardItem(words);
    part->setData(key, keyRole);
    part->setEditable(false);
    parent->appendRow(part);
    return part;
}

void SceneLook::addMaterial(const Material &material)
{
    QStandardItem *part = addPart(m_materials, {}, QString::fromStdString(material.name));
    part->setEditable(true);
    part->setToolTip(tr("The material's name, by which primitives name it"));
    addFields(part, fieldTexts(material, m_folder));
    if (material.texture)
        m_textures[textureNameIn(*part)] = material.texture;
}

QModelIndex SceneLook::addLight()
{
    QStandardItem *part = addPart(m_lights, {}, {});
    Light fromAbove;
    fromAbove.at = {0, -attributeOne, -attributeOne};
    addFields(part, fieldTexts(fromAbove));
    nameLights();
    return part->index();
}

QModelIndex SceneLook::addMaterial()
{
    const auto isTaken = [this](const QString &name) {
        for (int row = 0; row < m_materials->rowCount(); ++row) {
            if (m_materials->child(row)->text() == name)
                return true;
        }
        return false;
    };
    int number = 1;
    while (isTaken(tr("material %1").arg(number)))
        ++number;
    Material material;
    material.name = tr("material %1").arg(number).toStdString();
    addMaterial(material);
    return m_materials->child(m_materials->rowCount() - 1)->index();
}

void SceneLook::nameLights()
{
    for (int row = 0; row < m_lights->rowCount(); ++row)
        m_lights->child(row)->setText(tr("Light %1").arg(row + 1));
}

bool SceneLook::canRemove(const QModelIndex &index) const
{
    const QModelIndex parent = index.parent();
    return parent == m_lights->index()
        || (parent == m_materials->index() && std::size_t(index.row()) >= m_usedMaterials);
}

void SceneLook::remove(const QModelIndex &index)
{
    removeRow(index.row(), index.parent());
    nameLights();
}

/// A scene file that has the look and no primitive.
QByteArray SceneLook::text() const
{
    QByteArrayList fields = {"\"pixelplumb\": " + QByteArray::number(sceneFormat),
                             "\"frame\": { \"width\": 1, \"height\": 1 }"};
    if (m_camera->checkState() == Qt::Checked)
        fields.append("\"camera\": { " + fieldsText(*m_camera, m_textures) + " }");
    QByteArrayList materials;
    for (int row = 0; row < m_materials->rowCount(); ++row) {
        const QStandardItem &part = *m_materials->child(row);
        materials.append(quotedText(part.text().toUtf8()) + ": { " + fieldsText(part, m_textures)
                         + " }");
    }
    fields.append("\"materials\": { " + materials.join(", ") + " }");
    QByteArrayList lights;
    for (int row = 0; row < m_lights->rowCount(); ++row)
        lights.append("{ " + fieldsText(*m_lights->child(row), m_textures) + " }");
    fields.append("\"lights\": [ " + lights.join(", ") + " ]");
    if (const QByteArray rest = fieldsText(*invisibleRootItem(), m_textures); !rest.isEmpty())
        fields.append(rest);
    return "{ " + fields.join(", ") + ", \"primitives\": [] }";
}

Result<ChosenLook> SceneLook::look()
{
    const Result<SceneReading> read = readScene(text(), {}, m_folder);
    if (!read)
        return read.error();
    ChosenLook look = {read->scene.camera, read->scene.appearance};
    look.appearance.forced = m_forced;
    // Primitives name materials by their place; a file has them by name.
    for (int row = 0; row < m_materials->rowCount(); ++row) {
        const auto named
            = std::ranges::find(look.appearance.materials,
                                m_materials->child(row)->text().toStdString(), &Material::name);
        std::iter_swap(look.appearance.materials.begin() + row, named);
        Material &material = look.appearance.materials[std::size_t(row)];
        const QString texture = textureNameIn(*m_materials->child(row));
        if (material.texture)
            m_textures[texture] = material.texture;
        else if (!texture.isEmpty())
            material.texture = m_textures[texture];
    }
    return look;
}

} // namespace pixelplumb
