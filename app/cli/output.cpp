// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output.h"

#include "core/scene/fileaccess.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace pixelplumb::cli {

Output::Output(QString path, QStringList inputs)
    : m_path(std::move(path))
    , m_inputs(std::move(inputs))
{
}

Output::~Output() = default;

std::optional<InputError> Output::open()
{
    const QFileInfo target(m_path);
    bool opened = false;
    const bool toStandardOutput = m_path == QStringLiteral("-");
    const auto isReplaced = [this](const QString &input) {
        return isSameFile(m_path,
                          input == QStringLiteral("-") ? QStringLiteral("/dev/stdin") : input);
    };
    if (!toStandardOutput && std::ranges::any_of(m_inputs, isReplaced))
        return InputError{m_path, QStringLiteral("is the input, which it would replace"),
                          QStringLiteral("another file")};
    if (toStandardOutput) {
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
    return opened ? std::nullopt : std::optional(error(m_file->errorString()));
}

std::optional<InputError> Output::finish()
{
    bool finished = m_file->flush();
    if (auto *file = qobject_cast<QSaveFile *>(m_file.get()))
        finished = file->commit() && finished;
    return finished ? std::nullopt : std::optional(error(m_file->errorString()));
}

InputError Output::error(const QString &otherwise) const
{
    const QString place
        = m_path == QStringLiteral("-") ? QStringLiteral("standard output") : m_path;
    const bool hasFailed = m_file->error() != QFileDevice::NoError;
    return {place,
            QStringLiteral("cannot be written: ") + (hasFailed ? m_file->errorString() : otherwise),
            {}};
}

} // namespace pixelplumb::cli
