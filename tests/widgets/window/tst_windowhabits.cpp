// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/colours.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/files/scenefiles.h"
#include "widgets/look/messagebar.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

#include <QTest>
#include <QtWidgets>

namespace tst_windowhabits {

using namespace pixelplumb;

namespace {

Scene lineWithTwoVariants()
{
    Scene scene = sceneOf(lineAt(20, 41, 30, 44), "line-bresenham", frameOf(64, 48));
    scene.settings.variants = VariantSet().with(Variant::StayAtZero).with(Variant::OneStepShort);
    return scene;
}

/// Whether a marked line of the pseudocode reaches outside the visible part; the marks are counted.
bool isMarkOutOfView(const QTextBrowser &text, int &marks)
{
    const int top = text.verticalScrollBar()->value();
    const auto &document = *text.document();
    bool isOut = false;
    for (QTextCursor mark = document.find(u"▶"_s); !mark.isNull();
         mark = document.find(u"▶"_s, mark)) {
        const QRectF line = document.documentLayout()->blockBoundingRect(mark.block());
        isOut = isOut || line.top() < top || line.bottom() > top + text.viewport()->height();
        ++marks;
    }
    return isOut;
}

} // namespace

/// What a user expects of the window as a whole.
class TestWindowHabits : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void aLetterInAnOpenMenuChoosesItsEntry()
    {
        const auto window = openedWindow();
        SceneDocument &document = *window->parts().document;
        document.selectVertex(VertexRef{0, 0});
        const QAction *differences = action(*window, "showDifferences");
        QVERIFY(differences->shortcut() == QKeySequence(Qt::Key_D));
        const bool wereMarked = differences->isChecked();
        auto *menu = named<QMenu>(*window, "editMenu");
        menu->popup(window->mapToGlobal(QPoint(40, 40)));
        QVERIFY(QTest::qWaitForWindowExposed(menu));

        QTest::keyClick(menu, Qt::Key_D); // "Delete the selected primitive"

        QCOMPARE(document.primitiveCount(), 0);
        QCOMPARE(differences->isChecked(), wereMarked);
        QVERIFY(!menu->isVisible());
    }

    void aLetterThatNoEntryHasDoesNothing()
    {
        const auto window = openedWindow();
        const QAction *differences = action(*window, "showDifferences");
        const bool wereMarked = differences->isChecked();
        QTest::keyClick(window.get(), Qt::Key_F,
                        Qt::AltModifier); // through its menu bar, which receives the keys
        auto *menu = named<QMenu>(*window, "fileMenu");
        QTRY_COMPARE(QApplication::activePopupWidget(), menu);

        for (const Qt::Key key : {Qt::Key_D, Qt::Key_G, Qt::Key_2, Qt::Key_Delete})
            QTest::keyClick(menu, key);

        QCOMPARE(differences->isChecked(), wereMarked);
        QCOMPARE(window->parts().document->primitiveCount(), 1);
        QCOMPARE(window->parts().document->scene().method, std::string("column-scan"));
        QVERIFY(menu->isVisible());
        QTest::keyClick(menu, Qt::Key_Escape);
        QVERIFY(!menu->isVisible());
    }

    void aRefusalOutlastsTheKeyThatCausedIt()
    {
        Scene scene = lineWithTwoVariants();
        scene.method = "stroke-coverage";
        scene.settings.variants = {};
        scene.settings.fillRule = FillRule::Closed;
        scene.appearance.antialiasing = Antialiasing::Area;
        const auto window = openedWindow(scene);
        auto *methods = named<QComboBox>(*window, "methodBox");
        const int bresenham = methods->findData(u"line-bresenham"_s);
        QVERIFY(bresenham >= 0);
        methods->setFocus();
        methods->showPopup();
        QAbstractItemView *list = methods->view();
        QVERIFY(QTest::qWaitForWindowExposed(list->window()));
        list->setCurrentIndex(list->model()->index(bresenham, 0));
        QTest::keyClick(list, Qt::Key_Return);
        QCOMPARE(window->parts().document->scene().method, std::string("line-bresenham"));

        const auto *bar = named<MessageBar>(*window, "messageBar");
        QTRY_VERIFY(bar->isVisible());
        QTest::qWait(50);
        QVERIFY(bar->isVisible());
        QVERIFY2(bar->text().contains(u"antialiasing"_s), qPrintable(bar->text()));
        QTest::keyClick(window->parts().canvas, Qt::Key_Right);
        QVERIFY(!bar->isVisible());
    }

