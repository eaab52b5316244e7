// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/unsavedchanges.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace pixelplumb {

namespace {

struct ChangesQuestion {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::UnsavedChanges)
};

UnsavedChanges ask(const QString &name, QMessageBox::StandardButtons answers, QWidget *window)
{
    QMessageBox box(QMessageBox::Question, ChangesQuestion::tr("Unsaved Changes"),
                    ChangesQuestion::tr("“%1” has changes that are not saved.").arg(name), answers,
                    window);
    box.setObjectName(QStringLiteral("unsavedChanges"));
    box.setTextFormat(Qt::PlainText); // a name may look like HTML
    box.setInformativeText(ChangesQuestion::tr("Without saving they are lost."));
    box.setDefaultButton(answers & QMessageBox::Save ? QMessageBox::Save : QMessageBox::Cancel);
    switch (box.exec()) {
    case QMessageBox::Save:
        return UnsavedChanges::Save;
    case QMessageBox::Discard:
        return UnsavedChanges::Discard;
    default:
        return UnsavedChanges::Cancel;
    }
}

} // namespace

UnsavedChanges askAboutChanges(const QString &name, QWidget *window)
{
    return ask(name, QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window);
}

UnsavedChanges askAboutRevert(const QString &name, QWidget *window)
{
    return ask(name, QMessageBox::Discard | QMessageBox::Cancel, window);
}

} // namespace pixelplumb
