// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/sceneexports.h"

#include "core/runs/explain/pixelhistory.h"
#include "core/scene/asciiraster.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/inputrecord.h"
#include "core/scene/files/outputfile.h"
#include "core/scene/text/colourtext.h"
#include "widgets/files/examplefolder.h"
#include "widgets/files/svgexport.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/playhead.h"
#include "widgets/model/steptext.h"

namespace pixelplumb {

namespace {

/// The result of writing a trace.
struct WrittenTrace {
    /// Empty where the file is complete.
    QString error = SceneExports::tr("there is not enough memory.");
};

/// Runs in a worker thread. The error of a cancelled run is dropped.
WrittenTrace writtenTrace(const TracedScene &traced, const TraceExportOptions &options,
                          const QString &path)
{
    OutputFile file(path);
    std::optional<InputError> error = file.open();
    if (!error && !exportTrace(traced, options, file.device()))
        error = file.error();
    if (!error)
        error = file.finish();
    return {error ? error->message() : QString()};
}

} // namespace

SceneExports::SceneExports(const SceneDocument *document, Playhead *playhead,
                           const DisplayOptions *options, QWidget *window)
    : QObject(window)
    , m_document(document)
    , m_playhead(playhead)
    , m_options(options)
    , m_window(window)
    , m_writing(this)
{
}

bool SceneExports::writePicture(const QString &path, ExportMoment moment)
{
    if (!mayWriteTo(path))
        return false;
    const Scene &scene = m_playhead->traced()->scene;
    FrameBuffer finished(scene.frame);
    if (moment == ExportMoment::Finished)
        m_playhead->traced()->draw(finished.view()); // a recording may have ended early
    const FrameBuffer &shown = moment == ExportMoment::Finished ? finished : *m_playhead->frame();
    QImage picture = shown.image();
    const QString frame = frameText(*m_document);
    if (!frame.isEmpty())
        picture.setText(u"Description"_s, frame);
    QBuffer encoded; // libpng would print its own error if it wrote to the file directly
    picture.save(&encoded, "PNG");
    const std::optional<InputError> error = writeFile(path, encoded.data());
    return tellOutcome(path, error ? error->message() : QString(), frame);
}

bool SceneExports::writeAnnotatedGrid(const QString &path, ExportMoment moment)
{
    if (!mayWriteTo(path))
        return false;
    const QString frame = frameText(*m_document);
    if (moment == ExportMoment::AsDrawn)
        return tellOutcome(path, exportSvg(path, *m_playhead, *m_options, frame), frame);
    Playhead atEnd;
    atEnd.setTraced(m_playhead->sharedTraced());
    atEnd.seek(atEnd.end());
    return tellOutcome(path, exportSvg(path, atEnd, *m_options, frame), frame);
}

bool SceneExports::writeTrace(const QString &path, TraceLevel level, TableFormat format,
                              ExportMoment moment)
{
    if (!mayWriteTo(path))
        return false;
    const QString name = shownName(path);
    if (m_writing.isRunning())
        return tellOutcome(path, tr("another trace is still being written."));
    m_writtenPath = path;
    m_writing.setTitle(tr("Writing %1").arg(name));
    TraceExportOptions options{level, format};
    options.frame = movingFrame(*m_document);
    if (moment == ExportMoment::AsDrawn)
        options.rows.position = m_playhead->position();
    m_writing.start(
        [path, options, traced = m_playhead->sharedTraced()](const ProgressListener &listener) {
            TraceExportOptions told = options;
            told.progress = listener;
            return writtenTrace(*traced, told, path);
        },
        [this, path, frame = frameText(*m_document)](const WrittenTrace &written) {
            tellOutcome(path, written.error, frame);
        });
    return true;
}

void SceneExports::cancelWriting()
{
    if (!m_writing.isRunning())
        return;
    m_writing.cancel();
    emit notice(tr("%1 was not written.").arg(shownName(m_writtenPath)));
}

bool SceneExports::writeRaster(const QString &path, ExportMoment moment)
{
    if (!mayWriteTo(path))
        return false;
    const TracedScene &traced = *m_playhead->traced();
    const QString raster = asciiRaster(moment == ExportMoment::Finished
                                           ? coverageOf(traced)
                                           : coverageAt(traced, m_playhead->position()));
    const std::optional<InputError> error = writeFile(path, raster.toLatin1());
    return tellOutcome(path, error ? error->message() : QString(), frameText(*m_document));
}

void SceneExports::exportPicture(ExportMoment moment)
{
    if (const auto target
        = askForTarget(tr("Export the Picture"), tr("PNG picture"), u"png"_s, moment))
        writePicture(target->path, target->moment);
}

void SceneExports::exportAnnotatedGrid()
{
    if (const auto target
        = askForTarget(tr("Export the Annotated Grid"), tr("SVG drawing"), u"svg"_s))
        writeAnnotatedGrid(target->path, target->moment);
}

void SceneExports::exportTrace(TraceLevel level, TableFormat format)
{
    const auto titleOfSpans = [](SpanAxis axis) {
        return axis == SpanAxis::Column ? tr("Export the Columns")
            : axis == SpanAxis::Row     ? tr("Export the Rows")
                                        : tr("Export the Steps");
    };
    const QString title
        = level == TraceLevel::Column ? titleOfSpans(m_playhead->axis()) : tr("Export the Pixels");
    const bool isCsv = format == TableFormat::Csv;
    const auto target
        = askForTarget(title, isCsv ? tr("CSV table") : tr("JSON"), isCsv ? u"csv"_s : u"json"_s);
    if (target)
        writeTrace(target->path, level, format, target->moment);
}

void SceneExports::exportRaster()
{
    if (const auto target = askForTarget(tr("Export the Raster"), tr("Text"), u"txt"_s))
        writeRaster(target->path, target->moment);
}

void SceneExports::copyRaster()
{
    if (!hasTrace())
        return;
    if (m_playhead->isAheadHidden()) {
        emit notice(tr("The finished picture's raster is copied when the run has come to its end "
                       "(F5), or Predict is closed."));
        return;
    }
    const CoverageMask coverage = coverageOf(*m_playhead->traced());
    QApplication::clipboard()->setText(asciiRaster(coverage));
    const QString frame = frameText(*m_document);
    emit notice(tr("The finished picture's raster is on the clipboard: %1 × %2, # is covered.")
                    .arg(coverage.spec().width)
                    .arg(coverage.spec().height)
                + (frame.isEmpty() ? QString() : tr(" It is of %1.").arg(frame)));
}

void SceneExports::copyPickedPixel()
{
    const std::optional<QPoint> pixel = m_playhead->pickedPixel();
    if (!hasTrace() || !pixel)
        return;
    const Colour colour = unpacked(*m_playhead->frame()->view().at(pixel->x(), pixel->y()));
    QStringList cells{u"(%1, %2)"_s.arg(pixel->x()).arg(pixel->y()), colourText(colour)};
    if (const QString frame = frameText(*m_document); !frame.isEmpty())
        cells += frame;
    BriefPixelHistory history = briefPixelHistory(*m_playhead->traced(), pixel->x(), pixel->y());
    if (m_playhead->isAheadHidden())
        leaveOutAhead(history, m_playhead->position());
    for (const PixelAttempt &attempt : history.attempts)
        cells += u"%1 %2: %3"_s.arg(nameOf(attempt.kind), QString::number(attempt.primitive),
                                    attempt.reason);
    if (history.furtherRefusals > 0)
        cells += tr("%n more primitives leave it alone", nullptr, int(history.furtherRefusals));
    QApplication::clipboard()->setText(cells.join(QLatin1Char('\t')));
    emit notice(tr("Pixel (%1, %2) is on the clipboard.").arg(pixel->x()).arg(pixel->y()));
}

/// The file dialog offers the moments as kinds of files: every desktop's own dialog has a choice of
/// these.
std::optional<SceneExports::Target> SceneExports::askForTarget(
    const QString &title, const QString &kind, const QString &suffix,
    std::optional<ExportMoment> chosen) const
{
    QStringList filters;
    if (chosen != ExportMoment::AsDrawn)
        filters += tr("%1, finished (*.%2)").arg(kind, suffix);
    if (chosen != ExportMoment::Finished && m_playhead->position() < m_playhead->end())
        filters += tr("%1, as drawn so far: step %2 of %3 (*.%4)")
                       .arg(kind, QString::number(m_playhead->position()),
                            QString::number(m_playhead->end()), suffix);
    QFileDialog dialog(m_window, title);
    dialog.setNameFilters(filters);
    dialog.setObjectName(u"exportDialog"_s);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    if (!m_scenePath.isEmpty() && !isExample(m_scenePath))
        dialog.setDirectory(QFileInfo(m_scenePath).absolutePath());
    dialog.selectFile(proposedName(suffix));
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    const bool isFirst = dialog.selectedNameFilter() == filters.front();
    return Target{dialog.selectedFiles().constFirst(),
                  chosen.value_or(isFirst ? ExportMoment::Finished : ExportMoment::AsDrawn)};
}

QString SceneExports::proposedName(const QString &suffix) const
{
    const std::optional<int> frame = movingFrame(*m_document);
    const QString ofFrame = frame ? u"-frame-%1"_s.arg(*frame) : QString();
    return m_baseName + ofFrame + QLatin1Char('.') + suffix;
}

bool SceneExports::mayWriteTo(const QString &path)
{
    if (!hasTrace())
        return false;
    if (!isInput(path))
        return true;
    return tellOutcome(path, tr("it was read, and the export would replace it."));
}

bool SceneExports::hasTrace()
{
    if (m_playhead->traced())
        return true;
    emit complaint(tr("Nothing is drawn yet."));
    return false;
}

bool SceneExports::tellOutcome(const QString &path, const QString &error, const QString &frame)
{
    const QString name = shownName(path);
    if (!error.isEmpty())
        emit complaint(tr("%1 was not written: %2").arg(name, error));
    else if (frame.isEmpty())
        emit notice(tr("%1 is written.").arg(name));
    else
        emit notice(tr("%1 is written: %2.").arg(name, frame));
    return error.isEmpty();
}

} // namespace pixelplumb
