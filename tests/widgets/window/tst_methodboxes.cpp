// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/look/labels.h"
#include "widgets/look/messagebar.h"
#include "widgets/model/playhead.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"

#include <QTest>
#include <QtWidgets>

namespace tst_methodboxes {

using namespace pixelplumb;

namespace {

QString textOf(std::string_view name)
{
    return QString::fromUtf8(name.data(), qsizetype(name.size()));
}

/// "row-walk exact closed nearest"
QString textOf(const QString &method, const ScanSettings &settings)
{
    return QStringList{method, textOf(nameOf(settings.arithmetic)),
                       textOf(nameOf(settings.fillRule)), textOf(nameOf(settings.rounding))}
        .join(u' ');
}

QString boxesOf(const MainWindow &window)
{
    return QStringList{named<QComboBox>(window, "methodBox")->currentData().toString(),
                       named<QComboBox>(window, "arithmeticBox")->currentText(),
                       named<QComboBox>(window, "fillRuleBox")->currentText(),
                       named<QComboBox>(window, "roundingBox")->currentText()}
        .join(u' ');
}

/// Where the boxes, the status bar, the trace and the document disagree; empty if they do not.
QString disagreementIn(const MainWindow &window)
{
    const Scene &scene = window.parts().document->scene();
    const TracedScene &traced = *window.parts().playhead->traced();
    const QString drawn = textOf(traced.method->id, traced.scene.settings);
    const QString status = named<QLabel>(window, "statusSettings")->text();
    const QString begin = textOf(nameOf(traced.scene.settings.arithmetic)) + u" · "_s
        + textOf(nameOf(traced.scene.settings.fillRule)) + u" · "_s;
    const QStringList texts
        = {boxesOf(window), textOf(QString::fromStdString(scene.method), scene.settings)};
    for (const QString &text : texts) {
        if (text != drawn)
            return u"drawn is %1, said is %2"_s.arg(drawn, text);
    }
    return status.startsWith(begin) ? QString() : u"drawn is %1, status %2"_s.arg(drawn, status);
}

} // namespace

/// The boxes of method, arithmetic, fill rule and rounding show what is drawn.
class TestMethodBoxes : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void boxesStatusAndTraceAgreeWhateverIsAskedFor_data()
    {
        QTest::addColumn<QString>("method");
        for (const Method &method : methods())
            QTest::newRow(qPrintable(method.id)) << method.id;
    }
    void boxesStatusAndTraceAgreeWhateverIsAskedFor()
    {
        QFETCH(QString, method);
        const auto window = openedWindow(Scene());
        SceneDocument &document = *window->parts().document;
        const MessageBar &bar = *window->parts().messageBar;
        const Method &asked = *methodNamed(method);
        for (const Arithmetic arithmetic : allArithmetics) {
            for (const FillRule rule : allFillRules) {
                const ScanSettings settings{arithmetic, rule, ByteRounding::Truncate};
                const bool isKept = asked.objection(settings).isEmpty();
                const QString drawn = textOf(method, asked.adapted(settings));
                Scene scene;
                scene.frame.width = scene.frame.height = 12;
                scene.triangles = {triangleAt(1, 2, 10, 3, 5, 9)};
                scene.method = method.toStdString();
                scene.settings = settings;

                document.reset(scene); // as files and the command line do
                QCOMPARE(disagreementIn(*window), QString());
                QCOMPARE(boxesOf(*window), drawn);
                QVERIFY(!document.isModified());
                if (!isKept) {
                    QVERIFY(bar.isVisible());
                    QVERIFY2(bar.text().startsWith(asked.title), qPrintable(bar.text()));
                }

                document.setSettings({}); // as the boxes and menus do
                document.setSettings(settings);
                QCOMPARE(disagreementIn(*window), QString());
                QCOMPARE(boxesOf(*window), drawn);
                QVERIFY(isKept || bar.isVisible());
            }
        }
    }

