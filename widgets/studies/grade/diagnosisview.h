// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/diagnose/diagnosis.h"
#include "widgets/model/job.h"

#include <QtWidgets>

namespace pixelplumb {

class StudentPicture;

/// A candidate to open in the stepper: the scene with its defects, beside the right one.
struct DefectOpening {
    std::shared_ptr<const Scene> right;
    Scene defective;
    std::size_t position = 0; ///< of its run, just after the first step that departs
    QString title; ///< "defect unsorted-colours"
};

/// Names the bug in the student's picture, in a worker thread: the sets of known defects that draw
/// it, or come nearest, in words for the student or the assistant.
class DiagnosisView : public QWidget {
    Q_OBJECT

public:
    explicit DiagnosisView(const StudentPicture *student, QWidget *parent = nullptr);

    bool isRunning() const { return m_job.isRunning(); }
    QRect answer() const; ///< the rectangle of the visible parts of verdict, sets and sentence

public slots:
    void start();
    void cancel();
    void setLeaving(bool possible); ///< whether there is a candidate in the stepper

signals:
    void answered(); ///< the answer is shown
    void openRequested(const pixelplumb::DefectOpening &opening);
    void compareRequested(const pixelplumb::DefectOpening &opening);
    void leaveRequested();

private:
    enum class Audience { Student, Assistant };
    struct Named {
        Diagnosis diagnosis;
        /// By candidate; none where the runs are equal or the defects belong to the picture.
        std::vector<std::optional<PartingStep>> steps;
    };

    static std::optional<Named> diagnosed(const Submission &submission, const Margin &margin,
                                          const ProgressListener &listener);
    void addControls(QBoxLayout *layout);
    void addResults(QBoxLayout *layout);
    void take(const std::optional<Named> &found);
    void forget();
    void followStudent();
    void showCandidates();
    void showChosen();
    void updateButtons();
    Audience audience() const;
    QString titleOf(const DiagnosisCandidate &candidate) const;
    DefectOpening opening() const; ///< of the chosen candidate

    const StudentPicture *m_student;
    std::shared_ptr<const Scene> m_scene; ///< being diagnosed, or diagnosed last
    std::shared_ptr<const Scene> m_judged; ///< that scene, as it is right by the margin
    Margin m_margin; ///< by which it is judged
    std::optional<Named> m_named;
    QPushButton *m_start = nullptr;
    QComboBox *m_audience = nullptr;
    QLabel *m_verdict = nullptr;
    QListWidget *m_candidates = nullptr;
    QLabel *m_sentence = nullptr;
    QPushButton *m_open = nullptr;
    QPushButton *m_compare = nullptr;
    QPushButton *m_leave = nullptr;
    Job m_job;
};

/// "Wrong: 12 pixels differ. These defects draw the very picture:"
QString diagnosisText(const Diagnosis &diagnosis);
/// "unsorted-colours and y-truncated"
QString idsText(const DiagnosisCandidate &candidate);
/// One sentence per defect; `words`: for the student or the assistant.
QString sentencesText(const DiagnosisCandidate &candidate, QString Defect::*words);
/// " · 3 pixels are left"; empty where none are.
QString distanceText(const DiagnosisCandidate &candidate);

} // namespace pixelplumb
