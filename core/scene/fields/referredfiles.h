// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/number/jobprogress.h"
#include "core/scene/text/result.h"
#include "core/space/solid.h"

#include <QHash>

#include <utility>

namespace pixelplumb {

/// The pictures and meshes that a scene refers to: each is read once, relative to the scene's own
/// file.
class ReferredFiles {
public:
    /// `folder`: that of the scene's file; empty: the current one.
    explicit ReferredFiles(QString folder, ProgressListener listener = {})
        : m_folder(std::move(folder))
        , m_listener(std::move(listener))
    {
    }

    /// Returns "checker", or reads a picture.
    Result<std::shared_ptr<const Texture>> texture(const QString &name);
    Result<std::shared_ptr<const Mesh>> mesh(const QString &name);

private:
    QString pathOf(const QString &name) const;

    QString m_folder;
    ProgressListener m_listener; ///< for meshes
    QHash<QString, std::shared_ptr<const Texture>> m_textures; // by path
    QHash<QString, std::shared_ptr<const Mesh>> m_meshes;
    std::size_t m_texels = 0;
};

/// How many bytes a scene's file has together with the existing pictures and meshes that it names,
/// to estimate the time of reading; above 1 MiB the scene's file alone counts.
qint64 bytesToRead(const QString &path);

/// A file's name as written in a scene in the folder: relative where there is a folder; names that
/// are no absolute path, such as "checker", stay.
QString nameInFolder(const std::string &name, const QString &folder);

} // namespace pixelplumb
