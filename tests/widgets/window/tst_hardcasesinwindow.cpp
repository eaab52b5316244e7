// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/casestorun.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scenes/hardcasescenes.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "tests/support/window/windowsteps.h"
#include "widgets/model/scenedocument.h"

#include <QTest>

#include <numeric>

namespace tst_hardcasesinwindow {

using namespace pixelplumb;

namespace {

/// The limit for a method that visits each pixel for each primitive. Above it, the case's detail is
/// opened: the pixels around the place where the case is hard.
constexpr std::int64_t mostVisits = 1'000'000;

/// One in this many methods opens a case.
constexpr std::size_t methodShare = 3;

std::int64_t visitsOf(const Scene &scene)
{
    return std::int64_t(scene.frame.width) * scene.frame.height
        * std::int64_t(scene.triangles.size() + scene.shapes.size());
}

/// The cases; the largest ones are replaced by their details.
std::vector<NamedScene> casesToOpen()
{
    std::vector<NamedScene> cases = hardCaseScenes();
    const std::vector<NamedScene> details = hardCaseDetails();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (visitsOf(cases[i].second) > mostVisits)
            cases[i] = {details[i].first + u", detail"_s, details[i].second};
    }
    return cases;
}

} // namespace

/// Every hard case under a third of the methods, whether they draw its kind or not, and every
/// method with a third of the cases, stepped through in the window. The arithmetics alternate, too;
/// tst_everyrun runs every case under every method.
class TestHardCasesInWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_cases.size() > 70);
        m_settings.clear();
        m_window = openedWindow();
    }

    void everyHardCaseCanBeSteppedInTheWindow_data()
    {
        QTest::addColumn<std::size_t>("index");
        std::vector<std::size_t> all(m_cases.size());
        std::iota(all.begin(), all.end(), 0U);
        const auto methodsOf
            = [](std::size_t index) { return QString::number(index % methodShare); };
        for (const std::size_t index : casesToRun(all, methodsOf))
            QTest::newRow(qPrintable(m_cases[index].first)) << index;
    }
    void everyHardCaseCanBeSteppedInTheWindow()
    {
        QFETCH(std::size_t, index);
        // The arithmetics alternate from case to case and from method to method.
        std::size_t turn = index / methodShare;
        for (std::size_t i = index % methodShare; i < methods().size(); i += methodShare) {
            const Method &method = methods()[i];
            Scene scene = m_cases[index].second;
            scene.method = method.id.toStdString();
            scene.settings = method.adapted(scene.settings);
            scene.settings.arithmetic = method.arithmetics[turn++ % method.arithmetics.size()];
            m_window->parts().document->reset(scene);
            QVERIFY2(waitForRun(*m_window), scene.method.c_str());
            const QString fault = faultInSteps(*m_window);
            QVERIFY2(fault.isEmpty(), qPrintable(fault));
        }
    }

    void cleanupTestCase() { m_window.reset(); }

private:
    IsolatedSettings m_settings;
    const std::vector<NamedScene> m_cases = casesToOpen();
    std::unique_ptr<MainWindow> m_window; ///< one window for all, as for a user who opens one after
                                          ///< the other
};

PIXELPLUMB_TEST(TestHardCasesInWindow)

} // namespace tst_hardcasesinwindow

#include "tst_hardcasesinwindow.moc"
