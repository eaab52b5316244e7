// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/judging/labfigures.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/lab/accuracylab.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/window/panels.h"

#include <QTest>
#include <QtWidgets>

namespace tst_workspaces {

using namespace pixelplumb;

namespace {

constexpr const char *actions[]
    = {"stepWorkspace", "compareWorkspace", "measureWorkspace", "gradeWorkspace"};

QString current(const MainWindow &window)
{
    for (const char *name : actions) {
        if (action(window, name)->isChecked())
            return QLatin1String(name);
    }
    return {};
}

void goTo(const MainWindow &window, const char *workspace)
{
    action(window, workspace)->trigger();
    settle();
}

void toggle(const MainWindow &window, const QString &dock)
{
    action(window, qPrintable(dock + "Toggle"))->trigger();
    settle();
}

QDockWidget *dockNamed(const MainWindow &window, const char *name)
{
    return named<QDockWidget>(window, name);
}

QStringList openPanels(const MainWindow &window)
{
    QStringList open;
    for (const QDockWidget *dock : window.findChildren<QDockWidget *>()) {
        if (!dock->isHidden())
            open += dock->objectName();
    }
    open.sort();
    return open;
}

QStringList panelsInFront(const MainWindow &window)
{
    QStringList front;
    for (const QDockWidget *dock : window.findChildren<QDockWidget *>()) {
        if (dock->isVisible() && !dock->visibleRegion().isEmpty())
            front += dock->objectName();
    }
    front.sort();
    return front;
}

/// The draggable separator between the canvas and what is to its left or right.
QPoint separatorBeside(const MainWindow &window, Qt::DockWidgetArea area)
{
    const QRect centre = window.centralWidget()->geometry();
    const int x = area == Qt::LeftDockWidgetArea ? centre.left() - 2 : centre.right() + 3;
    return {x, centre.center().y()};
}

void addSizes()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("1024 × 640") << QSize(1016, 600);
    QTest::newRow("1366 × 768") << QSize(1358, 728);
    QTest::newRow("1920 × 1080") << QSize(1912, 1040);
}

} // namespace

