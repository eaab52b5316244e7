// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/fileaccess.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/files/sceneexports.h"
#include "widgets/files/scenefiles.h"
#include "widgets/look/corewords.h"
#include "widgets/look/labels.h"
#include "widgets/look/numberformat.h"

#include <QtTest>
#include <QtWidgets>

namespace tst_decimalpoint {

using namespace pixelplumb;

namespace {

/// The locale that widgets use on a system where numbers have a comma.
class CommaLocale {
public:
    CommaLocale() { QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany)); }
    ~CommaLocale() { keepDecimalPoint(); }
    Q_DISABLE_COPY_MOVE(CommaLocale)
};

/// All files with numbers that the window writes for the first scene, by name.
QMap<QString, QByteArray> writtenFiles()
{
    const QTemporaryDir folder;
    const auto window = openedWindow();
    SceneExports *exports = window->parts().exports;
    const auto path = [&folder](const QString &name) { return folder.filePath(name); };
    window->parts().files->saveTo(path("scene.json"));
    exports->writeRaster(path("raster.txt"));
    for (const auto &[name, level, format] :
         {std::tuple("columns.csv", TraceLevel::Column, TableFormat::Csv),
          std::tuple("columns.json", TraceLevel::Column, TableFormat::Json),
          std::tuple("pixels.csv", TraceLevel::Pixel, TableFormat::Csv),
          std::tuple("pixels.json", TraceLevel::Pixel, TableFormat::Json)}) {
        exports->writeTrace(path(name), level, format);
        if (!QTest::qWaitFor([exports] { return !exports->writing().isRunning(); }, 60000))
            return {};
    }
    QMap<QString, QByteArray> files;
    for (const QString &name : QDir(folder.path()).entryList(QDir::Files))
        files[name] = *readFile(path(name));
    return files;
}

} // namespace

/// Numbers have a decimal point on the screen and in files, in every language.
class TestDecimalPoint : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void filesAreTheSameInEveryLocaleAndLanguage()
    {
        const QMap<QString, QByteArray> expected = writtenFiles();
        QCOMPARE(expected.size(), 6);
        QVERIFY(expected["columns.csv"].contains("8.37037"));

        const CommaLocale comma;
        const Translation german({"de"});
        const QMap<QString, QByteArray> files = writtenFiles();

        QCOMPARE(files.keys(), expected.keys());
        for (const QString &name : files.keys())
            QVERIFY2(files[name] == expected[name], qPrintable(name));
    }

    void theProgramsLocaleHasAPointAndNoSignsBetweenThousands()
    {
        const CommaLocale comma;
        QCOMPARE(QLocale().toString(1234.5), "1.234,5");

        keepDecimalPoint();

        QCOMPARE(QLocale().toString(1234.5), "1234.5");
        QCOMPARE(u"%L1"_s.arg(1234567), "1234567");
    }

    void groupsAreApartBySpacesThatDoNotBreak()
    {
        QCOMPARE(groupedText(1234567), "1\u202f234\u202f567");
        QCOMPARE(groupedText(1234.5, 1), "1\u202f234.5");
        QCOMPARE(groupedText(999), "999");
    }

    void theSpeedHasAPointInGerman()
    {
        const Translation german({"de"});
        const auto window = openedWindow();

        QCOMPARE(named<QDoubleSpinBox>(*window, "speedBox")->text(), "10.0 /s");
    }

    void aTypedCommaIsAPoint_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::newRow("point") << "2.5";
        QTest::newRow("comma") << "2,5";
    }
    void aTypedCommaIsAPoint()
    {
        QFETCH(QString, typed);
        DecimalBox box;
        box.setDecimals(1);

        box.selectAll();
        QTest::keyClicks(&box, typed);
        QTest::keyClick(&box, Qt::Key_Return);

        QCOMPARE(box.value(), 2.5);
        QCOMPARE(box.text(), "2.5");
    }

    void aCoordinateWithACommaIsRefusedInWords()
    {
        const Translation german({"de"});
        const auto window = openedWindow();
        QSignalSpy refused(window->parts().document, &SceneDocument::refused);
        window->parts().canvas->editCoordinates({0, 0});
        auto *dialog = named<QInputDialog>(*window, "vertexDialog");
        dialog->setTextValue(u"1,5; 2"_s);
        dialog->accept();
        QCOMPARE(refused.count(), 1);
        const QString told = refused.front().front().toString();
        QVERIFY2(told.contains(u"1,5"_s), qPrintable(told));
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestDecimalPoint)

} // namespace tst_decimalpoint

#include "tst_decimalpoint.moc"
