// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/descriptor.h"
#include "core/scene/result.h"

#include <QStringList>

#include <optional>

namespace pixelplumb {

/// What stands in a folder of results.
inline const QString assignmentFile = QStringLiteral("assignment.json");
inline const QString partFile = QStringLiteral("part.json");
inline const QString reviewsFile = QStringLiteral("reviews.json");
/// "grades/ID.json"
inline QString submissionFile(const QString &id)
{
    return QStringLiteral("grades/%1.json").arg(id);
}

/// A folder of results, in which what is read and written is ours: files by their names,
/// "part.json" or "grades/ID.json". No link in it is followed, and nothing but an ordinary file is
/// read, waited for or replaced. What is read from it is no input: grading takes its own results up
/// again.
class ResultsFolder {
public:
    explicit ResultsFolder(QString path)
        : m_path(std::move(path))
    {
    }

    QString pathOf(const QString &file) const; ///< for who is told of it

    /// Makes it, if need be, for one run alone: another one is refused as long as the descriptor is
    /// open.
    Result<Descriptor> take() const;
    /// Makes the folders in it, if need be.
    std::optional<InputError> makeFolders() const;
    /// Whether anything has the name, whatever it is.
    bool has(const QString &file) const;
    Result<QByteArray> read(const QString &file) const;
    /// Replaces a file in one step: after an error the old content stands.
    std::optional<InputError> write(const QString &file, const QByteArray &content) const;
    void remove(const QString &file) const; ///< no input
    /// Of the ordinary files in one of its folders, sorted.
    QStringList filesIn(const QString &folder) const;

    /// "grades", "pictures", "gradescope".
    static const QStringList &folders();

private:
    struct Place;
    Result<Place> placeOf(const QString &file) const;

    QString m_path;
};

} // namespace pixelplumb
