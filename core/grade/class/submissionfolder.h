// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/text/result.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace pixelplumb {

/// A name that is safe to show and distinct from every other: bytes that are no plain characters of
/// UTF-8, and the backslash, become \xHH.
QString escapedName(const QByteArray &name);

/// The name that escapedName() shows like this.
QByteArray nameShownAs(const QString &escaped);

/// A unique name for files: the name's plain characters, and 64 bits of its hash.
QString idOf(const QByteArray &name);

/// A file of a submission.
struct SubmittedFile {
    QByteArray name; ///< as in the folder: any bytes but / and 0
    std::int64_t size = 0; ///< bytes
    bool isExecutable = false;
};

/// A part of a submission that is not read.
struct RefusedFile {
    QByteArray name;
    QString kind; ///< "a link"
};

/// One entry in a folder of submissions: a file, or a folder with files.
class SubmissionEntry {
public:
    SubmissionEntry(QByteArray folder, QByteArray entryName);

    const QByteArray &name() const { return m_name; }
    bool isFolder() const { return m_isFolder; }
    /// Regular files, no links; in a folder those directly in it, by name.
    const std::vector<SubmittedFile> &files() const { return m_files; }
    /// Anything else with a plain name: links are not followed, and pipes are not waited for.
    const std::vector<RefusedFile> &refused() const { return m_refused; }
    /// Reads one of the files, unless it is larger than `largest` bytes or was replaced by a link
    /// or a pipe.
    Result<QByteArray> read(const SubmittedFile &file, std::int64_t largest) const;
    /// A hash of all names and contents, subfolders included; none where they exceed 256 MiB or
    /// cannot be read.
    std::optional<QByteArray> digest() const;
    /// The path of one of the files, for starting it; none where it is no UTF-8.
    std::optional<QString> pathOf(const SubmittedFile &file) const;

private:
    QByteArray m_folder; ///< of all submissions
    QByteArray m_name;
    bool m_isFolder = false;
    std::vector<SubmittedFile> m_files;
    std::vector<RefusedFile> m_refused;
};

/// The names in a folder of submissions, sorted by their bytes, without those that begin with a
/// dot.
Result<std::vector<QByteArray>> submissionsIn(const QString &folder);

/// The names that begin with a dot; these are no submissions.
std::vector<QByteArray> hiddenIn(const QString &folder);

} // namespace pixelplumb
