// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

#include <QTest>
#include <QtWidgets>

namespace tst_keyboardassignment {

using namespace pixelplumb;

namespace {

/// Reactivates the window after a dialog closes; without a window manager nothing else does.
void comeBack()
{
    for (QWidget *window : QApplication::topLevelWidgets()) {
        if (!QApplication::focusWidget() && qobject_cast<MainWindow *>(window))
            window->activateWindow();
    }
    QVERIFY(QTest::qWaitFor([] { return QApplication::focusWidget() != nullptr; }));
}

/// Sends a key to the widget in focus, as the keyboard does.
void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
{
    comeBack();
    QTest::keyClick(QApplication::focusWidget(), key, modifiers);
}

/// Types into the dialog that a key opens, and closes it with Enter.
void answerWith(const QString &text)
{
    comeBack(); // no dialog is open while this waits
    QTimer::singleShot(0, qApp, [text] {
        const auto currentField = [] {
            QWidget *dialog = QApplication::activeModalWidget();
            return dialog ? qobject_cast<QLineEdit *>(dialog->focusWidget()) : nullptr;
        };
        if (!QTest::qWaitFor([&] { return currentField() != nullptr; })) {
            delete QApplication::activeModalWidget(); // it would wait for ever
            QTest::qFail(qPrintable(text), __FILE__, __LINE__);
            return;
        }
        QLineEdit *field = currentField();
        const QPointer<QWidget> dialog = QApplication::activeModalWidget();
        QVERIFY(QTest::qWaitFor([&] {
            if (!dialog || !dialog->isVisible())
                return true;
            // A file dialog offers names in a list once its folder has been read; Enter would then
            // choose one of them.
            if (QWidget *names = QApplication::activePopupWidget())
                names->hide();
            if (field->text() != text) {
                field->selectAll();
                QTest::keyClicks(field, text);
            } else {
                QTest::keyClick(field, Qt::Key_Return);
            }
            return !dialog || !dialog->isVisible();
        }));
    });
}

void goTo(const QString &pixel)
{
    answerWith(pixel);
    press(Qt::Key_G, Qt::ControlModifier);
}

} // namespace

/// The assignment from the first vertex to the picture file, without a mouse.
class TestKeyboardAssignment : public QObject {
    Q_OBJECT

private slots:
    void theWholeAssignmentIsDoneByTheKeyboardAlone()
    {
        const QTemporaryDir folder;
        const auto window = openedWindow();
        const Playhead &playhead = *window->parts().playhead;
        const SceneDocument &document = *window->parts().document;

        // Three vertices: by numbers, by arrow keys, by numbers.
        press(Qt::Key_N, Qt::ControlModifier);
        QVERIFY(document.scene().triangles.empty());
        goTo("4, 5");
        press(Qt::Key_Return);
        for (int i = 0; i < 6; ++i)
            press(Qt::Key_Right);
        for (int i = 0; i < 3; ++i)
            press(Qt::Key_Up);
        press(Qt::Key_Return);
        QCOMPARE(document.pendingVertices().size(), std::size_t(2));
        goTo("6, 14");
        press(Qt::Key_Return);
        QCOMPARE(document.scene().triangles.size(), std::size_t(1));
        const auto &vertices = document.scene().triangles[0].vertices;
        QCOMPARE(vertices[0].position, latticePixel(4, 5));
        QCOMPARE(vertices[1].position, latticePixel(10, 8));
        QCOMPARE(vertices[2].position, latticePixel(6, 14));

        // Through all columns, and through all pixels.
        press(Qt::Key_F5, Qt::ShiftModifier);
        std::set<std::int64_t> columns;
        while (playhead.position() < playhead.end()) {
            press(Qt::Key_F10);
            if (const auto x = playhead.currentColumnX())
                columns.insert(*x);
        }
        QCOMPARE(columns, (std::set<std::int64_t>{4, 5, 6, 7, 8, 9, 10}));
        press(Qt::Key_F5, Qt::ShiftModifier);
        std::size_t pixels = 0;
        while (playhead.position() < playhead.end()) {
            press(Qt::Key_F11);
            pixels += playhead.currentPixel().has_value();
        }
        QCOMPARE(pixels, playhead.traced()->trace->sampleCount());

        // A pixel's history.
        goTo("6, 9");
        QCOMPARE(playhead.pickedPixel(), QPoint(6, 9));
        QVERIFY(named<QLabel>(*window, "pixelHistoryHeading")->text().contains("(6, 9)"));

        // The picture file.
        const QString path = folder.filePath("picture.png");
        answerWith(path);
        press(Qt::Key_E, Qt::ControlModifier);
        const QImage picture(path);
        QCOMPARE(picture.size(),
                 QSize(playhead.frame()->spec().width, playhead.frame()->spec().height));
        QVERIFY(picture.pixelColor(6, picture.height() - 1 - 9) != QColor(Qt::black));
    }

    void theKeysOfTheCanvasAreForTheSceneThatHasCome_data()
    {
        QTest::addColumn<QString>("action");
        QTest::newRow("a new one") << "newScene";
        QTest::newRow("the first one") << "openDefaultScene";
    }
    void theKeysOfTheCanvasAreForTheSceneThatHasCome()
    {
        QFETCH(QString, action);
        const auto window = openedWindow();
        named<QWidget>(*window, "columnTable")->setFocus();

        pixelplumb::action(*window, qPrintable(action))->trigger();

        QCOMPARE(QApplication::focusWidget(), window->parts().canvas);
        press(Qt::Key_2);
        QVERIFY(document(*window).scene().method != "column-scan");
    }

private:
    static SceneDocument &document(const MainWindow &window) { return *window.parts().document; }

    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestKeyboardAssignment)

} // namespace tst_keyboardassignment

#include "tst_keyboardassignment.moc"
