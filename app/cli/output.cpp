// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output.h"

#include "core/scene/inputrecord.h"

#include <cstdio>

namespace pixelplumb::cli {

Output::Output(const QString &path)
{
    if (path != QStringLiteral("-"))
        m_file.emplace(path);
}

std::optional<InputError> Output::open()
{
    if (m_file)
        return m_file->open();
    if (auto refusal = refusalToPrint())
        return refusal;
    return m_standardOutput.open(fileno(stdout), QIODevice::WriteOnly) ? std::nullopt
                                                                       : std::optional(error());
}

QIODevice &Output::device()
{
    if (m_file)
        return m_file->device();
    return m_standardOutput;
}

std::optional<InputError> Output::finish()
{
    if (m_file)
        return m_file->finish();
    const bool isWritten
        = m_standardOutput.error() == QFileDevice::NoError && m_standardOutput.flush();
    return isWritten ? std::nullopt : std::optional(error());
}

InputError Output::error(const QString &otherwise) const
{
    if (m_file)
        return m_file->error(otherwise);
    return writingError(QStringLiteral("standard output"), m_standardOutput, otherwise);
}

std::optional<InputError> refusalOfStandardOutput(const QString &path, const QString &expected)
{
    if (path != QStringLiteral("-"))
        return std::nullopt;
    return InputError{QStringLiteral("-o -"), QStringLiteral("standard output has the report"),
                      expected};
}

} // namespace pixelplumb::cli
