// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/outputfile.h"

#include "core/scene/inputrecord.h"

#include <QFileInfo>
#include <QSaveFile>

#include <utility>

namespace pixelplumb {

OutputFile::OutputFile(QString path, WrittenAs as)
    : m_path(std::move(path))
    , m_as(as)
{
}

std::optional<InputError> OutputFile::open()
{
    if (m_as == WrittenAs::Export) {
        if (auto refusal = refusalToWrite(m_path))
            return refusal;
    }
    // A device or a pipe cannot be replaced by a finished file.
    const QFileInfo target(m_path);
    if (target.exists() && !target.isFile() && !target.isDir())
        m_file = std::make_unique<QFile>(m_path);
    else
        m_file = std::make_unique<QSaveFile>(m_path);
    return m_file->open(QIODevice::WriteOnly) ? std::nullopt : std::optional(error());
}

std::optional<InputError> OutputFile::finish()
{
    // Once a file is given up it does not say any more why.
    if (m_file->error() != QFileDevice::NoError || !m_file->flush())
        return error();
    auto *file = qobject_cast<QSaveFile *>(m_file.get());
    return !file || file->commit() ? std::nullopt : std::optional(error());
}

InputError OutputFile::error(const QString &otherwise) const
{
    return writingError(m_path, *m_file, otherwise);
}

InputError writingError(const QString &place, const QFileDevice &device, const QString &otherwise)
{
    const bool isSaid = device.error() != QFileDevice::NoError || otherwise.isEmpty();
    return {place,
            QStringLiteral("cannot be written: ") + (isSaid ? device.errorString() : otherwise),
            {}};
}

} // namespace pixelplumb
