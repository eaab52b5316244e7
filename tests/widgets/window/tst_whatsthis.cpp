// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/menuaction.h"
#include "widgets/model/scenedocument.h"
#include "widgets/window/panels.h"

#include <QTest>
#include <QtWidgets>

#include <algorithm>

namespace tst_whatsthis {

using namespace pixelplumb;

namespace {

/// The widget in which Qt shows a What's This text.
QWidget *shownText()
{
    for (QWidget *each : QApplication::topLevelWidgets()) {
        if (each->inherits("QWhatsThat") && each->isVisible())
            return each;
    }
    return nullptr;
}

qsizetype sentencesIn(const QString &text)
{
    return text.count(u". "_s) + (text.endsWith(u'.') ? 1 : 0);
}

QStringList explainedParts(const MainWindow &window)
{
    QStringList names{"canvas", "scrubber", "methodBox"};
    for (const Panel &panel : panels())
        names += QLatin1String(panel.dock);
    for (const QAction *menu : window.menuBar()->actions())
        names += menu->menu()->objectName();
    return names;
}

} // namespace

/// Help ▸ What's This?, and what it says about each part.
class TestWhatsThis : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }
    void cleanup() { QWhatsThis::leaveWhatsThisMode(); }

    void everyPanelAndMenuHasOneToThreeSentences()
    {
        const auto window = openedWindow();
        for (const QString &name : explainedParts(*window)) {
            const QString text = named<QWidget>(*window, qPrintable(name))->whatsThis();
            QVERIFY2(sentencesIn(text) >= 1 && sentencesIn(text) <= 3,
                     qPrintable(name + ": " + text));
        }
    }

    void everythingInTheToolBarsAndTheStatusBarIsExplained()
    {
        const auto window = openedWindow();
        window->resize(1440, 900); // so that the tool bars show all their buttons
        QTest::qWait(50);
        QStringList silent;
        int parts = 0;
        for (const QToolBar *bar : window->findChildren<QToolBar *>()) {
            for (const QWidget *part : bar->findChildren<QWidget *>()) {
                const bool isControl = qobject_cast<const QAbstractButton *>(part)
                    || qobject_cast<const QComboBox *>(part)
                    || qobject_cast<const QAbstractSlider *>(part)
                    || qobject_cast<const QAbstractSpinBox *>(part);
                if (!isControl || !part->isVisible() || part->objectName().startsWith("qt_"))
                    continue;
                ++parts;
                if (part->whatsThis().isEmpty())
                    silent += part->objectName();
            }
        }
        for (const char *name : {"statusPixel", "statusColumn", "statusStep", "statusSettings"}) {
            if (named<QWidget>(*window, name)->whatsThis().isEmpty())
                silent += QLatin1String(name);
        }
        QVERIFY2(silent.isEmpty(), qPrintable(silent.join(u' ')));
        QVERIFY2(parts >= 18, qPrintable(QString::number(parts)));
    }

    void theNextClickTellsInsteadOfDoing()
    {
        const auto window = openedWindow();
        action(*window, "drawTool")->trigger();
        QTest::keyClick(window.get(), Qt::Key_F1, Qt::ShiftModifier);
        QVERIFY(QWhatsThis::inWhatsThisMode());

        clickPixel(*window, {12, 40});

        QVERIFY(shownText());
        QVERIFY(!QWhatsThis::inWhatsThisMode());
        QVERIFY(!window->isWindowModified());
        QTest::keyClick(shownText(), Qt::Key_Escape);
        QTRY_VERIFY(!shownText());
        clickPixel(*window, {12, 40});
        QVERIFY(window->isWindowModified());
    }

    void aPartWithoutATextOfItsOwnTellsItsDocks()
    {
        const auto window = openedWindow();
        const auto *table = named<QWidget>(*window, "columnTable");
        action(*window, "whatsThis")->trigger();
        QVERIFY(QWhatsThis::inWhatsThisMode());
        QTest::mouseClick(table->findChild<QWidget *>("qt_scrollarea_viewport"), Qt::LeftButton);
        QVERIFY(shownText());
        const QImage told = shownText()->grab().toImage();
        QTest::keyClick(shownText(), Qt::Key_Escape);
        QTRY_VERIFY(!shownText());

        const auto *dock = named<QDockWidget>(*window, "columnsDock");
        QVERIFY(!dock->whatsThis().isEmpty());
        QWhatsThis::showText(dock->mapToGlobal(QPoint()), dock->whatsThis(), window.get());
        QVERIFY(shownText());
        QCOMPARE(shownText()->grab().toImage(), told);
        QTest::keyClick(shownText(), Qt::Key_Escape);
        QTRY_VERIFY(!shownText());
    }

    void escapeEndsIt()
    {
        const auto window = openedWindow();
        action(*window, "whatsThis")->trigger();
        QTest::keyClick(window->parts().canvas, Qt::Key_Escape);
        QVERIFY(!QWhatsThis::inWhatsThisMode());
        QVERIFY(!shownText());
    }

    void itTellsTheToolTipAsItIsNow()
    {
        const auto window = openedWindow();
        QCOMPARE(named<QWidget>(*window, "playButton")->whatsThis(),
                 u"Play by the chosen unit (Space)"_s);
        window->parts().document->setMethod("edge-equations");
        action(*window, "whatsThis")->trigger();
        QCOMPARE(named<QWidget>(*window, "playButton")->whatsThis(),
                 u"Play by the chosen unit (Space)"_s);
        QCOMPARE(action(*window, "play")->whatsThis(), u"Play by the chosen unit (Space)"_s);
        QVERIFY(action(*window, "zoomIn")->whatsThis().isEmpty()); // the menu has its text
        QCOMPARE(action(*window, "gradingDockToggle")->whatsThis(),
                 named<QDockWidget>(*window, "gradingDock")->whatsThis());
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestWhatsThis)

} // namespace tst_whatsthis

#include "tst_whatsthis.moc"