    void noTwoEntriesOfAMenuHaveOneLetter()
    {
        const auto window = openedWindow();
        for (const char *name : {"editMenu", "fileMenu"}) {
            QString letters;
            for (const QAction *entry : named<QMenu>(*window, name)->actions()) {
                const qsizetype mark = entry->text().indexOf(u'&');
                if (mark >= 0)
                    letters += entry->text()[mark + 1].toLower();
            }
            for (const QChar letter : letters)
                QVERIFY2(letters.count(letter) == 1, qPrintable(name + (u' ' + letters)));
        }
    }

    void theStatusBarTellsOfThePixelThatKeysHavePicked()
    {
        const auto window = openedWindow();
        const auto *field = named<QLabel>(*window, "statusPixel");
        clickPixel(*window, {22, 18});
        action(*window, "inspectTool")->trigger();
        clickPixel(*window, {22, 18});
        QVERIFY(field->text().startsWith(u"pixel (22, 18)"_s));
        Canvas *canvas = window->parts().canvas;
        QTest::keyClick(canvas, Qt::Key_Left);
        QTest::keyClick(canvas, Qt::Key_Left);
        QTest::keyClick(canvas, Qt::Key_Up);

        QCOMPARE(window->parts().playhead->pickedPixel(), std::optional(QPoint(20, 19)));
        QVERIFY2(field->text().startsWith(u"pixel (20, 19)"_s), qPrintable(field->text()));
    }

    void theLinesOfTheCurrentMethodAreInView()
    {
        const auto window = openedWindow(lineWithTwoVariants());
        window->resize(1366, 768);
        action(*window, "methodDockToggle")->trigger();
        const auto *text = named<QTextBrowser>(*window, "methodText");
        QTRY_VERIFY(text->isVisible());
        QVERIFY(text->verticalScrollBar()->maximum() > 0); // otherwise nothing is tested
        action(*window, "runToStart")->trigger();
        action(*window, "nextPixel")->trigger(); // the set-up, whose lines are more than fit
        int marks = 0;
        bool hasScrolled = false;
        for (int step = 0; step < 12; ++step) {
            action(*window, "nextPixel")->trigger();
            QVERIFY2(!isMarkOutOfView(*text, marks), qPrintable(QString::number(step)));
            hasScrolled = hasScrolled || text->verticalScrollBar()->value() > 0;
        }
        QVERIFY(marks > 12);
        QVERIFY(hasScrolled);
    }

    void theFormulasOfEachColumnAreWhollySeenInALowWindow()
    {
        Scene scene;
        scene.frame = frameOf(24, 24);
        scene.triangles = {{{{{latticePixel(3, 4), red},
                              {latticePixel(20, 7), green},
                              {latticePixel(8, 21), blue}}}}};
        const auto window = openedWindow(scene);
        window->resize(1366, 740); // 768 minus a title bar
        action(*window, "resetLayout")->trigger();
        const auto *formulas = named<QTextBrowser>(*window, "formulaText");
        action(*window, "runToStart")->trigger();
        for (int column = 0; column < 17; ++column) {
            action(*window, "nextColumn")->trigger();
            QTRY_VERIFY2(!formulas->verticalScrollBar()->isVisible(),
                         qPrintable(formulas->toPlainText()));
        }
    }

    void escapeBringsTheKeysOfTheCanvasBack_data()
    {
        QTest::addColumn<QString>("toggle");
        QTest::addColumn<QString>("part");
        QTest::newRow("this method") << "methodDockToggle"
                                     << "methodText";
        QTest::newRow("primitives") << "primitivesDockToggle"
                                    << "primitivesTree";
        QTest::newRow("columns") << ""
                                 << "columnTable";
        QTest::newRow("method box") << ""
                                    << "methodBox";
        QTest::newRow("speed") << ""
                               << "speedBox";
        QTest::newRow("motion") << "motionDockToggle"
                                << "motionX";
        QTest::newRow("predict") << "predictDockToggle"
                                 << "predictAnswer";
    }
    void escapeBringsTheKeysOfTheCanvasBack()
    {
        QFETCH(QString, toggle);
        QFETCH(QString, part);
        const auto window = openedWindow();
        if (!toggle.isEmpty())
            action(*window, qPrintable(toggle))->trigger();
        auto *focus = named<QWidget>(*window, qPrintable(part));
        focus->setFocus();
        QVERIFY(focus->hasFocus());

        QTest::keyClick(focus, Qt::Key_Escape);
        QVERIFY(window->parts().canvas->hasFocus());
        QTest::keyClick(window->parts().canvas, Qt::Key_2);
        QCOMPARE(window->parts().document->scene().method, methods()[1].id.toStdString());
    }

