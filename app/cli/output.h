// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/outputfile.h"

#include <QFile>

namespace pixelplumb::cli {

/// Where a result is written while it is made: standard output for "-", else a file that is no
/// input and appears whole or not at all.
class Output {
public:
    explicit Output(const QString &path);

    /// An error when the place cannot be written.
    std::optional<InputError> open();
    QIODevice &device();
    /// Makes the file permanent; without this call an existing file stays as it was.
    std::optional<InputError> finish();

    /// Why it cannot be written: what the device says, else `otherwise`.
    InputError error(const QString &otherwise = {}) const;

private:
    QFile m_standardOutput;
    std::optional<OutputFile> m_file; ///< none: standard output
};

/// Why "-" cannot take what a command writes in addition to its printed report; none where the path
/// is not "-".
std::optional<InputError> refusalOfStandardOutput(const QString &path, const QString &expected);

} // namespace pixelplumb::cli
