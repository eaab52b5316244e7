// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenefile.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/promisednames.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/files/autosave.h"
#include "widgets/files/scenefiles.h"
#include "widgets/lab/labfiles.h"
#include "widgets/model/scenedocument.h"

#include <QTest>
#include <QtWidgets>

#include <functional>

namespace tst_dialognames {

using namespace pixelplumb;

using Way = std::function<void(MainWindow &window)>;
namespace {

Way byAction(const char *name)
{
    return [name](MainWindow &window) { action(window, name)->trigger(); };
}

void modify(const MainWindow &window)
{
    ScanSettings settings = window.parts().document->scene().settings;
    settings.arithmetic = Arithmetic::Float64;
    window.parts().document->setSettings(settings);
}

/// A scene that takes so long to write that another request can come meanwhile.
Scene largeScene()
{
    Scene scene;
    scene.triangles.assign(
        20'000, {{{{latticePixel(1, 1), {}}, {latticePixel(9, 2), {}}, {latticePixel(5, 9), {}}}}});
    return scene;
}

/// How to open each of the dialogs.
QMap<QString, Way> ways()
{
    return {
        {"frameDialog", byAction("editFrame")},
        {"lookDialog", byAction("editLook")},
        {"triangleDialog", byAction("addTriangle")},
        {"vertexDialog",
         [](MainWindow &window) {
             window.parts().canvas->editCoordinates(window.parts().document->vertices().front());
         }},
        {"goToDialog", byAction("goTo")},
        {"studentPictureDialog", byAction("openStudentPicture")},
        {"gradeDialog",
         [](MainWindow &window) { named<QAbstractButton>(window, "gradingGrade")->click(); }},
        {"gradingOpenDialog",
         [](MainWindow &window) { named<QAbstractButton>(window, "gradingOpen")->click(); }},
        {"keySheet", byAction("showKeys")},
        {"manual", byAction("showManual")},
        {"about", byAction("showAbout")},
        {"unsavedChanges",
         [](MainWindow &window) {
             modify(window);
             window.parts().files->newScene();
         }},
        {"savingDialog",
         [](MainWindow &window) {
             const QTemporaryDir folder;
             window.parts().document->reset(largeScene());
             window.parts().files->saveTo(folder.filePath(u"large.json"_s));
             window.parts().files->newScene();
         }},
        {"saveDialog", byAction("saveSceneAs")},
        {"examplesDialog", byAction("showExamples")},
        {"exportDialog", byAction("exportPicture")},
        {"recoveryDialog",
         [](MainWindow &window) {
             const QString path = Autosave::defaultFolder() + u"/dialogname.json"_s;
             QDir().mkpath(Autosave::defaultFolder());
             QVERIFY(!writeSceneFile(path, Scene()));
             window.offerRecovery();
             QFile::remove(path);
         }},
        {"labOpenDialog", byAction("labOpen")},
        {"labSaveDialog",
         [](MainWindow &window) { LabFiles(&window).askForOutput({}, {}, u"json"_s); }},
    };
}

/// Records the names of the dialogs that appear, and closes each of them.
class DialogWatch : public QObject {
public:
    DialogWatch() { qApp->installEventFilter(this); }

    const QStringList &names() const { return m_names; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        auto *dialog = qobject_cast<QDialog *>(watched);
        if (dialog && event->type() == QEvent::Show) {
            m_names += dialog->objectName();
            QTimer::singleShot(0, dialog, &QDialog::reject);
        }
        return false;
    }

private:
    QStringList m_names;
};

} // namespace

/// The dialogs that are promised to programs appear under their names.
class TestDialogNames : public QObject {
    Q_OBJECT

private slots:
    void everyPromisedDialogIsOpened()
    {
        QStringList promised = promisedNames(PromisedObject::Dialog);
        promised.sort();
        QCOMPARE(QStringList(ways().keys()), promised);
    }

    void everyDialogComesUnderItsName_data()
    {
        QTest::addColumn<Way>("way");
        const QMap<QString, Way> all = ways();
        for (auto way = all.begin(); way != all.end(); ++way)
            QTest::newRow(qPrintable(way.key())) << way.value();
    }
    void everyDialogComesUnderItsName()
    {
        QFETCH(const Way, way);
        IsolatedSettings settings;
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        const auto window = openedWindow();
        const DialogWatch watch;

        way(*window);

        QTRY_COMPARE(watch.names(), QStringList{QString::fromLatin1(QTest::currentDataTag())});
    }
};

PIXELPLUMB_TEST(TestDialogNames)

} // namespace tst_dialognames

#include "tst_dialognames.moc"
