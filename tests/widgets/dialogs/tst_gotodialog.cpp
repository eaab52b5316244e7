// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"
#include "tests/support/colours.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/testprogram.h"
#include "tests/support/tracedplayhead.h"
#include "widgets/dialogs/gotodialog.h"

#include <QTest>
#include <QtWidgets>

namespace tst_gotodialog {

using namespace pixelplumb;

namespace {

Scene triangleScene(const char *method)
{
    Scene scene;
    scene.frame = frameOf(40, 40);
    scene.method = method;
    scene.triangles = {Triangle{
        {{{latticePixel(2, 3), red}, {latticePixel(30, 5), green}, {latticePixel(12, 33), blue}}}}};
    return scene;
}

} // namespace

/// "Go to 27" goes to the place where the method counts its steps.
class TestGoToDialog : public QObject {
    Q_OBJECT

private slots:
    void oneNumberIsWhatTheMethodWalks_data()
    {
        QTest::addColumn<Scene>("scene");
        QTest::addColumn<SpanAxis>("axis");
        QTest::addColumn<QString>("verdict");
        QTest::newRow("columns") << triangleScene("column-scan") << SpanAxis::Column
                                 << u"Goes to column 9."_s;
        QTest::newRow("rows") << triangleScene("row-walk") << SpanAxis::Row << u"Goes to row 9."_s;
        QTest::newRow("steps") << sceneOf(circleAt(20, 20, 18), "circle-midpoint", frameOf(40, 40))
                               << SpanAxis::Free << u"Goes to the shape's step 9."_s;
        // A steep line, with which the run begins, and a flat one: both have a position 9.
        Scene lines = sceneOf(lineAt(2, 2, 9, 36), "line-bresenham", frameOf(40, 40));
        lines.shapes.push_back(lineAt(8, 2, 20, 5));
        QTest::newRow("columns and rows") << lines << SpanAxis::Row << u"Goes to row 9."_s;
    }
    void oneNumberIsWhatTheMethodWalks()
    {
        QFETCH(Scene, scene);
        QFETCH(SpanAxis, axis);
        QFETCH(QString, verdict);
        TracedPlayhead playhead(scene);
        GoToDialog dialog(&playhead);
        auto *line = dialog.findChild<QLineEdit *>(u"goToLine"_s);
        const auto *label = dialog.findChild<QLabel *>(u"goToLabel"_s);
        const auto *said = dialog.findChild<QLabel *>(u"goToVerdict"_s);

        QTest::keyClicks(line, u"9"_s);

        QCOMPARE(said->text(), verdict);
        for (const auto &[each, noun] :
             {std::pair(SpanAxis::Column, "column"), std::pair(SpanAxis::Row, "row"),
              std::pair(SpanAxis::Free, "step of the shape")}) {
            QCOMPARE(label->text().contains(QLatin1String(noun)), each == axis);
            QCOMPARE(line->accessibleName().contains(QLatin1String(noun)), each == axis);
        }
        dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok)->click();
        const std::optional<SpanPlace> place = playhead.currentPlace();
        QVERIFY(place);
        QCOMPARE(place->axis, axis);
        QCOMPARE(place->coordinate, std::int64_t(9));
    }

    void whatNothingHasIsObjectedTo()
    {
        TracedPlayhead playhead(triangleScene("row-walk"));
        GoToDialog dialog(&playhead);
        QTest::keyClicks(dialog.findChild<QLineEdit *>(u"goToLine"_s), u"39"_s);

        QCOMPARE(dialog.findChild<QLabel *>(u"goToVerdict"_s)->text(), u"There is no row 39."_s);
        QVERIFY(!dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok)->isEnabled());
    }
};

PIXELPLUMB_TEST(TestGoToDialog)

} // namespace tst_gotodialog

#include "tst_gotodialog.moc"
