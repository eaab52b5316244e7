// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/traceexport.h"
#include "core/scan/choicenames.h"
#include "tests/support/scenesformethods.h"
#include "tests/support/tablefolder.h"
#include "tests/support/testprogram.h"

#include <QSet>
#include <QtTest>

namespace tst_exportedtables {

using namespace pixelplumb;

namespace {

constexpr std::array allLevels = {TraceLevel::SetUp, TraceLevel::Column, TraceLevel::Pixel};

} // namespace

/// Every table that can be exported can be read by the programs for which it is meant.
class TestExportedTables : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(scenesForEveryMethod().size() > 12); }

    void everyMethodNamesItsNumbersOnce_data() { addMethods(); }
    void everyMethodNamesItsNumbersOnce()
    {
        QFETCH(const Method *, method);

        // What a sample's table says of every method; a method may describe the same numbers.
        const QSet<QString> shared
            = {QStringLiteral("primitive"), QStringLiteral("x"), QStringLiteral("y"),
               QStringLiteral("R"),         QStringLiteral("G"), QStringLiteral("B")};
        const TraceNumbers bare;
        for (const TraceLevel level : allLevels) {
            const QStringList common = traceColumnNames(bare, level);
            QStringList own;
            for (const NumberDescription &number : level == TraceLevel::SetUp
                     ? method->numbers.setUp
                     : level == TraceLevel::Column ? method->numbers.span
                                                   : method->numbers.sample) {
                QVERIFY2(!own.contains(number.id), qPrintable(number.id));
                own.append(number.id);
                QVERIFY2(shared.contains(number.id) || !common.contains(number.id),
                         qPrintable(number.id));
            }
            QStringList all = traceColumnNames(method->numbers, level);
            QCOMPARE(all.removeDuplicates(), qsizetype(0));
            for (const QString &id : own)
                QVERIFY2(all.contains(id), qPrintable(id));
        }
    }

    void everyTableOfEveryMethodIsWellFormed_data() { addMethods(); }
    void everyTableOfEveryMethodIsWellFormed()
    {
        QFETCH(const Method *, method);

        for (const NamedScene &each : scenesForEveryMethod()) {
            for (const Arithmetic arithmetic : method->arithmetics) {
                const QString name = QStringLiteral("%1-%2-%3")
                                         .arg(method->id, each.first, nameText(nameOf(arithmetic)));
                const QString fault
                    = m_folder.faultOfKept(*tracedBy(*method, arithmetic, each.second), name);
                QVERIFY2(fault.isEmpty(), qPrintable(name + QStringLiteral(": ") + fault));
            }
        }
    }

    void pythonReadsThemToo()
    {
        QVERIFY(m_folder.keptCount() > 1000);
        const QString fault = m_folder.faultByPython();
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }

private:
    static void addMethods()
    {
        QTest::addColumn<const Method *>("method");
        for (const Method &method : methods())
            QTest::newRow(qPrintable(method.id)) << &method;
    }
    TableFolder m_folder;
};

PIXELPLUMB_TEST(TestExportedTables)

} // namespace tst_exportedtables

#include "tst_exportedtables.moc"
