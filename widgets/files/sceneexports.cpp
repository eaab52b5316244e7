// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/sceneexports.h"

#include "core/runs/pixelhistory.h"
#include "core/scene/asciiraster.h"
#include "core/scene/colourtext.h"
#include "core/scene/fileaccess.h"
#include "widgets/dialogs/rasterdialog.h"
#include "widgets/files/svgexport.h"
#include "widgets/model/playhead.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QSaveFile>

namespace pixelplumb {

namespace {

constexpr std::size_t mostCopiedRefusals = 20; ///< primitives that leave a pixel alone

/// What came of writing a trace.
struct WrittenTrace {
    /// Empty where the file stands whole.
    QString error = SceneExports::tr("there is not enough memory.");
};

/// Runs beside the GUI thread. Where it is cancelled nobody asks for the error.
WrittenTrace writtenTrace(const TracedScene &traced, const TraceExportOptions &options,
                          const QString &path)
{
    QSaveFile file(path);
    const bool isWritten
        = file.open(QIODevice::WriteOnly) && exportTrace(traced, options, file) && file.commit();
    return {isWritten ? QString() : file.errorString()};
}

} // namespace

SceneExports::SceneExports(Playhead *playhead, const DisplayOptions *options, QWidget *window)
    : QObject(window)
    , m_playhead(playhead)
    , m_options(options)
    , m_window(window)
    , m_writing(this)
{
}

bool SceneExports::writePicture(const QString &path)
{
    if (!mayWriteTo(path))
        return false;
    QSaveFile file(path);
    const bool written = file.open(QIODevice::WriteOnly)
        && m_playhead->frame()->image().save(&file, "PNG") && file.commit();
    return tellOutcome(path, written ? QString() : file.errorString());
}

bool SceneExports::writeAnnotatedGrid(const QString &path)
{
    return mayWriteTo(path) && tellOutcome(path, exportSvg(path, *m_playhead, *m_options));
}

bool SceneExports::writeTrace(const QString &path, TraceLevel level, TableFormat format)
{
    if (!mayWriteTo(path))
        return false;
    const QString name = QFileInfo(path).fileName();
    if (m_writing.isRunning())
        return tellOutcome(path, tr("another trace is still being written."));
    m_writtenPath = path;
    m_writing.setTitle(tr("Writing %1").arg(name));
    m_writing.start(
        [path, level, format,
         traced = m_playhead->sharedTraced()](const ProgressListener &listener) {
            return writtenTrace(*traced, {level, format, listener}, path);
        },
        [this, path](const WrittenTrace &written) { tellOutcome(path, written.error); });
    return true;
}

void SceneExports::cancelWriting()
{
    if (!m_writing.isRunning())
        return;
    m_writing.cancel();
    emit notice(tr("%1 was not written.").arg(QFileInfo(m_writtenPath).fileName()));
}

bool SceneExports::writeRaster(const QString &path)
{
    if (!mayWriteTo(path))
        return false;
    const QString raster = asciiRaster(coverageOf(m_playhead->traced()->scene));
    const std::optional<InputError> error = writeFile(path, raster.toLatin1());
    return tellOutcome(path, error ? error->message() : QString());
}

void SceneExports::exportPicture()
{
    const QString path
        = askForPath(tr("Export the Picture"), tr("PNG pictures (*.png)"), QStringLiteral("png"));
    if (!path.isEmpty())
        writePicture(path);
}

void SceneExports::exportAnnotatedGrid()
{
    const QString path = askForPath(tr("Export the Annotated Grid"), tr("SVG drawings (*.svg)"),
                                    QStringLiteral("svg"));
    if (!path.isEmpty())
        writeAnnotatedGrid(path);
}

void SceneExports::exportTrace(TraceLevel level, TableFormat format)
{
    const QString title
        = level == TraceLevel::Column ? tr("Export the Columns") : tr("Export the Pixels");
    const bool isCsv = format == TableFormat::Csv;
    const QString path = askForPath(title, isCsv ? tr("CSV tables (*.csv)") : tr("JSON (*.json)"),
                                    isCsv ? QStringLiteral("csv") : QStringLiteral("json"));
    if (!path.isEmpty())
        writeTrace(path, level, format);
}

void SceneExports::exportRaster()
{
    const QString path
        = askForPath(tr("Export the Raster"), tr("Text (*.txt)"), QStringLiteral("txt"));
    if (!path.isEmpty())
        writeRaster(path);
}

void SceneExports::copyRaster()
{
    if (!hasTrace())
        return;
    const CoverageMask coverage = coverageOf(m_playhead->traced()->scene);
    QApplication::clipboard()->setText(asciiRaster(coverage));
    emit notice(tr("The finished picture's raster is on the clipboard: %1 × %2, # is covered.")
                    .arg(coverage.spec().width)
                    .arg(coverage.spec().height));
}

void SceneExports::compareWithClipboard()
{
    if (!hasTrace())
        return;
    const Result<CoverageMask> pasted = parseAsciiRaster(QApplication::clipboard()->text());
    if (!pasted) {
        emit complaint(tr("The clipboard holds no raster: %1").arg(pasted.error().message()));
        return;
    }
    const Result<RasterComparison> comparison
        = compareRasters(coverageOf(m_playhead->traced()->scene), *pasted);
    if (!comparison) {
        emit complaint(tr("The rasters cannot be compared: %1").arg(comparison.error().message()));
        return;
    }
    emit notice(summaryOf(*comparison));
    auto *dialog = new RasterDialog(*comparison, m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void SceneExports::copyPickedPixel()
{
    const std::optional<QPoint> pixel = m_playhead->pickedPixel();
    if (!hasTrace() || !pixel)
        return;
    const Colour colour = unpacked(*m_playhead->frame()->view().at(pixel->x(), pixel->y()));
    QStringList cells{QStringLiteral("(%1, %2)").arg(pixel->x()).arg(pixel->y()),
                      colourText(colour)};
    const BriefPixelHistory history
        = briefPixelHistory(*m_playhead->traced(), pixel->x(), pixel->y(), mostCopiedRefusals);
    for (const PixelAttempt &attempt : history.attempts)
        cells += QStringLiteral("%1 %2: %3")
                     .arg(nameOf(attempt.kind))
                     .arg(attempt.primitive)
                     .arg(attempt.reason);
    if (history.furtherRefusals > 0)
        cells += tr("%n more primitive(s) leave it alone", nullptr, int(history.furtherRefusals));
    QApplication::clipboard()->setText(cells.join(QLatin1Char('\t')));
    emit notice(tr("Pixel (%1, %2) is on the clipboard.").arg(pixel->x()).arg(pixel->y()));
}

QString SceneExports::askForPath(const QString &title, const QString &filter,
                                 const QString &suffix) const
{
    QFileDialog dialog(m_window, title, {}, filter);
    dialog.setObjectName(QStringLiteral("exportDialog"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(m_baseName + QLatin1Char('.') + suffix);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().constFirst() : QString();
}

bool SceneExports::mayWriteTo(const QString &path)
{
    if (!hasTrace())
        return false;
    if (m_scenePath.isEmpty() || !isSameFile(path, m_scenePath))
        return true;
    return tellOutcome(path, tr("it is the scene itself, which the export would replace."));
}

bool SceneExports::hasTrace()
{
    if (m_playhead->traced())
        return true;
    emit complaint(tr("Nothing is drawn yet."));
    return false;
}

bool SceneExports::tellOutcome(const QString &path, const QString &error)
{
    const QString name = QFileInfo(path).fileName();
    if (error.isEmpty())
        emit notice(tr("%1 is written.").arg(name));
    else
        emit complaint(tr("%1 was not written: %2").arg(name, error));
    return error.isEmpty();
}

} // namespace pixelplumb
