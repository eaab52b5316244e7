// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/casestorun.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/inspect/formulapanel.h"
#include "widgets/inspect/pixelgrid.h"
#include "widgets/look/labels.h"
#include "widgets/model/playhead.h"
#include "widgets/model/primitivelistmodel.h"
#include "widgets/stepping/scrubber.h"
#include "widgets/studies/compare/comparepane.h"
#include "widgets/studies/compare/comparepanel.h"
#include "widgets/studies/compare/compareview.h"

#include <QTest>
#include <QtWidgets>

namespace tst_windowsizes {

using namespace pixelplumb;
using namespace std::chrono_literals;

namespace {

/// Fully visible: within each of its parents.
bool isInSight(const QWidget *part)
{
    if (!part || !part->isVisible())
        return false;
    QRect place = part->rect();
    for (const QWidget *each = part; each->parentWidget(); each = each->parentWidget()) {
        place.translate(each->pos());
        if (!each->parentWidget()->rect().contains(place))
            return false;
    }
    return true;
}

/// Parts that should be visible but are not wholly within the window.
QStringList hiddenParts(const MainWindow &window)
{
    QStringList hidden;
    for (const char *name :
         {"canvas", "scrubber", "columnTable", "formulaHeading", "formulaSentence", "formulaText",
          "methodBox", "arithmeticBox", "fillRuleBox", "roundingBox", "stepperBar",
          "nextColourButton", "statusPixel", "statusColumn"}) {
        if (!isInSight(named<QWidget>(window, name)))
            hidden += QLatin1String(name);
    }
    return hidden;
}

int hiddenFormulaLines(const MainWindow &window)
{
    return named<QTextBrowser>(window, "formulaText")->verticalScrollBar()->maximum();
}

/// The entries of all menus and of the menus in them.
QList<QAction *> entriesOf(const QWidget &menu)
{
    QList<QAction *> entries;
    for (QAction *entry : menu.actions()) {
        if (entry->menu())
            entries += entriesOf(*entry->menu());
        else if (!entry->isSeparator())
            entries += entry;
    }
    return entries;
}

using Sizes = std::vector<std::pair<const char *, QSize>>;

/// The room that a frame and a title bar leave on common screens, in logical pixels.
const Sizes allSizes = {{"1024 × 640", {1016, 600}},
                        {"1366 × 768", {1358, 728}},
                        {"2560 × 1440 at scale 2", {1272, 680}},
                        {"1920 × 1080", {1440, 960}}};

void addSizes(const Sizes &sizes)
{
    QTest::addColumn<QSize>("size");
    for (const auto &[name, size] : sizes)
        QTest::newRow(name) << size;
}

/// Each function draws its own sample of the sizes to run.
void addSizes()
{
    addSizes(casesToRun(
        allSizes, [](const auto &) { return QString::fromLatin1(QTest::currentTestFunction()); }));
}

} // namespace

/// The window on the screens that students have.
class TestWindowSizes : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void theFirstWindowFitsTheScreenAndAnyCanBeSmall()
    {
        const MainWindow first;
        QCOMPARE(first.size().boundedTo(first.screen()->availableSize()), first.size());
        const auto window = windowOf(QSize(1440, 960));

        QCOMPARE(window->minimumSizeHint().boundedTo({900, 560}), window->minimumSizeHint());
        QCOMPARE(window->minimumSize().boundedTo({900, 560}), window->minimumSize());
    }

