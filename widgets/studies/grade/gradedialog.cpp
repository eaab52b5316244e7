// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/gradedialog.h"

#include "widgets/look/parts.h"
#include "widgets/studies/grade/leewaybox.h"

namespace pixelplumb {

using namespace Qt::StringLiterals;

GradeDialog::GradeDialog(QWidget *parent)
    : QDialog(parent)
{
    setObjectName(u"gradeDialog"_s);
    setWindowTitle(tr("Grade a Folder"));
    auto *layout = withParts(new QVBoxLayout(this), {}, 16, 16);
    auto *form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    m_submissions = addPath(form, "gradeSubmissions", tr("&Submissions folder"),
                            tr("A folder with one file or folder for each student"));
    m_assignment = addPath(form, "gradeAssignment", tr("&Assignment file"),
                           tr("A JSON file that names the scenes to be drawn, and the points of "
                              "each (Help ▸ Manual ▸ Assignments)"));
    m_results = addPath(form, "gradeResults", tr("&Results folder"),
                        tr("A new folder, or one of an earlier grading, which goes on there"));
    m_leeway = new LeewayBox("gradeLeeway", this);
    m_leeway->offerNone(tr("as the assignment says"));
    form->addRow(tr("&Leeway"), m_leeway);
    layout->addLayout(form);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("&Grade"));
    layout->addWidget(m_buttons);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    updateOk();
    resize(560, sizeHint().height());
}

QLineEdit *GradeDialog::addPath(QFormLayout *form, const char *name, const QString &label,
                                const QString &inWords)
{
    auto *edit = named(new QLineEdit(this), name, {}, inWords);
    auto *browse = new QPushButton(tr("Choose…"), this);
    browse->setAccessibleName(tr("Choose: %1").arg(QString(label).remove(u'&')));
    browse->setAutoDefault(false);
    auto *row = withParts(new QHBoxLayout, {{edit, 1}, browse}, 8);
    form->addRow(label, row);
    qobject_cast<QLabel *>(form->labelForField(row))->setBuddy(edit);
    connect(edit, &QLineEdit::textChanged, this, &GradeDialog::updateOk);
    connect(browse, &QPushButton::clicked, this, [this, edit] {
        const QString path = edit == m_assignment
            ? QFileDialog::getOpenFileName(this, tr("The Assignment"), edit->text(),
                                           tr("Assignments (*.json);;All files (*)"))
            : QFileDialog::getExistingDirectory(this, tr("A Folder"), edit->text());
        if (!path.isEmpty())
            edit->setText(path);
    });
    return edit;
}

QString GradeDialog::submissions() const { return m_submissions->text(); }

QString GradeDialog::assignment() const { return m_assignment->text(); }

QString GradeDialog::results() const { return m_results->text(); }

std::optional<Leeway> GradeDialog::leeway() const { return m_leeway->leeway(); }

void GradeDialog::setPaths(const QString &submissions, const QString &assignment,
                           const QString &results)
{
    m_submissions->setText(submissions);
    m_assignment->setText(assignment);
    m_results->setText(results);
}

void GradeDialog::updateOk()
{
    const bool isWhole
        = m_buttons && !submissions().isEmpty() && !assignment().isEmpty() && !results().isEmpty();
    if (m_buttons)
        m_buttons->button(QDialogButtonBox::Ok)->setEnabled(isWhole);
}

} // namespace pixelplumb
