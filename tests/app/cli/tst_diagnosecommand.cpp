// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/defect.h"
#include "tests/support/probescenes.h"
#include "tests/support/programrun.h"
#include "tests/support/testprogram.h"

#include <QTest>

namespace tst_diagnosecommand {

using namespace pixelplumb;

/// The bugs that a picture may have are listed on the command line.
class TestDiagnoseCommand : public QObject {
    Q_OBJECT

private slots:
    void theDefectsOfAMethodAreListed()
    {
        const ProgramRun listed = run({QStringLiteral("probes"), QStringLiteral("--list"),
                                       QStringLiteral("--method"), QStringLiteral("row-walk")});
        QCOMPARE(listed.exitCode, 0);
        for (const Scene &scene : probeScenes("row-walk")) {
            for (const Defect &defect : defectsFor(scene))
                QVERIFY2(listed.output.contains('\n' + defect.id.toUtf8() + ' ')
                             || listed.output.startsWith(defect.id.toUtf8() + ' '),
                         qPrintable(defect.id));
        }
        QVERIFY(listed.output.contains("\nunsorted-colours "));
    }
};

PIXELPLUMB_TEST(TestDiagnoseCommand)

} // namespace tst_diagnosecommand

#include "tst_diagnosecommand.moc"
