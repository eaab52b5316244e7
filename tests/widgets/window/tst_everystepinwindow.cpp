// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/method.h"
#include "core/runs/scenerun.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/scenesformethods.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "tests/support/window/windowsteps.h"
#include "widgets/model/scenedocument.h"

#include <QTest>

#include <algorithm>

namespace tst_everystepinwindow {

using namespace pixelplumb;

/// Every method with a scene that has primitives of all kinds, and every scene under a method that
/// draws it and one that does not, in alternating arithmetics, stepped through in the window: a
/// method may draw nothing, but the window always has something to say. tst_everyrun checks what it
/// says about every run, without a window.
class TestEveryStepInWindow : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void everyMethodCanBeSteppedInTheWindow()
    {
        const Scene &mixed = std::ranges::find(m_scenes, u"mixed"_s, &NamedScene::first)->second;
        const auto window = openedWindow(mixed);
        std::size_t turn = 0;
        constexpr std::size_t share = isSanitized ? 3 : 1;
        for (std::size_t i = 0; i < methods().size(); i += share)
            QCOMPARE(faultUnder(*window, methods()[i], turn++), QString());
    }

    void everySceneCanBeSteppedInTheWindow_data()
    {
        QTest::addColumn<std::size_t>("scene");
        for (std::size_t i = 0; i < m_scenes.size(); ++i)
            QTest::newRow(qPrintable(m_scenes[i].first)) << i;
    }
    void everySceneCanBeSteppedInTheWindow()
    {
        QFETCH(std::size_t, scene);
        const auto window = openedWindow(m_scenes[scene].second);
        // One method of each sort, a different one from scene to scene.
        for (const bool draws : {true, false}) {
            Scene drawn = m_scenes[scene].second;
            for (std::size_t i = 0; i < methods().size(); ++i) {
                const Method &method = methods()[(scene + i) % methods().size()];
                drawn.method = method.id.toStdString();
                drawn.settings = method.adapted(m_scenes[scene].second.settings);
                if (drawsAnyOf(drawn) != draws || !objectionTo(drawn).isEmpty())
                    continue;
                QCOMPARE(faultUnder(*window, method, scene), QString());
                break;
            }
        }
    }

private:
    /// What the window fails to show at the steps of its scene under a method; empty if nothing.
    static QString faultUnder(MainWindow &window, const Method &method, std::size_t turn)
    {
        SceneDocument &document = *window.parts().document;
        document.setMethod(method.id.toStdString());
        ScanSettings settings = method.adapted(document.scene().settings);
        settings.arithmetic = method.arithmetics[turn % method.arithmetics.size()];
        document.setSettings(settings);
        if (!waitForRun(window))
            return method.id + u": no run"_s;
        const QString fault = faultInSteps(window);
        window.grab(); // painting must not fail
        return fault;
    }

    IsolatedSettings m_settings;
    const std::vector<NamedScene> m_scenes = scenesForEveryMethod();
};

PIXELPLUMB_TEST(TestEveryStepInWindow)

} // namespace tst_everystepinwindow

#include "tst_everystepinwindow.moc"
