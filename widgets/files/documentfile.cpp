// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/documentfile.h"

#include "core/scene/fileaccess.h"
#include "core/scene/scenefile.h"

#include <QFileInfo>

namespace pixelplumb {

std::optional<InputError> writeDocument(const QString &path, const Scene &scene)
{
    return writeFile(path, writeScene(scene, QFileInfo(path).absolutePath()), WrittenAs::Document);
}

} // namespace pixelplumb
