// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/nextpixel.h"
#include "core/runs/explain/prediction.h"
#include "core/runs/tracedscene.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/scanning.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "tests/support/window/windowsteps.h"
#include "widgets/canvas/canvas.h"
#include "widgets/inspect/columntable.h"
#include "widgets/inspect/pixelgrid.h"
#include "widgets/inspect/pixelhistorypanel.h"
#include "widgets/inspect/predictpanel.h"
#include "widgets/look/messagebar.h"
#include "widgets/look/signs.h"
#include "widgets/look/symbolitems.h"
#include "widgets/model/columntablemodel.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/studentpicture.h"
#include "widgets/stepping/scrubber.h"

#include <QTest>
#include <QtWidgets>

namespace tst_predicthiding {

using namespace pixelplumb;

/// Nothing in the window reveals what a student is asked to predict.
class TestPredictHiding : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }
    void cleanup() { m_window.reset(); }

    void rowsAheadShowOnlyTheirCountingNumber_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("method");
        QTest::addColumn<QStringList>("told");
        QTest::newRow("columns") << "default.json"
                                 << "column-scan" << QStringList{"x", "half"};
        QTest::newRow("rows") << "default.json"
                              << "row-walk" << QStringList{"y", "trapezoid"};
        QTest::newRow("Bresenham") << "lines.json"
                                   << "line-bresenham" << QStringList{"k"};
        QTest::newRow("DDA") << "lines.json"
                             << "line-dda" << QStringList{"u"};
        QTest::newRow("points of a line") << "lines.json"
                                          << "line-parametric" << QStringList{"i"};
        QTest::newRow("midpoint circle") << "circles.json"
                                         << "circle-midpoint" << QStringList{"arc", "x_k"};
    }
    void rowsAheadShowOnlyTheirCountingNumber()
    {
        QFETCH(QString, file);
        QFETCH(QString, method);
        QFETCH(QStringList, told);
        open(file, method);
        const QAbstractItemModel &model = *table()->model();
        const int ahead = int(*playhead().currentSpan()) + 1;

        for (int column = 0; column < model.columnCount(); ++column) {
            if (table()->isColumnHidden(column))
                continue;
            const QString title = model.headerData(column, Qt::Horizontal).toString();
            const QModelIndex cell = model.index(ahead, column);
            QVERIFY2((cell.data().toString() == u"?"_s) != told.contains(title), qPrintable(title));
            if (!told.contains(title))
                QVERIFY(!cell.data(Qt::ToolTipRole).isValid());
        }
    }

    /// Later answers could be copied from the previous step.
    void constantNumbersCountOncePerTriangle_data()
    {
        QTest::addColumn<Arithmetic>("arithmetic");
        QTest::newRow("exact") << Arithmetic::Exact;
        QTest::newRow("but for rounding") << Arithmetic::Float32;
    }
    void constantNumbersCountOncePerTriangle()
    {
        QFETCH(Arithmetic, arithmetic);
        Scene scene = defaultScene();
        scene.settings.arithmetic = arithmetic;
        const auto traced = traceScene(scene);
        QHash<QString, int> times;
        for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
            for (const Prediction &asked :
                 predictionsAfter(*traced, traced->trace->indexOfSpan(span)))
                times[asked.title] += int(!asked.isRepeated);
        }
        for (const char *rate : {"ΔR", "ΔG", "ΔB"})
            QCOMPARE(times[QString::fromUtf8(rate)], 1);
        for (const char *bound : {"y_B", "y_T", "⌈y_B⌉"})
            QCOMPARE(times[QString::fromUtf8(bound)], int(traced->trace->spanCount()));
    }

    void numbersAreAskedForInTheOrderOfTheirFormulas()
    {
        const auto traced = traceScene(defaultScene());
        QStringList titles;
        for (const Prediction &asked : predictionsAfter(*traced, traced->trace->indexOfSpan(20)))
            titles += asked.title;
        const QStringList order = {u"y_B"_s, u"y_T"_s, u"R_B"_s, u"G_B"_s,    u"B_B"_s,
                                   u"R_T"_s, u"ΔR"_s,  u"ΔB"_s,  u"first R"_s};
        QList<qsizetype> places;
        for (const QString &title : order)
            places += titles.indexOf(title);
        QVERIFY2(places.front() >= 0 && std::ranges::is_sorted(places),
                 qPrintable(titles.join(u' ')));
    }

    void whatIsAskedForIsWrittenWithASubscript()
    {
        open(u"default.json"_s, u"column-scan"_s);
        const auto *choice = named<QComboBox>(*m_window, "predictChoice");
        QVERIFY(choice->findText(u"y_B"_s) >= 0);
        QVERIFY(qobject_cast<const SymbolBox *>(choice)); // its list draws as it does
        QVERIFY(qobject_cast<SymbolDelegate *>(choice->itemDelegate()));
    }

    void theListNamesANumberAsItsQuestionDoes_data()
    {
        QTest::addColumn<QString>("method");
        for (const char *method :
             {"column-scan", "row-walk", "barycentric-rectangle", "edge-equations-incremental"})
            QTest::newRow(method) << QString(method);
    }
    void theListNamesANumberAsItsQuestionDoes()
    {
        QFETCH(QString, method);
        Scene scene = defaultScene();
        scene.method = method.toStdString();
        const auto traced = traceScene(scene);
        QVERIFY(!predictionsAfter(*traced, 0).empty());
        for (const Prediction &asked : predictionsAfter(*traced, 0))
            QVERIFY2(asked.words == asked.title || asked.words.endsWith(u", "_s + asked.title)
                         || asked.words.startsWith(u"the "_s + asked.title),
                     qPrintable(asked.title + u": "_s + asked.words));
    }

    /// Nor under another name: p_k of a line is p_k₊₁ of the previous step. The student must find
    /// out whether a number stays the same.
    void noAnswerStandsInTheCurrentStepUnderAnotherName_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("method");
        QTest::newRow("columns") << "default.json"
                                 << "column-scan";
        QTest::newRow("rows") << "default.json"
                              << "row-walk";
        for (const char *method : {"line-bresenham", "line-bresenham-symmetric", "line-dda",
                                   "line-slope-intercept", "line-parametric"})
            QTest::newRow(method) << "lines.json" << QString::fromLatin1(method);
        QTest::newRow("midpoint circle") << "circles.json"
                                         << "circle-midpoint";
        QTest::newRow("outline") << "polygon-outline.json"
                                 << "polygon-outline";
    }
    void noAnswerStandsInTheCurrentStepUnderAnotherName()
    {
        QFETCH(QString, file);
        QFETCH(QString, method);
        open(file, method);
        const TracedScene &traced = *playhead().traced();
        const ScanTrace &trace = *traced.trace;
        QHash<QString, QSet<QString>>
            mayBeCopied; // by the question's title: what its answer has always equalled so far
        for (std::size_t span = 0; span + 1 < trace.spanCount(); ++span) {
            if (trace.beginsPart(span + 1))
                continue;
            const std::vector<Quantity> cells = trace.span(span).cells;
            for (const Prediction &asked : predictionsAfter(traced, trace.indexOfSpan(span) + 1)) {
                QSet<QString> same;
                for (std::size_t i = 0; i < cells.size(); ++i) {
                    const NumberDescription &number = trace.numbers().span[i];
                    const bool isCount = number.group == NumberGroup::Position;
                    if (cells[i] == asked.value && !isCount && number.title != asked.title)
                        same.insert(number.title);
                }
                const auto known = mayBeCopied.find(asked.title);
                if (known == mayBeCopied.end())
                    mayBeCopied.insert(asked.title, same);
                else
                    known->intersect(same);
            }
        }
        QVERIFY(!mayBeCopied.isEmpty());
        for (auto question = mayBeCopied.begin(); question != mayBeCopied.end(); ++question)
            QVERIFY2(question->isEmpty(),
                     qPrintable(question.key() + u" is "_s
                                + QStringList(question->begin(), question->end()).join(u' ')));
    }

    /// The column width does not depend on the question marks shown instead of the numbers.
    void columnsKeepTheWidthOfTheNumbersThatAreHidden()
    {
        m_window = openedWindow();
        playhead().seekToSpan(0);
        const QList<int> before = widths();

        showPanel();
        QCOMPARE(widths(), before);
        playhead().step(StepUnit::Span, StepDirection::Forward);
        QCOMPARE(widths(), before);
    }

    void everyNumberOfTheRunFitsItsColumn()
    {
        open(u"default.json"_s, u"column-scan"_s);
        const QAbstractItemModel &model = *table()->model();
        const QFontMetricsF metrics(table()->font());
        for (int column = 0; column < model.columnCount(); ++column) {
            if (table()->isColumnHidden(column))
                continue;
            for (int row = 0; row < model.rowCount(); ++row) {
                const QString text
                    = model.index(row, column).data(ColumnTableModel::MeasuredTextRole).toString();
                QVERIFY2(metrics.horizontalAdvance(text) * 0.85 < table()->columnWidth(column),
                         qPrintable(text));
            }
        }
    }

    void theCopyOfTheTableHasNoNumberThatIsAhead()
    {
        open(u"lines.json"_s, u"line-bresenham"_s);
        table()->copyAll();
        const QStringList lines = QGuiApplication::clipboard()->text().split(u'\n');
        const int ahead = int(*playhead().currentSpan()) + 1;
        const QStringList names = lines.front().split(u'\t');
        const QStringList cells = lines[ahead + 1].split(u'\t');
        QCOMPARE(cells[names.indexOf(u"y"_s)], QString());
        QVERIFY(!cells[names.indexOf(u"k"_s)].isEmpty());
    }

    void tipsOfTheScrubberTellNoPixelAhead()
    {
        open(u"lines.json"_s, u"line-bresenham"_s);
        auto *scrubber = named<Scrubber>(*m_window, "scrubber");
        const auto tipAt = [&](std::size_t position) {
            const QPoint place(int(scrubber->scale().xOf(position)), scrubber->height() - 4);
            QHelpEvent help(QEvent::ToolTip, place, scrubber->mapToGlobal(place));
            QApplication::sendEvent(scrubber, &help);
            return QToolTip::text();
        };
        QVERIFY(tipAt(playhead().end()).contains(u"predict it"_s));
        QVERIFY(!tipAt(1).contains(u"predict it"_s));
    }

    void theTruthIsNeitherToldNorShown()
    {
        open(u"default.json"_s, u"column-scan"_s);
        const auto *grid = named<PixelGrid>(*m_window, "pixelGrid");
        const NextPixel next = *nextPixelAfter(*playhead().traced(), playhead().position());
        playhead().pick(next.pixel);
        QVERIFY(!grid->accessibleDescription().contains(u"truth"_s));
        QVERIFY(!grid->accessibleDescription().contains(u"R ="_s));
        const Canvas *canvas = m_window->parts().canvas;
        action(*m_window, "showTruth")->trigger();
        QVERIFY(!canvas->isTruthVisible());
        hidePanel();
        QVERIFY(grid->accessibleDescription().contains(u"truth"_s));
        QVERIFY(canvas->isTruthVisible());
    }

    /// At the end, nothing lies ahead.
    void atTheEndAllIsShownAndBehindItHiddenAgain()
    {
        open(u"default.json"_s, u"column-scan"_s);
        const Canvas *canvas = m_window->parts().canvas;
        action(*m_window, "showTruth")->trigger();
        const QAbstractItemModel &model = *table()->model();
        const auto lastCell = [&model] {
            return model.index(model.rowCount() - 1, model.columnCount() - 1).data().toString();
        };
        const QList<int> before = widths();

        QVERIFY(!canvas->isTruthVisible());
        QCOMPARE(lastCell(), u"?"_s);
        action(*m_window, "runToEnd")->trigger();
        QVERIFY(canvas->isTruthVisible());
        QVERIFY(lastCell() != u"?"_s);
        for (int i = 0; i < 2; ++i)
            playhead().step(StepUnit::Span, StepDirection::Backward);
        QVERIFY(!canvas->isTruthVisible());
        QCOMPARE(lastCell(), u"?"_s);
        QCOMPARE(widths(), before);
    }

    /// The first triangle has written the pixel; the second has yet to refuse or write it.
    void aPixelsHistoryEndsAtTheCurrentStep()
    {
        Scene scene = defaultScene();
        scene.triangles.push_back(scene.triangles.front());
        m_window = openedWindow(scene);
        playhead().pick({27, 19});
        playhead().seek(playhead().traced()->trace->indexOfSetUp(1) + 1);
        playhead().pick({27, 19});
        const auto *tree = named<QTreeView>(*m_window, "pixelHistoryTree");
        QCOMPARE(tree->model()->rowCount(), 2);

        showPanel();
        QCOMPARE(tree->model()->rowCount(), 1);
        QTextDocument heading;
        heading.setHtml(named<QLabel>(*m_window, "pixelHistoryHeading")->text());
        QVERIFY(heading.toPlainText().contains(u"still ahead"_s));
        QVERIFY(!heading.toPlainText().contains(u"truth"_s));
    }

    /// The numbers of a line's step name the step's pixel.
    void theNextPixelIsNotTheOneThatTheCurrentStepTells()
    {
        open(u"lines.json"_s, u"line-bresenham"_s);
        const ScanTrace &trace = *playhead().traced()->trace;
        playhead().seekToSpan(6);
        const NextPixel next = *nextPixelAfter(*playhead().traced(), playhead().position());
        QCOMPARE(trace.spanOf(trace.stepAt(next.step).sample), std::size_t(7));
        const PixelChange &current = trace.changes()[trace.firstSampleOf(6)];
        QVERIFY(wrongPixelText(*playhead().traced(), playhead().position(),
                               {int(current.x), int(current.y)})
                    .contains(u"current step"_s));
    }

    /// No panel shows the colour of a pixel that is still ahead.
    void noPanelShowsAPixelThatIsAhead()
    {
        m_window = openedWindow(twoTriangles());
        SceneDocument &document = *m_window->parts().document;
        document.setMotion(Motion{latticePixel(2, 1), 5});
        QVERIFY(waitForRun(*m_window));
        const TracedScene &traced = *playhead().traced();
        playhead().seek(playhead().end());
        const QImage finished = playhead().frame()->image().copy();
        m_window->parts().student->paste(finished, u"all of it"_s);
        QTRY_VERIFY(m_window->parts().student->judgement());
        playhead().seek(traced.trace->indexOfSetUp(1));
        const QSet<QRgb> ahead = coloursIn(finished) - coloursIn(playhead().frame()->image());
        QVERIFY(ahead.size() > 50);
        m_window->resize(1900, 1200);
        const auto shown = [&] {
            QStringList told;
            for (QDockWidget *dock : m_window->findChildren<QDockWidget *>()) {
                if (dock == dockNamed("predictDock"))
                    continue; // while visible, it hides what is ahead
                m_window->parts().messageBar->hide();
                named<QAction>(*m_window, qPrintable(dock->objectName() + "Toggle"))
                    ->setEnabled(true);
                dock->show();
                dock->raise();
                QTest::qWait(150); // studies draw in the background
                if (pixelsOf(ahead, dock->widget()->grab().toImage()) > 20)
                    told += dock->objectName();
            }
            return told;
        };

        dockNamed("predictDock")->close();
        QVERIFY2(shown().contains("submissionDock"), "the check sees what is shown");
        playhead().seek(traced.trace->indexOfSetUp(1));
        dockNamed("predictDock")->show();
        QTRY_VERIFY(playhead().isAheadHidden());
        QCOMPARE(shown(), QStringList());
        for (const char *dock :
             {"submissionDock", "motionDock", "hardCasesDock", "compareDock", "precisionDock"}) {
            QVERIFY2(!dockNamed(dock)->widget()->isEnabled(), dock);
            dockNamed(dock)->raise();
            const auto *veil = named<QWidget>(*dockNamed(dock), "predictVeil");
            QVERIFY2(veil->isVisible(), dock);
            QCOMPARE(veil->palette().color(veil->foregroundRole()), // not pale
                     m_window->palette().color(QPalette::Active, QPalette::WindowText));
        }
        QTest::mouseClick(named<QPushButton>(*dockNamed("precisionDock"), "predictFinish"),
                          Qt::LeftButton); // lies over the panel in front
        QVERIFY(shown().contains("submissionDock"));
        QVERIFY(!named<QWidget>(*dockNamed("submissionDock"), "predictVeil")->isVisible());
    }

    /// A pixel missing from a student's picture is one that the method paints.
    void theMarksOfAStudentsPictureEndAtTheCurrentStep()
    {
        m_window = openedWindow(twoTriangles());
        QImage empty = playhead().frame()->image().copy();
        empty.fill(Qt::black);
        m_window->parts().student->paste(empty, u"nothing"_s);
        QTRY_VERIFY(m_window->parts().student->judgement());
        playhead().seek(playhead().traced()->trace->indexOfSetUp(1));
        const QPoint pixel(30, 20); // a pixel of the second triangle
        const auto isMarked = [&] { return pixelplumb::isMarked(*m_window, pixel, Sign::Missing); };

        QVERIFY(isMarked());
        showPanel();
        QVERIFY(!isMarked());
        action(*m_window, "runToEnd")->trigger();
        QVERIFY(isMarked());
    }

