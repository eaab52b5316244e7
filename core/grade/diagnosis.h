// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defectpictures.h"
#include "core/number/jobprogress.h"

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
    std::vector<Defect> defects; ///< one or two
    std::int64_t distance = 0; ///< pixels that differ, of all pictures
};

/// Where the run of the defective scene first parts from the right one.
struct PartingStep {
    std::size_t step = 0; ///< of the defective run's trace
    QString heading; ///< "Column 12, first half"
    QString text; ///< "y_T is 41 1/2, should be 41 4/7"
};

struct Diagnosis {
    DiagnosisVerdict verdict = DiagnosisVerdict::Wrong;
    std::int64_t differing = 0; ///< pixels of all pictures, undecidable ones among them
    /// Every set of one or two defects whose pictures equal the student's, none that has a smaller
    /// one in it; where there is none the nearest ones, at most five.
    std::vector<DiagnosisCandidate> candidates;

    bool isExplained() const { return !candidates.empty() && candidates.front().distance == 0; }
};

/// Judges all pictures together: one cause for all. Undecidable: what differs is what a right
/// program in float32 may have, too (undecidablePixels). None where the listener, who hears how
/// many sets of defects are tried, ended it.
std::optional<Diagnosis> diagnose(std::span<const Submission> submissions,
                                  const ProgressListener &listener = {});

/// A picture of one of several scenes.
struct FoundPicture {
    std::size_t scene = 0; ///< its place among them
    Picture picture;
};

/// The same for those who judge many programs' pictures of the same scenes.
std::optional<Diagnosis> diagnose(DefectPictures &pictures, std::span<const FoundPicture> found,
                                  const ProgressListener &listener = {});

/// What a program with these defects draws.
Picture pictureWith(const Scene &scene, std::span<const Defect> defects);

/// The scene with the defects of a candidate that are a scene's.
Scene withDefects(Scene scene, std::span<const Defect> defects);

/// None where the runs are the same.
std::optional<PartingStep> partingStepOf(const Scene &right, const Scene &defective);

/// The same of a scene's run with defects. What is drawn by a program of ours (Defect::redraw) has
/// no run: it is the step of the run without this at which the pictures part. None where defects
/// are of the finished picture alone.
std::optional<PartingStep> partingStepOf(const Scene &scene, std::span<const Defect> defects);

} // namespace pixelplumb
