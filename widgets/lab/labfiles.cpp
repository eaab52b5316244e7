// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lab/labfiles.h"

#include "core/lab/study/labfile.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/inputrecord.h"
#include "widgets/lab/labplot.h"
#include "widgets/lab/labtext.h"
#include "widgets/look/typesetting.h"

namespace pixelplumb {

LabFiles::LabFiles(QWidget *window)
    : QObject(window)
    , m_window(window)
{
}

bool LabFiles::writeResults(const QString &path, const Study &study)
{
    return write(path, writeStudy(study));
}

bool LabFiles::writeTable(const QString &path, const Study &study)
{
    return write(path, csvOf(study));
}

bool LabFiles::writeChart(const QString &path, LabPlot &chart, const Study &study)
{
    const QStringList origin = figureOrigin(study);
    const bool isPicture = path.endsWith(u".png"_s, Qt::CaseInsensitive);
    return write(path, isPicture ? chart.png(origin) : chart.svg(origin));
}

std::optional<Study> LabFiles::read(const QString &path)
{
    const Result<QByteArray> text = readRegularFile(path);
    const Result<Study> study = text ? readStudy(*text) : Result<Study>(text.error());
    if (!study) {
        emit complaint(tr("%1 was not opened: %2").arg(shownName(path), study.error().message()));
        return std::nullopt;
    }
    return *study;
}

bool LabFiles::write(const QString &path, const QByteArray &content)
{
    const QString name = shownName(path);
    if (isInput(path)) {
        emit complaint(tr("%1 was not written: it was read, and would be replaced.").arg(name));
        return false;
    }
    if (const std::optional<InputError> error = writeFile(path, content)) {
        emit complaint(tr("%1 was not written: %2").arg(name, error->message()));
        return false;
    }
    emit notice(tr("%1 is written.").arg(name));
    return true;
}

QString LabFiles::askForOutput(const QString &title, const QString &filter,
                               const QString &suffix) const
{
    QFileDialog dialog(m_window, title, {}, filter);
    dialog.setObjectName(u"labSaveDialog"_s);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(u"lab."_s + suffix);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().constFirst() : QString();
}

QString LabFiles::askForInput(const QString &title) const
{
    QFileDialog dialog(m_window, title, {}, tr("Results of the lab (*.json);;All files (*)"));
    dialog.setObjectName(u"labOpenDialog"_s);
    dialog.setFileMode(QFileDialog::ExistingFile);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().constFirst() : QString();
}

} // namespace pixelplumb
