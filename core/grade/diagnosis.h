// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defectivescene.h"
#include "core/grade/picturematch.h"
#include "core/number/jobprogress.h"

#include <QStringList>

#include <optional>
#include <span>
#include <vector>

namespace pixelplumb {

/// A picture that a student's program drew of a scene; both have one size.
struct Submission {
    Scene scene;
    Picture picture;
};

enum class DiagnosisVerdict { Right, Wrong, Undecidable };
QString nameOf(DiagnosisVerdict verdict);

/// Defects that are there together, and what they leave unexplained.
struct DiagnosisCandidate {
    /// One or two, what is computed in where that is not allowed for, beside two perhaps one that
    /// alone is no mistake, and what it is drawn on where that is one colour and not black or
    /// white.
    std::vector<Defect> defects;
    std::int64_t distance = 0; ///< pixels that are not explained, of all pictures
    /// Pixels that differ, but may with these defects: by rounding, or on an edge.
    std::int64_t undecidable = 0;
    std::optional<Arithmetic> arithmetic = {}; ///< not the scene's, in which pictures are equal

    QStringList ids() const;
    /// The ids of those that alone are no mistake.
    QStringList rightAlone() const;
    /// A sentence a defect, for whom it is; of those that are the same one. A student is told of
    /// mistakes alone, where there are any.
    QStringList sentences(QString Defect::*words) const;
};

/// Whether a set of defects is worth words: it explains at least half of what differs.
constexpr bool isRelevant(std::int64_t distance, std::int64_t differing)
{
    return 2 * distance <= differing;
}

/// "1 pixel", "3 pixels".
QString pixelsText(std::int64_t pixels);
/// "but for 3 pixels that rounding or a sample on an edge may decide"; empty of none.
QString undecidableText(std::int64_t pixels);

/// Where the run of the defective scene first parts from the right one.
struct PartingStep {
    std::size_t step = 0; ///< of the defective run's trace
    QString heading; ///< "Column 12, first half"
    QString text; ///< "y_T is 41 1/2, should be 41 4/7"
};

struct Diagnosis {
    DiagnosisVerdict verdict = DiagnosisVerdict::Wrong;
    std::int64_t differing = 0; ///< pixels of all pictures, undecidable ones among them
    std::int64_t undecidable = 0; ///< of these, as differenceOf() counts them
    /// Every set of one or two defects whose pictures equal the student's, none that has a smaller
    /// one in it; where there is none, every one that leaves undecidable pixels alone, and behind
    /// them those that equal the pictures with one of these in them; else, if the pictures are
    /// wrong, at most five of the nearest ones: of single defects, and of pairs of one of those
    /// that come nearest alone with another, which leave at most three quarters of what it leaves.
    std::vector<DiagnosisCandidate> candidates;
    /// The error in which the search ended, without candidates; none: it went through.
    std::optional<QString> failure = {};

    bool isExplained() const { return !candidates.empty() && candidates.front().distance == 0; }
};

/// Judges all pictures together: one cause for all. Undecidable: what differs is what a right
/// program may have, too, that computes in arithmetic up to the tolerance (undecidablePixels;
/// exact: on ties alone; none: nowhere). None where the listener, who hears how many sets of
/// defects are tried, ended it. An exception ends the search alone (Diagnosis::failure).
std::optional<Diagnosis> diagnose(std::span<const Submission> submissions,
                                  const ProgressListener &listener = {},
                                  std::optional<Arithmetic> tolerance = Arithmetic::Float32);

/// The same for those who judge many programs' pictures of the same scenes.
std::optional<Diagnosis> diagnose(DefectPictures &pictures, std::span<const FoundPicture> found,
                                  const ProgressListener &listener = {},
                                  std::optional<Arithmetic> tolerance = Arithmetic::Float32);

/// None where the runs are the same.
std::optional<PartingStep> partingStepOf(const Scene &right, const Scene &defective);

/// The same of a scene's run with defects, beside the right run in the same arithmetic, if there is
/// another defect than that. What is drawn by a program of ours (Defect::redraw) has
/// no run: it is the step of the run without this at which the pictures part. None where defects
/// are of the finished picture alone.
std::optional<PartingStep> partingStepOf(const Scene &scene, std::span<const Defect> defects);

} // namespace pixelplumb
