// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/formulaexplanation.h"
#include "tests/support/scenes/defaultscene.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/scenes/spacescenes.h"
#include "tests/support/testprogram.h"
#include "tests/support/tracedplayhead.h"
#include "widgets/inspect/formulapanel.h"
#include "widgets/look/numberformat.h"

#include <QTest>
#include <QtWidgets>

#include <algorithm>

namespace tst_panels {

using namespace pixelplumb;

namespace {

/// The text without the characters that prevent line breaks in numbers.
QString textOf(const QTextBrowser &browser) { return browser.toPlainText().remove(QChar(0x2060)); }

} // namespace

class TestPanels : public QObject {
    Q_OBJECT

private slots:
    void formulasNameTheNumbersOfTheStep()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Float32));
        FormulaPanel panel(&playhead);

        playhead.seekToSpan(std::size_t(rowOf(33)));

        const Explanation explanation = explainStep(*playhead.traced(), playhead.position() - 1);
        const QString text = textOf(*panel.findChild<QTextBrowser *>());
        QVERIFY(!explanation.lines.empty());
        for (const FormulaLine &line : explanation.lines) {
            QVERIFY2(text.contains(displayText(line.used)), qPrintable(line.symbols));
            if (!line.exact.isNone())
                QVERIFY2(text.contains(displayError(line.used, line.exact)),
                         qPrintable(line.symbols));
        }
        QVERIFY(panel.accessibleDescription().contains(explanation.sentence));
    }

    void theWayFromSpaceStandsWhereASolidsTriangleBegins()
    {
        TracedPlayhead playhead(sceneOf({triangle3({0, 0, 2}, {1, 0, -2}, {0, 1, 4.5})}));
        FormulaPanel panel(&playhead);
        const auto *browser = panel.findChild<QTextBrowser *>();

        playhead.seek(playhead.traced()->trace->indexOfSetUp(0) + 1);
        const Explanation explanation = explainStep(*playhead.traced(), playhead.position() - 1);
        const QString text = textOf(*browser);
        QCOMPARE(explanation.stages.front().stage, u"Vertex"_s);
        QCOMPARE(explanation.stages.back().stage, u"Lattice"_s);
        for (const StageFormulas &stage : explanation.stages) {
            QVERIFY2(text.contains(stage.stage), qPrintable(stage.stage));
            for (const FormulaLine &line : stage.lines) {
                QVERIFY2(text.contains(displayText(line.used)), qPrintable(line.symbols));
                if (!line.exact.isNone())
                    QVERIFY2(text.contains(displayError(line.used, line.exact)),
                             qPrintable(line.symbols));
            }
        }
        QVERIFY(panel.accessibleDescription().contains(u"Clip coordinates"_s));

        playhead.seekToSpan(0);
        QVERIFY(!browser->toPlainText().contains(u"Clip coordinates"_s));
    }

    void theChangeOfHalfIsAnEvent()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        FormulaPanel panel(&playhead);
        auto *heading = panel.findChild<QLabel *>(u"formulaHeading"_s);

        playhead.seekToSpan(std::size_t(rowOf(26)));
        QVERIFY(!heading->text().contains(u"⚑"_s));

        playhead.seekToSpan(std::size_t(rowOf(27)));
        QVERIFY(heading->text().contains(u"⚑"_s));
        QVERIFY(heading->text().contains(u"L₁₂"_s));
    }

    void numbersStandOnOneLineInANarrowPanel()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Float64));
        FormulaPanel panel(&playhead);
        panel.resize(330, 700);
        panel.show();
        playhead.seekToSpan(std::size_t(rowOf(58)));
        const Explanation explanation = explainStep(*playhead.traced(), playhead.position() - 1);
        QStringList numbers;
        for (const FormulaLine &line : explanation.lines)
            numbers += displayText(line.used, Arithmetic::Float64);

        const QTextDocument &document = *panel.findChild<QTextBrowser *>()->document();
        int found = 0;
        for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
            const QString text = block.text().remove(QChar(0x2060));
            const bool isNumber = std::ranges::any_of(
                numbers, [&](const QString &number) { return text.endsWith(number); });
            if (!isNumber)
                continue;
            ++found;
            QVERIFY2(block.layout()->lineCount() == 1, qPrintable(text));
        }
        QVERIFY(found >= 10);
    }

    void anEmptySceneSaysWhatToDo()
    {
        Playhead playhead;
        FormulaPanel panel(&playhead);
        const auto *sentence = panel.findChild<QLabel *>(u"formulaSentence"_s);

        QVERIFY(sentence->text().contains(u"is still being recorded"_s));

        playhead.setTraced(traceScene(Scene()));
        QVERIFY(sentence->text().contains(u"Click three points on the canvas"_s));
    }

    void formulasKeepTheirPlaceWhileStepping()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        FormulaPanel panel(&playhead);
        panel.resize(440, 240);
        panel.show();
        playhead.seekToSpan(std::size_t(rowOf(30)));
        auto *formulas = panel.findChild<QTextBrowser *>();
        formulas->verticalScrollBar()->setValue(60);
        const QRect place = formulas->geometry();

        playhead.step(StepUnit::Span, StepDirection::Forward);

        QCOMPARE(formulas->geometry(), place);
        QCOMPARE(formulas->verticalScrollBar()->value(), 60);
    }

    void shortFormulasHaveNoScrollBarAtAnyWidth()
    {
        const Scene scene = sceneOf(lineAt(20, 41, 30, 44), "line-bresenham", frameOf(64, 48));
        TracedPlayhead playhead(scene);
        playhead.seekToSpan(0);
        FormulaPanel panel(&playhead);
        panel.show();
        const auto *bar = panel.findChild<QTextBrowser *>()->horizontalScrollBar();
        for (int width = 300; width <= 520; width += 4) {
            panel.resize(width, 300);
            QCoreApplication::processEvents();
            QVERIFY2(!bar->isVisible(), qPrintable(QString::number(width)));
        }
    }

    void aShortFormulaStandsBesideItsChannels()
    {
        TracedPlayhead playhead(defaultSceneIn(Arithmetic::Exact));
        FormulaPanel panel(&playhead);
        panel.resize(480, 600);
        panel.show();
        playhead.seekToSpan(std::size_t(rowOf(30)));
        const auto *formulas = panel.findChild<QTextBrowser *>();
        const QTextDocument &document = *formulas->document();
        const auto topOf = [&](const char *text) {
            const QTextCursor found = document.find(QString::fromUtf8(text));
            return found.isNull()
                ? -1
                : document.documentLayout()->blockBoundingRect(found.block()).top();
        };
        const double symbols = topOf("CB ← CB′");
        QVERIFY(symbols > 0);
        const QTextCursor channel = document.find(u"R "_s, document.find(u"CB ← CB′"_s));
        QCOMPARE(document.documentLayout()->blockBoundingRect(channel.block()).top(), symbols);
        QVERIFY(topOf("first C") > symbols);
    }
};

PIXELPLUMB_TEST(TestPanels)

} // namespace tst_panels

#include "tst_panels.moc"
