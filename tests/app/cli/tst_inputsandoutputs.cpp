// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/inputrecord.h"
#include "tests/support/testprogram.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace tst_inputsandoutputs {

using namespace pixelplumb;

/// What counts as read, and for whom. That no command writes what it reads is in
/// tests/data/transcripts/inputs.txt.
class TestInputsAndOutputs : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const QString &name) const { return m_folder.filePath(name); }

private slots:
    void init() { QVERIFY(m_folder.isValid()); }

    void whatIsNoLongerThereIsNoInput()
    {
        const InputRecord record;
        const QString input = path("input"), output = path("output");
        QVERIFY(!writeFile(input, "a"));
        QVERIFY(readFile(input).isOk());
        QVERIFY(isInput(input));
        QVERIFY(writeFile(input, "b"));
        QVERIFY(!writeFile(input, "b", WrittenAs::Document));
        QVERIFY(isInput(input)); // another file by the same name

        // Its number is free for the next file.
        QVERIFY(QFile::remove(input));
        for (int i = 0; i < 4; ++i)
            QVERIFY(!writeFile(output, "c"));
    }

    void aCommandKnowsItsOwnInputsAlone()
    {
        const QString input = path("input");
        QVERIFY(!writeFile(input, "a"));
        {
            const InputRecord record;
            const InputRecord another;
            QVERIFY(readFile(input).isOk());
        }
        QVERIFY(!isInput(input));
        QVERIFY(!writeFile(input, "b"));
    }
};

PIXELPLUMB_TEST(TestInputsAndOutputs)

} // namespace tst_inputsandoutputs

#include "tst_inputsandoutputs.moc"
