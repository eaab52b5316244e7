// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/menus.h"

#include "core/layers/layer.h"
#include "widgets/canvas/imagehandles.h"
#include "widgets/dialogs/gotodialog.h"
#include "widgets/dialogs/manual.h"
#include "widgets/files/recentfiles.h"
#include "widgets/files/sceneexports.h"
#include "widgets/files/scenefiles.h"
#include "widgets/files/studentpicturefiles.h"
#include "widgets/look/corewords.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/menuaction.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/stepping/scrubber.h"
#include "widgets/stepping/stepactions.h"
#include "widgets/window/whatsthis.h"

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
    setObjectName(u"fileMenu"_s);
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
    keepUpdated(files, &SceneFiles::pathChanged, revert,
                [revert, files] { revert->setEnabled(!files->path().isEmpty()); });
    addSeparator();
    addExports(parts);
    addSeparator();
    addMenuAction(this, "quit", tr("&Quit"), Qt::CTRL | Qt::Key_Q, [window] { window->close(); });
}

void FileMenu::addExports(const WindowParts &parts)
{
    SceneExports *exports = parts.exports;
    QMenu *menu = addMenu(tr("&Export"));
    menu->setObjectName(u"exportMenu"_s);
    addMenuAction(menu, "exportPicture", tr("&PNG of the finished picture…"), Qt::CTRL | Qt::Key_E,
                  [exports] { exports->exportPicture(ExportMoment::Finished); });
    QAction *asDrawn = addMenuAction(menu, "exportPictureAsDrawn", tr("PNG as &drawn so far…"), {},
                                     [exports] { exports->exportPicture(ExportMoment::AsDrawn); });
    keepUpdated(
        parts.playhead, &Playhead::positionChanged, asDrawn, [asDrawn, playhead = parts.playhead] {
            asDrawn->setEnabled(playhead->position() > 0 && playhead->position() < playhead->end());
        });
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
    keepUpdated(menu, &QMenu::aboutToShow, this, [spansCsv, spansJson, playhead = parts.playhead] {
        const auto [csv, json] = spanExportNames(playhead->axis());
        spansCsv->setText(csv);
        spansJson->setText(json);
    });
    menu->addSeparator();
    addMenuAction(menu, "exportRaster", tr("&Raster (ASCII text)…"), {},
                  [exports] { exports->exportRaster(); });
}

LayersMenu::LayersMenu(const WindowParts &parts, QWidget *window)
    : QMenu(tr("&Layers"), window)
{
    setObjectName(u"layersMenu"_s);
    setToolTipsVisible(true);
    for (const Layer &layer : layers())
        addLayer(layer, parts);
    addSeparator();
    DisplayOptions *options = parts.options;
    QAction *none
        = addMenuAction(this, "hideLayers", tr("&Hide all layers"),
                        Qt::CTRL | Qt::SHIFT | Qt::Key_L, [options] { options->setLayers({}); });
    QAction *firstMap
        = addMenuAction(this, "firstAffineMap", tr("&Reset the affine map"), {},
                        [options, document = parts.document] {
                            document->undoStack()->push(new ImageEdit(*options, std::nullopt));
                        });
    keepUpdated(options, &DisplayOptions::changed, this, [options, none, firstMap] {
        none->setEnabled(!options->layers().isEmpty());
        firstMap->setEnabled(options->affineImage().has_value());
    });
    connect(parts.document, &SceneDocument::opened, firstMap, &QAction::trigger);
}

void LayersMenu::addLayer(const Layer &layer, const WindowParts &parts)
{
    DisplayOptions *options = parts.options;
    const SceneDocument *document = parts.document;
    QAction *action = addSwitch(
        this, "", coreWord(layer.title), {}, [options, &layer] { options->toggleLayer(layer.id); },
        options, &DisplayOptions::changed,
        [options, &layer] { return options->layers().contains(layer.id); });
    action->setObjectName(u"layer-"_s + layer.id);
    keepUpdated(document, &SceneDocument::sceneChanged, action, [document, action, &layer] {
        const QString objection = layer.objection(document->scene());
        const QString text
            = objection.isEmpty() ? layer.toolTip : tr("Nothing to show: %1.").arg(objection);
        action->setEnabled(objection.isEmpty());
        action->setStatusTip(text);
        // Rich text wraps.
        action->setToolTip(
            u"<p>%1</p><p>%2</p>"_s.arg(text.toHtmlEscaped(), layer.source.toHtmlEscaped()));
    });
}

