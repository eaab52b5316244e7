// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenefile.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/openwindow.h"
#include "tests/support/scanning.h"
#include "widgets/messagebar.h"
#include "widgets/scenedocument.h"
#include "widgets/scenefiles.h"

#include <QTest>

using namespace pixelplumb;

namespace {

QString writtenFile(const IsolatedSettings &settings, const QString &name, const QByteArray &text)
{
    const QString path = settings.folder() + QLatin1Char('/') + name;
    QFile file(path);
    if (file.open(QIODevice::WriteOnly))
        file.write(text);
    return path;
}

} // namespace

/// Scenes opened and saved in the window, and what it asks and tells of them.
class TestWindowFiles : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void unsavedChangesAskBeforeTheWindowCloses()
    {
        const auto window = openedWindow();
        clickPixel(*window, {10, 40});
        int questions = 0;
        auto answer = UnsavedChanges::Cancel;
        window->parts().files->askAboutChanges = [&] {
            ++questions;
            return answer;
        };

        QVERIFY(!window->close());
        QVERIFY(window->isVisible());
        answer = UnsavedChanges::Discard;
        QVERIFY(window->close());
        QCOMPARE(questions, 2);
    }

    void anUnchangedWindowClosesWithoutAQuestion()
    {
        const auto window = openedWindow();
        window->parts().files->askAboutChanges = [] {
            QTest::qFail("asked", __FILE__, __LINE__);
            return UnsavedChanges::Cancel;
        };
        QVERIFY(window->close());
    }

    void savesAndOpensTheSameScene()
    {
        const auto window = openedWindow();
        window->parts().document->addTriangle(triangleAt(1, 1, 9, 2, 5, 20));
        const Scene saved = window->parts().document->scene();
        const QString path = m_settings.folder() + "/two.json";
        QVERIFY(window->parts().files->saveTo(path));
        QCOMPARE(window->windowTitle(), "two.json[*] — Pixelplumb");
        QVERIFY(!window->isWindowModified());

        const auto other = openedWindow();
        QVERIFY(other->openScene(path));
        QVERIFY(other->parts().document->scene() == saved);
        QVERIFY(action(*other, "revertScene")->isEnabled());
    }

    void aFileThatCannotBeReadIsToldInTheMessageBar()
    {
        const auto window = openedWindow();
        const Scene before = window->parts().document->scene();
        const QString path = writtenFile(m_settings, "cut.json", "{ \"pixelplumb\": 1, \"frame\"");

        QVERIFY(!window->openScene(path));

        const auto *bar = named<MessageBar>(*window, "messageBar");
        QVERIFY(bar->isVisible());
        QVERIFY2(bar->text().contains("cut.json"), qPrintable(bar->text()));
        QVERIFY(window->parts().document->scene() == before);
        QVERIFY(!window->openScene(m_settings.folder() + "/missing.json"));
        QVERIFY(bar->text().contains("missing.json"));
    }

    void tellsWhatSnappingDisplaced()
    {
        const auto window = openedWindow();
        Scene scene;
        scene.triangles = {triangleAt(1, 1, 9, 2, 5, 12)};
        QByteArray text = writeScene(scene);
        QVERIFY(text.contains("[1, 1]"));
        const QString path
            = writtenFile(m_settings, "snap.json", text.replace("[1, 1]", "[1.1, 1]"));
        const auto *bar = named<MessageBar>(*window, "messageBar");
        QVERIFY2(window->openScene(path), qPrintable(bar->text()));

        QVERIFY(bar->isVisible());
        QVERIFY2(bar->text().contains("1.1"), qPrintable(bar->text()));
    }

private:
    IsolatedSettings m_settings;
};

QTEST_MAIN(TestWindowFiles)
#include "tst_windowfiles.moc"
