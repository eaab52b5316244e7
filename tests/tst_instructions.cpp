// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProcess>
#include <QRegularExpression>
#include <QTest>

/// Instruction counts are the same on a busy and on an idle machine, so that they may be asserted.
class TestInstructions : public QObject {
    Q_OBJECT

private slots:
    void aNullObserverCostsWhatNoObserverCosts_data()
    {
        QTest::addColumn<QString>("arithmetic");
        QTest::newRow("exact") << "exact";
        QTest::newRow("float32") << "float32";
    }
    void aNullObserverCostsWhatNoObserverCosts()
    {
        QFETCH(QString, arithmetic);
        const qint64 hooked = instructionsOf({arithmetic, QStringLiteral("hooked")});
        const qint64 twin = instructionsOf({arithmetic, QStringLiteral("twin")});
        // 1 021 000 pixels: what the program itself costs is under half an instruction a pixel.
        constexpr qint64 fewest = qint64(10) * 1021000;
        QVERIFY2(hooked > fewest && twin > fewest, "both loops must have run and been counted");
        const qint64 difference = qAbs(hooked - twin);
        QVERIFY2(
            difference * 100 < twin,
            qPrintable(QStringLiteral("hooked %1, twin %2 instructions").arg(hooked).arg(twin)));
    }

private:
    static qint64 instructionsOf(const QStringList &arguments)
    {
        QProcess valgrind;
        valgrind.start(QStringLiteral("valgrind"),
                       QStringList{QStringLiteral("--tool=callgrind"),
                                   QStringLiteral("--callgrind-out-file=/dev/null"),
                                   QStringLiteral(PIXELPLUMB_KERNELS)}
                           + arguments);
        if (!valgrind.waitForFinished(120000))
            return -1;
        // A program that ended before its time has instructions to count, too.
        if (valgrind.exitStatus() != QProcess::NormalExit || valgrind.exitCode() != 0)
            return -1;
        const QString report = QString::fromUtf8(valgrind.readAllStandardError());
        static const QRegularExpression collected(QStringLiteral("Collected : (\\d+)"));
        return collected.match(report).captured(1).toLongLong();
    }
};

QTEST_GUILESS_MAIN(TestInstructions)
#include "tst_instructions.moc"
