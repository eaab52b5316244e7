// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/messagebar.h"
#include "widgets/model/playhead.h"

#include <QTest>
#include <QtWidgets>

#include <memory>

namespace tst_firststart {

using namespace pixelplumb;

/// What a student sees who starts the program for the first time on a screen of 1366 × 768.
class TestFirstStart : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_settings.clear();
        m_window = windowOf(QSize(1358, 728)); // the rest is the frame and the title bar
    }
    void cleanup() { m_window.reset(); }

    void theNumbersOfTheAssignmentAreInSightInEightRows()
    {
        QTRY_COMPARE(table().horizontalScrollBar()->maximum(), 0);
        const int rowHeight = table().verticalHeader()->defaultSectionSize();
        QTRY_VERIFY2(
            table().viewport()->height() >= 8 * rowHeight,
            qPrintable(
                u"%1 px for rows of %2 px"_s.arg(table().viewport()->height()).arg(rowHeight)));
        for (const char *title : {"x", "y_B", "y_T", "⌈y_B⌉", "⌊y_T⌋", "px", "ΔR", "ΔG", "ΔB",
                                  "first R", "first G", "first B"})
            QVERIFY2(shownTitles().contains(QString::fromUtf8(title)), title);
    }

    void aColumnsFormulasAreReadWholeOnASmallScreen_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1024 x 640") << QSize(1024, 640);
        QTest::newRow("in its frame") << QSize(1016, 600);
    }
    void aColumnsFormulasAreReadWholeOnASmallScreen()
    {
        QFETCH(QSize, size);
        m_window = windowOf(size);
        const auto *formulas
            = named<QWidget>(*m_window, "formulaPanel")->findChild<QTextBrowser *>();
        m_window->parts().playhead->step(StepUnit::Span, StepDirection::Forward);
        QVERIFY(formulas->toPlainText().contains(u"first row"_s)); // a column, and no pixel of it
        QVERIFY(formulas->toPlainText().contains(u"first C"_s));
        QTRY_COMPARE(formulas->verticalScrollBar()->maximum(), 0);
    }

    /// So that the column's formulas are read whole, too.
    void aSmallScreenShowsThemAllInThreeRows()
    {
        m_window = windowOf(QSize(1016, 600)); // of 1024 × 640
        QTRY_COMPARE(table().horizontalScrollBar()->maximum(), 0);
        const int rows = 3 * table().verticalHeader()->defaultSectionSize();
        QTRY_VERIFY2(table().viewport()->height() >= rows,
                     qPrintable(u"%1 px of %2 px"_s.arg(table().viewport()->height()).arg(rows)));
        QVERIFY(shownTitles().contains(u"first B"_s));
        QTRY_VERIFY(2 * m_window->parts().canvas->width() >= m_window->width() - 16);
    }

    void theLevelsAtTheEdgesAreOneClickAway()
    {
        QVERIFY(!shownTitles().contains(u"R_B"_s));
        named<QAction>(*m_window, "showEdgeColours")->trigger();
        QVERIFY(shownTitles().contains(u"R_B"_s));
    }

    void theCanvasHasHalfOfTheWidth()
    {
        QTRY_VERIFY(2 * m_window->parts().canvas->width() >= m_window->width());
    }

    void theKeysAreToldOnceUntilTheFirstKey()
    {
        MessageBar &bar = *m_window->parts().messageBar;
        m_window->greet();
        QVERIFY(bar.isVisible());
        for (const char *key : {"F10", "F11", "P", "V"})
            QVERIFY2(bar.text().contains(QLatin1String(key)), key);
        QCOMPARE(bar.text().count(u'\n'), 3);

        settle();
        QTest::keyClick(m_window->parts().canvas, Qt::Key_F10);
        QVERIFY(!bar.isVisible());
        m_window->greet();
        QVERIFY(!bar.isVisible());
    }

    void theKeysAreToldBesideTheTriangle_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1366 x 768") << QSize(1358, 728);
        QTest::newRow("2560 x 1440 at scale 2") << QSize(1272, 680);
        QTest::newRow("1024 x 640") << QSize(1016, 600);
    }
    void theKeysAreToldBesideTheTriangle()
    {
        QFETCH(QSize, size);
        m_window = windowOf(size);
        m_window->greet();
        const Canvas &canvas = *m_window->parts().canvas;
        const MessageBar &bar = *m_window->parts().messageBar;
        const auto covers = [&](const QPoint &pixel) {
            return bar.geometry().contains(canvas.positionOf(pixel).toPoint());
        };
        settle();
        QVERIFY(canvas.rect().contains(bar.geometry()));
        for (const QPoint pixel : {QPoint(4, 5), QPoint(58, 12), QPoint(26, 44), QPoint(28, 8)})
            QVERIFY2(!covers(pixel), qPrintable(u"(%1, %2)"_s.arg(pixel.x()).arg(pixel.y())));
        const bool isFree = canvas.positionOf(QPoint(0, 0)).x() > canvas.width() / 4.0;
        QVERIFY(!isFree || bar.geometry().right() < canvas.positionOf(QPoint(0, 0)).x());
    }

private:
    const QTableView &table() const { return *named<QTableView>(*m_window, "columnTable"); }

    QStringList shownTitles() const
    {
        QStringList titles;
        for (int column = 0; column < table().model()->columnCount(); ++column) {
            if (!table().isColumnHidden(column))
                titles += table().model()->headerData(column, Qt::Horizontal).toString();
        }
        return titles;
    }

    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
};

PIXELPLUMB_TEST(TestFirstStart)

} // namespace tst_firststart

#include "tst_firststart.moc"
