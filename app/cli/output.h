// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QFileDevice>
#include <QStringList>

#include <memory>
#include <optional>

namespace pixelplumb::cli {

/// Where a result is written as it is made: standard output for "-", else a file that appears whole
/// or not at all. A file that the command has read (its `inputs`, "-" for standard input) is never
/// written to.
class Output {
public:
    Output(QString path, QStringList inputs);
    ~Output();
    Q_DISABLE_COPY_MOVE(Output)

    /// An error when the place cannot be written to.
    std::optional<InputError> open();
    QIODevice &device() { return *m_file; }
    /// Makes it permanent; without it a file is left as it was.
    std::optional<InputError> finish();

    /// Why it cannot be written: what the device says, else `otherwise`.
    InputError error(const QString &otherwise) const;

private:
    QString m_path;
    QStringList m_inputs;
    std::unique_ptr<QFileDevice> m_file;
};

} // namespace pixelplumb::cli
