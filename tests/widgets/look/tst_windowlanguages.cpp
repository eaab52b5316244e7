// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/listings/pseudolanguage.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "tests/support/window/showntexts.h"
#include "tests/support/window/translationfile.h"
#include "widgets/look/corewords.h"
#include "widgets/look/labels.h"

#include <QTest>
#include <QtWidgets>

#include <algorithm>
#include <optional>

namespace tst_windowlanguages {

using namespace pixelplumb;

namespace {

void showPanel(const MainWindow &window, const QDockWidget &dock)
{
    QAction *toggle = named<QAction>(window, qPrintable(dock.objectName() + "Toggle"));
    if (!dock.isVisible() || dock.visibleRegion().isEmpty())
        toggle->trigger();
    settle();
}

/// Whether a text is the same in every language.
bool isOfNoLanguage(const ShownText &shown)
{
    static const QRegularExpression word(u"[A-Za-zÄÖÜäöüß]{2}"_s);
    if (!word.match(shown.text).hasMatch())
        return true; // a symbol or a number
    // Core names methods, rules, arithmetics and cases as course texts, files and the command line
    // do, and explains them in English, as those texts do. A button has its colour's name.
    static const QRegularExpression places(
        u"^((method|variant)-.*|layer-.* "
        "tip|precision_.*|(method|arithmetic|fillRule|rounding)Box|compare(Method|Arithmetic|FillRule)[1-4]|(columnTable|hardCaseVerdicts) header|predictChoice|hardCaseTitle|formulaSentence|pixelHistoryReason|nextColourButton|vertex[0-2]Colour)$"_s);
    return places.match(shown.place).hasMatch();
}

/// The untranslated texts, one per line; empty if all are translated.
QString untranslatedOf(const QList<ShownText> &texts)
{
    QStringList untranslated;
    for (const ShownText &shown : texts) {
        if (!isOfNoLanguage(shown) && !shown.text.contains(u'['))
            untranslated += shown.place + u": "_s + shown.text;
    }
    untranslated.removeDuplicates();
    return untranslated.join(u'\n');
}

/// The words of a text; names with hyphens, digits or dots, such as column-scan and float32, are
/// none.
QStringList wordsOf(const QString &text)
{
    static const QRegularExpression word(
        u"(?<![-_./0-9A-Za-zÄÖÜäöüß])[A-Za-zÄÖÜäöüß]{3,}(?![-_0-9A-Za-zÄÖÜäöüß]|[./][0-9A-Za-z])"_s);
    QStringList words;
    for (const QRegularExpressionMatch &match : word.globalMatch(text))
        words += match.captured().toLower();
    return words;
}

/// What the sources say in English and the translations never do.
QSet<QString> englishWords()
{
    QSet<QString> english;
    QSet<QString> german;
    for (const TranslatedText &text : textsOf(resource(u"/translations/pixelplumb_de.ts"_s))) {
        for (const QString &word : wordsOf(QString(text.source).remove(u'&')))
            english += word;
        for (const QString &form : text.forms) {
            for (const QString &word : wordsOf(QString(form).remove(u'&')))
                german += word;
        }
    }
    return english - german;
}

/// The part of a text that does not say that it is English.
QString unmarked(const QString &text)
{
    const QString plain
        = Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text;
    return QString(plain).remove(u'&').section(u"Auf Englisch:"_s, 0, 0);
}

/// "&Datei" → "d"
QChar mnemonicOf(const QString &text)
{
    const qsizetype place = QString(text).replace(u"&&"_s, u"  "_s).indexOf(u'&');
    return place < 0 || place + 1 == text.size() ? QChar() : text[place + 1].toLower();
}

/// The entries of a menu or submenu that share a letter; empty if none do.
QString sharedLetterIn(const QList<QAction *> &entries)
{
    QMap<QChar, QString> taken;
    for (const QAction *entry : entries) {
        const QChar letter = mnemonicOf(entry->text());
        if (!letter.isNull() && entry->isVisible()) {
            if (taken.contains(letter))
                return taken[letter] + u", "_s + entry->text();
            taken[letter] = entry->text();
        }
        if (const QString shared
            = entry->menu() ? sharedLetterIn(entry->menu()->actions()) : QString();
            !shared.isEmpty())
            return shared;
    }
    return {};
}

/// Buttons and labels of a part of the window that are narrower than their text.
QStringList narrowIn(const QWidget &whole)
{
    QStringList narrow;
    const auto judge = [&narrow](const QWidget &part, const QString &text) {
        // By style, a push button is wider than a short text needs.
        const int wanted = qobject_cast<const QPushButton *>(&part)
            ? std::min(part.sizeHint().width(), part.fontMetrics().horizontalAdvance(text) + 8)
            : part.sizeHint().width();
        if (part.isVisible() && !text.isEmpty() && part.width() < wanted)
            narrow += u"%1 “%2”: %3 of %4"_s.arg(part.objectName(), text)
                          .arg(part.width())
                          .arg(wanted);
    };
    for (const auto *button : whole.findChildren<QPushButton *>())
        judge(*button, button->text());
    for (const auto *button : whole.findChildren<QToolButton *>())
        judge(*button, button->text());
    for (const auto *label : whole.findChildren<QLabel *>()) {
        // A label that elides has its whole text in the tool tip; one with a minimum width of 1 is
        // cut by its panel, which can be widened.
        if (!label->wordWrap() && !qobject_cast<const ElidedLabel *>(label)
            && label->minimumWidth() != 1)
            judge(*label, label->text());
    }
    return narrow;
}

} // namespace

/// The window in languages other than the sources'.
class TestWindowLanguages : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void everyTextComesThroughTheTranslator()
    {
        PseudoLanguage pseudo;
        QCoreApplication::installTranslator(&pseudo);
        const auto window = windowOf(QSize(1440, 960));
        for (const QDockWidget *dock : window->findChildren<QDockWidget *>())
            showPanel(*window, *dock);

