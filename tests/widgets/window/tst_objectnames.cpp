// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/promisednames.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/dialogs/manual.h"
#include "widgets/look/appearance.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/signs.h"
#include "widgets/window/mainwindow.h"
#include "widgets/window/panels.h"

#include <QTest>
#include <QtWidgets>

namespace tst_objectnames {

using namespace pixelplumb;

namespace {

/// The scope in which an action's keys work: window-wide, or in one widget.
QString scopeOf(const QAction &action)
{
    return action.shortcutContext() == Qt::WindowShortcut
            || action.shortcutContext() == Qt::ApplicationShortcut
        ? u"window"_s
        : u"canvas"_s;
}

} // namespace

/// The contract with programs that drive the window, with users' hands and with screen readers.
class TestObjectNames : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_window = std::make_unique<MainWindow>();
        m_window->openDefaultScene();
        m_window->show();
        buildPanelsOf(*m_window);
    }

    void everyPromisedNameIsThereOnce()
    {
        for (const QString &name : promisedNames(PromisedObject::Widget))
            QVERIFY2(m_window->findChildren<QWidget *>(name).size() == 1, qPrintable(name));
        for (const QString &name : promisedNames(PromisedObject::Action))
            QVERIFY2(m_window->findChildren<QAction *>(name).size() == 1, qPrintable(name));
    }

    void theListOfPromisedNamesIsReadWhole()
    {
        QCOMPARE(unreadPromises(), QStringList());
        QStringList names = promisedNames(PromisedObject::Widget);
        QVERIFY(names.size() > 100);
        names += promisedNames(PromisedObject::Action) + promisedNames(PromisedObject::Dialog);
        QCOMPARE(names.removeDuplicates(), 0);
        // The names that the first programs were written for.
        for (const char *name :
             {"canvas", "columnTable", "pixelGrid", "formulaPanel", "pixelHistory", "stepperBar",
              "methodBox", "arithmeticBox", "fillRuleBox", "effectsPanel", "accuracyLab",
              "hardCases", "copyTable", "goToDialog"})
            QVERIFY2(names.contains(QLatin1String(name)), name);
    }

    void theManPageNamesEveryPanel()
    {
        const QString page = textInTree(u"resources/man/pixelplumb.1"_s).simplified();
        for (const Panel &panel : panels())
            QVERIFY2(page.contains(QLatin1String(panel.title)), panel.title);
        for (const char *key : {"Alt+1", "Alt+9", "Alt+0"})
            QVERIFY2(page.contains(QLatin1String(key)), key);
    }

    void everyActionOfTheMenusHasANameOfItsOwn()
    {
        QStringList names;
        const auto actions = menuActions();
        for (const QAction *action : QSet<const QAction *>(actions.begin(), actions.end())) {
            QVERIFY2(!action->objectName().isEmpty(), qPrintable(action->text()));
            names += action->objectName();
        }
        QCOMPARE(names.removeDuplicates(), 0);
        QVERIFY(names.size() > 50);
    }

    void noTwoActionsShareAKeyInOneScope()
    {
        // The same object may be in several menus; the window's keys also work in the canvas.
        QMap<QString, QString> window;
        QMap<QString, QString> canvas;
        QMap<QString, QString> elsewhere; // in lists, each with its own keys
        QStringList collisions;
        for (const QAction *action : m_window->findChildren<QAction *>()) {
            for (const QKeySequence &key : action->shortcuts()) {
                const QString text = key.toString();
                const bool inWindow = scopeOf(*action) == "window";
                const bool inCanvas = !inWindow && !isOfAnotherWidget(*action);
                if (window.contains(text) || (canvas.contains(text) && (inWindow || inCanvas))
                    || (elsewhere.contains(text) && inWindow))
                    collisions += text + ": " + action->objectName() + ", " + window.value(text)
                        + canvas.value(text) + elsewhere.value(text);
                (inWindow       ? window
                     : inCanvas ? canvas
                                : elsewhere)
                    .insert(text, action->objectName());
            }
        }
        QCOMPARE(collisions, QStringList());
        QVERIFY(window.size() > 25);
    }

    void theKeysOfTheDesignAreActions_data()
    {
        QTest::addColumn<QString>("key");
        for (const char *key : {"F10",       "Shift+F10", "F11",
                                "Shift+F11", "F5",        "Shift+F5",
                                "F9",        "Ctrl+F10",  "Ctrl+Shift+F10",
                                "Space",     "Ctrl+G",    "G",
                                "Z",         "D",         "R",
                                "1",         "Ctrl+C",    "Ctrl+Shift+C",
                                "?",         "Ctrl+Z",    "Ctrl+S",
                                "Ctrl+O",    "Ctrl+N"})
            QTest::newRow(key) << QString(key);
    }
    void theKeysOfTheDesignAreActions()
    {
        QFETCH(QString, key);
        QVERIFY(std::ranges::any_of(menuActions(), [&](const QAction *action) {
            return action->shortcuts().contains(QKeySequence(key));
        }));
    }

    void everyWidgetThatTakesTheFocusHasAnAccessibleName()
    {
        QStringList nameless;
        for (QWidget *widget : m_window->findChildren<QWidget *>()) {
            const bool isInner = widget->objectName().startsWith("qt_")
                || qobject_cast<QAbstractItemView *>(widget->parentWidget())
                || qobject_cast<QComboBox *>(widget->parentWidget())
                || (widget->parentWidget()
                    && widget->parentWidget()->inherits("QComboBoxPrivateContainer"))
                || widget->inherits("QMenu")
                || widget->inherits("QMenuBar")
                // A tab bar takes its name from its current tab, which an unused one does not have.
                || (widget->inherits("QTabBar") && !widget->isVisible());
            if (isInner || widget->focusPolicy() == Qt::NoFocus)
                continue;
            QAccessibleInterface *accessible = QAccessible::queryAccessibleInterface(widget);
            if (!accessible || accessible->text(QAccessible::Name).isEmpty())
                nameless += QString("%1 %2 in %3")
                                .arg(widget->metaObject()->className(), widget->objectName(),
                                     widget->parentWidget()->objectName());
        }
        QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join("; ")));
    }

    void theKeySheetShowsEveryKeyOfTheMenus()
    {
        QList<QMenu *> menus;
        for (const QAction *action : m_window->menuBar()->actions())
            menus += action->menu();
        const QString sheet = keySheetHtml(menus);
        QVERIFY(sheet.contains(u"after %1 s"_s.arg(double(peekDelay.count()) / 1000)));
        for (const QAction *action : menuActions()) {
            for (const QKeySequence &key : action->shortcuts())
                QVERIFY2(sheet.contains(key.toString(QKeySequence::NativeText).toHtmlEscaped()),
                         qPrintable(action->objectName()));
        }
    }

    void textAndSignsKeepTheirContrast_data()
    {
        QTest::addColumn<QPalette>("palette");
        QTest::newRow("light") << lightPalette();
        QTest::newRow("dark") << darkPalette();
    }
    void textAndSignsKeepTheirContrast()
    {
        QFETCH(QPalette, palette);
        const auto ratio = [&](QPalette::ColorRole text, QPalette::ColorRole background) {
            return contrastRatio(palette.color(text), palette.color(background));
        };
        QVERIFY(ratio(QPalette::WindowText, QPalette::Window) >= 7);
        QVERIFY(ratio(QPalette::Text, QPalette::AlternateBase) >= 7);
        QVERIFY(ratio(QPalette::ButtonText, QPalette::Button) >= 7);
        QVERIFY(ratio(QPalette::HighlightedText, QPalette::Highlight) >= 4.5);
        QVERIFY(ratio(QPalette::PlaceholderText, QPalette::Base) >= 4.5);
        QVERIFY(ratio(QPalette::Link, QPalette::Base) >= 4.5);
        QVERIFY(contrastRatio(palette.color(QPalette::Disabled, QPalette::Text),
                              palette.color(QPalette::Base))
                >= 3);
        for (int sign = 0; sign <= int(Sign::Changed); ++sign) {
            const QColor colour = signColour(Sign(sign), palette);
            QVERIFY2(contrastRatio(colour, palette.color(QPalette::Base)) >= 4.5,
                     qPrintable(QString("sign %1: %2").arg(sign).arg(colour.name())));
        }
    }

private:
    QList<QAction *> menuActions() const
    {
        QList<QAction *> all;
        for (const QAction *action : m_window->menuBar()->actions())
            collect(action->menu(), all);
        return all;
    }
    static void collect(const QMenu *menu, QList<QAction *> &all)
    {
        if (menu->objectName() == "recentMenu")
            return; // recent files change
        for (QAction *action : menu->actions()) {
            if (action->menu())
                collect(action->menu(), all);
            else if (!action->isSeparator())
                all += action;
        }
    }
    bool isOfAnotherWidget(const QAction &action) const
    {
        return !m_window->findChild<QWidget *>("canvas")->actions().contains(
            const_cast<QAction *>(&action));
    }

    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
};

PIXELPLUMB_TEST(TestObjectNames)

} // namespace tst_objectnames

#include "tst_objectnames.moc"
