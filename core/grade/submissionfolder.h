// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace pixelplumb {

/// A name as it can be shown and told from every other: bytes that are no plain characters of
/// UTF-8, and the backslash, become \xHH.
QString escapedName(const QByteArray &name);

/// The name that is shown like this.
QByteArray nameShownAs(const QString &escaped);

/// A name for files, unlike all others: the plain characters of it, and 64 bits of its hash.
QString idOf(const QByteArray &name);

/// A file of a submission.
struct SubmittedFile {
    QByteArray name; ///< as the folder has it: any bytes but / and 0
    std::int64_t size = 0; ///< bytes
    bool isExecutable = false;
};

/// What a submission has that is not read.
struct RefusedFile {
    QByteArray name;
    QString kind; ///< "a link"
};

/// What lies in a folder of submissions under one name: a file, or a folder with files.
class SubmissionEntry {
public:
    SubmissionEntry(QByteArray folder, QByteArray entryName);

    const QByteArray &name() const { return m_name; }
    bool isFolder() const { return m_isFolder; }
    /// Regular files; of a folder those right in it, by name. A link is none.
    const std::vector<SubmittedFile> &files() const { return m_files; }
    /// What else is there under plain names: nobody follows a link or waits at a pipe.
    const std::vector<RefusedFile> &refused() const { return m_refused; }
    /// The content of one of the files, unless it is larger than so many bytes or was replaced by a
    /// link or a pipe.
    Result<QByteArray> read(const SubmittedFile &file, std::int64_t largest) const;
    /// A hash of all names and contents, those of folders below among them; none where they are
    /// more than 256 MiB or cannot be read.
    std::optional<QByteArray> digest() const;
    /// The path of one of the files, for those who start it; none where it is no UTF-8.
    std::optional<QString> pathOf(const SubmittedFile &file) const;

private:
    QByteArray m_folder; ///< of all submissions
    QByteArray m_name;
    bool m_isFolder = false;
    std::vector<SubmittedFile> m_files;
    std::vector<RefusedFile> m_refused;
};

/// The names in a folder of submissions, in the order of their bytes, but for those that begin with
/// a dot.
Result<std::vector<QByteArray>> submissionsIn(const QString &folder);

/// Those that begin with a dot, and are no submissions.
std::vector<QByteArray> hiddenIn(const QString &folder);

} // namespace pixelplumb
