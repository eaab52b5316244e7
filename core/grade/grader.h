// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/gradereport.h"
#include "core/grade/submissionfolder.h"

#include <QImage>

#include <map>
#include <mutex>
#include <stop_token>

namespace pixelplumb {

struct Delivery;

/// A submission's grade, and what was judged.
struct GradedWork {
    GradedSubmission submission;
    std::vector<std::optional<Picture>> pictures; ///< by scene of the assignment
};

/// Grades submissions of one assignment; may be asked by several threads at once. Submissions that
/// have the same pictures are diagnosed once.
class Grader {
public:
    explicit Grader(Assignment assignment);

    const Assignment &assignment() const { return m_assignment; }
    /// What the scene's method draws.
    const Picture &expected(std::size_t scene) const { return m_expected[scene]; }
    /// A 1 for each pixel of what was found that may be so; empty: none.
    std::vector<std::uint8_t> leftOpen(std::size_t scene, const Picture &found) const;

    /// The digest is left empty. None where the stop was asked for.
    std::optional<GradedWork> grade(const SubmissionEntry &entry, const std::stop_token &stop = {});

    /// What is known of a submission whose grading ended in an error: no points.
    GradedWork ungraded(const SubmissionEntry &entry, const QString &error) const;

private:
    GradedScene judge(std::size_t scene, const Delivery &delivery) const;
    /// What is known of pictures, whoever drew them.
    struct Named {
        QString pictures; ///< one word for them
        std::vector<GradedCandidate> candidates;
        std::map<std::size_t, QStringList> explanations; ///< by scene, where none explains all
        std::optional<QString> error = {}; ///< in which it ended that this was to become known
    };

    std::optional<Named> named(const std::vector<FoundPicture> &found, const std::stop_token &stop);
    /// Adds the causes; false where the stop was asked for.
    bool search(const std::vector<FoundPicture> &found, const std::stop_token &stop, Named &named);
    std::optional<Diagnosis> diagnosisOf(std::span<const FoundPicture> found,
                                         const std::stop_token &stop);
    GradedCandidate gradedOf(const DiagnosisCandidate &candidate,
                             const std::vector<FoundPicture> &found) const;
    std::optional<GradedParting> partingOf(const DiagnosisCandidate &candidate,
                                           const std::vector<FoundPicture> &found) const;

    Assignment m_assignment;
    std::vector<Picture> m_expected;
    DefectPictures m_pictures;
    std::mutex m_mutex;
    std::map<QByteArray, Named> m_known; ///< by hash of pictures
};

/// As a file has it, line by line.
QImage imageOf(const Picture &picture);

} // namespace pixelplumb