    void escapeInAFloatingPanelBringsTheFocusToTheCanvas()
    {
        const auto window = openedWindow();
        named<QDockWidget>(*window, "columnsDock")->setFloating(true);
        auto *table = named<QWidget>(*window, "columnTable");
        QTest::keyClick(table, Qt::Key_Escape);
        QCOMPARE(window->focusWidget(), window->parts().canvas);
    }

    void spacePlaysFromABoxInWhichAMethodWasChosen()
    {
        const auto window = openedWindow();
        auto *box = named<QComboBox>(*window, "methodBox");
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Down);
        QTest::keyClick(box, Qt::Key_Space);
        QVERIFY(window->parts().playhead->isPlaying());
        QVERIFY(!box->view()->isVisible());
    }

    void aClickWhereANoteLiesPlacesAVertex()
    {
        Scene scene;
        scene.frame = frameOf(64, 48);
        const auto window = openedWindow(scene);
        Canvas &canvas = *window->parts().canvas;
        MessageBar &bar = *window->parts().messageBar;
        canvas.setTool(CanvasTool::Draw);
        bar.complain(u"It lies over the canvas, and is as wide as this."_s);
        const QPoint onBar = bar.geometry().center();
        const std::optional<QPoint> pixel = canvas.pixelAt(onBar);
        QVERIFY(pixel);

        QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {},
                          canvas.mapTo(window.get(), onBar));
        QCOMPARE(window->parts().document->pendingVertices().size(), std::size_t(1));
        QCOMPARE(window->parts().document->pendingVertices().front().position,
                 latticePixel(pixel->x(), pixel->y()));
        QVERIFY(!bar.isVisible());

        bar.complain(u"Its own button is its own."_s);
        auto *close = named<QWidget>(*window, "closeMessage");
        QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {},
                          close->mapTo(window.get(), close->rect().center()));
        QVERIFY(!bar.isVisible());
        QCOMPARE(window->parts().document->pendingVertices().size(), std::size_t(1));
    }

    void aNoteGoesAtTheNextKey_data()
    {
        QTest::addColumn<int>("key");
        QTest::newRow("Escape") << int(Qt::Key_Escape);
        QTest::newRow("Space") << int(Qt::Key_Space);
        QTest::newRow("F10") << int(Qt::Key_F10);
        QTest::newRow("an arrow") << int(Qt::Key_Left);
    }
    void aNoteGoesAtTheNextKey()
    {
        QFETCH(int, key);
        const auto window = openedWindow();
        MessageBar &bar = *window->parts().messageBar;
        bar.complain(u"“abc” is no coordinate."_s);
        QCoreApplication::processEvents(); // the key that caused it is processed
        QTest::keyClick(window->parts().canvas, Qt::Key_Shift);
        QVERIFY(bar.isVisible());
        QTest::keyClick(window->parts().canvas, Qt::Key(key));
        QVERIFY(!bar.isVisible());
    }

    void aNoteThatIsGoneCanBeCopied()
    {
        const auto window = openedWindow();
        MessageBar &bar = *window->parts().messageBar;
        bar.complain(u"“abc” is no coordinate."_s);
        QCoreApplication::processEvents(); // the key that caused it is processed
        QTest::keyClick(window->parts().canvas, Qt::Key_Escape);
        QVERIFY(!bar.isVisible());

        action(*window, "copyNote")->trigger();
        QCOMPARE(QGuiApplication::clipboard()->text(), u"“abc” is no coordinate."_s);
    }

    void aNewDocumentIsRightAndSeenWhole()
    {
        const auto window = openedWindow(lineWithTwoVariants());
        Canvas &canvas = *window->parts().canvas;
        const int fitted = canvas.zoom();
        canvas.zoomIn();
        canvas.zoomIn();
        QVERIFY(canvas.zoom() != fitted);

        window->parts().files->newScene();
        QVERIFY(window->parts().document->scene().settings.variants.isEmpty());
        QCOMPARE(window->parts().document->scene().method, std::string("line-bresenham"));
        QCOMPARE(canvas.zoom(), fitted);
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestWindowHabits)

} // namespace tst_windowhabits

#include "tst_windowhabits.moc"
