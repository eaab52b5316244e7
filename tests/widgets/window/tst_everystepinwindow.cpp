// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/openwindow.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenesformethods.h"
#include "tests/support/testprogram.h"
#include "tests/support/windowsteps.h"
#include "widgets/model/scenedocument.h"

#include <QTest>

namespace tst_everystepinwindow {

using namespace pixelplumb;

/// Every method beside every scene, its own kind or not, the arithmetics in turn, stepped through
/// in the window: a method may have nothing to draw, but the window always has something to say.
class TestEveryStepInWindow : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void everyMethodCanBeSteppedInTheWindow_data()
    {
        QTest::addColumn<std::size_t>("scene");
        for (std::size_t i = 0; i < m_scenes.size(); ++i)
            QTest::newRow(qPrintable(m_scenes[i].first)) << i;
    }
    void everyMethodCanBeSteppedInTheWindow()
    {
        QFETCH(std::size_t, scene);
        const auto window = openedWindow(m_scenes[scene].second);
        SceneDocument &document = *window->parts().document;
        std::size_t turn = scene;
        constexpr std::size_t share = isSanitized ? 3 : 1;
        for (std::size_t i = scene % share; i < methods().size(); i += share) {
            const Method &method = methods()[i];
            document.setMethod(method.id.toStdString());
            ScanSettings settings = method.adapted(document.scene().settings);
            settings.arithmetic = method.arithmetics[turn++ % method.arithmetics.size()];
            document.setSettings(settings);
            QVERIFY2(waitForRun(*window), qPrintable(method.id));
            const QString fault = faultInSteps(*window);
            QVERIFY2(fault.isEmpty(), qPrintable(fault));
            QVERIFY(!window->grab().isNull());
        }
    }

private:
    IsolatedSettings m_settings;
    const std::vector<NamedScene> m_scenes = scenesForEveryMethod();
};

PIXELPLUMB_TEST(TestEveryStepInWindow)

} // namespace tst_everystepinwindow

#include "tst_everystepinwindow.moc"
