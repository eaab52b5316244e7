// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/nextpixel.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/inspect/columntable.h"
#include "widgets/inspect/predictpanel.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

#include <QTest>
#include <QtWidgets>

namespace tst_predictkeys {

using namespace pixelplumb;

/// Predict without a mouse.
class TestPredictKeys : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_settings.clear();
        m_window = openedWindow();
        m_playhead = m_window->parts().playhead;
    }
    void cleanup() { m_window.reset(); }

    void theKeyOfADockGivesItsContentTheFocus_data()
    {
        QTest::addColumn<QString>("dock");
        QTest::addColumn<QString>("field"); // empty: any field inside the dock
        QTest::newRow("predict") << "predictDock"
                                 << "predictAnswer";
        QTest::newRow("primitives") << "primitivesDock"
                                    << "primitivesTree";
        QTest::newRow("compare") << "compareDock"
                                 << "";
        QTest::newRow("hard cases") << "hardCasesDock"
                                    << "";
        QTest::newRow("this method") << "methodDock"
                                     << "";
    }
    void theKeyOfADockGivesItsContentTheFocus()
    {
        QFETCH(QString, dock);
        QFETCH(QString, field);
        pressKeyOf(dock);
        QTRY_VERIFY(named<QDockWidget>(*m_window, qPrintable(dock))->isVisible());
        const QWidget *focus = QApplication::focusWidget();
        QVERIFY(focus);
        QVERIFY(named<QDockWidget>(*m_window, qPrintable(dock))->isAncestorOf(focus));
        if (!field.isEmpty())
            QCOMPARE(focus->objectName(), field);
    }

    void aMenusEntryLeavesTheFocusWhereItIs()
    {
        m_window->parts().canvas->setFocus();
        action(*m_window, "methodDockToggle")->trigger();
        QTRY_VERIFY(named<QDockWidget>(*m_window, "methodDock")->isVisible());
        QVERIFY(m_window->parts().canvas->hasFocus());
    }

    /// On the canvas a digit would choose a method, and Space would play.
    void predictIsInTheMenuOfStepsAndAsksAtOnce()
    {
        m_window->parts().canvas->setFocus();
        QAction *toggle = action(*m_window, "predictDockToggle");
        QVERIFY(named<QMenu>(*m_window, "stepMenu")->actions().contains(toggle));
        toggle->trigger();
        QTRY_COMPARE(QApplication::focusWidget(),
                     static_cast<QWidget *>(named<QLineEdit>(*m_window, "predictAnswer")));
    }

    void whatIsTypedAfterTheKeyIsTheAnswer()
    {
        const std::string method = m_window->parts().document->scene().method;
        pressKeyOf(u"predictDock"_s);
        QTest::keyClicks(QApplication::focusWidget(), u"1000"_s);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QVERIFY(named<QLabel>(*m_window, "predictVerdict")->text().startsWith(u"Not yet"));
        QCOMPARE(m_window->parts().document->scene().method, method);
        QVERIFY(m_window->parts().document->pendingVertices().empty());
    }

    void theNextPixelIsTyped()
    {
        pressKeyOf(u"predictDock"_s);
        askForPixel();
        QVERIFY(line()->isEnabled());
        QCOMPARE(line()->placeholderText(), u"x, y"_s);
        line()->setFocus();
        const NextPixel next = *nextPixelAfter(*m_playhead->traced(), m_playhead->position());

        type(u"%1 %2"_s.arg(next.pixel.x() + 1).arg(next.pixel.y()));
        QVERIFY(verdict().startsWith(u"Not "));
        QVERIFY(!m_playhead->isPlaying()); // the answer field keeps the space
        type(u"here"_s);
        QVERIFY(verdict().contains(u"12, 7"_s));
        type(u"%1, %2"_s.arg(next.pixel.x()).arg(next.pixel.y()));
        QVERIFY(verdict().startsWith(u"Right"));

        QTest::keyClick(line(), Qt::Key_Return); // continues
        QCOMPARE(m_playhead->currentPixel(), std::optional(next.pixel));
        QVERIFY(line()->hasFocus());
    }

    void anAnswerGoesOnToItsColumnPastTheSetUp()
    {
        pressKeyOf(u"predictDock"_s);
        m_playhead->seek(0);
        type(u"0"_s);
        named<QAbstractButton>(*m_window, "predictShow")->click();
        QTest::keyClick(line(), Qt::Key_Return);
        QCOMPARE(m_playhead->currentSpan(), std::optional(std::size_t(0)));
    }

    /// A user who steps on, reads the number and steps back is asked again but gets no credit; nor
    /// is the same question a new one at the next pixel of the span.
    void aStepThatWasDoneAlreadyIsNotForetold()
    {
        const auto value = [this] {
            return toText(
                predictionsAfter(*m_playhead->traced(), m_playhead->position()).front().value);
        };
        const auto score = [this] { return named<QLabel>(*m_window, "predictScore")->text(); };
        pressKeyOf(u"predictDock"_s);
        m_playhead->seek(1); // the set-up is done
        m_playhead->step(StepUnit::Span, StepDirection::Forward);
        m_playhead->step(StepUnit::Span, StepDirection::Backward);

        QVERIFY(verdict().contains(u"has already been shown"_s));
        type(value());
        QVERIFY(verdict().startsWith(u"Right"_s));
        QCOMPARE(score(), QString());

        m_playhead->step(StepUnit::Span, StepDirection::Forward);
        type(value());
        QCOMPARE(score(), u"Right at the first try: 1 of 1"_s);
        m_playhead->step(StepUnit::Sample, StepDirection::Forward);
        type(value());
        QCOMPARE(score(), u"Right at the first try: 1 of 1"_s);
    }

    /// Nor does the user get credit if another setting traces the same columns again, or an edit is
    /// undone.
    void aStepThatWasDoneUnderOtherSettingsIsNotForetold()
    {
        SceneDocument &document = *m_window->parts().document;
        const auto isSeen = [this] { return verdict().contains(u"has already been shown"_s); };
        pressKeyOf(u"predictDock"_s);
        m_playhead->seek(m_playhead->end());
        m_playhead->seek(0);
        QVERIFY(isSeen());

        ScanSettings settings = document.scene().settings;
        settings.rounding = ByteRounding::Truncate;
        document.setSettings(settings);
        QTRY_VERIFY(m_playhead->traced()->scene.settings == settings);
        QVERIFY(isSeen());

        Triangle moved = document.scene().triangles[0];
        moved.vertices[0].position.y += unitsPerPixel;
        document.setTriangle(0, moved, {});
        QTRY_VERIFY(m_playhead->traced()->scene.triangles[0] == moved);
        QVERIFY(!isSeen());
        document.undoStack()->undo();
        QTRY_VERIFY(!(m_playhead->traced()->scene.triangles[0] == moved));
        QVERIFY(isSeen());
    }

    void theNextPixelsTestsAreTheReasonForIt()
    {
        Scene scene = m_window->parts().document->scene();
        const auto reasonBy = [&scene](const char *method) {
            scene.method = method;
            return nextPixelAfter(*traceScene(scene), 0)->reason;
        };
        // At the vertex (4, 5) two edge functions are 0.
        QVERIFY2(reasonBy("edge-equations").startsWith(u"E₀ = 0, E₁ = "_s)
                     && reasonBy("edge-equations").endsWith(u"E₂ = 0: none is negative."),
                 qPrintable(reasonBy("edge-equations")));
        QVERIFY2(reasonBy("column-scan").contains(u"cover"), qPrintable(reasonBy("column-scan")));
    }

    /// A triangle drawn while its numbers are to be predicted is not scanned at once.
    void aNewTriangleIsForetoldFromItsFirstColumn()
    {
        pressKeyOf(u"predictDock"_s);
        Triangle triangle = m_window->parts().document->scene().triangles[0];
        for (Vertex &vertex : triangle.vertices)
            vertex.position.x += unitsPerPixel;
        m_window->parts().document->addTriangle(triangle);

        QTRY_COMPARE(m_playhead->traced()->primitives.size(), std::size_t(2));
        const ScanTrace &trace = *m_playhead->traced()->trace;
        QCOMPARE(m_playhead->position(), trace.indexOfSetUp(1));
        const auto first = predictionsAfter(*m_playhead->traced(), m_playhead->position()).front();
        QCOMPARE(first.step, trace.indexOfSpan(trace.firstSpanOf(1)));
        type(toText(first.value));
        QCOMPARE(named<QLabel>(*m_window, "predictScore")->text(),
                 u"Right at the first try: 1 of 1"_s);
    }

    void theButtonsHaveKeys()
    {
        for (const char *name : {"predictCheck", "predictShow", "predictNext"})
            QVERIFY2(!named<QPushButton>(*m_window, name)->shortcut().isEmpty(), name);
    }

private:
    void pressKeyOf(const QString &dock)
    {
        const QKeyCombination key
            = action(*m_window, qPrintable(dock + u"Toggle"_s))->shortcut()[0];
        QTest::keyClick(m_window.get(), key.key(), key.keyboardModifiers());
    }
    void askForPixel()
    {
        auto *choice = named<QComboBox>(*m_window, "predictChoice");
        choice->setCurrentIndex(choice->count() - 1);
    }
    void type(const QString &text)
    {
        line()->clear();
        QTest::keyClicks(line(), text);
        QTest::keyClick(line(), Qt::Key_Return);
    }
    static QString plain(const QString &html)
    {
        QTextDocument document;
        document.setHtml(html);
        return document.toPlainText();
    }
    QString verdict() { return plain(named<QLabel>(*m_window, "predictVerdict")->text()); }
    QLineEdit *line() { return named<QLineEdit>(*m_window, "predictAnswer"); }

    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
    Playhead *m_playhead = nullptr;
};

PIXELPLUMB_TEST(TestPredictKeys)

} // namespace tst_predictkeys

#include "tst_predictkeys.moc"
