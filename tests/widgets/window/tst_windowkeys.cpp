// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/dialogs/manual.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/menuaction.h"
#include "widgets/model/playhead.h"
#include "widgets/window/menus.h"

#include <QTest>
#include <QtWidgets>

namespace tst_windowkeys {

using namespace pixelplumb;

/// The keys that step, and those that belong to the canvas alone.
class TestWindowKeys : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void theFunctionKeysMoveTimeAndUndoEachOther()
    {
        const auto window = openedWindow();
        const Playhead &playhead = *window->parts().playhead;
        const std::size_t start = playhead.position();
        for (const int key : {Qt::Key_F10, Qt::Key_F11}) {
            QTest::keyClick(window.get(), Qt::Key(key));
            QVERIFY(playhead.position() > start);
            QTest::keyClick(window.get(), Qt::Key(key), Qt::ShiftModifier);
            QCOMPARE(playhead.position(), start);
        }
        QTest::keyClick(window.get(), Qt::Key_F5);
        QCOMPARE(playhead.position(), playhead.end());
        QTest::keyClick(window.get(), Qt::Key_F5, Qt::ShiftModifier);
        QCOMPARE(playhead.position(), std::size_t(0));
    }

    void f9StopsTheRunAtTheCurrentColumn()
    {
        const auto window = openedWindow();
        const Playhead &playhead = *window->parts().playhead;
        const std::optional<std::int64_t> column = playhead.currentColumnX();
        QTest::keyClick(window.get(), Qt::Key_F9);
        window->parts().playhead->seek(0);
        QTest::keyClick(window.get(), Qt::Key_F5);

        QCOMPARE(playhead.currentColumnX(), column);
        QVERIFY(!playhead.currentPixel());
    }

    void letterKeysActOnlyInTheCanvas()
    {
        const auto window = openedWindow();
        const DisplayOptions &options = *window->parts().options;
        const bool shown = options.isGridShown();
        QTest::keyClick(window->parts().canvas, Qt::Key_G);
        QCOMPARE(options.isGridShown(), !shown);

        QWidget *table = named<QWidget>(*window, "columnTable");
        table->setFocus();
        QTest::keyClick(table, Qt::Key_G);
        QCOMPARE(options.isGridShown(), !shown);
    }

    void aPanelsKeyClosesItOnlyWhereItHasTheFocus()
    {
        const auto window = openedWindow();
        const auto *dock = named<QDockWidget>(*window, "columnsDock");
        const QKeySequence key = named<QAction>(*window, "columnsDockToggle")->shortcut();
        QVERIFY(dock->isVisible());
        window->parts().canvas->setFocus();

        QTest::keySequence(window.get(), key);
        QVERIFY(dock->isVisible());
        QVERIFY(dock->isAncestorOf(QApplication::focusWidget()));

        QTest::keySequence(window.get(), key);
        QVERIFY(dock->isHidden());
        QVERIFY(window->parts().canvas->hasFocus());
    }

    void spacePlaysFromEverywhereButWhereItMeansSomethingElse()
    {
        const auto window = openedWindow();
        Playhead &playhead = *window->parts().playhead;
        for (const char *name : {"canvas", "columnTable", "pixelGrid", "scrubber"}) {
            auto *part = named<QWidget>(*window, name);
            part->setFocus();
            QTest::keyClick(part, Qt::Key_Space);
            QVERIFY2(playhead.isPlaying(), name);
            QTest::keyClick(part, Qt::Key_Space);
            QVERIFY2(!playhead.isPlaying(), name);
        }
        auto *next = named<QAbstractButton>(*window, "nextColumnButton");
        next->setFocus(Qt::TabFocusReason);
        const std::size_t position = playhead.position();
        QTest::keyClick(next, Qt::Key_Space);
        QVERIFY(!playhead.isPlaying());
        QVERIFY(playhead.position() > position);

        auto *speed = named<QAbstractSpinBox>(*window, "speedBox");
        speed->setFocus();
        QTest::keyClick(speed, Qt::Key_Space);
        QVERIFY(!playhead.isPlaying());
    }

