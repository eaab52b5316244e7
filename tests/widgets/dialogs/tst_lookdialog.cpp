// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scenefile.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"
#include "widgets/dialogs/lookdialog.h"
#include "widgets/model/scenedocument.h"

#include <QTest>
#include <QtWidgets>

namespace tst_lookdialog {

using namespace pixelplumb;

namespace {

Scene litScene()
{
    return readScene(R"({ "pixelplumb": 1, "frame": { "width": 8, "height": 8 },
        "camera": { "eye": [0, 1, 6], "near": 0.5 },
        "materials": { "b": { "texture": "checker", "shininess": 7 }, "a": {} },
        "lights": [ { "direction": [0, -1, "1/3"], "color": "#ff8000" } ], "ambient": "#101010",
        "antialiasing": 4,
        "primitives": [ { "sphere": [0, 0, 0], "radius": 1, "material": "b" } ] })")
        ->scene;
}

} // namespace

/// Camera, lights and materials, edited in a form over the keys of a scene's file.
class TestLookDialog : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_scene = litScene();
        m_dialog = std::make_unique<LookDialog>(m_scene, QString());
    }
    void cleanup() { m_dialog.reset(); }

    void theSceneIsShownAsItsFileHasItAndKeptWhereNothingIsChanged()
    {
        QCOMPARE(value("Camera", "eye"), u"0, 1, 6"_s);
        QCOMPARE(value("Camera", "near"), u"0.5"_s);
        QCOMPARE(value("Camera", "far"), QString()); // the default, beside it
        QCOMPARE(cell("Camera", "far").siblingAtColumn(SceneLook::Default).data().toString(),
                 u"100"_s);
        QCOMPARE(value("b", "shininess"), u"7"_s);
        QCOMPARE(value("Light 1", "direction"), u"0, -1, 5592405/16777216"_s);
        QCOMPARE(value("Light 1", "color"), u"#ff8000"_s);
        QCOMPARE(value("", "antialiasing"), u"4"_s);
        QVERIFY(m_dialog->look().camera == m_scene.camera);
        QVERIFY(m_dialog->look().appearance == m_scene.appearance);
    }

    void noRowIsNamedByAKeyOfTheFileOrHasItsBrackets()
    {
        button("addLight").click();
        button("addMaterial").click();
        const QAbstractItemModel &rows = *tree().model();
        const QModelIndexList all = rows.match(rows.index(0, 0), SceneLook::keyRole, QVariant(), -1,
                                               Qt::MatchContains | Qt::MatchRecursive);
        QVERIFY(all.size() > 20);
        for (const QModelIndex &row : all) {
            const QString words = row.data().toString();
            QVERIFY2(words != row.data(SceneLook::keyRole).toString(), qPrintable(words));
            for (const int column : {SceneLook::Value, SceneLook::Default})
                QVERIFY2(!row.siblingAtColumn(column).data().toString().contains(u'['),
                         qPrintable(words));
        }
    }

    void valuesAreTakenAsOneEditThatIsUndone()
    {
        set("Camera", "near", "0.25");
        set("b", "filter", "bilinear");
        set("", "shading", "flat");
        SceneDocument document;
        document.setScene(m_scene, u"scene"_s);
        const int before = document.undoStack()->index();
        document.setLook(m_dialog->look().camera, m_dialog->look().appearance);
        QCOMPARE(document.undoStack()->index(), before + 1);
        QCOMPARE(document.scene().camera->near, 0.25);
        const Material &material = document.scene().appearance.materials[1];
        QCOMPARE(material.name, std::string("b"));
        QCOMPARE(material.filter, TextureFilter::Bilinear);
        QCOMPARE(document.scene().appearance.shading, Shading::Flat);
        QVERIFY(material.texture);

        document.undoStack()->undo();
        QVERIFY(document.scene() == m_scene);
    }

    void aWrongValueIsToldWithItsPlaceAndCannotBeTaken_data()
    {
        QTest::addColumn<QString>("part");
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("told");
        QTest::newRow("negative") << "Camera"
                                  << "near"
                                  << "-1"
                                  << "camera.near";
        QTest::newRow("a word") << "Camera"
                                << "eye"
                                << "here"
                                << "camera.eye";
        QTest::newRow("two numbers") << "Camera"
                                     << "up"
                                     << "[0, 1]"
                                     << "camera.up";
        QTest::newRow("no choice") << ""
                                   << "shading"
                                   << "round"
                                   << "shading";
        QTest::newRow("a missing picture") << "b"
                                           << "texture"
                                           << "none.png"
                                           << "none.png";
        QTest::newRow("another key") << "Camera"
                                     << "up"
                                     << "[0, 1, 0], \"near\": [3]"
                                     << "camera.up";
    }
    void aWrongValueIsToldWithItsPlaceAndCannotBeTaken()
    {
        QFETCH(QString, part);
        QFETCH(QString, key);
        QFETCH(QString, value);
        QFETCH(QString, told);
        set(qPrintable(part), qPrintable(key), qPrintable(value));
        const QString verdict = m_dialog->findChild<QLabel *>("lookVerdict")->text();
        QVERIFY2(verdict.contains(told), qPrintable(verdict));
        QVERIFY(!okButton().isEnabled());
        QVERIFY(m_dialog->look().camera == m_scene.camera);

        set(qPrintable(part), qPrintable(key), "");
        QVERIFY(okButton().isEnabled());
    }

    void lightsAndMaterialsAreAddedAndThoseThatNothingNamesAreRemoved()
    {
        button("addLight").click();
        button("addMaterial").click();
        QCOMPARE(m_dialog->look().appearance.lights.size(), std::size_t(2));
        QCOMPARE(m_dialog->look().appearance.materials.size(), std::size_t(3));
        tree().model()->setData(tree().currentIndex(), u"A"_s);
        std::string names; // those that primitives name by their places stay where they are
        for (const Material &material : m_dialog->look().appearance.materials)
            names += material.name;
        QCOMPARE(names, std::string("abA"));
        QVERIFY(button("removePart").isEnabled()); // the added material is selected
        button("removePart").click();
        QCOMPARE(m_dialog->look().appearance.materials.size(), std::size_t(2));

        tree().setCurrentIndex(part("b")); // the sphere's
        QVERIFY(!button("removePart").isEnabled());
        tree().setCurrentIndex(part("Light 1"));
        button("removePart").click();
        QCOMPARE(m_dialog->look().appearance.lights.size(), std::size_t(1));
        QVERIFY(m_dialog->look().appearance.lights[0].colour != (Colour{{255, 128, 0}}));
    }

    void aSceneWithSolidsKeepsItsCamera()
    {
        QVERIFY(!(part("Camera").flags() & Qt::ItemIsUserCheckable));
        LookDialog flat(Scene{}, QString());
        QVERIFY(!flat.look().camera);
    }

