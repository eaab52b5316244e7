// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/inspect/methodpanel.h"
#include "widgets/inspect/pixelhistorypanel.h"
#include "widgets/inspect/predictpanel.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

#include <QtTest>
#include <QtWidgets>

namespace tst_predict {

using namespace pixelplumb;

namespace {

Prediction predictionOf(const Quantity &value, const Quantity &earlier = {})
{
    return {u"Column 3"_s,
            u"y_B"_s,
            u"y_B"_s,
            value,
            earlier,
            u"y_B ← y_B′ + m"_s,
            u"y_B ← y_B′ + m = 8 + 1/2"_s};
}

} // namespace

/// The panels that teach by prediction and by reading along.
class TestPredict : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_settings.clear();
        m_window = openedWindow();
        m_playhead = m_window->parts().playhead;
    }
    void cleanup() { m_window.reset(); }

    void answersAreJudgedByTheirValue_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<int>("guess");
        const auto add = [](const char *typed, Guess guess) {
            QTest::newRow(typed) << QString::fromUtf8(typed) << int(guess);
        };
        add("8 10/27", Guess::Right);
        add("226/27", Guess::Right);
        add("8.37", Guess::Right); // 8.370370…
        add("8.3704", Guess::Right);
        add("8,37", Guess::Right);
        add("8,3", Guess::Near);
        add("8,370,4", Guess::Unread);
        add("8.4", Guess::Near); // too few places to decide
        add("8.3", Guess::Near);
        add("8.38", Guess::Wrong);
        add("−8 10/27", Guess::OtherSign);
        add("8 13/54", Guess::Earlier);
        add("eight", Guess::Unread);
        add("", Guess::Unread);
        add("9", Guess::RoundedUp); // the question is not about whole numbers
        add("8", Guess::RoundedDown);
        add("10", Guess::Wrong);
    }
    void answersAreJudgedByTheirValue()
    {
        QFETCH(QString, typed);
        QFETCH(int, guess);
        QCOMPARE(int(judge(predictionOf(Quantity::rational(226, 27), Quantity::rational(445, 54)),
                           typed)),
                 guess);
    }

    void aFractionIsRightBesideARoundedNumber_data()
    {
        QTest::addColumn<Quantity>("value");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<bool>("isRight");
        const Quantity nearest = Quantity::of(97.0F / 18);
        QTest::newRow("the float nearest to it") << nearest << "5 7/18" << true;
        const Quantity drifted = Quantity::of(5.3889F);
        QTest::newRow("a float that has drifted") << drifted << "5 7/18" << true;
        const Quantity fixed = Quantity::rational(353166, 65536);
        QTest::newRow("a fixed-point number") << fixed << "5 7/18" << true;
        QTest::newRow("not of a whole one") << nearest << "5" << false;
        QTest::newRow("another fraction") << nearest << "5 6/18" << false;
        QTest::newRow("a fraction near it") << nearest << "5 388/1000" << false;
    }
    void aFractionIsRightBesideARoundedNumber()
    {
        QFETCH(Quantity, value);
        QFETCH(QString, typed);
        QFETCH(bool, isRight);
        Prediction bound = predictionOf(value);
        bound.exact = Quantity::rational(97, 18);
        QCOMPARE(judge(bound, typed) == Guess::Right, isRight);
    }

    /// If the answer is near, the panel asks for more places, and the first try still counts.
    void aTryIsNotLostByTooFewPlaces()
    {
        openPanel();
        auto *choice = named<QComboBox>(*m_window, "predictChoice");
        const auto all = predictionsAfter(*m_playhead->traced(), m_playhead->position());
        const auto isLong = [](const Prediction &each) {
            const double tenths = each.value.toDouble() * 10;
            return judge(each, QString::number(std::round(tenths) / 10, 'f', 1)) == Guess::Near;
        };
        const auto asked = std::ranges::find_if(all, isLong);
        QVERIFY(asked != all.end());
        choice->setCurrentIndex(choice->findText(asked->title));

        answer(QString::number(std::round(asked->value.toDouble() * 10) / 10, 'f', 1));
        QVERIFY(label("predictVerdict").startsWith(u"Near"_s));
        answer(toText(asked->value));
        QCOMPARE(label("predictScore"), u"Right at the first try: 1 of 1"_s);
    }

    void aWholeNumberBesideTheRightOneIsOneOff()
    {
        const Prediction row = predictionOf(Quantity::integer(9));
        QCOMPARE(judge(row, u"8"_s), Guess::OneOff);
        QCOMPARE(judge(row, u"10"_s), Guess::OneOff);
        QCOMPARE(judge(row, u"9"_s), Guess::Right);
        QCOMPARE(judge(row, u"7"_s), Guess::Wrong);
    }

    /// The answer to a question is what the table says once the step is done.
    void everyQuestionIsANumberOfTheNextSpan()
    {
        const TracedScene &traced = *m_playhead->traced();
        const std::size_t span = *m_playhead->currentSpan() + 1;
        const auto cells = traced.trace->span(span).cells;
        const auto all = predictionsAfter(traced, m_playhead->position());
        QVERIFY(all.size() >= 10);
        for (const Prediction &prediction : all)
            QVERIFY2(std::ranges::find(cells, prediction.value) != cells.end(),
                     qPrintable(prediction.title));
        QCOMPARE(all.front().title, u"y_B"_s);
    }

    void everyNumberOfTheAssignmentCanBeChosen()
    {
        openPanel();
        const auto *choice = named<QComboBox>(*m_window, "predictChoice");
        for (const char *title : {"y_B", "y_T", "⌈y_B⌉", "⌊y_T⌋", "px", "ΔR", "ΔG", "ΔB", "first R",
                                  "first G", "first B"})
            QVERIFY2(choice->findText(QString::fromUtf8(title)) >= 0, title);
    }

    /// ΔR stands in the rows above: it can be practised, and does not count.
    void whatNeverChangesIsPractice()
    {
        openPanel();
        auto *choice = named<QComboBox>(*m_window, "predictChoice");
        choice->setCurrentIndex(choice->findText(u"ΔR"_s));
        QVERIFY(label("predictVerdict").contains(u"does not count"_s));
        answer(u"1000"_s);
        QVERIFY(label("predictVerdict").startsWith(u"Not"_s));
        QCOMPARE(label("predictScore"), QString());
    }

    void theCountOfPixelsFollowsFromTheBounds()
    {
        const auto all = predictionsAfter(*m_playhead->traced(), m_playhead->position());
        const auto asked = std::ranges::find(all, u"px"_s, &Prediction::title);
        QVERIFY(asked != all.end());
        QCOMPARE(asked->rule, u"px = ⌊y_T⌋ − ⌈y_B⌉ + 1"_s);
        QVERIFY(asked->reason.startsWith(asked->rule + u" = "_s));
        QCOMPARE(judge(*asked, toText(asked->value)), Guess::Right);
        QVERIFY(asksForWhole(*asked));
    }

    void theAnswerIsCheckedAndItsReasonTold()
    {
        openPanel();
        const Prediction asked
            = predictionsAfter(*m_playhead->traced(), m_playhead->position()).front();
        QVERIFY(label("predictQuestion").contains(u"Column"_s));

        answer(u"1000"_s);
        QVERIFY(label("predictVerdict").startsWith(u"Not"_s));
        answer(toText(asked.earlier));
        QVERIFY(label("predictVerdict").contains(u"span before"_s));
        answer(toText(asked.value));
        QVERIFY(label("predictVerdict").startsWith(u"Right"_s));
        QVERIFY(label("predictVerdict").contains(u"m"_s));
        // Only the first answer counts.
        QCOMPARE(label("predictScore"), u"Right at the first try: 0 of 1"_s);

        const std::size_t before = *m_playhead->currentSpan();
        QTest::keyClick(line(), Qt::Key_Return);
        QCOMPARE(*m_playhead->currentSpan(), before + 1);
        answer(
            toText(predictionsAfter(*m_playhead->traced(), m_playhead->position()).front().value));
        QCOMPARE(label("predictScore"), u"Right at the first try: 1 of 2"_s);
    }

    void whatIsShownCountsAsNotKnown()
    {
        openPanel();
        QTest::mouseClick(named<QPushButton>(*m_window, "predictShow"), Qt::LeftButton);
        QVERIFY(label("predictVerdict").contains(u"y"_s));
        QCOMPARE(label("predictScore"), u"Right at the first try: 0 of 1"_s);
        QVERIFY(!named<QPushButton>(*m_window, "predictShow")->isEnabled());
        QVERIFY(named<QPushButton>(*m_window, "predictNext")->isEnabled());
    }

    void theNextPixelIsPickedOnTheCanvas()
    {
        openPanel();
        auto *choice = named<QComboBox>(*m_window, "predictChoice");
        choice->setCurrentIndex(choice->count() - 1);
        const NextPixel next = *nextPixelAfter(*m_playhead->traced(), m_playhead->position());

        m_playhead->pick(next.pixel + QPoint(1, 1));
        QVERIFY(label("predictVerdict").startsWith(u"Not"_s));
        QVERIFY(label("predictVerdict").contains(u"comes later: Column"_s));
        m_playhead->pick(next.pixel + QPoint(0, 1));
        QVERIFY(label("predictVerdict").contains(u"later in the same span"_s));
        m_playhead->pick(next.pixel - QPoint(1, 0));
        QVERIFY(label("predictVerdict").contains(u"drawn already, in step"_s));
        m_playhead->pick(QPoint(0, 0));
        QVERIFY(label("predictVerdict").contains(u"Refused by"_s));
        answer(u"64, 12"_s);
        QVERIFY(
            label("predictVerdict").contains(u"off the frame, columns 0 to 63 and rows 0 to 47"_s));
        m_playhead->pick(next.pixel);
        QVERIFY(label("predictVerdict").startsWith(u"Right"_s));
        QTest::mouseClick(named<QPushButton>(*m_window, "predictNext"), Qt::LeftButton);
        QCOMPARE(m_playhead->currentPixel(), std::optional(next.pixel));
    }

    void typingOnAnUnaskedFieldIsNoCanvasKey()
    {
        openPanel();
        const std::string method = m_window->parts().document->scene().method;
        m_playhead->seek(m_playhead->end());
        QVERIFY(!line()->isEnabled());
        m_window->parts().canvas->setFocus();

        QTest::mouseClick(m_window->windowHandle(), Qt::LeftButton, Qt::NoModifier,
                          line()->mapTo(m_window.get(), line()->rect().center()));
        QVERIFY(!m_window->parts().canvas->hasFocus());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_2);
        QCOMPARE(m_window->parts().document->scene().method, method);
    }

    void theFocusStaysInThePanelAsItsPartsAreUsedUp()
    {
        openPanel();
        auto *panel = named<PredictPanel>(*m_window, "predict");
        auto *show = named<QPushButton>(*m_window, "predictShow");
        show->setFocus();
        show->click();
        QVERIFY(line()->hasFocus()); // Enter continues
        m_playhead->seek(m_playhead->end());
        QVERIFY(panel->hasFocus());
    }

    void theScoreEndsWithTheScene()
    {
        openPanel();
        answer(u"1000"_s);
        QVERIFY(!label("predictScore").isEmpty());
        action(*m_window, "newScene")->trigger();
        QCOMPARE(label("predictScore"), QString());
        QVERIFY(label("predictQuestion").contains(u"Nothing is drawn yet"_s));
    }

    void aClosedPanelEndsTheScoreAndItsOpenQuestion()
    {
        openPanel();
        answer(u"1000"_s);
        QSignalSpy told(m_playhead, &Playhead::message);
        action(*m_window, "predictDockToggle")->trigger();
        QCOMPARE(told.size(), 1);
        QCOMPARE(told[0][0].toString(), u"Predict is closed. Right at the first try: 0 of 1."_s);

        openPanel();

        QCOMPARE(label("predictScore"), QString());
        QVERIFY(
            label("predictVerdict").startsWith(u"The panel was closed with this question open."_s));
        QVERIFY(!named<QPushButton>(*m_window, "predictCheck")->isEnabled());
        QTest::mouseClick(named<QPushButton>(*m_window, "predictNext"), Qt::LeftButton);
        QVERIFY(named<QPushButton>(*m_window, "predictCheck")->isEnabled());
    }

    void theLinesThatAStepDoesAreMarked()
    {
        action(*m_window, "methodDockToggle")->trigger();
        const auto *text = named<QTextBrowser>(*m_window, "methodText");
        m_playhead->seekToSpan(*m_playhead->currentSpan() + 1);
        QVERIFY(text->toPlainText().contains(u"▶"_s));
        const QString atSpan
            = named<MethodPanel>(*m_window, "methodPanel")->accessibleDescription();
        QVERIFY(atSpan.contains(u"else: y₀₂ ← y₀₂ + m₀₂"_s));
        m_playhead->step(StepUnit::Sample, StepDirection::Forward);
        const QString atFirst
            = named<MethodPanel>(*m_window, "methodPanel")->accessibleDescription();
        QVERIFY(atFirst.contains(u"the first: R ← R_B"_s));
        m_playhead->step(StepUnit::Sample, StepDirection::Forward);
        QVERIFY(named<MethodPanel>(*m_window, "methodPanel")
                    ->accessibleDescription()
                    .contains(u"else: R ← R + ΔR"_s));
    }

private:
    void openPanel()
    {
        action(*m_window, "predictDockToggle")->trigger();
        QTRY_VERIFY(named<PredictPanel>(*m_window, "predict")->isVisible());
    }
    QLineEdit *line() { return named<QLineEdit>(*m_window, "predictAnswer"); }
    void answer(const QString &text)
    {
        line()->clear();
        QTest::keyClicks(line(), text);
        QTest::keyClick(line(), Qt::Key_Return);
    }
    /// A label's words without markup.
    QString label(const char *name)
    {
        QTextDocument document;
        document.setHtml(named<QLabel>(*m_window, name)->text());
        return document.toPlainText();
    }

    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
    Playhead *m_playhead = nullptr;
};

PIXELPLUMB_TEST(TestPredict)

} // namespace tst_predict

#include "tst_predict.moc"