/// The four arrangements of the window, and how to get from one to another.
class TestWorkspaces : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void theWindowOpensInStepWithoutItsDrawers()
    {
        const auto window = openedWindow();
        QCOMPARE(current(*window), "stepWorkspace");
        QCOMPARE(openPanels(*window),
                 QStringList({"columnsDock", "formulaDock", "pixelGridDock", "pixelHistoryDock"}));
    }

    /// Qt keeps the tab bars of other arrangements, whose base line would go through a panel.
    void noTabBarOfAnotherWorkspaceIsSeen_data() { addSizes(); }
    void noTabBarOfAnotherWorkspaceIsSeen()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);
        for (int round = 0; round < 3; ++round) {
            for (const char *workspace : actions) {
                goTo(*window, workspace);
                for (const QTabBar *bar :
                     window->findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly)) {
                    for (const QDockWidget *dock : window->findChildren<QDockWidget *>())
                        QVERIFY2(!bar->isVisible() || !dock->isVisible()
                                     || dock->visibleRegion().isEmpty()
                                     || !bar->geometry().intersects(dock->geometry()),
                                 qPrintable(u"%1: %2 tabs over %3"_s.arg(QLatin1String(workspace))
                                                .arg(bar->count())
                                                .arg(dock->objectName())));
                }
            }
        }
    }

    void keysAndTheRowOfButtonsGoToEachOfThem()
    {
        const auto window = openedWindow();
        const auto *row = named<QWidget>(*window, "workspaceRow");
        QVERIFY(row->isVisible());
        QCOMPARE(window->menuBar()->cornerWidget(), row);
        int key = Qt::Key_1;
        for (const char *name : actions) {
            const QString keyText = u"Ctrl+"_s + QChar(key);
            QCOMPARE(action(*window, name)->shortcut(), QKeySequence(keyText));
            QTest::keyClick(window.get(), Qt::Key(key++), Qt::ControlModifier);
            QCOMPARE(current(*window), name);
            auto *button
                = named<QToolButton>(*row, qPrintable(QLatin1String(name) + QString("Button")));
            QVERIFY(button->isChecked());
            QVERIFY(!button->accessibleName().isEmpty());
            QVERIFY(button->toolTip().contains(keyText));
        }
        QTest::mouseClick(named<QToolButton>(*row, "stepWorkspaceButton"), Qt::LeftButton);
        QCOMPARE(current(*window), "stepWorkspace");
    }

    void theMainPanelOfEachIsInSightAtOnceAndItsOthersAreOpen()
    {
        const auto window = windowOf(QSize(1358, 728));
        goTo(*window, "compareWorkspace");
        QCOMPARE(openPanels(*window),
                 QStringList({"compareDock", "hardCasesDock", "motionDock", "precisionDock"}));
        QCOMPARE(panelsInFront(*window), QStringList({"compareDock", "hardCasesDock"}));
        goTo(*window, "measureWorkspace");
        QCOMPARE(
            openPanels(*window),
            QStringList({"accuracyLabDock", "effectsDock", "operationsDock", "performanceDock"}));
        QCOMPARE(panelsInFront(*window), QStringList("accuracyLabDock"));
        goTo(*window, "gradeWorkspace");
        QCOMPARE(panelsInFront(*window), QStringList({"gradingDock", "submissionDock"}));
    }

    void eachIsFoundAsItWasLeft()
    {
        const auto window = openedWindow();
        toggle(*window, "predictDock");
        dockNamed(*window, "columnsDock")->close();
        goTo(*window, "gradeWorkspace");
        dockNamed(*window, "submissionDock")->close();
        window->resizeDocks({dockNamed(*window, "gradingDock")}, {230}, Qt::Vertical);
        settle();
        const int height = dockNamed(*window, "gradingDock")->height();
        const QStringList grade = openPanels(*window);

        goTo(*window, "stepWorkspace");
        QVERIFY(dockNamed(*window, "predictDock")->isVisible());
        QVERIFY(dockNamed(*window, "columnsDock")->isHidden());
        goTo(*window, "gradeWorkspace");
        QCOMPARE(openPanels(*window), grade);
        QCOMPARE(dockNamed(*window, "gradingDock")->height(), height);
    }

    void theNextWindowOpensInTheLastOneAndFindsAllAsTheyWereLeft()
    {
        {
            const auto window = openedWindow();
            dockNamed(*window, "formulaDock")->close();
            window->parts().playhead->setStepsPerSecond(250);
            goTo(*window, "measureWorkspace");
            action(*window, "effectsDockToggle")->trigger();
            dockNamed(*window, "operationsDock")->close();
            settle();
            QVERIFY(window->close());
        }
        const auto window = openedWindow();
        settle();
        QCOMPARE(current(*window), "measureWorkspace");
        QCOMPARE(window->parts().playhead->stepsPerSecond(), 250.0);
        QCOMPARE(panelsInFront(*window), QStringList("effectsDock"));
        QVERIFY(dockNamed(*window, "operationsDock")->isHidden());
        goTo(*window, "stepWorkspace");
        QVERIFY(dockNamed(*window, "formulaDock")->isHidden());
        QVERIFY(dockNamed(*window, "columnsDock")->isVisible());
    }

    void whatIsNoArrangementIsNotShown()
    {
        QSettings().setValue("workspaces/current", 7);
        QSettings().setValue("workspaces/layout1", QByteArray("of another kind"));
        const auto window = openedWindow();
        QCOMPARE(current(*window), "stepWorkspace");
        goTo(*window, "compareWorkspace");
        QVERIFY(panelsInFront(*window).contains("compareDock"));
    }

    void resetIsOfTheCurrentOneOnly()
    {
        const auto window = openedWindow();
        dockNamed(*window, "formulaDock")->close();
        goTo(*window, "measureWorkspace");
        dockNamed(*window, "accuracyLabDock")->close();
        named<QToolBar>(*window, "viewToolBar")->hide();

        action(*window, "resetLayout")->trigger();
        settle();
        QCOMPARE(current(*window), "measureWorkspace");
        QCOMPARE(panelsInFront(*window), QStringList("accuracyLabDock"));
        QVERIFY(named<QToolBar>(*window, "viewToolBar")->isVisible());
        goTo(*window, "stepWorkspace");
        QVERIFY(dockNamed(*window, "formulaDock")->isHidden());
    }

    void theKeyOfAPanelGoesToItsWorkspace_data()
    {
        QTest::addColumn<int>("row");
        for (int row = 0; row < int(panels().size()); ++row)
            QTest::newRow(panels()[std::size_t(row)].title) << row;
    }
    void theKeyOfAPanelGoesToItsWorkspace()
    {
        QFETCH(int, row);
        const Panel &panel = panels()[std::size_t(row)];
        const auto window = openedWindow();
        goTo(*window, panel.workspace == Workspace::Grade ? "stepWorkspace" : "gradeWorkspace");
        const QKeySequence key
            = action(*window, qPrintable(QLatin1String(panel.dock) + QString("Toggle")))
                  ->shortcut();
        QTest::keySequence(window.get(), key);
        settle();

        QCOMPARE(current(*window), actions[int(panel.workspace)]);
        QVERIFY(panelsInFront(*window).contains(QLatin1String(panel.dock)));
    }

    void zOnTheCanvasGoesToThePixelGrid()
    {
        const auto window = openedWindow();
        goTo(*window, "measureWorkspace");
        QTest::keyClick(window->parts().canvas, Qt::Key_Z);
        QCOMPARE(current(*window), "stepWorkspace");
        QVERIFY(panelsInFront(*window).contains("pixelGridDock"));
        QCOMPARE(QApplication::focusWidget()->objectName(), "pixelGrid");
    }

    void aDotOfTheLabGoesToCompareAndAltLeftGoesBack()
    {
        const auto window = openedWindow();
        goTo(*window, "measureWorkspace");
        LabMiss miss;
        miss.scene = window->parts().document->scene();
        miss.x = 27;
        miss.y = 19;
        emit named<AccuracyLab>(*window, "accuracyLab")->missRequested(miss);
        settle();
        QCOMPARE(current(*window), "compareWorkspace");
        QVERIFY(panelsInFront(*window).contains("compareDock"));

        QTest::keyClick(window->parts().canvas, Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(current(*window), "measureWorkspace");
        QTest::keyClick(window->parts().canvas, Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(current(*window), "stepWorkspace");
        QVERIFY(!action(*window, "workspaceBack")->isEnabled());
        QTest::keyClick(window->parts().canvas, Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(current(*window), "stepWorkspace");
    }

    void aPictureGoesToGradeAndAMarkedPixelStaysThere()
    {
        const auto window = openedWindow();
        QImage black(64, 48, QImage::Format_RGB32);
        black.fill(Qt::black);
        QApplication::clipboard()->setImage(black);
        action(*window, "pasteStudentPicture")->trigger();
        QTRY_COMPARE(current(*window), "gradeWorkspace");
        settle();

        clickPixel(*window, {27, 19});
        settle();
        QCOMPARE(current(*window), "gradeWorkspace");
        QCOMPARE(panelsInFront(*window), QStringList({"gradingDock", "submissionDock"}));
    }

    void predictGoesOnAskingWhileItsWorkspaceIsLeft()
    {
        const auto window = openedWindow();
        const Playhead &playhead = *window->parts().playhead;
        toggle(*window, "predictDock");
        QVERIFY(playhead.isAheadHidden());
        goTo(*window, "compareWorkspace");
        QVERIFY(playhead.isAheadHidden());
        goTo(*window, "measureWorkspace");
        QVERIFY(playhead.isAheadHidden());
        goTo(*window, "stepWorkspace");
        QVERIFY(playhead.isAheadHidden());
        dockNamed(*window, "predictDock")->close();
        QVERIFY(!playhead.isAheadHidden());
        goTo(*window, "compareWorkspace");
        QVERIFY(!playhead.isAheadHidden());
    }

    void aPanelThatIsOpenInAnotherWorkspaceIsRaisedThere()
    {
        const auto window = openedWindow();
        goTo(*window, "compareWorkspace");
        dockNamed(*window, "formulaDock")->show(); // through the context menu of the titles
        settle();
        QVERIFY(!panelsInFront(*window).contains("formulaDock"));
        toggle(*window, "formulaDock");
        QCOMPARE(current(*window), "compareWorkspace");
        QVERIFY(panelsInFront(*window).contains("formulaDock"));
    }

    void theMenuOverTheTitlesShowsAPanelInTheCurrentWorkspace()
    {
        const auto window = openedWindow();
        const std::unique_ptr<QMenu> menu(window->createPopupMenu());
        for (QAction *each : menu->actions()) {
            if (each->text() == "Compare")
                each->trigger();
        }
        QCOMPARE(current(*window), "stepWorkspace");
        QVERIFY(!dockNamed(*window, "compareDock")->isHidden());
    }

    void whatHadTheKeysHasThemAgain()
    {
        const auto window = openedWindow();
        auto *table = named<QWidget>(*window, "columnTable");
        table->setFocus();
        goTo(*window, "measureWorkspace");
        QCOMPARE(window->focusWidget(), window->parts().canvas);
        goTo(*window, "stepWorkspace");
        QCOMPARE(window->focusWidget(), table);
    }

    void aWindowThatBecameSmallerKeepsHalfForTheCanvas()
    {
        const auto window = windowOf(QSize(1912, 1040));
        goTo(*window, "compareWorkspace");
        window->resizeDocks({dockNamed(*window, "hardCasesDock")}, {900}, Qt::Horizontal);
        settle();
        goTo(*window, "stepWorkspace");
        window->resize(1016, 600);
        settle();
        QVERIFY(window->parts().canvas->width() >= 1016 / 2 - 16);
        goTo(*window, "compareWorkspace");
        QVERIFY(window->parts().canvas->width() >= 1016 / 2 - 16);
        QCOMPARE(window->size(), QSize(1016, 600));
    }

    void aSeparatorIsDraggedNoFurtherThanHalfOfTheCanvas_data() { addSizes(); }
    void aSeparatorIsDraggedNoFurtherThanHalfOfTheCanvas()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);
        for (const auto &[name, area] : {std::pair{"stepWorkspace", Qt::RightDockWidgetArea},
                                         std::pair{"compareWorkspace", Qt::LeftDockWidgetArea}}) {
            goTo(*window, name);
            const int before = window->parts().canvas->width();
            const QPoint from = separatorBeside(*window, area);
            const int way = area == Qt::LeftDockWidgetArea ? 600 : -600;
            QTest::mousePress(window.get(), Qt::LeftButton, {}, from);
            QTest::mouseMove(window.get(), from + QPoint(way, 0));
            QTest::qWait(20); // the window moves it asynchronously
            QVERIFY2(window->parts().canvas->width() < before, "it is a separator");
            QVERIFY(window->parts().canvas->width() >= size.width() / 2 - 16);
            QTest::mouseRelease(window.get(), Qt::LeftButton, {}, from + QPoint(way, 0));
            settle();
            QVERIFY(window->parts().canvas->width() >= size.width() / 2 - 16);
            QCOMPARE(window->size(), size);
        }
    }

    /// Except for the room that the panel needs at least.
    void aPanelThatIsDroppedBesideTheCanvasLeavesItHalf_data() { addSizes(); }
    void aPanelThatIsDroppedBesideTheCanvasLeavesItHalf()
    {
        QFETCH(QSize, size);
        const auto window = windowOf(size);
        for (const char *name : {"columnsDock", "primitivesDock", "methodDock"}) {
            QDockWidget *dock = dockNamed(*window, name);
            window->addDockWidget(Qt::LeftDockWidgetArea, dock);
            dock->show();
            window->resizeDocks({dock}, {size.width() * 2 / 3}, Qt::Horizontal);
            settle();
            QVERIFY2(window->parts().canvas->width() >= size.width() / 2 - 16
                         || dock->width() == dock->minimumSizeHint().width(),
                     name);
            QCOMPARE(window->size(), size);
            action(*window, "resetLayout")->trigger();
        }
    }

    /// Also where a panel that was just dropped would still glide into its place.
    void aWorkspaceIsLeftWhileAPanelIsDraggedAndRightAfterItWasDropped()
    {
        const auto window = windowOf(QSize(1016, 600));
        const auto drag = [&window](const char *name, const QPoint &to) {
            QDockWidget *dock = dockNamed(*window, name);
            const auto end = [&] { return dock->mapFromGlobal(window->mapToGlobal(to)); };
            QTest::mousePress(dock, Qt::LeftButton, {}, {40, 8});
            QTest::mouseMove(dock, {60, 30});
            QTest::mouseMove(dock, end());
            QTest::mouseRelease(dock, Qt::LeftButton, {}, end());
        };
        drag("formulaDock", {300, 500});
        action(*window, "compareWorkspace")->trigger();
        action(*window, "stepWorkspace")->trigger();
        drag("columnsDock", {700, 150});
        goTo(*window, "compareWorkspace");
        QCOMPARE(current(*window), u"compareWorkspace"_s);
        QDockWidget *dock = dockNamed(*window, "hardCasesDock");
        QTest::mousePress(dock, Qt::LeftButton, {}, {40, 8});
        QTest::mouseMove(dock, {60, 30});
        QTest::mouseMove(dock, {200, 100});
        goTo(*window, "measureWorkspace");
        QTest::mouseRelease(dock, Qt::LeftButton, {}, {200, 100});
        goTo(*window, "compareWorkspace");
        QCOMPARE(window->size(), QSize(1016, 600));
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestWorkspaces)

} // namespace tst_workspaces

#include "tst_workspaces.moc"
