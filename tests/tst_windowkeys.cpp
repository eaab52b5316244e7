// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"

#include <QTest>

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

    void f9StopsTheRunAtTheColumnInHand()
    {
        const auto window = openedWindow();
        const Playhead &playhead = *window->parts().playhead;
        QTest::keyClick(window.get(), Qt::Key_F9);
        window->parts().playhead->seek(0);
        QTest::keyClick(window.get(), Qt::Key_F5);

        QCOMPARE(playhead.columnXInHand(), std::optional<std::int64_t>(27));
        QVERIFY(!playhead.pixelInHand());
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

private:
    IsolatedSettings m_settings;
};

QTEST_MAIN(TestWindowKeys)
#include "tst_windowkeys.moc"
