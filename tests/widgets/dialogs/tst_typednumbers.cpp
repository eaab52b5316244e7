// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/dialogs/triangledialog.h"
#include "widgets/model/primitivelistmodel.h"
#include "widgets/model/scenedocument.h"

#include <QtTest>
#include <QtWidgets>

namespace tst_typednumbers {

using namespace pixelplumb;

/// If a typed number is not used unchanged, the dialog says what becomes of it.
class TestTypedNumbers : public QObject {
    Q_OBJECT

private slots:
    void aNumberThatIsMovedToItsLatticeIsToldInTheDialog()
    {
        const auto window = openedWindow();
        SceneDocument &document = *window->parts().document;
        TriangleDialog dialog({document.scene().triangles.front(), document.attributesOf(0)});
        const auto *verdict = named<QLabel>(dialog, "triangleVerdict");
        QCOMPARE(verdict->text(), QString());

        named<QLineEdit>(dialog, "vertex1u")->setText(u"1/3"_s);
        QVERIFY2(verdict->text().contains(
                     u"vertex 1, u: 1/3 is read as 5592405/16777216, displaced by"_s),
                 qPrintable(verdict->text()));
        named<QLineEdit>(dialog, "vertex0x")->setText(u"4.1"_s);
        QVERIFY(verdict->text().contains(u"vertex 0, x: 4.1 is drawn at"_s));
        named<QLineEdit>(dialog, "vertex0x")->setText(u"4"_s);
        named<QLineEdit>(dialog, "vertex1u")->setText(u"0.5"_s);
        QCOMPARE(verdict->text(), QString());
    }

    void whatIsNoCoordinateIsRefusedWithAWord()
    {
        const auto window = openedWindow();
        SceneDocument &document = *window->parts().document;
        QSignalSpy refused(&document, &SceneDocument::refused);
        QSignalSpy notice(&document, &SceneDocument::notice);
        action(*window, "primitivesDockToggle")->trigger();
        auto *tree = named<QTreeView>(*window, "primitivesTree");
        auto *model = qobject_cast<PrimitiveListModel *>(tree->model());
        const QModelIndex x = model->index(2, PrimitiveListModel::X, model->indexOfPrimitive(0));
        tree->expand(model->indexOfPrimitive(0));
        tree->setCurrentIndex(x);
        tree->edit(x);
        auto *field = named<QLineEdit>(*tree, "coordinateField");
        field->selectAll();
        QTest::keyClicks(field, u"abc"_s);
        QCOMPARE(refused.count(), 0); // it may still become a number
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(refused.count() > 0);
        QVERIFY2(refused.last()[0].toString().contains(u"53/2"_s),
                 qPrintable(refused.last()[0].toString()));
        QVERIFY(!document.isModified());

        field->selectAll();
        QTest::keyClicks(field, u"1/3"_s);
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(notice.count(), 1);
        const QString told = notice.last()[0].toString();
        QVERIFY2(told.startsWith(u"vertex 2, x: 1/3 is drawn"_s), qPrintable(told));
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestTypedNumbers)

} // namespace tst_typednumbers

#include "tst_typednumbers.moc"
