// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/workingfolder.h"

#include <QFile>

#include <filesystem>

namespace pixelplumb {

namespace fs = std::filesystem;

namespace {

/// Folders may be closed to their owner.
void openFolders(const fs::path &top)
{
    std::error_code ignored;
    fs::permissions(top, fs::perms::owner_all, fs::perm_options::add, ignored);
    for (fs::directory_iterator entry(top, ignored); entry != fs::directory_iterator();
         entry.increment(ignored)) {
        if (entry->symlink_status(ignored).type() == fs::file_type::directory)
            openFolders(entry->path());
    }
}

} // namespace

WorkingFolder::~WorkingFolder()
{
    if (!m_folder.isValid())
        return;
    const fs::path path(QFile::encodeName(m_folder.path()).toStdString());
    std::error_code ignored;
    fs::remove_all(path, ignored);
    if (!ignored)
        return;
    openFolders(path);
    fs::remove_all(path, ignored);
}

} // namespace pixelplumb
