// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/assignment.h"
#include "core/grade/diagnosis.h"
#include "core/grade/picturediff.h"

#include <QStringList>

namespace pixelplumb {

/// What became of a submission as a whole.
enum class GradeVerdict {
    Right,
    Undecidable, ///< what differs may be either way
    Wrong,
    Nothing, ///< there is no picture that could be judged
};
inline constexpr std::array allGradeVerdicts
    = {GradeVerdict::Right, GradeVerdict::Undecidable, GradeVerdict::Wrong, GradeVerdict::Nothing};
QString nameOf(GradeVerdict verdict); ///< "right", "undecidable", "wrong", "nothing"

/// Why there is no picture of a scene to judge.
enum class PictureLack {
    NotThere, ///< neither a file nor a program
    NotDrawn, ///< the program could not be run, or did not end well: GradedRun::end
    Empty,
    OtherSize,
    TraceAlone, ///< lines of a trace, none of them a pixel's
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
    double points = 0; ///< all, none or, where the assignment says so, the share that is right
    double of = 0;

    friend bool operator==(const GradedCheck &, const GradedCheck &) = default;
};

/// How a program ended that was run on a scene.
struct GradedRun {
    QString end; ///< "finished", "crashed", "timed out" …
    QString told; ///< a sentence: what happened
    QString messages; ///< the beginning of its stderr, without control characters
    std::optional<QString> sandboxLack = {}; ///< why it ran in no sandbox; none: in one

    friend bool operator==(const GradedRun &, const GradedRun &) = default;
};

/// In frame coordinates, as everywhere beside a scene.
struct FramePixel {
    int x = 0;
    int y = 0;

    friend bool operator==(const FramePixel &, const FramePixel &) = default;
};

/// What became of one scene.
struct GradedScene {
    QString scene; ///< its name in the assignment
    QString file; ///< the picture's in the submission, escaped; empty: none, or a program drew it
    QString fault; ///< why there is no picture to judge: "no file shallow.png"; empty: there is one
    std::optional<PictureLack> lack
        = {}; ///< the same as a kind; none: there is one, or nobody said
    QString picture; ///< a copy of what was judged, as seen from the results' folder; or empty
    QString pictureDigest = {}; ///< of the copy's bytes, SHA-256 in hexadecimal digits; or empty
    std::array<std::int64_t, allPixelVerdicts.size()> counts = {}; ///< pixels, by PixelVerdict
    int largestError = 0; ///< of a byte, where the colour is wrong
    QStringList causes; ///< what, done to the whole picture, leaves at most half of the differences
    std::optional<FramePixel> firstDifference; ///< as one reads, from the top line on
    std::optional<GradedRun> run;
    QString trace; ///< the first quantity in which the program's trace differs; empty: none
    std::optional<QString> note; ///< what else is to be known: which of two pictures was taken
    std::vector<GradedCheck> checks; ///< those that are asked
    /// Of a submission that no set explains whole: the sets that explain this picture alone,
    /// "flat-first and upside-down".
    std::optional<QStringList> explanations = {};

    friend bool operator==(const GradedScene &, const GradedScene &) = default;
};

/// The first step at which the run with the defects parts from the right one.
struct GradedParting {
    QString scene;
    std::int64_t step = 0; ///< of the trace with the defects, from 0
    QString heading; ///< "Column 12, first half"
    QString text; ///< "y_T is 41 1/2, should be 41 4/7"

    friend bool operator==(const GradedParting &, const GradedParting &) = default;
};

/// Defects that together explain the pictures, or come nearest.
struct GradedCandidate {
    QStringList defects; ///< their ids, as DiagnosisCandidate has them
    QStringList forStudent; ///< sentences, on what is a mistake
    QStringList forAssistant;
    std::int64_t distance = 0; ///< pixels that are not explained, of all pictures
    std::optional<std::int64_t> undecidable = {}; ///< pixels that may be either way; none: 0
    std::optional<QString> arithmetic = {}; ///< not the scene's, in which pictures are equal
    std::optional<GradedParting> parts = {};
    std::optional<QStringList> rightAlone = {}; ///< of the ids those that alone are no mistake

