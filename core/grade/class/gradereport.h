// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/class/assignment.h"
#include "core/grade/diagnose/diagnosis.h"
#include "core/grade/diagnose/frameconvention.h"
#include "core/grade/pictures/picturediff.h"

#include <QStringList>

namespace pixelplumb {

/// The result for a whole submission.
enum class GradeVerdict {
    Right,
    Undecidable, ///< all differences are left open
    Wrong,
    Nothing, ///< no picture could be judged
};
inline constexpr std::array allGradeVerdicts
    = {GradeVerdict::Right, GradeVerdict::Undecidable, GradeVerdict::Wrong, GradeVerdict::Nothing};
QString nameOf(GradeVerdict verdict); ///< "right", "undecidable", "wrong", "nothing"

/// Why a scene has no picture to judge.
enum class PictureLack {
    NotThere, ///< neither a file nor a program
    NotDrawn, ///< the program could not be run, or did not end well: see GradedRun::end
    Empty,
    OtherSize,
    TraceAlone, ///< lines of a trace, but none of pixels
    Unreadable,
};
inline constexpr std::array allPictureLacks
    = {PictureLack::NotThere,  PictureLack::NotDrawn,   PictureLack::Empty,
       PictureLack::OtherSize, PictureLack::TraceAlone, PictureLack::Unreadable};
QString nameOf(PictureLack lack); ///< "not there", "not drawn", "empty", "of another size" …

/// One check of one scene.
struct GradedCheck {
    Check check = Check::Picture;
    bool isPassed = false;
    double points = 0; ///< all, none or, if the assignment says so, the share that is right
    double of = 0;

    friend bool operator==(const GradedCheck &, const GradedCheck &) = default;
};

/// How a program's run on a scene ended.
struct GradedRun {
    QString end; ///< "finished", "crashed", "timed out" …
    QString told; ///< a sentence on what happened
    QString messages; ///< the beginning of its stderr, without control characters
    std::optional<QString> sandboxLack = {}; ///< why it ran without a sandbox; none: it ran in one

    friend bool operator==(const GradedRun &, const GradedRun &) = default;
};

/// In frame coordinates, as everywhere outside a scene.
struct FramePixel {
    int x = 0;
    int y = 0;

    friend bool operator==(const FramePixel &, const FramePixel &) = default;
};

/// The result for one scene.
struct GradedScene {
    QString scene; ///< its name in the assignment
    QString file; ///< the picture file in the submission, escaped; empty: none, or a program's
    QString fault; ///< why there is no picture to judge: "no file shallow.png"; empty: there is one
    std::optional<PictureLack> lack
        = {}; ///< the kind of fault; none: there is a picture, or no kind was recorded
    QString picture; ///< a copy of what was judged, relative to the results' folder; or empty
    QString pictureDigest = {}; ///< of the copy's bytes, SHA-256 in hexadecimal digits; or empty
    DifferenceCounts counts;
    int largestError = 0; ///< of a byte, in pixels with the verdict Colour
    QStringList causes; ///< changes of the whole picture that leave at most half of the differences
    std::optional<FramePixel> firstDifference; ///< in reading order, from the top line on
    std::optional<GradedRun> run;
    QString trace; ///< the first quantity in which the program's trace differs; empty: none
    std::optional<QString> note; ///< a further remark: which of two pictures was taken
    std::vector<GradedCheck> checks; ///< those that are made
    /// The names of the invariants that its program breaks; none: they are not asked for, or it
    /// broke none of them and did not draw all triangles.
    std::optional<QStringList> brokenInvariants = {};
    /// For a submission that no set explains as a whole: the sets that explain this picture alone,
    /// "flat-first and upside-down".
    std::optional<QStringList> explanations = {};
    std::optional<QStringList> places
        = {}; ///< of wrong pixels (wrongPlaces); none: nothing is wrong

    friend bool operator==(const GradedScene &, const GradedScene &) = default;
};

/// The first step at which the run with the defects differs from the right one.
struct FirstDivergence {
    QString scene;
    std::int64_t step = 0; ///< in the trace with the defects, from 0
    QString heading; ///< "Column 12, first half"
    QString text; ///< "y_T is 41 1/2, should be 41 4/7"

    friend bool operator==(const FirstDivergence &, const FirstDivergence &) = default;
};

/// Defects that together explain the pictures, or come nearest to them.
struct GradedCandidate {
    QStringList defects; ///< their ids, as in DiagnosisCandidate
    QStringList forStudent; ///< sentences about mistakes
    QStringList forAssistant;
    std::int64_t distance = 0; ///< unexplained pixels in all pictures
    std::optional<std::int64_t> undecidable = {}; ///< pixels that may be either way; none: 0
    std::optional<QString> arithmetic = {}; ///< not the scene's, but pictures are equal in it
    std::optional<FirstDivergence> parts = {};
    std::optional<QStringList> rightAlone = {}; ///< the ids of those that alone are no mistake

