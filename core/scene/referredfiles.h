// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/number/jobprogress.h"
#include "core/scene/result.h"
#include "core/space/solid.h"

#include <QHash>

#include <utility>

namespace pixelplumb {

/// What a scene takes from other files, pictures and meshes: each read once, found beside the
/// scene's own file.
class ReferredFiles {
public:
    /// The folder of the scene's file; empty where there is none: the current one.
    explicit ReferredFiles(QString folder, ProgressListener listener = {})
        : m_folder(std::move(folder))
        , m_listener(std::move(listener))
    {
    }

    /// "checker", or a picture.
    Result<std::shared_ptr<const Texture>> texture(const QString &name);
    Result<std::shared_ptr<const Mesh>> mesh(const QString &name);

private:
    QString pathOf(const QString &name) const;

    QString m_folder;
    ProgressListener m_listener; ///< of meshes
    QHash<QString, std::shared_ptr<const Texture>> m_textures; // by path
    QHash<QString, std::shared_ptr<const Mesh>> m_meshes;
    std::size_t m_texels = 0;
};

/// How many bytes a scene's file has with the pictures and meshes that it names, so far as they are
/// there; for guesses of how long it takes to read them. Beyond 1 MiB its own alone.
qint64 bytesToRead(const QString &path);

/// A file's name as a scene in the folder says it: relative where there is a folder; names that are
/// no absolute path, as "checker", stay.
QString nameInFolder(const std::string &name, const QString &folder);

} // namespace pixelplumb
