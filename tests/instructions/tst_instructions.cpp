// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testprogram.h"

#include <QProcess>
#include <QRegularExpression>
#include <QTest>

namespace tst_instructions {

/// Instruction counts are the same on a busy and on an idle machine, so tests can assert them.
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
        const QString kernels = QStringLiteral(PIXELPLUMB_KERNELS);
        const qint64 hooked = instructionsOf({kernels, arithmetic, QStringLiteral("hooked")});
        const qint64 twin = instructionsOf({kernels, arithmetic, QStringLiteral("twin")});
        // 1 021 000 pixels: the program's own cost is under half an instruction per pixel.
        constexpr qint64 fewest = qint64(10) * 1021000;
        QVERIFY2(hooked > fewest && twin > fewest, "both loops must have run and been counted");
        const qint64 difference = qAbs(hooked - twin);
        QVERIFY2(
            difference * 100 < twin,
            qPrintable(QStringLiteral("hooked %1, twin %2 instructions").arg(hooked).arg(twin)));
    }

    void aSceneWithoutEffectsCostsWhatItCostBeforeThereWereAny()
    {
        const QString scene = QStringLiteral(PIXELPLUMB_FLATSCENE);
        const qint64 planned = instructionsOf({scene, QStringLiteral("planned")});
        const qint64 plain = instructionsOf({scene, QStringLiteral("plain")});
        QVERIFY2(plain > 100'000'000, "some millions of pixels must have been drawn and counted");
        // Each picture checks once; a thousandth would be a few instructions per column.
        QVERIFY2(qAbs(planned - plain) * 1000 < plain,
                 qPrintable(QStringLiteral("planned %1, plain %2").arg(planned).arg(plain)));
    }

private:
    /// The instructions of a program run with these arguments.
    static qint64 instructionsOf(const QStringList &arguments)
    {
        QProcess valgrind;
        valgrind.start(QStringLiteral("valgrind"),
                       QStringList{QStringLiteral("--tool=callgrind"),
                                   QStringLiteral("--callgrind-out-file=/dev/null")}
                           + arguments);
        if (!valgrind.waitForFinished(120000))
            return -1;
        // A program that ended early has an instruction count, too.
        if (valgrind.exitStatus() != QProcess::NormalExit || valgrind.exitCode() != 0)
            return -1;
        const QString report = QString::fromUtf8(valgrind.readAllStandardError());
        static const QRegularExpression collected(QStringLiteral("Collected : (\\d+)"));
        return collected.match(report).captured(1).toLongLong();
    }
};

PIXELPLUMB_TEST(TestInstructions)

} // namespace tst_instructions

#include "tst_instructions.moc"
