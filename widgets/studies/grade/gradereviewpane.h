// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtWidgets>

#include <map>
#include <optional>

namespace pixelplumb {

class Gradebook;
struct GradedPicture;

/// The explanation of one student's pictures, what the student is told, and the assistant's
/// comment and points. These are saved as soon as their field is left, for the table, another
/// submission or another folder; points only with the reason why they are changed.
class GradeReviewPane : public QWidget {
    Q_OBJECT

public:
    explicit GradeReviewPane(Gradebook *book, QWidget *parent = nullptr);
    ~GradeReviewPane() override;

    /// The current submission, by its index in the report; none: nobody's.
    void setSubmission(const std::optional<std::size_t> &place);
    const std::optional<std::size_t> &submission() const { return m_shown; }
    void beginComment();
    /// The picture of the chosen scene; none without a current submission.
    std::optional<GradedPicture> picture() const;

public slots:
    void toggleAccepted();

signals:
    void left(); ///< by Escape
    void sceneChosen();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void saveComment();
    void savePoints();
    bool lacksReason() const; ///< points are typed, and not why
    void commentCluster();
    void showReport();
    void showReview();
    void showCauses();

    Gradebook *m_book;
    std::optional<std::size_t> m_shown;
    std::map<std::size_t, QString> m_withoutReason; ///< points that wait for their reason
    QComboBox *m_scene = nullptr;
    QLabel *m_causes = nullptr;
    QLabel *m_sentences = nullptr;
    QLabel *m_done = nullptr;
    QPlainTextEdit *m_comment = nullptr;
    QLineEdit *m_points = nullptr;
    QLineEdit *m_reason = nullptr;
    QToolButton *m_accept = nullptr;
    QToolButton *m_forCluster = nullptr;
};

} // namespace pixelplumb