private:
    QTreeView &tree() const { return *m_dialog->findChild<QTreeView *>("lookTree"); }
    QPushButton &button(const char *name) const
    {
        return *m_dialog->findChild<QPushButton *>(QLatin1String(name));
    }
    QPushButton &okButton() const
    {
        return *m_dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
    }
    QModelIndex part(const char *name) const
    {
        const QModelIndexList found
            = tree().model()->match(tree().model()->index(0, 0), Qt::DisplayRole,
                                    QLatin1String(name), 1, Qt::MatchExactly | Qt::MatchRecursive);
        return found.value(0);
    }
    QModelIndex cell(const char *partName, const char *key) const
    {
        const QModelIndex parent
            = QLatin1String(partName).isEmpty() ? QModelIndex() : part(partName);
        for (int row = 0; row < tree().model()->rowCount(parent); ++row) {
            const QModelIndex index = tree().model()->index(row, SceneLook::Key, parent);
            if (index.data(SceneLook::keyRole).toString() == QLatin1String(key))
                return index.siblingAtColumn(SceneLook::Value);
        }
        return {};
    }
    QString value(const char *partName, const char *key) const
    {
        return cell(partName, key).data().toString();
    }
    void set(const char *partName, const char *key, const char *value)
    {
        QVERIFY(tree().model()->setData(cell(partName, key), QString::fromUtf8(value)));
    }

    IsolatedSettings m_settings;
    Scene m_scene;
    std::unique_ptr<LookDialog> m_dialog;
};

PIXELPLUMB_TEST(TestLookDialog)

} // namespace tst_lookdialog

#include "tst_lookdialog.moc"
