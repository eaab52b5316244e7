// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/gradefolder.h"
#include "tests/support/submissions.h"
#include "tests/support/testprogram.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

namespace tst_gradeclass {

using namespace pixelplumb;

/// A class of 200: right, each defect, pairs of them, what nobody can explain, what is no picture.
class TestGradeClass : public QObject {
    Q_OBJECT

private slots:
    void twoHundredSubmissionsAreGraded()
    {
        const QTemporaryDir folder;
        const Assignment assignment = exampleAssignment();
        const std::vector<Defect> defects = defectsOf(assignment);
        std::size_t explicable = 0;
        for (std::size_t i = 0; i < 200; ++i) {
            const QString own
                = folder.filePath(QStringLiteral("subs/%1").arg(i, 3, 10, QLatin1Char('0')));
            const Defect &one = defects[i % defects.size()];
            const Defect &other = defects[(7 * i + 11) % defects.size()];
            const bool isPair
                = i >= defects.size() && one.id != other.id && canBeTogether(one, other);
            QVERIFY(deliver(own, assignment, isPair ? std::vector{one, other} : std::vector{one}));
            const QString first
                = QStringLiteral("%1/%2.png").arg(own, assignment.scenes.front().name);
            if (i % 20 == 3) {
                QVERIFY(writeTo(first, QByteArray::number(qulonglong(i))));
            } else if (i % 10 == 4) { // a pixel that nobody would write
                QImage image(first);
                image.setPixel(int(i % 40), 1, qRgb(1, 2, 3));
                QVERIFY(image.save(first));
            } else {
                ++explicable;
            }
        }

        QElapsedTimer watch;
        watch.start();
        const auto report
            = gradeFolder({folder.filePath(QStringLiteral("subs")),
                           folder.filePath(QStringLiteral("results")), QStringLiteral("1"), 2},
                          assignment);
        const qint64 elapsed = watch.elapsed();
        QVERIFY(report.isOk() && report->has_value());
        QCOMPARE((*report)->submissions.size(), 200U);
        std::size_t explained = 0;
        for (const GradedSubmission &each : (*report)->submissions)
            explained += each.verdict == GradeVerdict::Right || each.isExplained() ? 1 : 0;
        qInfo("200 submissions in %lld ms, %zu explained, %zu causes", qlonglong(elapsed),
              explained, clustersOf(**report).size());
        QVERIFY(explained >= explicable * 9 / 10);
    }
};

PIXELPLUMB_TEST(TestGradeClass)

} // namespace tst_gradeclass

#include "tst_gradeclass.moc"
