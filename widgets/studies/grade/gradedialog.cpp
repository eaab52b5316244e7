// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/grade/gradedialog.h"

#include "widgets/dialogs/manual.h"
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
    addWords(layout);
    auto *form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    m_submissions = addPath(form, "gradeSubmissions", tr("&Submissions folder"));
    m_assignment = addPath(form, "gradeAssignment", tr("&Assignment file"));
    m_byScene = explained(
        new QCheckBox(tr("&Grade by the window's scene: one task, 5 points"), this), "gradeByScene",
        tr("Each student has drawn the scene that is open now; there is no "
           "assignment file"));
    form->addRow({}, m_byScene);
    connect(m_byScene, &QCheckBox::toggled, this, &GradeDialog::updateOk);
    m_results = addPath(form, "gradeResults", tr("&Results folder"));
    m_leeway = new LeewayBox("gradeLeeway", this);
    m_leeway->offerNone(tr("as the assignment says"));
    form->addRow(tr("&Leeway"), m_leeway);
    layout->addLayout(form);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Grad&e"));
    layout->addWidget(m_buttons);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    updateOk();
    resize(560, sizeHint().height());
}

/// What is asked for, and where the manual tells more of it.
void GradeDialog::addWords(QBoxLayout *layout)
{
    auto *words = readingLabel("gradeWords", tr("What is graded by what"), this);
    words->setTextFormat(Qt::RichText);
    words->setTextInteractionFlags(Qt::TextBrowserInteraction);
    words->setText(
        tr("<p>The submissions folder holds one picture, or one folder, for each student.</p>"
           "<p>An assignment is a JSON file that names the scenes to be drawn and their points "
           "(<a href=\"assignment-file.md\">how to write one</a>).</p>"));
    layout->addWidget(words);
    connect(words, &QLabel::linkActivated, this, [this](const QString &document) {
        auto *manual = new Manual(manualPages({}), this);
        manual->setAttribute(Qt::WA_DeleteOnClose);
        manual->follow(document);
        manual->open();
    });
}

QLineEdit *GradeDialog::addPath(QFormLayout *form, const char *name, const QString &label)
{
    auto *edit = new QLineEdit(this);
    edit->setObjectName(QLatin1String(name));
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

bool GradeDialog::isByScene() const { return m_byScene->isChecked(); }

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
    if (!m_buttons)
        return; // it is being built
    m_assignment->setEnabled(!isByScene());
    m_buttons->button(QDialogButtonBox::Ok)
        ->setEnabled(!submissions().isEmpty() && !results().isEmpty()
                     && (isByScene() || !assignment().isEmpty()));
}

} // namespace pixelplumb
