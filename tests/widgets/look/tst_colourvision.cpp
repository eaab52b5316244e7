// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/openwindow.h"
#include "tests/support/testprogram.h"
#include "widgets/canvas/canvas.h"
#include "widgets/files/sceneexports.h"
#include "widgets/look/colourvisionswitch.h"
#include "widgets/model/playhead.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QListWidget>
#include <QScreen>
#include <QTest>

#include <cmath>

namespace tst_colourvision {

using namespace pixelplumb;

namespace {

/// A part as the window shows it: grabbed by itself it would be drawn as to ordinary eyes.
QImage shown(MainWindow &window, const QString &part)
{
    const auto *widget = named<QWidget>(window, qPrintable(part));
    const QImage whole = window.grab().toImage();
    const double ratio = whole.devicePixelRatio();
    const QPoint place = widget->mapTo(&window, QPoint());
    return whole
        .copy(int(place.x() * ratio), int(place.y() * ratio), int(widget->width() * ratio),
              int(widget->height() * ratio))
        .convertToFormat(QImage::Format_ARGB32);
}

/// Of which no part moves by itself.
std::unique_ptr<MainWindow> settledWindow()
{
    auto window = openedWindow();
    window->resize(1440, 900);
    action(*window, "resetLayout")->trigger();
    QTest::qWait(200);
    return window;
}

void addVisions()
{
    QTest::addColumn<ColourVision>("vision");
    QTest::addColumn<QString>("action");
    QTest::newRow("protanopia") << ColourVision::Protanopia << "visionProtanopia";
    QTest::newRow("deuteranopia") << ColourVision::Deuteranopia << "visionDeuteranopia";
    QTest::newRow("tritanopia") << ColourVision::Tritanopia << "visionTritanopia";
}

} // namespace

/// View ▸ Seen with: the window as it looks to eyes without one kind of cones.
class TestColourVision : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void coloursAreSeenAsThePaperHasThem_data()
    {
        QTest::addColumn<ColourVision>("vision");
        QTest::addColumn<QString>("colour");
        QTest::addColumn<QString>("seen");
        const auto add = [](ColourVision vision, const char *colour, const char *seen) {
            QTest::addRow("%d %s", int(vision), colour) << vision << colour << seen;
        };
        // The matrices in decimal numbers, in linear light.
        add(ColourVision::Protanopia, "#ff0000", "#6d5f00");
        add(ColourVision::Protanopia, "#00ff00", "#ffe500");
        add(ColourVision::Protanopia, "#0000ff", "#0059ff");
        add(ColourVision::Protanopia, "#d55e00", "#817100");
        add(ColourVision::Protanopia, "#123456", "#243657");
        add(ColourVision::Deuteranopia, "#ff0000", "#a39000");
        add(ColourVision::Deuteranopia, "#00ff00", "#efd63a");
        add(ColourVision::Deuteranopia, "#0000ff", "#003dfb");
        add(ColourVision::Deuteranopia, "#d55e00", "#9e8c00");
        add(ColourVision::Deuteranopia, "#123456", "#1a3055");
        add(ColourVision::Tritanopia, "#ff0000", "#ff000f");
        add(ColourVision::Tritanopia, "#00ff00", "#00f7d9");
        add(ColourVision::Tritanopia, "#0000ff", "#006b96");
        add(ColourVision::Tritanopia, "#d55e00", "#eb4050");
        add(ColourVision::Tritanopia, "#123456", "#003c40");
        add(ColourVision::Ordinary, "#d55e00", "#d55e00");
    }
    void coloursAreSeenAsThePaperHasThem()
    {
        QFETCH(ColourVision, vision);
        QFETCH(QString, colour);
        QFETCH(QString, seen);
        QCOMPARE(QColor::fromRgb(seenWith(vision, QColor(colour).rgb())).name(), seen);
    }

    void greysStayAndSoDoesAlpha_data() { addVisions(); }
    void greysStayAndSoDoesAlpha()
    {
        QFETCH(ColourVision, vision);
        for (int byte = 0; byte < 256; ++byte) {
            const QRgb grey = qRgba(byte, byte, byte, 255 - byte);
            QCOMPARE(seenWith(vision, grey), grey);
        }
    }

    void aPictureIsSeenPixelByPixel_data() { addVisions(); }
    void aPictureIsSeenPixelByPixel()
    {
        QFETCH(ColourVision, vision);
        QImage picture(64, 3, QImage::Format_ARGB32);
        for (int x = 0; x < 64; ++x) {
            for (int y = 0; y < 3; ++y)
                picture.setPixel(x, y, qRgba(4 * (x / 2), 255 - 3 * x, 80 * y, 255));
        }
        QImage seen = picture;
        seeWith(vision, seen);
        for (int x = 0; x < 64; ++x) {
            for (int y = 0; y < 3; ++y)
                QCOMPARE(seen.pixel(x, y), seenWith(vision, picture.pixel(x, y)));
        }
    }

