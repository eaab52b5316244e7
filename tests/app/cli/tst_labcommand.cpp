// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/labfile.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/programs/programrun.h"
#include "tests/support/testprogram.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

namespace tst_labcommand {

using namespace pixelplumb;

class TestLabCommand : public QObject {
    Q_OBJECT

private slots:
    void writesWhatCanBeRead()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"study.json"_s);

        const ProgramRun written
            = run({"lab", defaultScene(), "--family", "own-scene", "--contender",
                   "column-scan:exact,column-scan:float32", "--format", "json", "-o", file});
        QFile opened(file);
        QVERIFY(opened.open(QIODevice::ReadOnly));
        const Result<Study> study = readStudy(opened.readAll());

        QCOMPARE(written.exitCode, 0);
        QVERIFY(bool(study));
        QCOMPARE(study->rows.size(), std::size_t(2));
    }

    void anInterruptedStudyWritesWhatItHas()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"study.json"_s);
        QProcess process;
        process.start(program(), {"lab", "--full", "--format", "json", "-o", file});
        QVERIFY(process.waitForStarted());
        QTest::qWait(1000); // its judging takes minutes

        ::kill(pid_t(process.processId()), SIGINT);

        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitCode(), 1);
        const QByteArray told = process.readAllStandardError();
        QVERIFY(told.contains("Ctrl-C again ends at once") && told.contains("interrupted"));
        const auto study = readStudy(*readFile(file));
        QVERIFY(study);
        QVERIFY(!study->isComplete);
        QVERIFY(!study->rows.empty());
    }
};

PIXELPLUMB_TEST(TestLabCommand)

} // namespace tst_labcommand

#include "tst_labcommand.moc"
