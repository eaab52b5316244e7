// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/text/result.h"
#include "core/scene/text/writtenas.h"

#include <QFileDevice>

#include <memory>
#include <optional>

namespace pixelplumb {

/// A file that is written while its content is made; it appears whole or not at all. What is no
/// regular file (a device, a pipe) is written to directly.
class OutputFile {
public:
    explicit OutputFile(QString path, WrittenAs as = WrittenAs::Export);

    /// An error when it cannot be written to.
    std::optional<InputError> open();
    QFileDevice &device() { return *m_file; }
    /// Makes the file permanent; without it the old file stays.
    std::optional<InputError> finish();

    /// Why the file cannot be written: what the device reports, else `otherwise`.
    InputError error(const QString &otherwise = {}) const;

private:
    QString m_path;
    WrittenAs m_as;
    std::unique_ptr<QFileDevice> m_file;
};

/// Why a device takes no more data; `place` names it, and `otherwise` stands in where it reports
/// nothing.
InputError writingError(const QString &place, const QFileDevice &device, const QString &otherwise);

} // namespace pixelplumb
