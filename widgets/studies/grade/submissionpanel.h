// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

namespace pixelplumb {

class CompareLink;
class DiagnosisView;
class ElidedLabel;
class LeewayBox;
class Playhead;
class StudentPicture;
class SubmissionView;

/// The verdict on a student's picture: how it differs from what the scene's method draws, by cause,
/// with the two pictures side by side.
class SubmissionPanel : public QWidget {
    Q_OBJECT

public:
    SubmissionPanel(StudentPicture *student, Playhead *playhead, QWidget *parent = nullptr);

    DiagnosisView *diagnosis() const { return m_diagnosis; }

    QSize sizeHint() const override { return {300, 560}; }

public slots:
    /// Centres a pixel in both pictures.
    void lookAt(const QPoint &pixel);

signals:
    void openRequested(); ///< another picture

private:
    void addHead(QBoxLayout *layout);
    void addTexts(QBoxLayout *layout);
    void addPictures(QBoxLayout *layout);
    void showJudgement();
    void showPixel();
    void fitPictures();
    void pickNext();

    StudentPicture *m_student;
    Playhead *m_playhead;
    CompareLink *m_link;
    ElidedLabel *m_name = nullptr;
    QToolButton *m_remove = nullptr;
    LeewayBox *m_leeway = nullptr;
    QToolButton *m_next = nullptr;
    QLabel *m_verdict = nullptr;
    QLabel *m_counts = nullptr;
    QLabel *m_causes = nullptr;
    QLabel *m_pixel = nullptr;
    SubmissionView *m_found = nullptr;
    SubmissionView *m_expected = nullptr;
    QWidget *m_content = nullptr;
    QWidget *m_pictures = nullptr;
    QBoxLayout *m_pair = nullptr; ///< the two pictures
    DiagnosisView *m_diagnosis = nullptr;
};

} // namespace pixelplumb
