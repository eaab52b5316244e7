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
        action(*m_window, "predictDockToggle")->trigger();
        QTRY_VERIFY(named<PredictPanel>(*m_window, "predict")->isVisible());
        QVERIFY(m_window->parts().canvas->hasFocus());
    }

    void whatIsTypedAfterTheKeyIsTheAnswer()
    {
        const std::string method = m_window->parts().document->scene().method;
        pressKeyOf(QStringLiteral("predictDock"));
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("1000"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QVERIFY(named<QLabel>(*m_window, "predictVerdict")->text().startsWith(u"Not yet"));
        QCOMPARE(m_window->parts().document->scene().method, method);
        QVERIFY(m_window->parts().document->pendingVertices().empty());
    }

    void theNextPixelIsTyped()
    {
        pressKeyOf(QStringLiteral("predictDock"));
        askForPixel();
        QVERIFY(line()->isEnabled());
        QCOMPARE(line()->placeholderText(), QStringLiteral("x, y"));
        line()->setFocus();
        const NextPixel next = *nextPixelAfter(*m_playhead->traced(), m_playhead->position());

        type(QStringLiteral("%1 %2").arg(next.pixel.x() + 1).arg(next.pixel.y()));
        QVERIFY(verdict().startsWith(u"Not "));
        QVERIFY(!m_playhead->isPlaying()); // the answer field keeps the space
        type(QStringLiteral("here"));
        QVERIFY(verdict().contains(QStringLiteral("12, 7")));
        type(QStringLiteral("%1, %2").arg(next.pixel.x()).arg(next.pixel.y()));
        QVERIFY(verdict().startsWith(u"Right"));

        QTest::keyClick(line(), Qt::Key_Return); // continues
        QCOMPARE(m_playhead->currentPixel(), std::optional(next.pixel));
        QVERIFY(line()->hasFocus());
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
        pressKeyOf(QStringLiteral("predictDock"));
        m_playhead->seek(0);
        m_playhead->step(StepUnit::Span, StepDirection::Forward);
        m_playhead->step(StepUnit::Span, StepDirection::Backward);

        QVERIFY(verdict().contains(QStringLiteral("has been seen")));
        type(value());
        QVERIFY(verdict().startsWith(QStringLiteral("Right")));
        QCOMPARE(score(), QString());

        m_playhead->step(StepUnit::Span, StepDirection::Forward);
        type(value());
        QCOMPARE(score(), QStringLiteral("Right at the first try: 1 of 1"));
        m_playhead->step(StepUnit::Sample, StepDirection::Forward);
        type(value());
        QCOMPARE(score(), QStringLiteral("Right at the first try: 1 of 1"));
    }

    /// Nor does the user get credit if another setting traces the same columns again, or an edit is
    /// undone.
    void aStepThatWasDoneUnderOtherSettingsIsNotForetold()
    {
        SceneDocument &document = *m_window->parts().document;
        const auto isSeen = [this] { return verdict().contains(QStringLiteral("has been seen")); };
        pressKeyOf(QStringLiteral("predictDock"));
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
        QVERIFY2(reasonBy("edge-equations").startsWith(QStringLiteral("E₀ = 0, E₁ = "))
                     && reasonBy("edge-equations").endsWith(u"E₂ = 0: none is negative."),
                 qPrintable(reasonBy("edge-equations")));
        QVERIFY2(reasonBy("column-scan").contains(u"cover"), qPrintable(reasonBy("column-scan")));
    }

    /// A triangle drawn while its numbers are to be predicted is not scanned at once.
    void aNewTriangleIsForetoldFromItsFirstColumn()
    {
        pressKeyOf(QStringLiteral("predictDock"));
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
                 QStringLiteral("Right at the first try: 1 of 1"));
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
            = action(*m_window, qPrintable(dock + QStringLiteral("Toggle")))->shortcut()[0];
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
