// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/descriptor.h"
#include "core/scene/text/result.h"

#include <QStringList>

#include <optional>

namespace pixelplumb {

/// The files in a folder of results.
inline const QString assignmentFile = u"assignment.json"_s;
inline const QString lockFile = u"grading.lock"_s; ///< empty; see ResultsLock
inline const QString reviewsFile = u"reviews.json"_s;
inline const QString submissionListFile = u"submissions.json"_s;
/// "grades/ID.json"
inline QString submissionFile(const QString &id) { return u"grades/%1.json"_s.arg(id); }

/// A folder of results, whose files are named "assignment.json" or "grades/ID.json". Links in it
/// are not followed, and only regular files are read or replaced. What is read from it does not
/// count as input: grading resumes from its own results.
class ResultsFolder {
public:
    explicit ResultsFolder(QString path)
        : m_path(std::move(path))
    {
    }

    QString pathOf(const QString &file) const; ///< for messages

    /// Opens the lock file, which is made if need be.
    Result<Descriptor> openLockFile() const;
    /// Makes the folders inside it, if need be.
    std::optional<InputError> makeFolders() const;
    /// Whether anything of any kind has the name.
    bool has(const QString &file) const;
    Result<QByteArray> read(const QString &file) const;
    /// Replaces a file in one step: after an error the old content remains.
    std::optional<InputError> write(const QString &file, const QByteArray &content) const;
    void remove(const QString &file) const; ///< no input
    /// The names of the regular files in one of its folders, sorted.
    QStringList filesIn(const QString &folder) const;

    /// "grades", "pictures", "gradescope".
    static const QStringList &folders();

private:
    struct Place;
    Result<Place> placeOf(const QString &file) const;

    QString m_path;
};

} // namespace pixelplumb