    void methodsStandUnderTheHeadingsOfTheirFamilies()
    {
        const auto window = openedWindow(Scene());
        for (const char *name : {"methodBox", "compareMethod1"}) {
            const auto *box = named<QComboBox>(*window, name);
            QString heading;
            std::size_t found = 0;
            for (int row = 0; row < box->count(); ++row) {
                const Method *method = methodNamed(box->itemData(row).toString());
                const bool isChoice = box->model()->index(row, 0).flags() & Qt::ItemIsEnabled;
                QCOMPARE(isChoice, method || box->itemText(row) == u"Truth"_s);
                if (!isChoice)
                    heading = box->itemText(row);
                if (method)
                    QCOMPARE(heading, titleOf(method->family));
                found += std::size_t(method != nullptr);
            }
            QCOMPARE(found, methods().size());
        }
    }

    void aTitleIsWholeWhereThereIsRoom()
    {
        const auto window = windowOf(QSize(1358, 728));
        const auto *box = static_cast<const ElidingBox *>(named<QComboBox>(*window, "methodBox"));
        for (const Method &method : methods()) {
            window->parts().document->setMethod(method.id.toStdString());
            QCOMPARE(box->shownText(), method.title);
        }
    }

    void aTitleThatIsCutIsToldFromAllOthersAndIsWholeInTheToolTip()
    {
        const auto window = windowOf(QSize(1016, 600));
        const auto *box = static_cast<const ElidingBox *>(named<QComboBox>(*window, "methodBox"));
        int cut = 0;
        QStringList seen;
        for (const Method &method : methods()) {
            window->parts().document->setMethod(method.id.toStdString());
            const QString shown = box->shownText();
            QVERIFY2(shown == method.title || shown.contains(QChar(0x2026)), qPrintable(shown));
            QVERIFY2(!seen.contains(shown), qPrintable(shown));
            seen += shown;
            QVERIFY2(box->toolTip().contains(method.title), qPrintable(box->toolTip()));
            QVERIFY(box->fontMetrics().horizontalAdvance(shown) < box->width());
            cut += int(shown != method.title);
        }
        QVERIFY(cut > 0 && cut < int(methods().size()));
    }