    void thePanelsOfAFloatingDockKeepSpaceForTheirButtons()
    {
        const auto window = openedWindow();
        auto *dock = named<QDockWidget>(*window, "columnsDock");
        dock->setFloating(true);
        auto *toggle = named<QAbstractButton>(*window, "showExactButton");
        toggle->setFocus();
        QKeyEvent press(QEvent::ShortcutOverride, Qt::Key_Space, Qt::NoModifier, " ");
        press.ignore();
        QApplication::sendEvent(dock, &press);
        QCOMPARE(press.isAccepted(), QApplication::focusWidget() == toggle);
    }

    void theWheelChangesNoBoxThatHasNotTheFocus()
    {
        const auto window = openedWindow();
        auto *methods = named<QComboBox>(*window, "methodBox");
        auto *speed = named<QAbstractSpinBox>(*window, "speedBox");
        const auto turn = [](QWidget *box) {
            const QPointF middle = box->rect().center();
            QWheelEvent wheel(middle, box->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(box, &wheel);
        };
        const QString before = methods->currentText() + speed->text();
        turn(methods);
        turn(speed);
        QCOMPARE(methods->currentText() + speed->text(), before);
        // Nor does the wheel focus them.
        QCOMPARE(methods->focusPolicy() & Qt::WheelFocus, Qt::StrongFocus);

        speed->setFocus();
        turn(speed);
        QVERIFY(methods->currentText() + speed->text() != before);
    }

    /// The menu shows what Undo would revert, because users look for it there.
    void listsOfKeysCallUndoByItsName()
    {
        const auto window = openedWindow();
        action(*window, "drawTool")->trigger();
        clickPixel(*window, {12, 40});
        QCOMPARE(withoutMnemonic(action(*window, "undo")->text()), "Undo place vertex");

        const auto *help = named<HelpMenu>(*window, "helpMenu");
        QVERIFY(keySheetHtml(help->menus()).contains("<td>Undo</td>"));
        QVERIFY(!keySheetHtml(help->menus()).contains("Undo place vertex"));
        QTest::keyClick(window->parts().canvas, Qt::Key_Escape);
        QVERIFY(keySheetHtml(help->menus()).contains("<td>Undo</td>"));
    }

    void pAndVChooseTheToolInTheCanvas()
    {
        const auto window = openedWindow();
        Canvas *canvas = window->parts().canvas;
        QVERIFY(action(*window, "inspectTool")->isChecked());
        QTest::keyClick(canvas, Qt::Key_P);
        QVERIFY(action(*window, "drawTool")->isChecked());
        QTest::keyClick(canvas, Qt::Key_V);
        QVERIFY(canvas->tool() == CanvasTool::Inspect);
        QVERIFY(action(*window, "inspectTool")->isChecked());
        QVERIFY(!action(*window, "drawTool")->isChecked());
        clickPixel(*window, {12, 40});
        QCOMPARE(window->parts().playhead->pickedPixel(), std::optional(QPoint(12, 40)));
        QVERIFY(!window->isWindowModified());

        QTest::keyClick(canvas, Qt::Key_P);
        clickPixel(*window, {12, 40});
        QVERIFY(window->isWindowModified());
        QTest::keyClick(canvas, Qt::Key_Escape);
        QVERIFY(!window->isWindowModified());

        QWidget *table = named<QWidget>(*window, "columnTable");
        table->setFocus();
        QTest::keyClick(table, Qt::Key_V);
        QVERIFY(canvas->tool() == CanvasTool::Inspect);
        QTest::keyClick(table, Qt::Key_P);
        QVERIFY(canvas->tool() == CanvasTool::Draw);
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestWindowKeys)

} // namespace tst_windowkeys

#include "tst_windowkeys.moc"