    QStringList mistakes() const; ///< the other ids; where there are none, these
    friend bool operator==(const GradedCandidate &, const GradedCandidate &) = default;
};

/// What the assistant said; kept apart, so that grading anew loses none of it.
struct GradeReview {
    QString comment; ///< goes to the student
    bool isAccepted = false;

    bool isEmpty() const { return comment.isEmpty() && !isAccepted; }
    friend bool operator==(const GradeReview &, const GradeReview &) = default;
};

/// What became of a submission.
struct GradedSubmission {
    QString name; ///< as the folder has it; what is no plain character is escaped: "a\x0ab"
    QString id; ///< unlike all others, and fit for a file's name
    QString digest; ///< of its bytes, the assignment and the version of the program
    GradeVerdict verdict = GradeVerdict::Nothing;
    std::int64_t differing = 0; ///< pixels of all pictures that were judged; undecidable ones, too
    std::vector<GradedScene> scenes; ///< those of the assignment, in its order
    std::vector<GradedCandidate> candidates; ///< as Diagnosis has them
    std::optional<QString> pictures
        = {}; ///< one word for each set of pictures; none: all are right
    std::optional<QString> searchError
        = {}; ///< in which the search for defects ended; none: in none
    /// In which its grading ended, "it does not fit into memory"; none: in none.
    std::optional<QString> gradingError = {};
    GradeReview review = {}; ///< not in the submission's own file

    double points() const;
    /// Whether nothing is wrong that was handed in, but colours were asked for and are not there: a
    /// raster of characters has none.
    bool lacksColours() const;
    /// Whether the candidates explain the submission's pictures.
    bool isExplained() const { return !candidates.empty() && candidates.front().distance == 0; }

    friend bool operator==(const GradedSubmission &, const GradedSubmission &) = default;
};

/// A graded folder.
struct GradeReport {
    Assignment assignment;
    std::vector<GradedSubmission> submissions; ///< by name
    QStringList missing = {}; ///< names of submissions that are known and have no grade here

    friend bool operator==(const GradeReport &, const GradeReport &) = default;
};

/// Why programs ran in no sandbox, each reason once; empty where all did that were run.
QStringList sandboxLacks(const GradeReport &report);
/// What those programs could do, and how many submissions' they were; empty: none.
QString unsandboxedText(const GradeReport &report);
/// The same of one submission, of which it is told who.
QString unsandboxedText(const GradedSubmission &submission);
/// Whether its programs ran in the sandbox; none: none was run.
std::optional<bool> isSandboxed(const GradedSubmission &submission);

/// "1 submission", "3 submissions".
QString submissionsText(std::size_t submissions);
/// "cannot be graded: it does not fit into memory".
QString ungradedText(const QString &error);
/// Those that could not be graded, for a message: "ada, bob: cannot be graded: …", a line for each
/// error.
QStringList ungradedLines(const GradeReport &report);
/// The verdict as it is shown: its name; where colours are lacking, "right in coverage"; "cannot be
/// graded".
QString verdictText(const GradedSubmission &submission);
/// Of a submission that lacks colours, what its verdict holds of.
QString rasterText(const GradedSubmission &submission);

/// Submissions that have one cause: the same set of defects explains them. Of those that none
/// explains, the ones that have the same pictures, or else to which the same set comes nearest. Of
/// those that have no picture, the ones that lack it for the same reason.
struct GradeCluster {
    QString title; ///< "unsorted-colours", "right", "no known defect, near to flat-first"
    QStringList forStudent; ///< of its first set
    QStringList forAssistant;
    std::vector<std::size_t> submissions; ///< places in the report, ascending
};

/// The largest first; those that are right come last.
std::vector<GradeCluster> clustersOf(const GradeReport &report);

/// What the student is told, a line each, at the assignment's hint level; ends with the comment.
QStringList sentencesFor(const GradedSubmission &submission, HintLevel level);

} // namespace pixelplumb
