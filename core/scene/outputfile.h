// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"
#include "core/scene/writtenas.h"

#include <QFileDevice>

#include <memory>
#include <optional>

namespace pixelplumb {

/// A file that is written as its content is made: it appears whole or not at all. What is no
/// regular file (a device, a pipe) is written to as it is.
class OutputFile {
public:
    explicit OutputFile(QString path, WrittenAs as = WrittenAs::Export);

    /// An error when it cannot be written to.
    std::optional<InputError> open();
    QFileDevice &device() { return *m_file; }
    /// Makes it permanent; without it a file is left as it was.
    std::optional<InputError> finish();

    /// Why it cannot be written: what the device says, else `otherwise`.
    InputError error(const QString &otherwise = {}) const;

private:
    QString m_path;
    WrittenAs m_as;
    std::unique_ptr<QFileDevice> m_file;
};

/// Why a device takes no more, at a place that has a name; `otherwise` where it does not say.
InputError writingError(const QString &place, const QFileDevice &device, const QString &otherwise);

} // namespace pixelplumb
