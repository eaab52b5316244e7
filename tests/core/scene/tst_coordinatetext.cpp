// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/text/coordinatetext.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_coordinatetext {

using namespace pixelplumb;

/// Coordinates as texts: read exactly, snapped to the lattice, or refused with a reason.
class TestCoordinateText : public QObject {
    Q_OBJECT

private slots:
    void readsACoordinateExactly_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<qint64>("units");
        QTest::addColumn<QString>("displacement");
        const auto row = [](const char *text, qint64 units, const char *displacement = "0") {
            QTest::newRow(text) << QString::fromUtf8(text) << units
                                << QString::fromUtf8(displacement);
        };
        row("26", 26 * 256);
        row("-26", -26 * 256);
        row("+26", 26 * 256);
        row("−26", -26 * 256);
        row(" 26 ", 26 * 256);
        row("26.5", 26 * 256 + 128);
        row("26.", 26 * 256);
        row(".5", 128);
        row("1e3", 1000 * 256);
        row("2.65E+1", 26 * 256 + 128);
        row("256e-2", 655, "-9/6400"); // 2.56 px = 655.36 units
        row("27/2", 13 * 256 + 128);
        row("17 3/8", 17 * 256 + 96);
        row("17\u20093/8", 17 * 256 + 96);
        row("-17 3/8", -(17 * 256 + 96));
        row("1/3", 85, "-1/768"); // 256/3 = 85 1/3
        row("-1/3", -85, "1/768");
        row("12.1", 3098, "1/640"); // 3097.6 units
        row("1/512", 1, "1/512"); // halves go up
        row("-1/512", 0, "1/512");
        row("3/512", 2, "1/512");
        row("-3/512", -1, "1/512");
        row("-0", 0);
        row("1073741824", largestCoordinate);
        row("-1073741824", -largestCoordinate);
        // 0.1 is not a double, and not on the lattice: 25.6 units.
        row("0.1", 26, "1/640");
        // One part in 10^30 above or below the midpoint between two lattice points decides.
        row("0.001953124999999999999999999999999999", 0, "-0.001953125");
        row("0.001953125000000000000000000000000001", 1, "0.001953125");
        row("4181389724724491839037947176121567782371328/"
            "1393796574908163946345982392040522594123776",
            3 * 256);
        row("1/1393796574908163946345982392040522594123776", 0, "-7.174648137343064e-43");
        row("1e-999", 0, "-5e-324");
    }
    void readsACoordinateExactly()
    {
        QFETCH(QString, text);
        QFETCH(qint64, units);
        QFETCH(QString, displacement);

        const Result<SnappedNumber> snapped = parseCoordinate(text);

        QVERIFY2(snapped.isOk(), snapped ? "" : qPrintable(snapped.error().message()));
        QCOMPARE(snapped->units, units);
        QCOMPARE(toText(snapped->displacement), displacement);
        QCOMPARE(snapped->isDisplaced(), displacement != u"0"_s);
    }

    void refusesWhatIsNoCoordinate_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("found");
        const auto row = [](const char *text, const char *found) {
            QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(found);
        };
        row("", "“” is no coordinate");
        row("nan", "“nan” is no coordinate");
        row("NaN", "“NaN” is no coordinate");
        row("inf", "“inf” is no coordinate");
        row("-Infinity", "“-Infinity” is no coordinate");
        row("twelve", "“twelve” is no coordinate");
        row("1.2.3", "“1.2.3” is no coordinate");
        row("1,5", "“1,5” is no coordinate");
        row("--1", "“--1” is no coordinate");
        row("0x10", "“0x10” is no coordinate");
        row(".", "“.” is no coordinate");
        row("e5", "“e5” is no coordinate");
        row("1e", "“1e” is no coordinate");
        row("1/2/3", "“1/2/3” is no coordinate");
        row("1/-2", "“1/-2” is no coordinate");
        row("1.5 1/2", "“1.5 1/2” is no coordinate");
        row("1 2", "“1 2” is no coordinate");
        row("٣", "“٣” is no coordinate");
        row("1/0", "1/0 divides by zero");
        row("3e9", "3e9 is outside ±1073741824 px");
        row("-1073741825", "-1073741825 is outside ±1073741824 px");
        row("1073741824.0000000000000000000001",
            "1073741824.0000000000000000000001 is outside ±1073741824 px");
        row("1e99999999999999999999", "1e99999999999999999999 is outside ±1073741824 px");
    }
    void refusesWhatIsNoCoordinate()
    {
        QFETCH(QString, text);
        QFETCH(QString, found);

        const Result<SnappedNumber> snapped = parseCoordinate(text);

        QVERIFY(!snapped.isOk());
        QCOMPARE(snapped.error().found, found);
    }

    void refusesATextOfAThousandDigits()
    {
        const Result<SnappedNumber> snapped = parseCoordinate(QString(1000, u'1'));

        QVERIFY(!snapped.isOk());
        QVERIFY(snapped.error().found.endsWith(u"is longer than 400 characters"_s));
    }

    void writesTheShortestExactCoordinate_data()
    {
        QTest::addColumn<qint64>("units");
        QTest::addColumn<QString>("text");
        QTest::newRow("whole") << qint64(26 * 256) << "26";
        QTest::newRow("half") << qint64(26 * 256 + 128) << "53/2";
        QTest::newRow("negative") << qint64(-1) << "-1/256";
        QTest::newRow("zero") << qint64(0) << "0";
        QTest::newRow("largest") << qint64(largestCoordinate - 1) << "274877906943/256";
    }
    void writesTheShortestExactCoordinate()
    {
        QFETCH(qint64, units);
        QFETCH(QString, text);

        QCOMPARE(coordinateText(units), text);
        QCOMPARE(parseCoordinate(text)->units, units);
    }
};

PIXELPLUMB_TEST(TestCoordinateText)

} // namespace tst_coordinatetext

#include "tst_coordinatetext.moc"
