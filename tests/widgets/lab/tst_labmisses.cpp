// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/study/labfile.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/madestudy.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/files/scenefiles.h"
#include "widgets/lab/accuracylab.h"
#include "widgets/lab/paretoplot.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/studies/compare/comparepane.h"
#include "widgets/studies/compare/comparepanel.h"
#include "widgets/studies/compare/compareview.h"

#include <QTest>
#include <QtWidgets>

#include <random>

namespace tst_labmisses {

using namespace pixelplumb;

namespace {

constexpr int longest = 60'000; // ms
/// The room that a screen of 1366 × 768 leaves.
constexpr QSize sizeOnSmallScreen(1358, 728);
const QString contenderId = u"column-scan:float32"_s;

enum class Colours { One, Three };

/// A triangle with vertices on the lattice, not on whole pixels.
Scene randomTriangle(const QString &method, Arithmetic arithmetic, Colours colours,
                     std::mt19937 &random)
{
    Scene scene;
    scene.method = method.toStdString();
    scene.settings.arithmetic = arithmetic;
    const auto next = [&random](int below) { return int(random() % unsigned(below)); };
    const auto level = [&next] { return std::uint8_t(next(256)); };
    Triangle &triangle = scene.triangles.emplace_back();
    for (Vertex &vertex : triangle.vertices) {
        vertex.position = {Lattice(next(int(scene.frame.width * unitsPerPixel))),
                           Lattice(next(int(scene.frame.height * unitsPerPixel)))};
        vertex.colour = {{level(), level(), level()}};
        if (colours == Colours::One)
            vertex.colour = triangle.vertices.front().colour;
    }
    return scene;
}

/// A triangle that a method first draws wrong in this way.
LabMiss missOf(Difference kind, const QString &method, Arithmetic arithmetic)
{
    std::mt19937 random(1);
    // A triangle with a wrong colour usually has it first.
    const Colours colours = kind == Difference::Colour ? Colours::Three : Colours::One;
    for (int attempt = 0; attempt < 100'000; ++attempt) {
        const Scene scene = randomTriangle(method, arithmetic, colours, random);
        const auto traced = traceScene(scene);
        const auto first = traced->firstWrongPixel();
        if (first && traced->differences.at(first->x, first->y) == kind)
            return {scene, first->x, first->y};
    }
    qFatal("no triangle goes wrong so");
    return {};
}

} // namespace

/// A click on a dot of the lab brings everything to the contender's first wrong pixel.
class TestLabMisses : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_settings.clear();
        m_window = openedWindow();
        m_window->resize(sizeOnSmallScreen);
        action(*m_window, "accuracyLabDockToggle")->trigger();
        m_lab = named<AccuracyLab>(*m_window, "accuracyLab");
        QCoreApplication::processEvents();
    }
    void cleanup() { m_window.reset(); }

    void everythingStandsAtTheFirstWrongPixel_data()
    {
        QTest::addColumn<Difference>("kind");
        QTest::addColumn<QString>("method");
        QTest::addColumn<Arithmetic>("arithmetic");
        const auto row
            = [](const char *name, Difference kind, const char *method, Arithmetic arithmetic) {
                  QTest::newRow(name) << kind << QString::fromLatin1(method) << arithmetic;
              };
        row("missing", Difference::Missing, "column-scan", Arithmetic::Float32);
        row("extra", Difference::Extra, "column-scan", Arithmetic::Fixed16);
        row("colour", Difference::Colour, "column-scan", Arithmetic::Fixed16);
        row("missing in a row", Difference::Missing, "row-walk", Arithmetic::Float32);
        row("refused", Difference::Missing, "barycentric-incremental", Arithmetic::Float32);
    }
    void everythingStandsAtTheFirstWrongPixel()
    {
        QFETCH(const Difference, kind);
        QFETCH(const QString, method);
        QFETCH(const Arithmetic, arithmetic);
        const LabMiss miss = missOf(kind, method, arithmetic);
        const QPoint pixel(int(miss.x), int(miss.y));
        showStudyWith(miss);

        clickTheDot();

        const auto *compare = named<ComparePanel>(*m_window, "compare");
        QTRY_VERIFY_WITH_TIMEOUT(compare->contest() && !compare->isRunning()
                                     && compare->contest()->scene == miss.scene,
                                 longest);
        const Playhead *playhead = m_window->parts().playhead;
        const TracedScene &traced = *playhead->traced();
        QCOMPARE(playhead->pickedPixel(), std::optional(pixel));
        QCOMPARE(playhead->position(), traced.decidedAt(miss.x, miss.y)); // so it is marked
        const TraceStep step = *playhead->currentStep();
        const bool isVisited = step.kind == StepKind::Sample
            && traced.trace->changes()[step.sample].x == pixel.x()
            && traced.trace->changes()[step.sample].y == pixel.y();
        if (kind == Difference::Missing && method != u"barycentric-incremental"_s) {
            const SpanPlace &place = traced.trace->placeOf(step.span);
            QCOMPARE(place.coordinate, place.axis == SpanAxis::Column ? miss.x : miss.y);
            QVERIFY(!isVisited);
        } else {
            QVERIFY(isVisited);
            QCOMPARE(traced.trace->changes()[step.sample].isWritten(), kind != Difference::Missing);
        }
        const auto *canvas = named<Canvas>(*m_window, "canvas");
        QVERIFY(canvas->view().contains(canvas->positionOf(pixel)));
        QVERIFY2(canvas->zoom() >= 8, qPrintable(QString::number(canvas->zoom())));
        QCOMPARE(m_window->size(), sizeOnSmallScreen);
        const QString place = u"(%1, %2)"_s.arg(pixel.x()).arg(pixel.y());
        QVERIFY(named<QLabel>(*m_window, "compareReason")->text().contains(place));
        QCOMPARE(compare->contenders().front().settings.arithmetic, arithmetic);
        QVERIFY(compare->contenders().back().isTruth());
        for (const ComparePane *pane : compare->panes())
            QVERIFY(QRectF(pane->view()->rect()).contains(pane->view()->positionOf(pixel)));
        action(*m_window, "stepWorkspace")->trigger();
        QVERIFY(named<QLabel>(*m_window, "pixelHistoryHeading")->text().contains(place));
    }

    void theFirstIsThatOfTheOrderOfDrawing()
    {
        StudySettings settings;
        settings.families = {u"slivers"_s, u"random-subpixel"_s};
        settings.mostSamples = 20'000'000;
        settings.rounds = 0;
        for (const char *id :
             {"column-scan:fixed16.16", "row-walk:float32", "barycentric-incremental:float32"})
            settings.contenders.push_back(*labContenderNamed(QLatin1String(id)));
        int higherThanAnother = 0;
        for (const LabRow &row : runStudy(settings).rows) {
            if (!row.firstMiss)
                continue;
            const auto traced = traceScene(row.firstMiss->scene);
            const std::size_t decided = traced->decidedAt(row.firstMiss->x, row.firstMiss->y);
            const FrameSpec &frame = traced->scene.frame;
            for (int y = 0; y < frame.height; ++y) {
                for (int x = 0; x < frame.width; ++x) {
                    if (traced->differences.at(x, y) == Difference::None)
                        continue;
                    QVERIFY(traced->decidedAt(x, y) >= decided);
                    higherThanAnother += y < row.firstMiss->y ? 1 : 0;
                }
            }
        }
        QVERIFY(higherThanAnother > 0); // it is not the lowest one
    }

    void unsavedChangesAreAskedAboutFirst()
    {
        const LabMiss miss = missOf(Difference::Missing, u"column-scan"_s, Arithmetic::Float32);
        showStudyWith(miss);
        SceneFiles *files = m_window->parts().files;
        SceneDocument *document = m_window->parts().document;
        ScanSettings settings = document->scene().settings;
        settings.arithmetic = Arithmetic::Float64;
        document->setSettings(settings);
        QVERIFY(document->isModified());
        const Scene mine = document->scene();
        const std::size_t position = m_window->parts().playhead->position();
        int questions = 0;
        auto answer = UnsavedChanges::Cancel;
        files->askAboutChanges = [&] {
            ++questions;
            return answer;
        };

        clickTheDot();
        QCOMPARE(questions, 1);
        QVERIFY(document->scene() == mine);
        QVERIFY(document->isModified());
        QVERIFY(document->undoStack()->canUndo());
        QCOMPARE(m_window->parts().playhead->position(), position);
        QVERIFY(!named<QWidget>(*m_window, "compare")->isVisible());

        answer = UnsavedChanges::Discard;
        clickTheDot();
        QCOMPARE(questions, 2);
        QVERIFY(document->scene() == miss.scene);
    }

private:
    static std::shared_ptr<Study> studyWith(const LabMiss &miss)
    {
        auto results = madeResults({{"column-scan:float32", 2, 5000}, {"proved", 3, 0, true}});
        results->rows.front().firstMiss = miss;
        return results;
    }
    void showStudyWith(const LabMiss &miss)
    {
        const QString path = m_folder.filePath(u"lab.json"_s);
        QVERIFY(!writeFile(path, writeStudy(*studyWith(miss))));
        QVERIFY(m_lab->openResults(path));
        QCoreApplication::processEvents();
    }
    void clickTheDot()
    {
        auto *pareto = named<ParetoPlot>(*m_lab, "labPareto");
        auto *plot = pareto->findChild<QWidget *>();
        const auto dot = pareto->positionOf(contenderId);
        QVERIFY(dot.has_value());
        QTest::mouseClick(plot, Qt::LeftButton, {}, plot->mapFrom(pareto, dot->toPoint()));
    }

    IsolatedSettings m_settings;
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
    AccuracyLab *m_lab = nullptr;
};

PIXELPLUMB_TEST(TestLabMisses)

} // namespace tst_labmisses

#include "tst_labmisses.moc"
