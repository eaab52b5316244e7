// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defectivescene.h"
#include "core/grade/diagnose/picturematch.h"
#include "core/number/jobprogress.h"

#include <QStringList>

#include <optional>
#include <span>
#include <vector>

namespace pixelplumb {

/// A picture that a student's program drew of a scene; both have the same size.
struct Submission {
    Scene scene;
    Picture picture;
};

enum class DiagnosisVerdict { Right, Wrong, Undecidable };
QString nameOf(DiagnosisVerdict verdict);

/// Defects that occur together, and what they leave unexplained.
struct DiagnosisCandidate {
    /// One or two defects; with two, perhaps one that alone is no mistake; the arithmetic where it
    /// is not tolerated; and the background where it is one colour, neither black nor white.
    std::vector<Defect> defects;
    std::int64_t distance = 0; ///< unexplained pixels in all pictures
    /// Pixels that differ, but may do so with these defects: by rounding, or on an edge.
    std::int64_t undecidable = 0;
    std::optional<Arithmetic> arithmetic = {}; ///< not the scene's, but pictures are equal in it

    QStringList ids() const;
    /// The ids of the defects that alone are no mistake.
    QStringList rightAlone() const;
    /// One sentence for each defect, from its member `words`, without repetitions. A student reads
    /// only of mistakes, where there are any.
    QStringList sentences(QString Defect::*words) const;
};

/// Whether a set of defects that does not explain the pictures is worth mentioning: it leaves at
/// most a tenth of what differs. Sets that leave more were mostly wrong when real programs were
/// tried: they misled their readers.
constexpr bool isRelevant(std::int64_t distance, std::int64_t differing)
{
    return 10 * distance <= differing;
}

/// "1 pixel", "3 pixels".
QString pixelsText(std::int64_t pixels);
/// "but for 3 pixels that rounding or a sample on an edge may decide"; empty for 0.
QString undecidableText(std::int64_t pixels);

/// Where the run of the defective scene first differs from the right one.
struct PartingStep {
    std::size_t step = 0; ///< in the trace of the defective run
    QString heading; ///< "Column 12, first half"
    QString text; ///< "y_T is 41 1/2, should be 41 4/7"
};

/// How many columns or rows were looked at, of all that large pictures have.
struct SampledPart {
    std::size_t spans = 0, of = 0;
};
/// "sets that only come near were looked for in 16 of 800 columns or rows: a nearer one may be
/// missing"
QString sampledText(const SampledPart &part);

struct Diagnosis {
    DiagnosisVerdict verdict = DiagnosisVerdict::Wrong;
    std::int64_t differing = 0; ///< pixels in all pictures, including undecidable ones
    std::int64_t undecidable = 0; ///< of these, as differenceOf() counts them
    std::vector<QStringList> places = {}; ///< of the others, by picture (wrongPlaces)
    /// Every set of one or two defects whose pictures equal the student's, except supersets of
    /// another. Where there is none: every set that leaves only undecidable pixels, followed by the
    /// sets that contain one of these and equal the pictures. Else, if the pictures are wrong, at
    /// most five of the nearest relevant sets (isRelevant): single defects, and pairs of a defect
    /// that is among the nearest alone with another, if they leave at most three quarters of what
    /// it leaves.
    std::vector<DiagnosisCandidate> candidates;
    /// Where pictures are large and no set equals them: by which part sets were refused that leave
    /// clearly more there. Which sets equal the pictures is known for certain.
    std::optional<SampledPart> sampled = {};
    /// The error that ended the search, leaving no candidates; none: it completed.
    std::optional<QString> failure = {};
    DrawnWork work = {}; ///< what was drawn for it, besides what other submissions had drawn

    bool isExplained() const { return !candidates.empty() && candidates.front().distance == 0; }
};

/// Judges all pictures together: one cause for all, or if there is none also one of another method
/// (setsOfOtherMethods). Undecidable means that a right program may have
/// the same differences, by the margin (undecidablePixels). None where the listener, who hears how
/// many sets of defects are tried, ended it. An exception ends only the search
/// (Diagnosis::failure).
std::optional<Diagnosis> diagnose(std::span<const Submission> submissions,
                                  const ProgressListener &listener = {}, const Margin &margin = {});

/// Like diagnose() above, for judging many programs' pictures of the same scenes, by their methods.
std::optional<Diagnosis> diagnose(DefectPictures &pictures, std::span<const FoundPicture> found,
                                  const ProgressListener &listener = {}, const Margin &margin = {});

/// The sets that explain the pictures, up to the margin, where triangles are drawn by another
/// method than the scenes': along columns, along rows or by edge tests; each begins with that
/// method, as a defect. None where the listener ended it.
std::optional<std::vector<DiagnosisCandidate>> setsOfOtherMethods(
    const DefectPictures &pictures, std::span<const FoundPicture> found,
    const ProgressListener &listener, const Margin &margin);

/// None where the runs are equal.
std::optional<PartingStep> partingStepOf(const Scene &right, const Scene &defective);

/// Compares a scene's run with defects to the right run, in the same arithmetic unless that is the
/// only defect. What our own program draws (Defect::redraw) has no run: the step is then that of
/// the run without it at which the pictures first differ. None where all defects are of the
/// finished picture.
std::optional<PartingStep> partingStepOf(const Scene &scene, std::span<const Defect> defects);

} // namespace pixelplumb
