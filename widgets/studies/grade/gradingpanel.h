// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/studies/grade/openings.h"

#include <QtWidgets>

#include <optional>

namespace pixelplumb {

class ElidedLabel;
class Gradebook;
class GradeFilter;
class GradeReviewPane;
class GradeTable;
class SceneDocument;

/// The assistant's bench: the submissions of a graded folder as a table, by cause, with what each
/// student is told; reviewed by keys. A selected submission opens beside what was expected: the
/// selected row, its texts and the displayed picture always belong to the same student.
class GradingPanel : public QWidget {
    Q_OBJECT

public:
    explicit GradingPanel(SceneDocument *document, QWidget *parent = nullptr);
    ~GradingPanel() override;

    Gradebook *book() const { return m_book; }
    QSize sizeHint() const override; ///< low while there is nobody to show

public slots:
    void openResults(); ///< asks for the folder
    void gradeFolder(); ///< asks what
    void gradeBy(const QString &assignment); ///< asks which folder
    /// Grades as the dialog was last told to, but by the scene of a file.
    void gradeByScene(const QString &sceneFile);
    void putDown(); ///< deselects: no picture is displayed

signals:
    void openRequested(const pixelplumb::GradedPicture &picture);
    void closeRequested(); ///< no submission is current
    void sceneMet(const QString &path); ///< was given as an assignment
    void neededHeightChanged();

private:
    void addFiles(QBoxLayout *layout);
    void addTable(QBoxLayout *layout);
    void followJob();
    void showReport();
    void showSummary();
    void takeChosen();
    void openChosen();
    void openCurrent();
    template <class Change>
    void narrow(const Change &change);
    std::optional<std::size_t> chosen() const; ///< the submission's index in the report

    SceneDocument *m_document;
    Gradebook *m_book;
    QAbstractItemModel *m_model;
    GradeFilter *m_filter;
    GradeReviewPane *m_review = nullptr;
    QToolButton *m_report = nullptr;
    QLineEdit *m_words = nullptr;
    QComboBox *m_cluster = nullptr;
    GradeTable *m_table = nullptr;
    ElidedLabel *m_confinement = nullptr;
    ElidedLabel *m_summary = nullptr;
    QTimer m_taking; ///< runs while the selected row is not the current submission yet
    /// As the dialog had them last.
    struct {
        QString submissions, assignment, results;
        std::optional<Leeway> leeway;
    } m_paths;
};

} // namespace pixelplumb
