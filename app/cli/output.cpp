// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <cstdio>
#include <utility>

namespace pixelplumb::cli {

Output::Output(QString path)
    : m_path(std::move(path))
{
}

Output::~Output() = default;

std::optional<InputError> Output::open()
{
    const QFileInfo target(m_path);
    bool opened = false;
    if (m_path == QStringLiteral("-")) {
        auto standardOutput = std::make_unique<QFile>();
        opened = standardOutput->open(stdout, QIODevice::WriteOnly);
        m_file = std::move(standardOutput);
    } else if (target.exists() && !target.isFile() && !target.isDir()) {
        // A device or a pipe cannot be replaced by a finished file.
        m_file = std::make_unique<QFile>(m_path);
        opened = m_file->open(QIODevice::WriteOnly);
    } else {
        m_file = std::make_unique<QSaveFile>(m_path);
        opened = m_file->open(QIODevice::WriteOnly);
    }
    return opened ? std::nullopt : std::optional(error());
}

std::optional<InputError> Output::finish()
{
    bool finished = m_file->flush();
    if (auto *file = qobject_cast<QSaveFile *>(m_file.get()))
        finished = file->commit() && finished;
    return finished ? std::nullopt : std::optional(error());
}

InputError Output::error() const
{
    const QString place
        = m_path == QStringLiteral("-") ? QStringLiteral("standard output") : m_path;
    return {place, QStringLiteral("cannot be written: ") + m_file->errorString(), {}};
}

} // namespace pixelplumb::cli
