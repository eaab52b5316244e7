// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/window/mainwindow.h"

#include "core/runs/clampeddepths.h"
#include "widgets/canvas/canvas.h"
#include "widgets/canvas/overdrawoverlay.h"
#include "widgets/files/autosave.h"
#include "widgets/files/recentfiles.h"
#include "widgets/files/sceneexports.h"
#include "widgets/files/scenefiles.h"
#include "widgets/files/studentpicturefiles.h"
#include "widgets/inspect/columntablepanel.h"
#include "widgets/inspect/predictpanel.h"
#include "widgets/inspect/primitivespanel.h"
#include "widgets/look/colourbutton.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/messagebar.h"
#include "widgets/look/paletteswitch.h"
#include "widgets/look/parts.h"
#include "widgets/model/effectswitches.h"
#include "widgets/model/playhead.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/scenetracer.h"
#include "widgets/model/studentpicture.h"
#include "widgets/stepping/scrubber.h"
#include "widgets/stepping/stepactions.h"
#include "widgets/stepping/stepperbar.h"
#include "widgets/window/editmenu.h"
#include "widgets/window/menus.h"
#include "widgets/window/methodbar.h"
#include "widgets/window/studylinks.h"
#include "widgets/window/viewmenu.h"
#include "widgets/window/whatsthis.h"
#include "widgets/window/windowdocks.h"
#include "widgets/window/windowkeys.h"
#include "widgets/window/windowsettings.h"
#include "widgets/window/windowstatusbar.h"
#include "widgets/window/workspaces.h"

