// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/grader.h"
#include "core/grade/pictures/picturediff.h"
#include "core/runs/tracedscene.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/files/scenefiles.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/messagebar.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/model/studentpicture.h"
#include "widgets/studies/compare/comparepanel.h"
#include "widgets/studies/grade/diagnosisview.h"

#include <QTest>
#include <QtWidgets>

namespace tst_studentpicture {

using namespace pixelplumb;

namespace {

constexpr QPoint missing(35, 20); ///< a pixel that the default scene covers
constexpr QPoint extra(1, 46); ///< a pixel that it does not cover

/// The method's picture of the scene.
QImage drawn(const Scene &scene)
{
    const FrameBuffer frame(scene.frame);
    drawScene(scene, frame);
    return frame.image().copy();
}

/// The method's picture with one missing pixel and one extra one.
QImage wrongPicture(const Scene &scene)
{
    QImage picture = drawn(scene);
    const auto line = [&scene](const QPoint &pixel) { return pictureLine(scene.frame, pixel.y()); };
    picture.setPixel(missing.x(), line(missing), packed(scene.frame.background));
    picture.setPixel(extra.x(), line(extra), qRgb(255, 255, 0));
    return picture;
}

const PictureJudgement *judgement(const MainWindow &window)
{
    return window.parts().student->judgement().get();
}

QString text(const MainWindow &window, const char *name)
{
    return named<QLabel>(window, name)->text();
}

/// A window in which a picture of the default scene has been pasted and judged.
std::unique_ptr<MainWindow> windowWith(QImage (*picture)(const Scene &scene))
{
    auto window = openedWindow();
    QApplication::clipboard()->setImage(picture(window->parts().document->scene()));
    action(*window, "pasteStudentPicture")->trigger();
    if (!QTest::qWaitFor([&window] { return judgement(*window) != nullptr; }))
        qFatal("the picture is not judged");
    return window;
}

std::vector<Defect> defectIn(const Scene &right, const QString &id)
{
    const std::vector<Defect> all = defectsFor(right);
    const auto found = std::ranges::find(all, id, &Defect::id);
    if (found == all.end())
        qFatal("no defect %s", qPrintable(id));
    return {*found};
}

/// A window with a small scene, in which defects are found quickly, and the scene's picture with a
/// defect.
std::unique_ptr<MainWindow> windowWithDefect(const char *id)
{
    auto window = openedWindow();
    Scene scene = window->parts().document->scene();
    scene.frame.width = 32;
    scene.frame.height = 24;
    for (Vertex &vertex : scene.triangles[0].vertices)
        vertex.position = {vertex.position.x / 2, vertex.position.y / 2};
    window->parts().document->setScene(scene, u"small"_s);
    window->parts().document->markSaved();
    QApplication::clipboard()->setImage(imageOf(pictureWith(scene, defectIn(scene, id))));
    action(*window, "pasteStudentPicture")->trigger();
    return window;
}

void nameTheBug(const MainWindow &window)
{
    QTRY_VERIFY(judgement(window));
    QTest::mouseClick(named<QPushButton>(window, "nameTheBug"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!named<DiagnosisView>(window, "diagnosis")->isRunning(), 60'000);
}

/// Selects a defect among those found, in the assistant's words.
void choose(const MainWindow &window, const QString &id)
{
    named<QComboBox>(window, "diagnosisAudience")->setCurrentIndex(1);
    auto *candidates = named<QListWidget>(window, "diagnosisCandidates");
    const QList<QListWidgetItem *> items = candidates->findItems(id, Qt::MatchExactly);
    QCOMPARE(items.size(), 1);
    candidates->setCurrentItem(items.front());
}

} // namespace

/// A student's picture on the canvas, handled as a user does.
class TestStudentPicture : public QObject {
    Q_OBJECT

private slots:
    void theLeewayIsChosenBesideThePicture()
    {
        const auto window = openedWindow();
        Scene open = window->parts().document->scene();
        open.settings.fillRule = FillRule::Open;
        QApplication::clipboard()->setImage(drawn(open));
        action(*window, "pasteStudentPicture")->trigger();
        QTRY_VERIFY(judgement(*window));
        const auto wrongUnder = [&](Leeway leeway) {
            auto *box = named<QComboBox>(*window, "submissionLeeway");
            box->setCurrentIndex(box->findData(int(leeway)));
            emit box->activated(box->currentIndex());
            QTest::qWait(0);
            return judgement(*window)->diff.differing();
        };
        QVERIFY(wrongUnder(Leeway::Strict) > 0);
        QCOMPARE(wrongUnder(Leeway::Edges), 0);
        QVERIFY(text(*window, "submissionVerdict").startsWith("Right within the leeway"));
        QCOMPARE(wrongUnder(Leeway::Once), 0);
        QVERIFY(wrongUnder(Leeway::Strict) > 0);
    }

    void aDroppedPictureIsMarkedOnTheCanvas_data() { addPalettes(); }
    void aDroppedPictureIsMarkedOnTheCanvas()
    {
        QFETCH(QPalette, palette);
        const auto window = openedWindow();
        QApplication::setPalette(palette);
        const QString path = m_folder.filePath("student.png");
        QVERIFY(wrongPicture(window->parts().document->scene()).save(path));

        dropFile(*window, path);

        QTRY_VERIFY(judgement(*window));
        QCOMPARE(judgement(*window)->verdictAt(missing), Difference::Missing);
        QCOMPARE(judgement(*window)->verdictAt(extra), Difference::Extra);
        QCOMPARE(judgement(*window)->diff.differing(), std::int64_t(2));
        QVERIFY(named<QDockWidget>(*window, "submissionDock")->isVisible());
        QCOMPARE(text(*window, "submissionName"), "student.png");
        QCOMPARE(text(*window, "submissionVerdict"), "Wrong: 2 pixels differ.");
        QVERIFY(text(*window, "submissionCounts").contains("1 missing"));
        QTest::qWait(50); // the dock has appeared
        window->parts().canvas->fitToView();
        grabbed(*window, "student");
        QVERIFY(isMarked(*window, missing, Sign::Missing));
        QVERIFY(isMarked(*window, extra, Sign::Extra));
    }

    void theCanvasShowsThePictureAndForAWhileTheExpectedOne()
    {
        QVERIFY(!action(*openedWindow(), "showStudent")->isEnabled());
        const auto window = windowWith(&wrongPicture);
        const auto &parts = window->parts();
        QVERIFY(action(*window, "showStudent")->isChecked());
        const auto &frames = parts.student->frames();
        const auto colourIn = [](const FrameBuffer &frame, const QPoint &pixel) {
            return *frame.view().at(pixel.x(), pixel.y());
        };
        QCOMPARE(colourIn(frames.found(), extra), qRgb(255, 255, 0));
        QVERIFY(colourIn(frames.expected(), missing) != colourIn(frames.found(), missing));
        parts.options->setDifferencesShown(false);
        parts.canvas->fitToView();
        const auto shown = [&parts](const QPoint &pixel) {
            const QImage seen = parts.canvas->grab().toImage();
            return seen.pixel(parts.canvas->mapping().cellOf(pixel).center().toPoint());
        };
        QCOMPARE(shown(extra), qRgb(255, 255, 0));

        parts.canvas->setFocus();
        QTest::keyPress(parts.canvas, Qt::Key_Shift);
        QTRY_COMPARE(shown(extra), packed(parts.document->scene().frame.background));
        QVERIFY(!parts.canvas->isTruthVisible());
        QTest::keyRelease(parts.canvas, Qt::Key_Shift);
        QCOMPARE(shown(extra), qRgb(255, 255, 0));

        ScanSettings rounded = parts.document->scene().settings;
        rounded.arithmetic = Arithmetic::Float32;
        parts.document->setSettings(rounded); // another run
        QTRY_COMPARE(parts.playhead->traced()->scene.settings, rounded);
        QVERIFY(action(*window, "showStudent")->isChecked());
        action(*window, "nextColumn")->trigger(); // who steps sees the run
        QVERIFY(!action(*window, "showStudent")->isChecked());
        QTest::keyClick(parts.canvas, Qt::Key_S);
        QCOMPARE(shown(extra), qRgb(255, 255, 0));
    }

    void thePicturesGrowWithThePanel()
    {
        const auto window = windowWith(&wrongPicture);
        settle();
        const auto *panel = named<QWidget>(*window, "submission");
        const auto *picture = named<QWidget>(*window, "submissionPicture");
        QVERIFY2(picture->width() > panel->width() * 3 / 4,
                 qPrintable(QString::number(picture->width())));
        QVERIFY(picture->height() >= picture->width() / 2);
    }

    void everyFormatIsTaken_data()
    {
        QTest::addColumn<QString>("suffix");
        for (const char *suffix : {"png", "ppm", "bmp", "txt"})
            QTest::newRow(suffix) << suffix;
    }
    void everyFormatIsTaken()
    {
        QFETCH(QString, suffix);
        const auto window = openedWindow();
        const QString path = m_folder.filePath("picture." + suffix);
        if (suffix == "txt") {
            action(*window, "copyRaster")->trigger();
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(QApplication::clipboard()->text().toLatin1());
        } else {
            QVERIFY(drawn(window->parts().document->scene()).save(path));
        }

        dropFile(*window, path);

        QTRY_VERIFY(judgement(*window));
        QCOMPARE(text(*window, "submissionVerdict"), "Right: no pixel differs.");
    }

    void aPastedRasterIsCompared()
    {
        const auto window = openedWindow();
        action(*window, "copyRaster")->trigger();
        QString raster = QApplication::clipboard()->text();
        QVERIFY(raster.count('#') > 900);
        raster[int(raster.indexOf('#'))] = '.';
        raster[0] = '#';
        QApplication::clipboard()->setText(raster);

        QTest::keyClick(window->parts().canvas, Qt::Key_V, Qt::ControlModifier);

        QTRY_VERIFY(judgement(*window));
        QCOMPARE(judgement(*window)->diff.count(Difference::Missing), std::int64_t(1));
        QCOMPARE(judgement(*window)->diff.count(Difference::Extra), std::int64_t(1));
    }

    void transparencyIsIgnoredAndThatIsSaid_data()
    {
        QTest::addColumn<int>("alpha");
        QTest::addColumn<bool>("isSaid");
        QTest::newRow("opaque") << 255 << false;
        QTest::newRow("a pixel is not") << 254 << true;
    }
    void transparencyIsIgnoredAndThatIsSaid()
    {
        QFETCH(int, alpha);
        QFETCH(bool, isSaid);
        const auto window = openedWindow();
        QImage image
            = drawn(window->parts().document->scene()).convertToFormat(QImage::Format_ARGB32);
        const QRgb first = image.pixel(0, 0);
        image.setPixel(0, 0, qRgba(qRed(first), qGreen(first), qBlue(first), alpha));
        for (const char *way : {"pasted", "dropped"}) {
            if (way == "pasted"_L1) {
                window->parts().student->paste(image, "pasted");
            } else {
                const QString path = m_folder.filePath("transparent.png");
                QVERIFY(image.save(path));
                dropFile(*window, path);
            }
            QTRY_VERIFY(judgement(*window));
            QCOMPARE(text(*window, "submissionVerdict"), "Right: no pixel differs.");
            QVERIFY(text(*window, "submissionCounts").contains("transparency is ignored")
                    == isSaid);
            window->parts().student->remove();
        }
    }

    void theMarksFollowADraggedVertex()
    {
        const auto window = windowWith(&drawn);
        SceneDocument *document = window->parts().document;
        action(*window, "drawTool")->trigger();
        Canvas *canvas = window->parts().canvas;
        QTest::qWait(50);
        const VertexRef first = document->vertices().front();
        const QPointF from = canvas->positionOf(document->vertexAt(first)->position);

        QTest::mousePress(canvas, Qt::LeftButton, {}, from.toPoint());
        QTest::mouseMove(canvas, (from + QPointF(40, -40)).toPoint());
        QTest::mouseMove(canvas, (from + QPointF(60, -60)).toPoint());

        QTRY_VERIFY(judgement(*window)->diff.differing() > 0); // before the button is released
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, (from + QPointF(60, -60)).toPoint());
        action(*window, "undo")->trigger();
        QTRY_COMPARE(text(*window, "submissionVerdict"), "Right: no pixel differs.");
    }

    void aPictureOfAnotherSizeIsRefusedAndNothingIsLost()
    {
        const auto window = windowWith(&drawn);
        const Scene before = window->parts().document->scene();
        const QString path = m_folder.filePath("small.png");
        QVERIFY(drawn(before).copy(0, 0, 32, 24).save(path));

        dropFile(*window, path);

        const auto *message = named<QWidget>(*window, "messageBar");
        QTRY_VERIFY(message->isVisible());
        const QString said = named<QLabel>(*window, "messageText")->text();
        QVERIFY2(said.contains("small.png: The picture is 32 × 24 pixels")
                     && said.contains("frame 64 × 48"),
                 qPrintable(said));
        QCOMPARE(window->parts().document->scene(), before);
        QCOMPARE(text(*window, "submissionVerdict"), "Right: no pixel differs.");
    }

    void anotherFrameWaitsForThePictureToFitAgain()
    {
        const auto window = windowWith(&drawn);
        SceneDocument *document = window->parts().document;
        FrameSpec frame = document->scene().frame;
        frame.width += 6;

        document->setFrame(frame);
        QTRY_VERIFY(!judgement(*window));
        QVERIFY(text(*window, "submissionVerdict").contains("70 × 48"));

        action(*window, "undo")->trigger();
        QTRY_COMPARE(text(*window, "submissionVerdict"), "Right: no pixel differs.");
    }

    void whatIsNoPictureIsToldAsSuch()
    {
        const auto window = openedWindow();
        const QString path = m_folder.filePath("notes.txt");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("no picture at all\n");
        file.close();

        dropFile(*window, path);

        const auto *message = named<QWidget>(*window, "messageBar");
        QTRY_VERIFY(message->isVisible());
        QVERIFY(named<QLabel>(*window, "messageText")->text().contains("PNG, PPM, BMP"));
        QVERIFY(!window->parts().student->isThere());
    }

    void aDroppedSceneIsOpened()
    {
        const auto window = openedWindow();
        dropFile(*window, resource(u"/scenes/ties-at-tenths.json"_s));
        QTRY_VERIFY(window->windowTitle().startsWith("ties-at-tenths.json"));
        QVERIFY(!window->parts().student->isThere());
    }

    void aMarkedPixelOpensItsHistory()
    {
        const auto window = windowWith(&wrongPicture);
        action(*window, "stepWorkspace")->trigger();
        auto *history = named<QDockWidget>(*window, "pixelHistoryDock");
        history->hide();
        action(*window, "inspectTool")->trigger();
        QTest::qWait(50);

        clickPixel(*window, missing);

        QCOMPARE(window->parts().playhead->pickedPixel(), missing);
        QVERIFY(history->isVisible());
        QVERIFY2(
            text(*window, "submissionPixel").startsWith("(35, 20) student: #000000, expected: #")
                && text(*window, "submissionPixel").endsWith("missing"),
            qPrintable(text(*window, "submissionPixel")));
    }

    void buttonsGoFromDifferenceToDifferenceAndRemoveThePicture()
    {
        const auto window = windowWith(&wrongPicture);
        auto *next = named<QToolButton>(*window, "submissionNext");
        window->parts().playhead->pick(QPoint(0, 47));

        QTest::mouseClick(next, Qt::LeftButton);
        QCOMPARE(window->parts().playhead->pickedPixel(), extra);
        QTest::mouseClick(next, Qt::LeftButton);
        QCOMPARE(window->parts().playhead->pickedPixel(), missing);
        QTest::mouseClick(next, Qt::LeftButton);
        QCOMPARE(window->parts().playhead->pickedPixel(), extra);

        QTest::mouseClick(named<QToolButton>(*window, "submissionRemove"), Qt::LeftButton);
        QVERIFY(!judgement(*window));
        QVERIFY(!isMarked(*window, extra, Sign::Extra));
        QCOMPARE(text(*window, "submissionName"), "No student's picture");
    }

    void withItsPanelClosedItEndsWithItsScene_data()
    {
        QTest::addColumn<bool>("isClosed");
        QTest::newRow("closed") << true;
        QTest::newRow("open") << false;
    }

    void withItsPanelClosedItEndsWithItsScene()
    {
        QFETCH(bool, isClosed);
        const auto window = windowWith(&wrongPicture);
        auto *dock = named<QDockWidget>(*window, "submissionDock");
        if (isClosed)
            dock->close();

        Scene other = window->parts().document->scene();
        other.triangles.clear();
        QVERIFY(window->parts().files->showScene(other));

        QCOMPARE(window->parts().student->isThere(), !isClosed);
    }

    /// The button that names the bug before anything is scrolled, and then the answer.
    void whatIsAskedAndAnsweredIsInView()
    {
        const auto window = windowWithDefect("rounding-truncate");
        const QWidget *view = named<QScrollArea>(*window, "submissionArea")->viewport();
        const auto isInView = [&](const char *part) {
            const auto *widget = named<QWidget>(*window, part);
            return view->rect().contains(QRect(widget->mapTo(view, QPoint()), widget->size()));
        };
        window->resize(1366, 768);
        QTRY_VERIFY(judgement(*window));
        QTRY_VERIFY(isInView("nameTheBug"));
        QVERIFY(named<QPushButton>(*window, "nameTheBug")->isEnabled());
        window->resize(1024, 640);
        nameTheBug(*window);
        for (const char *part : {"diagnosisVerdict", "diagnosisCandidates"})
            QTRY_VERIFY2(isInView(part), part);
    }

    /// The method draws the scene right; shown together with a wrong picture, that would be a
    /// second verdict.
    void oneVerdictIsToldAtATime()
    {
        const auto window = windowWithDefect("rounding-truncate");
        const auto *figures = named<QLabel>(*window, "statusFigures");
        QTRY_VERIFY(judgement(*window));
        QTRY_VERIFY_WITH_TIMEOUT(figures->toolTip().contains("When finished: all pixels correct"),
                                 60'000);
        QVERIFY2(figures->text().startsWith("Submission: Wrong"), qPrintable(figures->text()));
        QVERIFY(!figures->text().contains("correct"));

        QTest::mouseClick(named<QToolButton>(*window, "submissionRemove"), Qt::LeftButton);
        QTRY_COMPARE(figures->text(), u"When finished: all pixels correct"_s);
    }

    void theBugIsNamedInWordsForBothUntilTheSceneChanges()
    {
        const auto window = windowWithDefect("rounding-truncate");

        nameTheBug(*window);

        const QString verdict = text(*window, "diagnosisVerdict");
        QVERIFY2(verdict.startsWith("Wrong. Exactly one set of known bugs"), qPrintable(verdict));
        auto *candidates = named<QListWidget>(*window, "diagnosisCandidates");
        QCOMPARE(candidates->count(), 1);
        QCOMPARE(candidates->item(0)->text(), "Look at how a colour becomes a byte.");
        choose(*window, "rounding-truncate");
        QCOMPARE(candidates->item(0)->text(), "rounding-truncate");
        QVERIFY2(
            text(*window, "diagnosisSentence").startsWith("Levels are cut to bytes, not rounded"),
            qPrintable(text(*window, "diagnosisSentence")));
        grabbed(*window, "diagnosis");

        ScanSettings settings = window->parts().document->scene().settings;
        settings.arithmetic = Arithmetic::Float32;
        window->parts().document->setSettings(settings);
        QTRY_COMPARE(candidates->count(), 0);
        QVERIFY(named<QPushButton>(*window, "nameTheBug")->isEnabled());
    }

    void aDefectIsOpenedWhereItPartsAndLeftAgain()
    {
        const auto window = windowWithDefect("colours-120");
        const SceneDocument *document = window->parts().document;
        const Scene right = document->scene();
        nameTheBug(*window);
        choose(*window, "colours-120");
        QVERIFY(text(*window, "diagnosisSentence").contains("First wrong number: step "));
        static const QRegularExpression place(u"step \\d+, [a-z]"_s);
        QVERIFY(text(*window, "diagnosisSentence").contains(place));

        QTest::mouseClick(named<QPushButton>(*window, "diagnosisOpen"), Qt::LeftButton);

        QCOMPARE(drawn(document->scene()),
                 drawn(withDefects(right, defectIn(right, "colours-120"))));
        QVERIFY(document->isModified());
        const Playhead *playhead = window->parts().playhead;
        grabbed(*window, "stepper");
        const auto parts = partingStepOf(right, document->scene());
        QVERIFY(parts);
        QCOMPARE(playhead->position(), parts->step + 1);
        QVERIFY(named<QWidget>(*window, "formulaPanel")->isVisible()); // in the workspace Step
        // The right picture is still shown next to the student's.
        QVERIFY(judgement(*window)->diff.differing() > 0);
        QCOMPARE(drawn(*window->parts().student->scene()), drawn(right));

        QTest::mouseClick(named<QPushButton>(*window, "diagnosisLeave"), Qt::LeftButton);

        QCOMPARE(document->scene(), right);
        QVERIFY(!document->isModified());
        QVERIFY(!named<QPushButton>(*window, "diagnosisLeave")->isEnabled());
        QVERIFY(named<QListWidget>(*window, "diagnosisCandidates")->count() > 0);
    }

    void aDefectThatNoRunHasIsOpenedAtTheFirstPixelThatDiffers()
    {
        const auto window = windowWithDefect("last-sample-missing");
        const SceneDocument *document = window->parts().document;
        const Scene right = document->scene();
        nameTheBug(*window);
        choose(*window, "last-sample-missing");
        const auto parts = partingStepOf(right, defectIn(right, "last-sample-missing"));
        QVERIFY(parts);
        QVERIFY2(text(*window, "diagnosisSentence").contains(parts->text),
                 qPrintable(text(*window, "diagnosisSentence")));

        QTest::mouseClick(named<QPushButton>(*window, "diagnosisOpen"), Qt::LeftButton);

        const Playhead *playhead = window->parts().playhead;
        QTRY_COMPARE(playhead->position(), parts->step + 1);
        QCOMPARE(document->scene(), right); // the run is the right one
        QVERIFY(!document->isModified());
        QVERIFY(!named<QPushButton>(*window, "diagnosisCompare")->isEnabled());
        const TraceStep step = playhead->traced()->trace->stepAt(parts->step);
        const PixelChange &pixel = playhead->traced()->trace->changes()[step.sample];
        QVERIFY(judgement(*window)->verdictAt(QPoint(pixel.x, pixel.y)) != Difference::None);
    }

    void aDefectOfThePictureAloneHasNoStep()
    {
        const auto window = windowWithDefect("left-and-right-exchanged");
        nameTheBug(*window);
        choose(*window, "left-and-right-exchanged");
        QVERIFY(!text(*window, "diagnosisSentence").contains("First wrong number: step"));
        QVERIFY(!named<QPushButton>(*window, "diagnosisOpen")->isEnabled());
    }

    void aDefectOfSettingsStandsBesideTheRightRunInCompare()
    {
        const auto window = windowWithDefect("rule-open");
        nameTheBug(*window);
        choose(*window, "rule-open");

        QTest::mouseClick(named<QPushButton>(*window, "diagnosisCompare"), Qt::LeftButton);

        const auto *compare = named<ComparePanel>(*window, "compare");
        QVERIFY(compare->isVisible());
        QCOMPARE(compare->contenders().size(), std::size_t(2));
        QCOMPARE(compare->contenders()[0].settings.fillRule, FillRule::Open);
        QCOMPARE(compare->contenders()[1].settings.fillRule, FillRule::Closed);
    }

    void theSearchIsCancelled()
    {
        const auto window = windowWithDefect("rounding-truncate");
        QTRY_VERIFY(judgement(*window));
        QTest::mouseClick(named<QPushButton>(*window, "nameTheBug"), Qt::LeftButton);
        const auto *view = named<DiagnosisView>(*window, "diagnosis");
        QVERIFY(view->isRunning());

        QTest::mouseClick(named<QPushButton>(*window, "diagnosisCancel"), Qt::LeftButton);

        QVERIFY(!view->isRunning());
        QCOMPARE(text(*window, "diagnosisVerdict"), "Cancelled.");
        QVERIFY(named<QPushButton>(*window, "nameTheBug")->isEnabled());
    }

    void aLargePictureIsComparedBesideTheWindow()
    {
        const auto window = openedWindow();
        SceneDocument *document = window->parts().document;
        FrameSpec frame = document->scene().frame;
        frame.width = 600;
        frame.height = 400;
        document->setFrame(frame);
        QApplication::clipboard()->setImage(drawn(document->scene()));
        action(*window, "pasteStudentPicture")->trigger();

        QVERIFY(window->parts().student->isRunning());
        QTRY_COMPARE(text(*window, "submissionVerdict"), "Right: no pixel differs.");
    }

private:
    QTemporaryDir m_folder;
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestStudentPicture)

} // namespace tst_studentpicture

#include "tst_studentpicture.moc"