    void everythingIsInSightAtTheFirstStart_data() { addSizes(allSizes); }
    void everythingIsInSightAtTheFirstStart()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);

        QCOMPARE(window->size(), size);
        QCOMPARE(hiddenParts(*window).join(u' '), QString());
        QCOMPARE(hiddenFormulaLines(*window), 0);
        const auto *table = named<QTableView>(*window, "columnTable");
        const QRect row = table->visualRect(table->currentIndex());
        QVERIFY(table->viewport()->rect().top() <= row.top());
        QVERIFY(table->viewport()->rect().bottom() >= row.bottom());
    }

    void formulasAreScrolledOnlyWhereThePixelGridNeedsTheRoom_data() { addSizes(); }
    void formulasAreScrolledOnlyWhereThePixelGridNeedsTheRoom()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);
        Playhead &playhead = *window->parts().playhead;
        const auto *grid = named<PixelGrid>(*window, "pixelGrid");

        int scrolled = 0;
        for (std::size_t span = 0; span < playhead.traced()->trace->spanCount(); ++span) {
            playhead.seekToSpan(span);
            for (int step = 0; step < 2; ++step) {
                if (hiddenFormulaLines(*window) > 0)
                    settle();
                scrolled += int(hiddenFormulaLines(*window) > 0);
                playhead.step(StepUnit::Sample, StepDirection::Forward);
            }
        }

        QVERIFY(scrolled == 0 || grid->height() <= grid->minimumSizeHint().height() + 2);
        QVERIFY(grid->visibleRegion().isEmpty()
                || grid->height() >= grid->minimumSizeHint().height());
    }

    void steppingMovesNoPanel_data() { addSizes(); }
    void steppingMovesNoPanel()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);
        const auto places = [&window] {
            QList<QRect> docks;
            for (const char *name : {"formulaDock", "pixelGridDock", "pixelHistoryDock"})
                docks += named<QDockWidget>(*window, name)->geometry();
            return docks;
        };
        const QList<QRect> first = places();

        for (const char *key : {"nextColumn", "nextPixel", "nextColumn", "previousColumn",
                                "previousColumn", "nextPixel", "runToEnd", "runToStart"}) {
            action(*window, key)->trigger();
            settle();
            QVERIFY2(places() == first, key);
        }
    }

    void aPanelsKeyShowsItAndHidesItWhereItIsInFront_data() { addSizes(); }
    void aPanelsKeyShowsItAndHidesItWhereItIsInFront()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);
        for (const QDockWidget *dock : window->findChildren<QDockWidget *>()) {
            QAction *toggle = named<QAction>(*window, qPrintable(dock->objectName() + "Toggle"));
            const auto isInFront
                = [dock] { return dock->isVisible() && !dock->visibleRegion().isEmpty(); };
            if (isInFront()) {
                toggle->trigger();
                settle();
                QVERIFY2(!isInFront(), qPrintable(dock->objectName()));
            }
            for (const bool shown : {true, false, true}) {
                toggle->trigger();
                settle();
                QVERIFY2(isInFront() == shown, qPrintable(dock->objectName()));
                QVERIFY2(toggle->isChecked() == shown, qPrintable(dock->objectName()));
            }
        }
    }

    /// Entries that ask for more, which end in an ellipsis, are left out; other questions are
    /// closed.
    void theCanvasKeepsHalfOfTheWidthInEveryWorkspaceAfterEveryEntryOfEveryMenu()
    {
        const QSize small = allSizes[0].second;
        const auto window = windowOf(small);
        const auto keepsHalf = [&window, &small] {
            settle();
            return window->size() == small
                && window->parts().canvas->width() >= small.width() / 2 - 8;
        };
        QTimer closing;
        connect(&closing, &QTimer::timeout, &closing, [] {
            if (QWidget *asking = QApplication::activeModalWidget())
                asking->close();
        });
        closing.start(10ms);
        for (const char *workspace :
             {"stepWorkspace", "compareWorkspace", "measureWorkspace", "gradeWorkspace"}) {
            action(*window, workspace)->trigger();
            action(*window, "resetLayout")->trigger();
            QVERIFY2(keepsHalf(), workspace);
            for (QAction *entry : entriesOf(*window->menuBar())) {
                if (!entry->isEnabled() || entry->text().endsWith(u'…')
                    || entry->objectName() == u"quit"_s)
                    continue;
                entry->trigger();
                QVERIFY2(keepsHalf(), qPrintable(workspace + u' ' + entry->text()));
                for (QWidget *other : QApplication::topLevelWidgets()) {
                    if (other != window.get() && other->isVisible())
                        other->close();
                }
            }
        }
    }

    void theCanvasKeepsItsHeightWhateverPanelIsOpened_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("percent");
        QTest::newRow("1366 × 768") << QSize(1358, 728) << 40;
        QTest::newRow("1920 × 1080") << QSize(1912, 1040) << 40;
    }
    void theCanvasKeepsItsHeightWhateverPanelIsOpened()
    {
        QFETCH(QSize, size);
        QFETCH(int, percent);
        const auto window = windowOf(size);
        QStringList low;
        const auto look = [&](const QString &what) {
            settle();
            const int height = window->parts().canvas->height();
            if (height < size.height() * percent / 100)
                low += u"%1: %2 px"_s.arg(what).arg(height);
        };
        for (const char *workspace :
             {"stepWorkspace", "compareWorkspace", "measureWorkspace", "gradeWorkspace"}) {
            action(*window, workspace)->trigger();
            look(QLatin1String(workspace));
        }
        for (const QDockWidget *dock : window->findChildren<QDockWidget *>()) {
            QAction *toggle = named<QAction>(*window, qPrintable(dock->objectName() + "Toggle"));
            if (!toggle->isChecked())
                toggle->trigger();
            look(dock->objectName());
        }
        QVERIFY2(low.isEmpty(), qPrintable(low.join(u'\n')));
    }

    /// Everything that brings a panel into the window: its key, floating and docking, dragging to
    /// every side, all panels at once, and resetting the layout.
    void noPanelMakesTheWindowLargerThanItsScreen_data() { addSizes(); }
    void noPanelMakesTheWindowLargerThanItsScreen()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);
        const auto isAsLarge = [&window, &size](const QString &afterWhat) {
            settle();
            const bool fits = window->size() == size
                && window->minimumSize().boundedTo(size) == window->minimumSize();
            if (!fits)
                qWarning("%s: %d × %d", qPrintable(afterWhat), window->width(), window->height());
            return fits;
        };
        const QList<QDockWidget *> docks = window->findChildren<QDockWidget *>();
        for (QDockWidget *dock : docks) {
            QAction *toggle = named<QAction>(*window, qPrintable(dock->objectName() + "Toggle"));
            if (!toggle->isChecked())
                toggle->trigger();
            QVERIFY(isAsLarge(dock->objectName() + " is opened in its workspace"));
            QVERIFY2(window->parts().canvas->width() >= size.width() / 2 - 8,
                     qPrintable(dock->objectName()));
        }
        action(*window, "stepWorkspace")->trigger();
        for (QDockWidget *dock : docks) {
            dock->show();
            QVERIFY(isAsLarge(dock->objectName() + " is opened beside all before it"));
        }
        for (QDockWidget *dock : docks) {
            dock->setFloating(true);
            QVERIFY(isAsLarge(dock->objectName() + " floats"));
            QVERIFY2(dock->minimumSizeHint().boundedTo(size) == dock->minimumSizeHint(),
                     qPrintable(dock->objectName()));
            dock->close();
            QVERIFY(isAsLarge(dock->objectName() + " is closed"));
            named<QAction>(*window, qPrintable(dock->objectName() + "Toggle"))->trigger();
            QVERIFY(isAsLarge(dock->objectName() + " is opened again"));
            action(*window, "stepWorkspace")->trigger();
            dock->show();
            dock->setFloating(false);
            QVERIFY(isAsLarge(dock->objectName() + " is back"));
        }
        for (const Qt::DockWidgetArea area : {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea,
                                              Qt::TopDockWidgetArea, Qt::BottomDockWidgetArea}) {
            for (QDockWidget *dock : docks) { // each next to all others, none behind a tab
                window->addDockWidget(area, dock);
                dock->show();
                QVERIFY(isAsLarge(dock->objectName() + " is dragged"));
            }
            QVERIFY(window->parts().canvas->isVisible());
        }
        action(*window, "resetLayout")->trigger();
        QVERIFY(isAsLarge(u"the layout is reset"_s));
        for (const char *name : {"zoomIn", "zoomIn", "zoomOut", "zoomToOne", "zoomToFit"}) {
            action(*window, name)->trigger();
            QVERIFY(isAsLarge(QLatin1String(name)));
        }
        QCOMPARE(hiddenParts(*window).join(u' '), QString());
    }

    void manyPanesDoNotWidenTheWindow_data() { addSizes(); }
    void manyPanesDoNotWidenTheWindow()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);
        auto *compare = named<ComparePanel>(*window, "compare");
        action(*window, "compareDockToggle")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(compare->contest() && !compare->isRunning(), 20000);
        while (compare->panes().size() < mostContenders)
            QTest::mouseClick(named<QToolButton>(*compare, "compareMore"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(compare->contest()->runs.size() == mostContenders, 20000);
        settle();
        QCOMPARE(window->width(), size.width());
        QVERIFY(window->minimumSizeHint().width() <= size.width());
    }

    void theChoicesOfComparedRunsAreReadWhole_data() { addSizes(); }
    void theChoicesOfComparedRunsAreReadWhole()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);
        auto *compare = named<ComparePanel>(*window, "compare");
        action(*window, "compareDockToggle")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(compare->contest() && !compare->isRunning(), 20000);
        settle();

        for (const ElidingBox *box : compare->findChildren<ElidingBox *>()) {
            QVERIFY2(isInSight(box), qPrintable(box->objectName()));
            QCOMPARE(box->shownText(), box->currentText());
        }
        for (const QLabel *label : compare->findChildren<QLabel *>()) {
            if (label->objectName() == u"predictVeil"_s)
                continue;
            QVERIFY2(isInSight(label), qPrintable(label->text()));
            QVERIFY2(label->height() >= label->heightForWidth(label->width()),
                     qPrintable(label->text()));
        }
        // Each pixel is two of the screen's, at least.
        for (const ComparePane *pane : compare->panes())
            QVERIFY2(pane->view()->mapping().zoom().devicePixels >= 2,
                     qPrintable(QString::number(pane->view()->height())));
        Playhead &playhead = *window->parts().playhead;
        playhead.pick({58, 12}); // which float64 loses
        settle();
        const auto *reason = named<QLabel>(*compare, "compareReason");
        QVERIFY2(reason->text().contains(u"instead of"_s), qPrintable(reason->text()));
        QVERIFY2(isInSight(reason) || size.height() < 640, qPrintable(reason->text()));
    }

    void aPanelThatIsClosedGivesItsRoomBack_data() { addSizes(); }
    void aPanelThatIsClosedGivesItsRoomBack()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);
        const QSize before = window->parts().canvas->size();
        for (const char *name : {"projectionDockToggle", "motionDockToggle", "gradingDockToggle",
                                 "accuracyLabDockToggle"}) {
            action(*window, name)->trigger();
            settle();
            QVERIFY2(window->parts().canvas->height() >= size.height() / 4, name);
            action(*window, name)->trigger();
            action(*window, "stepWorkspace")->trigger();
            settle();
            QVERIFY2(window->parts().canvas->size() == before, name);
        }
    }

    void thePrimitivesAreReadWithoutScrollingAcross_data() { addSizes(); }
    void thePrimitivesAreReadWithoutScrollingAcross()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);

        action(*window, "primitivesDockToggle")->trigger();
        settle();

        auto *tree = named<QTreeView>(*window, "primitivesTree");
        tree->expandAll();
        settle();
        QVERIFY(isInSight(tree));
        QCOMPARE(tree->horizontalScrollBar()->maximum(), 0);
        const int swatch = tree->style()->pixelMetric(QStyle::PM_SmallIconSize);
        QVERIFY(tree->columnWidth(PrimitiveListModel::ColourText)
                > swatch + tree->fontMetrics().horizontalAdvance("#0000ff"));
        const int beforeName = 2 * tree->indentation(); // and the box that shows it
        QVERIFY(tree->columnWidth(PrimitiveListModel::Name)
                > beforeName + tree->fontMetrics().horizontalAdvance("triangle 0"));
    }

    void theButtonsOfAHardCaseAreInSightAndItsWordsAreWhole_data() { addSizes(); }
    void theButtonsOfAHardCaseAreInSightAndItsWordsAreWhole()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);

        action(*window, "hardCasesDockToggle")->trigger();
        settle();

        for (const char *name : {"hardCasesTree", "hardCaseTitle", "hardCaseOpen",
                                 "hardCaseCompare", "hardCasePrecision"})
            QVERIFY2(isInSight(named<QWidget>(*window, name)), name);
        for (const char *name : {"hardCaseOpen", "hardCaseCompare", "hardCasePrecision"}) {
            const auto *button = named<QPushButton>(*window, name);
            QVERIFY2(button->width() > button->fontMetrics().horizontalAdvance(button->text()),
                     name);
        }
        const QWidget *column = named<QWidget>(*window, "hardCaseWords")->parentWidget();
        QVERIFY(column->width() <= column->parentWidget()->width());
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestWindowSizes)

} // namespace tst_windowsizes

#include "tst_windowsizes.moc"