    QStringList mistakes() const; ///< the other ids; all ids where there are none
    friend bool operator==(const GradedCandidate &, const GradedCandidate &) = default;
};

/// The assistant's review; stored separately, so that grading again keeps it.
struct GradeReview {
    QString comment; ///< shown to the student
    bool isAccepted = false;
    std::optional<double> points = {}; ///< in place of those of the checks; none: those
    std::optional<QString> reason = {}; ///< for these points, shown to the student

    bool isEmpty() const { return comment.isEmpty() && !isAccepted && !points; }
    friend bool operator==(const GradeReview &, const GradeReview &) = default;
};

/// The result for a submission.
struct GradedSubmission {
    QString name; ///< as in the folder; characters that are not plain are escaped: "a\x0ab"
    QString id; ///< unique, and fit for a file name
    QString digest; ///< of its bytes, the assignment and the version of the program
    GradeVerdict verdict = GradeVerdict::Nothing;
    /// By which it was judged; none: the assignment's own.
    std::optional<FrameConvention> convention = {};
    std::int64_t differing = 0; ///< pixels in all judged pictures, including undecidable ones
    std::vector<GradedScene> scenes; ///< those of the assignment, in its order
    std::vector<GradedCandidate> candidates; ///< as in Diagnosis
    std::optional<QString> pictures
        = {}; ///< one word for each set of pictures; none: all are right
    std::optional<QString> searchError = {}; ///< that ended the search for defects; none: no error
    /// That ended its grading, "it does not fit into memory"; none: no error.
    std::optional<QString> gradingError = {};
    GradeReview review = {}; ///< not in the submission's own file

    double points() const; ///< as reviewed
    double pointsOfChecks() const;
    /// Whether nothing handed in is wrong, but required colours are missing: a raster of characters
    /// has none.
    bool lacksColours() const;
    /// For which invariants points are lost: "breaks order", each once.
    QString lostInvariants() const;
    /// Whether the candidates explain the submission's pictures.
    bool isExplained() const { return !candidates.empty() && candidates.front().distance == 0; }

    friend bool operator==(const GradedSubmission &, const GradedSubmission &) = default;
};

/// A graded folder.
struct GradeReport {
    Assignment assignment;
    std::vector<GradedSubmission> submissions; ///< by name
    QStringList missing = {}; ///< names of known submissions without a grade here

    friend bool operator==(const GradeReport &, const GradeReport &) = default;
};

/// Why programs ran without a sandbox, each reason once; empty where all programs ran in one.
QStringList sandboxLacks(const GradeReport &report);
/// What those programs could do, and in how many submissions; empty: none.
QString unsandboxedText(const GradeReport &report);
/// Like unsandboxedText() above, for one submission.
QString unsandboxedText(const GradedSubmission &submission);
/// Whether its programs ran in the sandbox; none: no program was run.
std::optional<bool> isSandboxed(const GradedSubmission &submission);

/// "1 submission", "3 submissions".
QString submissionsText(std::size_t submissions);
/// "cannot be graded: it does not fit into memory".
QString ungradedText(const QString &error);
/// The submissions that could not be graded, for a message: "ada, bob: cannot be graded: …", one
/// line for each error.
QStringList ungradedLines(const GradeReport &report);
/// The verdict as shown: its name; "right in coverage" where colours are missing; "pictures right,
/// breaks order" where points are lost for an invariant; or "cannot be graded".
QString verdictText(const GradedSubmission &submission);
/// For a submission without colours: what its verdict applies to.
QString rasterText(const GradedSubmission &submission);

/// Submissions with one cause: the same set of defects explains them. Unexplained ones are grouped
/// by equal pictures, or else by the nearest set. Those without a picture are grouped by the reason
/// why it is missing.
struct GradeCluster {
    QString title; ///< "unsorted-colours", "right", "no known defect, close to flat-first"
    QStringList forStudent; ///< of its first set
    QStringList forAssistant;
    std::vector<std::size_t> submissions; ///< indices in the report, ascending
};

/// Largest first; right submissions come last.
std::vector<GradeCluster> clustersOf(const GradeReport &report);

/// What the student is told at the assignment's hint level, one sentence per line, then the
/// comment.
QStringList sentencesFor(const GradedSubmission &submission, HintLevel level);

} // namespace pixelplumb
