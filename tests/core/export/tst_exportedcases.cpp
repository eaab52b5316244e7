// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scan/choicenames.h"
#include "tests/support/hardcasescenes.h"
#include "tests/support/tablefolder.h"
#include "tests/support/testprogram.h"

#include <QtTest>

namespace tst_exportedcases {

using namespace pixelplumb;

/// Every table of every hard case, the arithmetics in turn, can be read by the programs for which
/// it is meant; tst_exportedtables has all arithmetics.
class TestExportedCases : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_cases = hardCaseDetails();
        QVERIFY(m_cases.size() > 70);
    }

    void everyTableOfEveryHardCaseIsWellFormed_data()
    {
        QTest::addColumn<const Method *>("method");
        for (const Method &method : methods())
            QTest::newRow(qPrintable(method.id)) << &method;
    }
    void everyTableOfEveryHardCaseIsWellFormed()
    {
        QFETCH(const Method *, method);

        std::size_t turn = 0;
        for (const NamedScene &each : m_cases) {
            const Arithmetic arithmetic = method->arithmetics[turn++ % method->arithmetics.size()];
            const QString name = QStringLiteral("%1-%2-%3")
                                     .arg(method->id, each.first, nameText(nameOf(arithmetic)));
            const auto traced = tracedBy(*method, arithmetic, each.second);
            const QString fault = m_folder.faultOfKept(*traced, name);
            QVERIFY2(fault.isEmpty(), qPrintable(name + QStringLiteral(": ") + fault));
        }
    }

    void pythonReadsThemToo()
    {
        QVERIFY(m_folder.keptCount() > 1000);
        const QString fault = m_folder.faultByPython();
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }

private:
    TableFolder m_folder;
    std::vector<NamedScene> m_cases;
};

PIXELPLUMB_TEST(TestExportedCases)

} // namespace tst_exportedcases

#include "tst_exportedcases.moc"
