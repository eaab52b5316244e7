// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/dialogs/manual.h"
#include "widgets/window/panels.h"

#include <QTest>
#include <QtWidgets>

namespace tst_manual {

using namespace pixelplumb;

/// The manual is part of the program: each page has its text, and links lead from page to page.
class TestManual : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_settings.clear();
        m_window = openedWindow();
        QTest::keyClick(m_window->parts().canvas, Qt::Key_F1);
        m_pages = named<QListWidget>(*m_window, "manualPages");
        m_text = named<QTextBrowser>(*m_window, "manualText");
    }
    void cleanup() { m_window.reset(); }

    void everyPageHasItsText()
    {
        QVERIFY(m_pages->count() > 6);
        for (int page = 0; page < m_pages->count(); ++page) {
            m_pages->setCurrentRow(page);
            QVERIFY2(m_text->toPlainText().size() > 500, qPrintable(m_pages->item(page)->text()));
        }
    }

    void everyHeadOfATableIsBold()
    {
        int tables = 0;
        for (int page = 0; page < m_pages->count(); ++page) {
            m_pages->setCurrentRow(page);
            for (QTextFrame *frame : m_text->document()->rootFrame()->childFrames()) {
                const auto *table = qobject_cast<QTextTable *>(frame);
                if (!table || m_pages->item(page)->text() == u"Keys and mouse"_s)
                    continue;
                ++tables;
                for (int column = 0; column < table->columns(); ++column) {
                    const QTextCursor head = table->cellAt(0, column).firstCursorPosition();
                    QVERIFY2(
                        head.block().text().isEmpty()
                            || head.block().begin().fragment().charFormat().fontWeight()
                                >= QFont::DemiBold,
                        qPrintable(m_pages->item(page)->text() + u": "_s + head.block().text()));
                    QCOMPARE(table->cellAt(0, column).lastCursorPosition().block(), head.block());
                }
            }
        }
        QVERIFY(tables > 0);
    }

    void noPageNamesATestOfTheSourceTree()
    {
        for (int page = 0; page < m_pages->count(); ++page) {
            m_pages->setCurrentRow(page);
            if (m_pages->item(page)->text() != u"Proofs"_s)
                QVERIFY2(!m_text->toPlainText().contains(u"tst_"_s),
                         qPrintable(m_pages->item(page)->text()));
        }
    }

    void theFirstPageIsOfTheAssignmentAndEveryPanelIsExplained()
    {
        QVERIFY(m_text->toPlainText().contains(u"⌈y_B⌉"_s));
        m_pages->setCurrentRow(1);
        for (const Panel &panel : panels()) {
            const auto *toggle
                = action(*m_window, qPrintable(QLatin1String(panel.dock) + u"Toggle"_s));
            QVERIFY2(m_text->toPlainText().contains(toggle->shortcut().toString()), panel.dock);
        }
    }

    /// Qt begins a table just behind a code block with an empty line.
    void theHeadingsOfTablesAreBoldLines()
    {
        int tables = 0;
        for (int page = 0; page < m_pages->count(); ++page) {
            m_pages->setCurrentRow(page);
            if (m_text->toMarkdown().isEmpty() || page == 1 || page == 2)
                continue; // made from the window
            for (QTextFrame *frame : m_text->document()->rootFrame()->childFrames()) {
                const auto *table = qobject_cast<QTextTable *>(frame);
                if (!table)
                    continue;
                ++tables;
                const QTextTableCell heading = table->cellAt(0, 0);
                const QTextCursor end = heading.lastCursorPosition();
                QCOMPARE(heading.firstCursorPosition().block(), end.block());
                QVERIFY2(end.position() == heading.firstPosition()
                             || end.charFormat().fontWeight() >= QFont::Bold,
                         qPrintable(end.block().text()));
            }
        }
        QVERIFY(tables > 10);
    }

    void aLinkGoesToItsPage()
    {
        emit m_text->anchorClicked(QUrl(u"scene-file.md"_s));
        QCOMPARE(m_pages->currentItem()->text(), u"Scene files"_s);
        const QString before = m_text->toPlainText();
        emit m_text->anchorClicked(QUrl(u"https://example.org/"_s));
        QCOMPARE(m_text->toPlainText(), before);
    }

private:
    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
    QListWidget *m_pages = nullptr;
    QTextBrowser *m_text = nullptr;
};

PIXELPLUMB_TEST(TestManual)

} // namespace tst_manual

#include "tst_manual.moc"
