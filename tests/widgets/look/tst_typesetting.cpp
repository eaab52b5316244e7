// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scan/choicenames.h"
#include "tests/support/testprogram.h"
#include "widgets/look/appearance.h"
#include "widgets/look/formulahtml.h"
#include "widgets/look/labels.h"
#include "widgets/look/typesetting.h"

#include <QTest>
#include <QtWidgets>

namespace tst_typesetting {

using namespace pixelplumb;

namespace {

/// The lines of rich text at a given width.
QStringList linesOf(const QString &html, double width)
{
    QTextDocument document;
    document.setHtml(html);
    document.setTextWidth(width);
    document.documentLayout()->documentSize(); // lines are broken on demand
    QStringList lines;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        for (int line = 0; line < block.layout()->lineCount(); ++line) {
            const QTextLine each = block.layout()->lineAt(line);
            lines.append(block.text().mid(each.textStart(), each.textLength()).trimmed());
        }
    }
    return lines;
}

} // namespace

/// How texts are laid out where there is little room.
class TestTypesetting : public QObject {
    Q_OBJECT

private slots:
    void aMixedNumberStaysOnOneLine()
    {
        const QString html
            = typesetHtml(u"y_B = 17 3/8 and y_T = 26 11/54 cover the rows 18 to 26."_s);
        bool broke = false;
        for (int width = 120; width < 600; width += 3) {
            const QStringList lines = linesOf(html, width);
            broke = broke || lines.size() > 2;
            for (const QString &line : lines) {
                QVERIFY2(!line.startsWith(u"3/8"_s), qPrintable(line));
                QVERIFY2(!line.startsWith(u"11/54"_s), qPrintable(line));
            }
        }
        QVERIFY(broke);
    }

    void anExponentIsNotLoweredWithAnIndex()
    {
        QCOMPARE(SymbolText(u"h = ⌊256·√(r_x² − d²)⌋/256"_s).html(),
                 u"h = ⌊256·√(r<sub>x</sub>² − d²)⌋/256"_s);
        QCOMPARE(SymbolText(u"2⁻²·x_start³ + y_B2"_s).html(),
                 u"2⁻²·x<sub>start</sub>³ + y<sub>B2</sub>"_s);
    }

    void aSwitchHasAFrameAndIsFilledWhereItIsOn_data()
    {
        QTest::addColumn<PaletteChoice>("choice");
        QTest::newRow("light") << PaletteChoice::Light;
        QTest::newRow("dark") << PaletteChoice::Dark;
    }
    void aSwitchHasAFrameAndIsFilledWhereItIsOn()
    {
        QFETCH(PaletteChoice, choice);
        applyAppearance(choice);
        QToolButton button;
        button.setText(u"truth"_s);
        button.setCheckable(true);
        button.setAutoRaise(true);
        button.resize(button.sizeHint());
        const auto frameColour
            = [&] { return button.grab().toImage().pixelColor(button.width() / 2, 0); };
        const auto insideColour
            = [&] { return button.grab().toImage().pixelColor(3, button.height() / 2); };
        const QColor window = button.palette().color(QPalette::Window);
        const QColor off = frameColour();
        const QColor insideOff = insideColour();

        button.setChecked(true);

        const QColor inside = insideColour();
        // WCAG 2.1, 1.4.11, requires this of a control's border.
        QVERIFY(contrastRatio(off, window) >= 3);
        QVERIFY(contrastRatio(frameColour(), window) >= 3);
        QVERIFY(inside != insideOff);
        QVERIFY(contrastRatio(inside, button.palette().color(QPalette::ButtonText)) >= 4.5);
    }

    /// An extra line gives the error if there is one; otherwise one word is enough.
    void anExactNumberTakesALineOnlyWhereItDiffers()
    {
        Explanation explanation;
        explanation.lines = {{NumberSubject::General, u"y_B ← y_B′ + m"_s, u"7.5 + 0.125"_s,
                              Quantity::of(7.625f), Quantity::rational(61, 8)}};
        const QString same = formulaHtml(explanation, Arithmetic::Float32, QPalette());
        QVERIFY(same.contains(u"exact"_s));
        QVERIFY(!same.contains(u"error"_s));
        explanation.lines[0].exact = Quantity::rational(611, 80);
        const QString other = formulaHtml(explanation, Arithmetic::Float32, QPalette());
        QVERIFY(other.contains(u"error"_s));
        QVERIFY(other.count(u"<tr>"_s) == same.count(u"<tr>"_s) + 1);
    }

    void aTextThatIsCutLosesItsMiddle()
    {
        ElidingBox box;
        box.addItem(u"Edge equations, relative to a vertex"_s);
        box.resize(box.sizeHint());
        QCOMPARE(box.shownText(), box.currentText());

        box.resize(box.width() / 2, box.height());

        const QStringList ends = box.shownText().split(u'…');
        QVERIFY2(ends.size() == 2, qPrintable(box.shownText()));
        QVERIFY(!ends[0].isEmpty() && box.currentText().startsWith(ends[0].trimmed()));
        QVERIFY(!ends[1].isEmpty() && box.currentText().endsWith(ends[1].trimmed()));
    }

    void whereThereIsHardlyRoomTheFirstLettersTellChoicesApart()
    {
        QStringList shown;
        for (const FillRule rule : allFillRules) {
            ElidingBox box;
            box.setToolTip(u"Fill rule"_s);
            box.addItem(nameText(nameOf(rule)));
            box.resize(51, box.sizeHint().height()); // as in Compare at 1024 px
            QVERIFY2(!box.shownText().contains(u'…'), qPrintable(box.shownText()));
            QVERIFY(box.currentText().startsWith(box.shownText()));
            shown += box.shownText();

            if (box.shownText() == box.currentText())
                continue;
            QHelpEvent help(QEvent::ToolTip, box.rect().center(), QPoint());
            QCoreApplication::sendEvent(&box, &help);
            QCOMPARE(QToolTip::text(), u"Fill rule: "_s + box.currentText());
        }
        QCOMPARE(shown.removeDuplicates(), 0);
    }
};

PIXELPLUMB_TEST(TestTypesetting)

} // namespace tst_typesetting

#include "tst_typesetting.moc"