    void theWindowLooksAsItDoesToSuchEyesAndTellsSo_data() { addVisions(); }
    void theWindowLooksAsItDoesToSuchEyesAndTellsSo()
    {
        QFETCH(ColourVision, vision);
        QFETCH(QString, action);
        const auto window = settledWindow();
        if (window->devicePixelRatio() != std::floor(window->devicePixelRatio()))
            QSKIP("a part that begins between two device pixels is moved to one of them");
        auto *told = named<QAbstractButton>(*window, "statusVision");
        QVERIFY(!told->isVisible());
        const QStringList parts{"canvas", "scrubber", "nextColourButton"};
        QMap<QString, QImage> before;
        for (const QString &part : parts)
            before[part] = shown(*window, part);
        const QImage numbers = shown(*window, "pixelGrid");

        pixelplumb::action(*window, qPrintable(action))->trigger();

        QVERIFY(told->isVisible());
        QVERIFY2(told->text().contains(QLatin1String(QTest::currentDataTag())),
                 qPrintable(told->text()));
        for (const QString &part : parts) {
            QImage seen = before[part];
            seeWith(vision, seen);
            QVERIFY2(seen != before[part], qPrintable(part));
            QVERIFY2(shown(*window, part) == seen, qPrintable(part));
        }
        QVERIFY(shown(*window, "pixelGrid") != numbers);
        grabbed(*window, "vision");

        QTest::mouseClick(told, Qt::LeftButton);
        QVERIFY(!told->isVisible());
        QVERIFY(pixelplumb::action(*window, "visionOrdinary")->isChecked());
        for (const QString &part : parts)
            QVERIFY2(shown(*window, part) == before[part], qPrintable(part));
    }

    void everyPanelOnTheScreenIsDrawnAnewAtOnce()
    {
        const auto window = settledWindow();
        if (!window->screen()->geometry().contains(window->geometry()))
            QSKIP("the offscreen screen does not hold the window at this ratio");
        const auto onScreen = [&](const char *part) {
            const auto *widget = named<QWidget>(*window, part);
            const QPoint place = widget->mapTo(window.get(), QPoint());
            return window->screen()
                ->grabWindow(window->winId(), place.x(), place.y(), widget->width(),
                             widget->height())
                .toImage();
        };
        const QStringList parts{"canvas", "columnTable", "pixelGrid", "pixelHistory"};
        QMap<QString, QImage> before;
        for (const QString &part : parts)
            before[part] = onScreen(qPrintable(part));
        QVERIFY(before["columnTable"] != QImage());

        action(*window, "visionTritanopia")->trigger();
        for (const QString &part : parts)
            QTRY_VERIFY2(onScreen(qPrintable(part)) != before[part], qPrintable(part));
        action(*window, "visionOrdinary")->trigger();
        for (const QString &part : parts)
            QTRY_VERIFY2(onScreen(qPrintable(part)) == before[part], qPrintable(part));
    }

    void theExamplesAreSeenSoToo()
    {
        const auto window = openedWindow();
        action(*window, "visionProtanopia")->trigger();
        action(*window, "showExamples")->trigger();
        const auto *list = named<QListWidget>(*window, "examplesList");
        QVERIFY(list->graphicsEffect());
        action(*window, "visionOrdinary")->trigger();
        QVERIFY(!list->graphicsEffect());
    }

    void whatIsDrawnToldAndCopiedIsAsEver()
    {
        const auto window = openedWindow();
        const Playhead &playhead = *window->parts().playhead;
        window->parts().playhead->pick({27, 19});
        const QImage frame = playhead.frame()->image().copy();
        const QString told = named<QLabel>(*window, "statusPixel")->text();
        window->parts().exports->copyPickedPixel();
        const QString copied = QApplication::clipboard()->text();
        QVERIFY(copied.contains(u'#'));

        action(*window, "visionDeuteranopia")->trigger();
        window->repaint();

        QCOMPARE(playhead.frame()->image(), frame);
        QCOMPARE(named<QLabel>(*window, "statusPixel")->text(), told);
        window->parts().exports->copyPickedPixel();
        QCOMPARE(QApplication::clipboard()->text(), copied);
    }

    void steppingAndEditingGoOnUnderIt()
    {
        const auto window = settledWindow();
        action(*window, "visionProtanopia")->trigger();
        const QImage before = shown(*window, "canvas");
        QTest::keyClick(window.get(), Qt::Key_F10);
        QVERIFY(shown(*window, "canvas") != before);
        QTest::keyClick(window.get(), Qt::Key_F10, Qt::ShiftModifier);
        window->parts().canvas->setFocus();
        QTRY_COMPARE(shown(*window, "canvas"), before);
    }

    void itIsNotKeptForTheNextSession()
    {
        {
            const auto window = openedWindow();
            action(*window, "visionTritanopia")->trigger();
            window->close();
        }
        const auto window = openedWindow();
        QVERIFY(action(*window, "visionOrdinary")->isChecked());
        QVERIFY(!named<QWidget>(*window, "statusVision")->isVisible());
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestColourVision)

} // namespace tst_colourvision

#include "tst_colourvision.moc"
