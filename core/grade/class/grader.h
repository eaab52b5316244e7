// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/gradereport.h"
#include "core/grade/class/submissionfolder.h"

#include <QImage>

#include <map>
#include <memory>
#include <mutex>
#include <stop_token>

namespace pixelplumb {

struct Delivery;

/// A submission's grade, and the pictures that were judged.
struct GradedWork {
    GradedSubmission submission;
    std::vector<std::optional<Picture>> pictures; ///< by scene of the assignment
};

/// Grades submissions of one assignment; thread-safe. Submissions with the same pictures are
/// diagnosed once.
class Grader {
public:
    explicit Grader(Assignment assignment);

    const Assignment &assignment() const { return m_assignment; }
    /// Judges by another convention of the frame; made when it is first asked for.
    Grader &in(FrameConvention convention);
    /// What the scene's method draws.
    const Picture &expected(std::size_t scene) const { return m_expected[scene]; }
    /// How the found picture differs from that, up to what the margin leaves open.
    PictureDiff diffOf(std::size_t scene, const Picture &found) const;

    /// Leaves the digest empty. None where the stop was requested.
    std::optional<GradedWork> grade(const SubmissionEntry &entry, const std::stop_token &stop = {});

    /// The grade of a submission whose grading ended in an error: no points.
    GradedWork ungraded(const SubmissionEntry &entry, const QString &error) const;

private:
    struct WrongPixels {
        std::int64_t coverage = 0; ///< missing or extra
        std::int64_t all = 0;

        friend auto operator<=>(const WrongPixels &, const WrongPixels &) = default;
    };
    WrongPixels wrongIn(const std::vector<Delivery> &deliveries) const;
    /// The grader by whose convention these cover the fewest wrong pixels, if it is clearly better.
    Grader &bestFor(const std::vector<Delivery> &deliveries);
    std::optional<GradedWork> gradeIn(const SubmissionEntry &entry,
                                      std::vector<Delivery> deliveries,
                                      const std::stop_token &stop);
    GradedScene judge(std::size_t scene, const Delivery &delivery) const;
    /// What is known about a set of pictures, whoever drew them.
    struct Named {
        QString pictures; ///< one word that names the set
        std::vector<GradedCandidate> candidates;
        std::map<std::size_t, QStringList> explanations; ///< by scene, if none explains all
        std::optional<QString> error = {}; ///< the error that ended the search for causes
    };

    std::optional<Named> named(const std::vector<FoundPicture> &found, const std::stop_token &stop);
    /// Adds the causes; false where the stop was requested.
    bool search(const std::vector<FoundPicture> &found, const std::stop_token &stop, Named &named);
    std::optional<Diagnosis> diagnosisOf(std::span<const FoundPicture> found,
                                         const std::stop_token &stop);
    /// Names what explains one scene's picture for all of them, where it comes nearest and is
    /// relevant to the whole.
    void tryOnAll(const DiagnosisCandidate &candidate, const std::vector<FoundPicture> &found,
                  const Diagnosis &whole, Named &named) const;
    GradedCandidate gradedOf(const DiagnosisCandidate &candidate,
                             const std::vector<FoundPicture> &found) const;
    std::optional<FirstDivergence> partingOf(const DiagnosisCandidate &candidate,
                                             const std::vector<FoundPicture> &found) const;

    Assignment m_assignment;
    std::vector<Picture> m_expected;
    DefectPictures m_pictures;
    FrameConvention m_convention = FrameConvention::AsAsked;
    std::mutex m_mutex;
    std::map<FrameConvention, std::unique_ptr<Grader>> m_others;
    std::map<QByteArray, Named> m_known; ///< by hash of the pictures
};

/// The frame's pixel at a place of its picture (Picture::placeOf()).
FramePixel pixelOfPlace(const FrameSpec &frame, std::size_t place);
/// The first wrong pixel in the order of reading, else the first undecidable one.
std::optional<FramePixel> firstDifferenceIn(const PictureDiff &diff, const FrameSpec &frame);

/// Line by line, the top line first, as in a file.
QImage imageOf(const Picture &picture);

} // namespace pixelplumb