namespace pixelplumb {

namespace {

ColumnPlaces columnPlacesOf(const Canvas &canvas)
{
    const double origin = canvas.positionOf(QPoint(0, 0)).x();
    return {origin, canvas.positionOf(QPoint(1, 0)).x() - origin, canvas.view().left(),
            canvas.view().right()};
}

} // namespace

MainWindow::MainWindow(QWidget *parent)
    : QMainWindow(parent)
{
    setObjectName(u"mainWindow"_s);
    setAcceptDrops(true);
    setAnimated(false); // restoreState() crashes while a dropped panel glides into its place
    m_palettes = new PaletteSwitch(this);
    makeParts();
    makeCentre();
    m_docks = new WindowDocks(m_parts, this);
    makeMenus();
    makeToolBars();
    setStatusBar(new WindowStatusBar(m_parts, this));
    connectParts();
    connectStudies(m_parts, *m_docks, this);
    m_docks->whenBuilt<ColumnTablePanel>( // a click into the table must not cost the tools' keys
        [this](ColumnTablePanel *panel) { panel->addActions(m_editMenu->tools()); });
    m_docks->whenBuilt<PrimitivesPanel>(
        [this](PrimitivesPanel *panel) { panel->takeKeysOf(m_editMenu->deletion()); });
    new WindowKeys(m_parts.canvas, this);
    connect(m_docks, &WindowDocks::panelBuilt, this, &explainParts);
    m_settings = std::make_unique<WindowSettings>(m_parts, m_docks->workspaces(), this);
    m_settings->restore();
    connect(qGuiApp, &QGuiApplication::commitDataRequest, this, &MainWindow::commitData);
    updateTitle();
    explainParts(this);
    m_parts.canvas->setFocus();
}

MainWindow::~MainWindow() = default;

void MainWindow::makeParts()
{
    m_parts.document = new SceneDocument(this);
    m_parts.playhead = new Playhead(this);
    m_parts.options = new DisplayOptions(this);
    m_parts.effects = new EffectSwitches(this);
    m_parts.tracer = new SceneTracer(this);
    m_parts.previewer = new ScenePreviewer(this);
    m_parts.recent = new RecentFiles(this);
    m_parts.files = new SceneFiles(m_parts.document, m_parts.recent, this);
    m_autosave = new Autosave(m_parts.document, Autosave::defaultFolder(), this);
    m_parts.exports = new SceneExports(m_parts.document, m_parts.playhead, m_parts.options, this);
    m_parts.student = new StudentPicture(this);
    m_parts.pictures = new StudentPictureFiles(m_parts.student, this);
    m_parts.steps = new StepActions(m_parts.playhead, this);
}

void MainWindow::makeCentre()
{
    auto *centre = new QWidget(this);
    m_parts.canvas = new Canvas(m_parts.document, m_parts.playhead, m_parts.options, centre);
    m_parts.canvas->setPreviewer(m_parts.previewer);
    m_parts.canvas->setEffects(m_parts.effects);
    m_parts.canvas->setStudentPicture(m_parts.student);
    m_parts.messageBar = new MessageBar(m_parts.canvas);
    m_parts.overdraw = new OverdrawOverlay(m_parts.canvas, m_parts.playhead);
    m_parts.scrubber = new Scrubber(m_parts.playhead, centre);
    // The scrubber lies below the canvas: a column has the same x in both.
    connect(m_parts.canvas, &Canvas::viewChanged, m_parts.scrubber,
            [this] { m_parts.scrubber->setColumnPlaces(columnPlacesOf(*m_parts.canvas)); });
    withParts(new QVBoxLayout(centre), {{m_parts.canvas, 1}, m_parts.scrubber}, 0, 0);
    centre->setFocusProxy(m_parts.canvas);
    setCentralWidget(centre);
}

void MainWindow::makeMenus()
{
    auto *files = new FileMenu(m_parts, this);
    connect(files, &FileMenu::examplesRequested, this,
            [this] { showExamples(m_parts, *m_docks, this); });
    menuBar()->addMenu(files);
    m_editMenu = new EditMenu(m_parts, this);
    menuBar()->addMenu(m_editMenu);
    m_viewMenu = new ViewMenu(m_parts, m_docks, m_palettes, this);
    menuBar()->addMenu(m_viewMenu);
    menuBar()->addMenu(new LayersMenu(m_parts, this));
    auto *steps = new StepMenu(m_parts, this);
    steps->addSeparator();
    steps->addAction(m_docks->toggleOf<PredictPanel>());
    menuBar()->addMenu(steps);
    menuBar()->addMenu(new MethodMenu(m_parts, this));
    menuBar()->addMenu(new HelpMenu(menuBar()));
    menuBar()->setCornerWidget(new WorkspaceRow(m_viewMenu->workspaces()));
}

void MainWindow::makeToolBars()
{
    const auto addBar = [this](const char *name, const QString &title) {
        QToolBar *bar = addToolBar(title);
        bar->setObjectName(QLatin1String(name));
        bar->setMovable(false);
        return bar;
    };
    // In one tool bar, so that the method's box gets what the rest leaves.
    QToolBar *view = addBar("viewToolBar", tr("Method and view"));
    view->addWidget(new MethodBar(m_parts.document));
    view->addSeparator();
    view->addActions({m_viewMenu->grid(), m_viewMenu->truth(), m_viewMenu->differences()});
    view->addSeparator();
    auto *label = new QLabel(tr("Next vertex"));
    label->setContentsMargins(8, 0, 8, 0);
    view->addWidget(label);
    m_nextColour = named(new ColourButton(tr("Colour of the next vertex")), "nextColourButton");
    m_nextColour->setToolButtonStyle(Qt::ToolButtonIconOnly); // the tool bar fits into 1024 pixels
    view->addWidget(m_nextColour);

    addToolBarBreak();
    QToolBar *steps = addBar("stepperToolBar", tr("Tools and stepper"));
    steps->addActions(m_editMenu->tools());
    steps->addWidget(new StepperBar(m_parts.playhead, *m_parts.steps));
}

void MainWindow::connectParts()
{
    SceneDocument *document = m_parts.document;
    // A message concerns the previous action; this one's message comes later.
    connect(document, &SceneDocument::sceneChanged, m_parts.messageBar, &QWidget::hide);
    connect(document, &SceneDocument::pendingChanged, m_parts.messageBar, &QWidget::hide);
    connect(document, &SceneDocument::sceneChanged, this, &MainWindow::traceDocument);
    connect(document, &SceneDocument::currentFrameChanged, this, &MainWindow::traceDocument);
    connect(m_parts.effects, &EffectSwitches::changed, this, &MainWindow::traceDocument);
    connect(document, &SceneDocument::modifiedChanged, this, &QWidget::setWindowModified);
    connect(document, &SceneDocument::refused, m_parts.messageBar, &MessageBar::complain);
    connect(document, &SceneDocument::notice, m_parts.messageBar, &MessageBar::tell);
    connect(m_parts.tracer, &SceneTracer::traced, this, &MainWindow::takeTrace);
    connect(m_parts.tracer, &SceneTracer::failed, m_parts.messageBar, &MessageBar::complain);
    connect(m_parts.tracer, &SceneTracer::cancelled, m_parts.messageBar,
            [this] { m_parts.messageBar->tell(cancelledRunNote()); });
    connect(m_parts.files, &SceneFiles::pathChanged, this, &MainWindow::updateTitle);
    // The other scene's position and pixel mean nothing in the new one, and its run would only
    // occupy memory while a large scene is traced.
    connect(m_parts.files, &SceneFiles::replacing, m_parts.playhead,
            [this] { m_parts.playhead->setTraced(nullptr); });
    connect(m_parts.files, &SceneFiles::replacing, m_parts.effects, &EffectSwitches::reset);
    connect(m_parts.files, &SceneFiles::replacing, m_parts.canvas, &Canvas::fitToView);
    connect(m_parts.files, &SceneFiles::begun, m_parts.canvas,
            [canvas = m_parts.canvas] { canvas->setTool(CanvasTool::Draw); });
    for (const auto come : {&SceneFiles::begun, &SceneFiles::loaded})
        connect(m_parts.files, come, this, &MainWindow::giveKeysToTheScene);
    connect(m_parts.files, &SceneFiles::loaded, this, [this] {
        m_parts.canvas->setTool(CanvasTool::Inspect); // to look at someone else's scene
        if (!m_parts.files->path().isEmpty())
            setOpeningPlace(OpeningMoment::HalfDrawn);
    });
    connect(m_parts.files, &SceneFiles::complaint, m_parts.messageBar, &MessageBar::complain);
    connect(m_parts.files, &SceneFiles::notice, m_parts.messageBar, &MessageBar::tell);
    connect(m_parts.exports, &SceneExports::complaint, m_parts.messageBar, &MessageBar::complain);
    const auto updateColour = [this, document] { m_nextColour->setColour(document->nextColour()); };
    connect(document, &SceneDocument::nextColourChanged, m_nextColour, updateColour);
    connect(m_nextColour, &ColourButton::colourChosen, document, &SceneDocument::setNextColour);
    updateColour();
    connect(m_parts.canvas, &Canvas::colourRequested, this, [this](const VertexRef &ref) {
        const std::optional<Vertex> vertex = m_parts.document->vertexAt(ref);
        if (!vertex)
            return;
        if (const auto colour = askForColour(vertex->colour, tr("Colour of the Vertex"), this))
            m_parts.document->setVertexColour(ref, *colour);
    });
}

void MainWindow::traceDocument()
{
    const std::shared_ptr<const Scene> scene
        = m_parts.effects->applied(m_parts.document->currentSnapshot());
    m_parts.student->follow(scene);
    m_parts.tracer->trace(scene);
    if (m_parts.tracer->isRunning())
        return m_parts.previewer->preview(scene);
    m_parts.previewer->clear(); // the scene is traced already, or cannot be
}

void MainWindow::takeTrace(const std::shared_ptr<const TracedScene> &traced)
{
    m_parts.playhead->setTraced(traced);
    m_parts.previewer->followTrace(traced);
    goToOpeningPlace();
    if (traced->trace->isCut())
        m_parts.messageBar->tell(cutRunNote(*traced));
    else if (const QString rejected = rejectionNote(*traced); !rejected.isEmpty())
        m_parts.messageBar->tell(rejected);
    else if (const QString clamped = clampedDepthsText(traced->primitives); !clamped.isEmpty())
        m_parts.messageBar->tell(clamped + u'.');
}

void MainWindow::updateTitle()
{
    m_parts.exports->setScenePath(m_parts.files->path());
    m_autosave->setSceneFile(m_parts.files->path());
    m_parts.exports->setBaseName(m_parts.files->baseName());
    setWindowTitle(tr("%1[*] — Pixelplumb").arg(m_parts.files->titleName()));
    setWindowModified(m_parts.document->isModified());
}

QMenu *MainWindow::createPopupMenu()
{
    auto *menu = new QMenu(this);
    for (QDockWidget *dock : m_docks->all())
        menu->addAction(dock->toggleViewAction());
    menu->addSeparator();
    for (const QToolBar *bar : findChildren<QToolBar *>())
        menu->addAction(bar->toggleViewAction());
    return menu;
}

} // namespace pixelplumb