private:
    /// Two triangles, the second in colours that the window uses nowhere else.
    static Scene twoTriangles()
    {
        Scene scene;
        scene.triangles = {triangleAt(2, 2, 14, 4, 8, 14), triangleAt(20, 10, 60, 14, 34, 42)};
        const std::array<Colour, 3> colours = {{{{251, 7, 133}}, {{23, 247, 91}}, {{87, 19, 253}}}};
        for (std::size_t i = 0; i < 3; ++i) {
            scene.triangles[0].vertices[i].colour = {{9, 9, 9}};
            scene.triangles[1].vertices[i].colour = colours[i];
        }
        return scene;
    }
    static QSet<QRgb> coloursIn(const QImage &image)
    {
        QSet<QRgb> colours;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                colours.insert(image.pixel(x, y) | 0xff000000);
        }
        return colours;
    }
    static int pixelsOf(const QSet<QRgb> &colours, const QImage &image)
    {
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                count += colours.contains(image.pixel(x, y) | 0xff000000) ? 1 : 0;
        }
        return count;
    }
    QDockWidget *dockNamed(const char *name) { return named<QDockWidget>(*m_window, name); }
    Playhead &playhead() { return *m_window->parts().playhead; }
    ColumnTable *table() { return named<ColumnTable>(*m_window, "columnTable"); }
    static Scene defaultScene() { return openedWindow()->parts().document->scene(); }

    /// Opens a scene in the middle of its run, with the panel visible.
    void open(const QString &file, const QString &method)
    {
        m_window = openedWindow(file);
        m_window->parts().document->setMethod(method.toStdString());
        QVERIFY(waitForRun(*m_window));
        playhead().seekToSpan(playhead().traced()->trace->spanCount() / 4);
        showPanel();
    }
    void showPanel()
    {
        toggle();
        QTRY_VERIFY(named<PredictPanel>(*m_window, "predict")->isVisible());
    }
    void hidePanel() { toggle(); }
    void toggle() { action(*m_window, "predictDockToggle")->trigger(); }
    QList<int> widths()
    {
        QList<int> widths;
        for (int column = 0; column < table()->model()->columnCount(); ++column)
            widths += table()->columnWidth(column);
        return widths;
    }

    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
};

PIXELPLUMB_TEST(TestPredictHiding)

} // namespace tst_predicthiding

#include "tst_predicthiding.moc"
