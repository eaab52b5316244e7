// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/rounding/margin.h"

#include <QtWidgets>

#include <optional>

namespace pixelplumb {

class LeewayBox;

/// What is to be graded: a folder of submissions, an assignment, and where the results go.
class GradeDialog : public QDialog {
    Q_OBJECT

public:
    explicit GradeDialog(QWidget *parent = nullptr);

    QString submissions() const;
    QString assignment() const;
    /// Whether the window's scene takes the place of an assignment.
    bool isByScene() const;
    QString results() const;
    /// In place of the assignment's; none: the assignment's.
    std::optional<Leeway> leeway() const;
    /// Fills in the paths as if typed.
    void setPaths(const QString &submissions, const QString &assignment, const QString &results);

private:
    QLineEdit *addPath(QFormLayout *form, const char *name, const QString &label);
    void addWords(QBoxLayout *layout);
    void updateOk();

    QLineEdit *m_submissions = nullptr;
    QLineEdit *m_assignment = nullptr;
    QLineEdit *m_results = nullptr;
    QCheckBox *m_byScene = nullptr;
    LeewayBox *m_leeway = nullptr;
    QDialogButtonBox *m_buttons = nullptr;
};

} // namespace pixelplumb