    void aPartHasOneNameInStatusFormulaAndTable_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("title");
        QTest::newRow("outline") << "polygon-outline.json"
                                 << "polygon-outline"
                                 << "edge 1"
                                 << "Steps";
        QTest::newRow("triangles") << "polygon-star.json"
                                   << "polygon-tessellation"
                                   << "triangle 1"
                                   << "Rows";
    }
    void aPartHasOneNameInStatusFormulaAndTable()
    {
        QFETCH(QString, scene);
        QFETCH(QString, method);
        QFETCH(QString, name);
        QFETCH(QString, title);
        const auto window = openedWindow(scene);
        window->parts().document->setMethod(method.toStdString());
        Playhead &playhead = *window->parts().playhead;
        const ScanTrace &trace = *playhead.traced()->trace;
        std::size_t span = 0;
        while (trace.placeOf(span).part != 1)
            ++span;
        playhead.seekToSpan(span);

        QVERIFY2(named<QLabel>(*window, "statusColumn")->text().endsWith(name),
                 qPrintable(named<QLabel>(*window, "statusColumn")->text()));
        QVERIFY(named<QLabel>(*window, "formulaHeading")->text().contains(name));
        const auto *table = named<QAbstractItemView>(*window, "columnTable");
        QCOMPARE(table->model()->headerData(int(span), Qt::Vertical).toString(), name);
        QCOMPARE(named<QDockWidget>(*window, "columnsDock")->windowTitle(), title);
    }

    void aNoteNamesEachSettingThatWasChanged()
    {
        const auto window = openedWindow(Scene());
        Scene scene;
        scene.method = "edge-equations";
        scene.settings.arithmetic = Arithmetic::Fixed16;
        scene.settings.fillRule = FillRule::HalfOpenColumn;
        const Method &method = *methodNamed(u"edge-equations");
        QVERIFY(!method.supports(Arithmetic::Fixed16));
        const ScanSettings drawn = method.adapted(scene.settings);

        window->parts().document->reset(scene);
        const QString note = window->parts().messageBar->text();
        QVERIFY2(note.contains(textOf(nameOf(drawn.arithmetic))), qPrintable(note));
        QCOMPARE(note.contains(textOf(nameOf(FillRule::HalfOpenColumn))),
                 !method.supports(FillRule::HalfOpenColumn));
    }

    void aSettingThatWouldChangeNothingIsGreyAndSaysWhy()
    {
        const auto window = openedWindow(Scene());
        SceneDocument &document = *window->parts().document;
        const std::array settings = {"fillRuleBox", "roundingBox", "arithmeticBox"};
        for (const char *box : settings)
            QVERIFY2(named<QComboBox>(*window, box)->isEnabled(), box);

        Scene scene;
        scene.method = "line-bresenham";
        Shape line;
        line.kind = PrimitiveKind::Line;
        line.vertices = {{latticePixel(1, 1), {{9, 9, 9}}}, {latticePixel(8, 4), {{9, 9, 9}}}};
        scene.shapes = {line};
        document.reset(scene);
        for (const char *box : settings) {
            const auto *shown = named<QComboBox>(*window, box);
            QVERIFY2(!shown->isEnabled(), box);
            QVERIFY2(shown->toolTip().startsWith("The method "), qPrintable(shown->toolTip()));
        }
        QVERIFY(named<QComboBox>(*window, "fillRuleBox")->toolTip().contains("has no inside"));

        document.setVertexColour({0, 0}, {{200, 9, 9}});
        QVERIFY(named<QComboBox>(*window, "roundingBox")->isEnabled());
        document.undoStack()->undo();
        QVERIFY(!named<QComboBox>(*window, "roundingBox")->isEnabled());
        document.setMethod("column-scan");
        for (const char *box : settings)
            QVERIFY2(named<QComboBox>(*window, box)->isEnabled(), box);
    }

    void aVariantIsTickedInTheMenuAndGreyWhereTheMethodRefusesIt()
    {
        Scene scene;
        scene.triangles = {triangleAt(1, 2, 10, 3, 5, 9)};
        const auto window = openedWindow(scene);
        SceneDocument &document = *window->parts().document;
        auto *const late = named<QAction>(*window, "variant-no-colour-pre-step");
        const auto *const box = named<QAction>(*window, "variant-rounded-box");
        QVERIFY(late->isEnabled() && late->isCheckable() && !late->isChecked());
        QVERIFY(!box->isEnabled());
        QVERIFY2(box->toolTip().contains(u"“Edge equations”"_s), qPrintable(box->toolTip()));

        late->trigger();
        QVERIFY(late->isChecked());
        QVERIFY(document.scene().settings.variants.contains(Variant::NoColourPreStep));
        QVERIFY(window->parts().playhead->traced()->scene.settings == document.scene().settings);
        const QString status = named<QLabel>(*window, "statusSettings")->text();
        QVERIFY2(status.contains("No pre-step of colour"), qPrintable(status));

        document.setMethod("edge-equations");
        QVERIFY(document.scene().settings.variants.isEmpty());
        QVERIFY(!late->isEnabled() && !late->isChecked() && box->isEnabled());
        const QString note = window->parts().messageBar->text();
        QVERIFY2(note.contains(u"no-colour-pre-step"_s), qPrintable(note));

        document.undoStack()->undo();
        QVERIFY(late->isChecked());
        late->trigger();
        QVERIFY(document.scene().settings.variants.isEmpty());
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestMethodBoxes)

} // namespace tst_methodboxes

#include "tst_methodboxes.moc"
