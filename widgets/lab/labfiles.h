// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/study.h"

#include <QtWidgets>

#include <optional>

namespace pixelplumb {

class LabPlot;

/// Results and charts of the lab as files. Never overwrites a file that was read.
class LabFiles : public QObject {
    Q_OBJECT

public:
    explicit LabFiles(QWidget *window);

    /// These return false or none after a complaint.
    bool writeResults(const QString &path, const Study &study);
    bool writeTable(const QString &path, const Study &study);
    /// Writes a figure, SVG or PNG by the path's ending, with the machine, the command and all
    /// warnings.
    bool writeChart(const QString &path, LabPlot &chart, const Study &study);
    std::optional<Study> read(const QString &path);

    /// Ask for a path; empty where the person cancels.
    QString askForOutput(const QString &title, const QString &filter, const QString &suffix) const;
    QString askForInput(const QString &title) const;

signals:
    void complaint(const QString &text);
    void notice(const QString &text);

private:
    bool write(const QString &path, const QByteArray &content);

    QWidget *m_window;
};

} // namespace pixelplumb
