// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/export/traceexport.h"
#include "widgets/model/job.h"

#include <QtWidgets>

#include <optional>

namespace pixelplumb {

class DisplayOptions;
class Playhead;
class SceneDocument;

/// The moment of the run that is exported.
enum class ExportMoment {
    Finished,
    AsDrawn, ///< the state at the playhead's position
};

/// Exports from the window: the picture, the annotated grid, the trace as a table, the raster as
/// text; and the raster on the clipboard. All are of the finished run, unless asked for as drawn so
/// far. In a scene that moves they are of the current frame, which is named in the proposed file
/// name, in the notice about the file, and in every export but the raster.
class SceneExports : public QObject {
    Q_OBJECT

public:
    SceneExports(const SceneDocument *document, Playhead *playhead, const DisplayOptions *options,
                 QWidget *window);

    /// The name that file dialogs propose, without its ending and the frame of the motion.
    void setBaseName(const QString &name) { m_baseName = name; }
    /// The scene's file, empty where it has none: file dialogs begin in its folder.
    void setScenePath(const QString &path) { m_scenePath = path; }

    /// These return false after a complaint.
    bool writePicture(const QString &path, ExportMoment moment = ExportMoment::Finished);
    bool writeAnnotatedGrid(const QString &path, ExportMoment moment = ExportMoment::Finished);
    bool writeRaster(const QString &path, ExportMoment moment = ExportMoment::Finished);
    /// Begins to write the current run in a worker thread, unaffected by later changes; one trace
    /// at a time. The path only ever holds a complete file.
    bool writeTrace(const QString &path, TraceLevel level, TableFormat format,
                    ExportMoment moment = ExportMoment::Finished);

    const Job &writing() const { return m_writing; }
    void cancelWriting();

public slots:
    void exportPicture(pixelplumb::ExportMoment moment);
    void exportAnnotatedGrid();
    void exportTrace(pixelplumb::TraceLevel level, pixelplumb::TableFormat format);
    void exportRaster();
    /// The finished picture's coverage.
    void copyRaster();
    /// "pixel (27, 19) #a06f30 …": the picked pixel and what wrote it.
    void copyPickedPixel();

signals:
    void complaint(const QString &text);
    void notice(const QString &text);

private:
    /// The file and the moment a person chose; none where they cancelled.
    struct Target {
        QString path;
        ExportMoment moment = ExportMoment::Finished;
    };
    /// Asks for the moment, too, unless it was chosen already.
    std::optional<Target> askForTarget(const QString &title, const QString &kind,
                                       const QString &suffix,
                                       std::optional<ExportMoment> chosen = {}) const;
    /// False after a complaint: nothing is drawn, or the path is that of an input.
    bool mayWriteTo(const QString &path);
    bool hasTrace();
    /// "cube.png", "cube-frame-8.png".
    QString proposedName(const QString &suffix) const;
    /// `frame`: of the motion; empty where the scene stands still.
    bool tellOutcome(const QString &path, const QString &error, const QString &frame = {});

    const SceneDocument *m_document;
    Playhead *m_playhead;
    const DisplayOptions *m_options;
    QWidget *m_window;
    QString m_baseName;
    QString m_scenePath;
    Job m_writing; ///< writes a trace
    QString m_writtenPath;
};

} // namespace pixelplumb
