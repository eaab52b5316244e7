// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/traceexport.h"

#include <QObject>

class QWidget;

namespace pixelplumb {

class DisplayOptions;
class Playhead;

/// What leaves the window: the picture, the annotated grid, the trace as a table, the raster as
/// text; and the raster that comes back by the clipboard.
class SceneExports : public QObject {
    Q_OBJECT

public:
    SceneExports(Playhead *playhead, const DisplayOptions *options, QWidget *window);

    /// The name that file dialogs begin with, without its ending.
    void setBaseName(const QString &name) { m_baseName = name; }

    /// Each is false after a complaint.
    bool writePicture(const QString &path);
    bool writeAnnotatedGrid(const QString &path);
    bool writeTrace(const QString &path, TraceLevel level, TableFormat format);
    bool writeRaster(const QString &path);

public slots:
    void exportPicture();
    void exportAnnotatedGrid();
    void exportTrace(pixelplumb::TraceLevel level, pixelplumb::TableFormat format);
    void exportRaster();
    /// The finished picture's coverage.
    void copyRaster();
    /// Lays the clipboard's raster over the finished picture.
    void compareWithClipboard();
    /// "pixel (27, 19) #a06f30 …": the picked pixel and what wrote it.
    void copyPickedPixel();

signals:
    void complaint(const QString &text);
    void notice(const QString &text);

private:
    QString askForPath(const QString &title, const QString &filter, const QString &suffix) const;
    bool hasTrace();
    bool tellOutcome(const QString &path, const QString &error);

    Playhead *m_playhead;
    const DisplayOptions *m_options;
    QWidget *m_window;
    QString m_baseName;
};

} // namespace pixelplumb
