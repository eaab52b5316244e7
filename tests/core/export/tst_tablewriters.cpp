// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/numbertext.h"
#include "core/export/spreadsheettext.h"
#include "core/export/textwriter.h"
#include "tests/support/testprogram.h"

#include <QBuffer>
#include <QJsonDocument>
#include <QJsonValue>
#include <QtTest>

namespace tst_tablewriters {

using namespace pixelplumb;

/// How cells and numbers are written in CSV, JSON and aligned text, whatever the table holds.
class TestTableWriters : public QObject {
    Q_OBJECT

private slots:
    void quotesCellsAfterRfc4180()
    {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        const auto writer = makeCsvWriter(buffer);

        writer->begin({{u"a"_s, Field::Kind::Text}, {u"b"_s, Field::Kind::Text}});
        writer->writeRow({u"1, 2"_s, u"say \"yes\"\nor no"_s});
        writer->writeRow({QString(), u"ÄΔ"_s});
        writer->end();

        QCOMPARE(bytes, QByteArray("a,b\r\n\"1, 2\",\"say \"\"yes\"\"\nor no\"\r\n,ÄΔ\r\n"));
    }

    void noCellIsAFormula_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("cell");
        const auto row = [](const char *text, const char *cell) {
            QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(cell);
        };
        row("", "");
        row("Ann = Bob + 1-2@x.org", "Ann = Bob + 1-2@x.org");
        row("=1+1", "'=1+1");
        row("+1", "'+1");
        row("-1", "'-1");
        row("@SUM(1)", "'@SUM(1)");
        row("\t=1", "'\t'=1");
        row("\r=1", "'\r'=1");
        row("a;=1+1;b", "a;'=1+1;b");
        row("a; =1", "a; '=1");
        row("a\n=1", "a\n'=1");
        row("a|@x", "a|'@x");
        row("a,\"=1\"", "a,\"'=1\"");
        row("＝1+1", "'＝1+1");
        row("＋1", "'＋1");
        row("－1", "'－1");
        row("＠x", "'＠x");
        row("a；＝1", "a；'＝1");
        row("﹦1", "'﹦1");
        row("'=1", "''=1");
        row("a;'=1", "a;''=1");
        row("O'Brien", "O'Brien");
    }
    void noCellIsAFormula()
    {
        QFETCH(QString, text);
        QTEST(spreadsheetText(text), "cell");
    }

    void writesWhatJsonCannotHoldAsText()
    {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        const auto writer = makeJsonWriter(buffer, {});

        writer->begin({{u"error"_s, Field::Kind::Error},
                       {u"name"_s, Field::Kind::Text},
                       {u"count"_s, Field::Kind::Number}});
        writer->writeRow(
            {Quantity::of(std::numeric_limits<double>::quiet_NaN()), u"a\"b"_s, Quantity()});
        writer->writeRow({Quantity::of(-std::numeric_limits<double>::infinity()), QString(),
                          Quantity::integer(7)});
        writer->end();

        const QJsonDocument document = QJsonDocument::fromJson(bytes);
        QCOMPARE(document[u"rows"_s][0][u"error"_s].toString(), u"nan"_s);
        QCOMPARE(document[u"rows"_s][0][u"name"_s].toString(), u"a\"b"_s);
        QVERIFY(document[u"rows"_s][0][u"count"_s].isNull());
        QCOMPARE(document[u"rows"_s][1][u"error"_s].toString(), u"-inf"_s);
        QCOMPARE(document[u"rows"_s][1][u"count"_s].toInt(), 7);
    }

    void spellsNumbersForProgramsWithoutLosingADigit_data()
    {
        QTest::addColumn<Quantity>("number");
        QTest::addColumn<QString>("decimal");
        QTest::addColumn<QString>("fraction");
        const auto row = [](const char *name, const Quantity &number, const char *decimal,
                            const char *fraction) {
            QTest::newRow(name) << number << QString::fromLatin1(decimal)
                                << QString::fromLatin1(fraction);
        };
        row("none", {}, "", "");
        row("whole", Quantity::integer(-17), "-17", "-17");
        row("lattice", Quantity::rational(-23, 4), "-5.75", "-23/4");
        row("between -1 and 0", Quantity::rational(-1, 256), "-0.00390625", "-1/256");
        row("last digit of 32.32", Quantity::rational((Int128(1) << 62) + 1, Int128(1) << 32),
            "1073741824.00000000023283064365386962890625", "4611686018427387905/4294967296");
        row("third", Quantity::rational(1, 3), "0.3333333333333333", "1/3");
        row("float32", Quantity::of(0.1F), "0.10000000149011612", "0.10000000149011612");
        row("nearest to a fraction below zero", Quantity::rational(-2, 99), "-0.020202020202020204",
            "-2/99");
        row("float64", Quantity::of(0.1), "0.1", "0.1");
        row("infinite", Quantity::of(-std::numeric_limits<float>::infinity()), "-inf", "-inf");
        row("no number", Quantity::of(-std::numeric_limits<double>::quiet_NaN()), "nan", "nan");
    }
    void spellsNumbersForProgramsWithoutLosingADigit()
    {
        QFETCH(Quantity, number);

        QTEST(decimalText(number), "decimal");
        QTEST(fractionText(number), "fraction");
    }

    void alignsATextTable()
    {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        const auto writer = makeTextWriter(buffer, TextNumbers::Mixed);

        writer->begin({{u"x"_s, Field::Kind::Number},
                       {u"y_B"_s, Field::Kind::Number, u"⌈y⌉"_s},
                       {u"fate"_s, Field::Kind::Text}});
        writer->writeRow({Quantity::integer(9), Quantity::rational(277, 54), u"a"_s});
        writer->writeRow({Quantity::integer(10), Quantity::rational(-7, 8), QString()});
        writer->writeRow({Quantity::integer(-1), Quantity::integer(12), u"bc"_s});
        writer->end();

        QCOMPARE(QString::fromUtf8(bytes),
                 u" x      ⌈y⌉  fate\n"
                 " 9   5 7/54  a\n"
                 "10     −7/8\n"
                 "−1  12       bc\n"_s);
    }
};

PIXELPLUMB_TEST(TestTableWriters)

} // namespace tst_tablewriters

#include "tst_tablewriters.moc"
