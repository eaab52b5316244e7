// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/filemenu.h"

#include "widgets/files/recentfiles.h"
#include "widgets/files/sceneexports.h"
#include "widgets/files/scenefiles.h"
#include "widgets/files/studentpicturefiles.h"
#include "widgets/look/menuaction.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

namespace pixelplumb {

namespace {

/// The names of the span exports for a method's axis: as a CSV table and as JSON.
std::pair<QString, QString> spanExportNames(SpanAxis axis)
{
    switch (axis) {
    case SpanAxis::Row:
        return {FileMenu::tr("Ro&ws (CSV)…"), FileMenu::tr("Rows (&JSON)…")};
    case SpanAxis::Free:
        return {FileMenu::tr("&Steps (CSV)…"), FileMenu::tr("Steps (&JSON)…")};
    case SpanAxis::Column:
        break;
    }
    return {FileMenu::tr("&Columns (CSV)…"), FileMenu::tr("Columns (&JSON)…")};
}

} // namespace

FileMenu::FileMenu(const WindowParts &parts, QWidget *window)
    : QMenu(tr("&File"), window)
{
    setObjectName(QStringLiteral("fileMenu"));
    SceneFiles *files = parts.files;
    addMenuAction(this, "newScene", tr("&New"), QKeySequence::New, [files] { files->newScene(); });
    addMenuAction(this, "openScene", tr("&Open…"), QKeySequence::Open, [files] { files->open(); });
    addMenu(parts.recent->createMenu(this));
    connect(parts.recent, &RecentFiles::chosen, files, &SceneFiles::openFile);
    addMenuAction(this, "showExamples", tr("Exa&mples…"), Qt::CTRL | Qt::SHIFT | Qt::Key_O,
                  [this] { emit examplesRequested(); });
    addMenuAction(this, "openDefaultScene", tr("Open the &first scene"), {}, [files] {
        if (files->mayReplace())
            files->loadDefault();
    });
    StudentPictureFiles *pictures = parts.pictures;
    addMenuAction(this, "openStudentPicture", tr("Open student's p&icture…"),
                  Qt::CTRL | Qt::SHIFT | Qt::Key_P, [pictures] { pictures->open(); });
    addSeparator();
    addMenuAction(this, "saveScene", tr("&Save"), QKeySequence::Save, [files] { files->save(); });
    addMenuAction(this, "saveSceneAs", tr("Save &as…"), Qt::CTRL | Qt::SHIFT | Qt::Key_S,
                  [files] { files->saveAs(); });
    QAction *revert = addMenuAction(this, "revertScene", tr("Re&vert to the file"), {},
                                    [files] { files->revert(); });
    const auto updateRevert = [revert, files] { revert->setEnabled(!files->path().isEmpty()); };
    connect(files, &SceneFiles::pathChanged, revert, updateRevert);
    updateRevert();
    addSeparator();
    addExports(parts);
    addSeparator();
    addMenuAction(this, "quit", tr("&Quit"), Qt::CTRL | Qt::Key_Q, [window] { window->close(); });
}

void FileMenu::addExports(const WindowParts &parts)
{
    SceneExports *exports = parts.exports;
    QMenu *menu = addMenu(tr("&Export"));
    menu->setObjectName(QStringLiteral("exportMenu"));
    addMenuAction(menu, "exportPicture", tr("&Picture (PNG)…"), Qt::CTRL | Qt::Key_E,
                  [exports] { exports->exportPicture(); });
    addMenuAction(menu, "exportGrid", tr("&Annotated grid (SVG)…"), {},
                  [exports] { exports->exportAnnotatedGrid(); });
    menu->addSeparator();
    const auto addTable = [&](const char *name, const QString &text, TraceLevel level,
                              TableFormat format) {
        return addMenuAction(menu, name, text, {},
                             [exports, level, format] { exports->exportTrace(level, format); });
    };
    QAction *spansCsv = addTable("exportColumnsCsv", {}, TraceLevel::Column, TableFormat::Csv);
    QAction *spansJson = addTable("exportColumnsJson", {}, TraceLevel::Column, TableFormat::Json);
    addTable("exportPixelsCsv", tr("Pi&xels (CSV)…"), TraceLevel::Pixel, TableFormat::Csv);
    addTable("exportPixelsJson", tr("Pixels (JS&ON)…"), TraceLevel::Pixel, TableFormat::Json);
    const auto nameSpans = [spansCsv, spansJson, playhead = parts.playhead] {
        const auto [csv, json] = spanExportNames(playhead->axis());
        spansCsv->setText(csv);
        spansJson->setText(json);
    };
    connect(menu, &QMenu::aboutToShow, this, nameSpans);
    nameSpans();
    menu->addSeparator();
    addMenuAction(menu, "exportRaster", tr("&Raster (ASCII text)…"), {},
                  [exports] { exports->exportRaster(); });
}

} // namespace pixelplumb
