// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"
#include "core/scene/text/result.h"

#include <QStandardItemModel>

#include <map>

namespace pixelplumb {

/// How a scene is seen, apart from its primitives.
struct ChosenLook {
    std::optional<Camera> camera;
    Appearance appearance;
};

/// The camera, the lights, the materials and the other fields of a scene's look as rows to edit:
/// what it is, value, default. An empty value is the default; a list of numbers has no brackets.
class SceneLook : public QStandardItemModel {
    Q_OBJECT

public:
    enum Column { Key, Value, Default };
    static constexpr int choicesRole = Qt::UserRole; ///< QStringList: what a value can be
    static constexpr int keyRole = Qt::UserRole + 1; ///< in the first column: the key of a file

    /// `folder`: the scene's, in which textures are looked up.
    SceneLook(const Scene &scene, const QString &folder, QObject *parent = nullptr);

    /// What the rows say, or what is wrong with them. A texture is read once.
    Result<ChosenLook> look();

    QModelIndex addLight();
    QModelIndex addMaterial();
    /// False for rows that are no light or material, and for materials that the scene uses.
    bool canRemove(const QModelIndex &index) const;
    void remove(const QModelIndex &index);

private:
    QStandardItem *addPart(QStandardItem *parent, const QString &key, const QString &words);
    void addMaterial(const Material &material);
    QByteArray text() const;
    void nameLights();

    QString m_folder;
    EffectForcing m_forced; ///< kept: a file does not have it
    std::map<QString, std::shared_ptr<const Texture>> m_textures; ///< by the names in the rows
    std::size_t m_usedMaterials = 0; ///< the first ones, which cannot be removed
    QStandardItem *m_camera = nullptr;
    QStandardItem *m_lights = nullptr;
    QStandardItem *m_materials = nullptr;
};

} // namespace pixelplumb
