// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/outputfile.h"

#include <QFile>

namespace pixelplumb::cli {

/// Where a result is written as it is made: standard output for "-", else a file that appears whole
/// or not at all and is no input.
class Output {
public:
    explicit Output(const QString &path);

    /// An error when the place cannot be written to.
    std::optional<InputError> open();
    QIODevice &device();
    /// Makes it permanent; without it a file is left as it was.
    std::optional<InputError> finish();

    /// Why it cannot be written: what the device says, else `otherwise`.
    InputError error(const QString &otherwise = {}) const;

private:
    QFile m_standardOutput;
    std::optional<OutputFile> m_file; ///< none: standard output
};

/// Why "-" is no place for what a command writes beside the report that it prints; none where the
/// path is another.
std::optional<InputError> refusalOfStandardOutput(const QString &path, const QString &expected);

} // namespace pixelplumb::cli
