// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testprogram.h"

#include <QProcess>
#include <QTest>

namespace tst_windowoptions {

using namespace Qt::StringLiterals;

/// The command line of the window.
class TestWindowOptions : public QObject {
    Q_OBJECT

private slots:
    void whatCannotBeMeantEndsTheProgramAsAUsageError_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("message");
        const auto row = [](const QStringList &arguments, const char *message) {
            QTest::newRow(qPrintable(u'(' + arguments.join(u' ') + u')'))
                << arguments << QByteArray(message);
        };
        row({"--nosuch"}, "nosuch");
        row({"-x"}, "x");
        row({"--position"}, "position");
        row({"--position=-1"}, "--position -1: expected 0 or more");
        row({"--position=many"}, "--position many: expected an integer");
        row({"--position=1", "--position=2"}, "--position stands twice");
        row({"--palette="}, "expected light, dark or system");
        row({"--method=%1\x1b[31m"}, "--method %1\\x1b[31m: expected a method");
        row({""}, "expected one scene");
        row({"a.json", "b.json"}, "b.json");
    }
    void whatCannotBeMeantEndsTheProgramAsAUsageError()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, message);
        QProcess process;
        process.start(QStringLiteral(PIXELPLUMB_WINDOW), arguments);
        QVERIFY(process.waitForFinished(120'000));

        const QByteArray told = process.readAllStandardError();
        QVERIFY2(process.exitCode() == 2, told.constData());
        QVERIFY2(told.contains(message), told.constData());
    }

    /// QProcess encodes its arguments: only a shell can name such a file.
    void aNameThatIsNotUtf8IsRefused()
    {
        QProcess process;
        process.start(
            u"sh"_s,
            {u"-c"_s, u"\"$0\" \"$(printf 'a\\377.json')\""_s, QStringLiteral(PIXELPLUMB_WINDOW)});
        QVERIFY(process.waitForFinished(120'000));
        QCOMPARE(process.exitCode(), 2);
        QCOMPARE(
            process.readAllStandardError(),
            QByteArray("pixelplumb: argument 1, “a\\xff.json”, is not UTF-8; expected names in "
                       "UTF-8\n"));
    }

    void helpIsNoError()
    {
        QProcess process;
        process.start(QStringLiteral(PIXELPLUMB_WINDOW), {"--help"});
        QVERIFY(process.waitForFinished(120'000));
        QCOMPARE(process.exitCode(), 0);
        QVERIFY(process.readAllStandardOutput().contains("--position"));
    }
};

PIXELPLUMB_TEST(TestWindowOptions)

} // namespace tst_windowoptions

#include "tst_windowoptions.moc"