        QList<ShownText> texts = shownTexts(*window);
        for (const QAction *menu : window->menuBar()->actions())
            appendTexts(texts, *menu->menu());

        const QString untranslated = untranslatedOf(texts);
        QVERIFY2(untranslated.isEmpty(), qPrintable(untranslated));
    }

    void everyTextOfADialogComesThroughTheTranslator_data()
    {
        QTest::addColumn<QString>("opener");
        for (const char *opener : {"editFrame", "editLook", "addTriangle", "goTo", "showKeys",
                                   "showAbout", "showExamples"})
            QTest::newRow(opener) << opener;
    }
    void everyTextOfADialogComesThroughTheTranslator()
    {
        QFETCH(QString, opener);
        PseudoLanguage pseudo;
        QCoreApplication::installTranslator(&pseudo);
        const auto window = windowOf(QSize(1440, 960));
        std::optional<QString> untranslated;
        QTimer::singleShot(200, window.get(), [&] {
            for (QWidget *each : QApplication::topLevelWidgets()) {
                if (auto *dialog = qobject_cast<QDialog *>(each); dialog && dialog->isVisible()) {
                    untranslated = untranslatedOf(shownTexts(*dialog));
                    dialog->reject();
                }
            }
        });

        action(*window, qPrintable(opener))->trigger();

        QTRY_VERIFY(untranslated);
        QVERIFY2(untranslated->isEmpty(), qPrintable(*untranslated));
    }

    void everyTextThatIsAskedForIsInTheFiles()
    {
        PseudoLanguage pseudo;
        QCoreApplication::installTranslator(&pseudo);
        const auto window = windowOf(QSize(1440, 960));
        for (const QDockWidget *dock : window->findChildren<QDockWidget *>())
            showPanel(*window, *dock);
        for (const char *key : {"runToEnd", "runToStart", "nextColumn", "nextPixel"})
            action(*window, key)->trigger();

        QSet<QString> unknown = pseudo.asked();
        QVERIFY(unknown.size() > 500);
        for (const TranslatedText &text : textsOf(resource(u"/translations/pixelplumb_de.ts"_s)))
            unknown.remove(text.name());
        for (const QString &name : unknown) {
            if (!name.startsWith("core: "_L1)) // coreWord() requests all
                                               // texts
                QFAIL(qPrintable(name));
        }
    }

    void noPanelIsEnglishInGermanWithoutSayingSo()
    {
        const QSet<QString> english = englishWords();
        QVERIFY(english.contains(u"edge"_s) && !english.contains(u"pixel"_s));
        const Translation german({"de"});
        const auto window = windowOf(QSize(1358, 728));
        QStringList found;
        const auto look = [&](const QWidget &whole) {
            for (const ShownText &shown : shownTexts(whole) + shownContents(whole)) {
                if (shown.place == u"hardCasesTree cell"_s)
                    continue; // names of cases and of their families
                for (const QString &word : wordsOf(unmarked(shown.text))) {
                    if (english.contains(word))
                        found += u"%1: %2 (%3)"_s.arg(shown.place, shown.text.left(300), word);
                }
            }
        };
        for (const char *step : {"runToStart", "nextColumn", "nextPixel", "runToEnd"}) {
            action(*window, step)->trigger();
            settle();
            look(*window);
        }
        for (const QDockWidget *dock : window->findChildren<QDockWidget *>()) {
            showPanel(*window, *dock);
            look(*dock);
        }
        found.removeDuplicates();
        for (const QString &each : std::as_const(found))
            qWarning("%s", qPrintable(each));
        QVERIFY(found.empty());
    }

    void lettersOfAMenuAreUniqueInGerman()
    {
        const Translation german({"de"});
        const auto window = windowOf(QSize(1440, 960));

        QCOMPARE(sharedLetterIn(window->menuBar()->actions()), QString());
        window->openScene(resource(u"/scenes/lines.json"_s));
        settle(); // the steps now have other names
        QCOMPARE(sharedLetterIn(window->menuBar()->actions()), QString());
    }

    void nothingIsCutInGerman_data()
    {
        QTest::addColumn<QSize>("size");
        // The room that a frame and a title bar leave on common screens.
        QTest::newRow("1024 × 640") << QSize(1016, 600);
        QTest::newRow("1366 × 768") << QSize(1358, 728);
    }
    void nothingIsCutInGerman()
    {
        QFETCH(QSize, size);
        const Translation german({"de"});
        const auto window = windowOf(size);
        QCOMPARE(window->size(), size);

        QStringList cut = narrowIn(*window);
        for (const QToolBar *bar : window->findChildren<QToolBar *>()) {
            if (const auto *more = named<QToolButton>(*bar, "qt_toolbar_ext_button");
                more && more->isVisible())
                cut += bar->windowTitle() + " does not fit";
        }
        for (const QDockWidget *dock : window->findChildren<QDockWidget *>()) {
            showPanel(*window, *dock);
            cut += narrowIn(*dock);
        }

        cut.removeDuplicates();
        QVERIFY2(cut.empty(), qPrintable(cut.join(u'\n')));
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestWindowLanguages)

} // namespace tst_windowlanguages

#include "tst_windowlanguages.moc"