StepMenu::StepMenu(const WindowParts &parts, QWidget *window)
    : QMenu(tr("&Step"), window)
{
    setObjectName(u"stepMenu"_s);
    const StepActions &steps = *parts.steps;
    for (const StepUnit unit : {StepUnit::Span, StepUnit::Sample, StepUnit::SetUp}) {
        addAction(steps.step(unit, StepDirection::Forward));
        addAction(steps.step(unit, StepDirection::Backward));
    }
    addSeparator();
    addAction(steps.play());
    QMenu *units = addMenu(tr("Play &by"));
    units->setObjectName(u"unitMenu"_s);
    units->addActions(steps.units());
    addSeparator();
    addAction(steps.toEnd());
    addAction(steps.toStart());
    addAction(steps.runToPixel(StepDirection::Forward));
    addAction(steps.runToPixel(StepDirection::Backward));
    Scrubber *scrubber = parts.scrubber;
    addMenuAction(this, "nextMark", tr("Next &mark"), Qt::Key_F8,
                  [scrubber] { scrubber->goToMark(StepDirection::Forward); });
    addMenuAction(this, "previousMark", tr("Previous m&ark"), Qt::SHIFT | Qt::Key_F8,
                  [scrubber] { scrubber->goToMark(StepDirection::Backward); });
    Playhead *playhead = parts.playhead;
    addMenuAction(this, "goTo", tr("&Go to…"), Qt::CTRL | Qt::Key_G, [playhead, window] {
        GoToDialog dialog(playhead, window);
        dialog.exec();
    });
    addSeparator();
    addAction(steps.toggleColumnBreakpoint());
    addAction(steps.togglePixelBreakpoint());
    addAction(steps.clearBreakpoints());
}

HelpMenu::HelpMenu(QMenuBar *bar)
    : QMenu(tr("&Help"), bar)
    , m_bar(bar)
{
    setObjectName(u"helpMenu"_s);
    addMenuAction(this, "showManual", tr("&Manual"), Qt::Key_F1, [this] { showManual(); });
    addMenuAction(this, "showKeys", tr("&Keys and mouse"), Qt::Key_Question,
                  [this] { showKeys(); });
    QAction *whatsThis
        = addMenuAction(this, "whatsThis", tr("&What's This?"), Qt::SHIFT | Qt::Key_F1,
                        [this] { enterWhatsThis(m_bar->window()); });
    whatsThis->setToolTip(tr("The next click explains the part that is clicked (Shift+F1)"));
    addMenuAction(this, "showAbout", tr("&About Pixelplumb"), {}, [this] { showAbout(); });
}

QList<QMenu *> HelpMenu::menus() const
{
    QList<QMenu *> menus;
    for (const QAction *action : m_bar->actions()) {
        if (action->menu())
            menus += action->menu();
    }
    return menus;
}

void HelpMenu::showKeys()
{
    auto *sheet = new KeySheet(menus(), m_bar->window());
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->show();
}

void HelpMenu::showManual()
{
    const QList<ManualPage> ofTheWindow = {{tr("Panels"), {}, panelsHtml(m_bar->window())},
                                           {tr("Keys and mouse"), {}, keySheetHtml(menus())}};
    auto *manual = new Manual(manualPages(ofTheWindow), m_bar->window());
    manual->setAttribute(Qt::WA_DeleteOnClose);
    manual->show();
}

void HelpMenu::showAbout()
{
    QMessageBox about(
        QMessageBox::NoIcon, tr("About Pixelplumb"),
        tr("<h3>Pixelplumb %1</h3><p>See, step through, measure and grade triangle scan "
           "conversion.</p><p>Qt %2, %3, %4</p><p>Licence: GPL-3.0-or-later. Pixelplumb uses no "
           "network and sends no data.</p>")
            .arg(QCoreApplication::applicationVersion(), QLatin1String(qVersion()),
                 QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture()),
        QMessageBox::Close, m_bar->window());
    about.setObjectName(u"about"_s);
    about.setIconPixmap(m_bar->window()->windowIcon().pixmap(64));
    about.setTextInteractionFlags(Qt::TextBrowserInteraction); // to copy it into a report
    about.exec();
}

} // namespace pixelplumb
