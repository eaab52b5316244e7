// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testprogram.h"

#include <QProcess>
#include <QRegularExpression>
#include <QTest>

namespace tst_instructions {

using namespace Qt::StringLiterals;

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
        const qint64 hooked = instructionsOf({kernels, arithmetic, u"hooked"_s});
        const qint64 twin = instructionsOf({kernels, arithmetic, u"twin"_s});
        // 1 021 000 pixels: the program's own cost is under half an instruction per pixel.
        constexpr qint64 fewest = qint64(10) * 1021000;
        QVERIFY2(hooked > fewest && twin > fewest, "both loops must have run and been counted");
        const qint64 difference = qAbs(hooked - twin);
        QVERIFY2(difference * 100 < twin,
                 qPrintable(u"hooked %1, twin %2 instructions"_s.arg(hooked).arg(twin)));
    }

    void aSceneWithoutEffectsCostsWhatItCostBeforeThereWereAny()
    {
        const QString scene = QStringLiteral(PIXELPLUMB_FLATSCENE);
        const qint64 planned = instructionsOf({scene, u"planned"_s});
        const qint64 plain = instructionsOf({scene, u"plain"_s});
        QVERIFY2(plain > 100'000'000, "some millions of pixels must have been drawn and counted");
        // Each picture checks once; a thousandth would be a few instructions per column.
        QVERIFY2(qAbs(planned - plain) * 1000 < plain,
                 qPrintable(u"planned %1, plain %2"_s.arg(planned).arg(plain)));
    }

private:
    /// The instructions of a program run with these arguments.
    static qint64 instructionsOf(const QStringList &arguments)
    {
        QProcess valgrind;
        valgrind.start(u"valgrind"_s,
                       QStringList{u"--tool=callgrind"_s, u"--callgrind-out-file=/dev/null"_s}
                           + arguments);
        if (!valgrind.waitForFinished(120000))
            return -1;
        // A program that ended early has an instruction count, too.
        if (valgrind.exitStatus() != QProcess::NormalExit || valgrind.exitCode() != 0)
            return -1;
        const QString report = QString::fromUtf8(valgrind.readAllStandardError());
        static const QRegularExpression collected(u"Collected : (\\d+)"_s);
        return collected.match(report).captured(1).toLongLong();
    }
};

PIXELPLUMB_TEST(TestInstructions)

} // namespace tst_instructions

#include "tst_instructions.moc"
