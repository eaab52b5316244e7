// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/isolatedsettings.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"

#include <QTest>
#include <QtWidgets>

#include <random>

namespace tst_mainwindow {

using namespace pixelplumb;

/// The window as a whole: its initial state, the agreement of its parts, and what is remembered.
class TestMainWindow : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings.clear(); }

    void opensHalfDrawnAtTheNumbersOfTheSecondColumnPastTheMiddleVertex()
    {
        const auto window = openedWindow();
        const Playhead &playhead = *window->parts().playhead;

        QCOMPARE(playhead.currentColumnX(), std::optional<std::int64_t>(28));
        QCOMPARE(playhead.currentStep()->kind, StepKind::Span);
        QCOMPARE(playhead.pickedPixel(), std::optional(QPoint(28, 9)));
        QVERIFY(!playhead.isPlaying());
        QVERIFY(named<QLabel>(*window, "statusPixel")->text().startsWith("pixel (28, 9) #"));
        QCOMPARE(named<QLabel>(*window, "statusColumn")->text(), "column 28, second half");
    }

    void undoTakesBackEverything()
    {
        const auto window = openedWindow();
        SceneDocument &document = *window->parts().document;
        const Scene start = document.scene();
        const unsigned seed = 20201;
        std::mt19937 random(seed);
        const auto coordinate = [&] {
            return LatticePoint{Lattice(random() % 16384), Lattice(random() % 12288)};
        };
        for (int change = 0; change < 60; ++change) {
            const VertexRef ref{
                int(random() % std::max<std::size_t>(1, document.scene().triangles.size())),
                int(random() % 3)};
            switch (random() % 7) {
            case 0:
            case 1:
                document.placeVertex(coordinate());
                break;
            case 2:
                if (document.vertexAt(ref))
                    document.moveVertex(ref, coordinate(), change);
                break;
            case 3:
                if (document.vertexAt(ref))
                    document.setVertexColour(ref, {{std::uint8_t(random()), 7, 9}});
                break;
            case 4:
                if (change % 5 == 0)
                    document.deletePrimitive(0);
                break;
            case 5: {
                FrameSpec frame = document.scene().frame;
                frame.width = 20 + std::int32_t(random() % 80);
                document.setFrame(frame);
                break;
            }
            default: {
                ScanSettings settings = document.scene().settings;
                settings.arithmetic = allArithmetics[random() % allArithmetics.size()];
                document.setSettings(settings);
            }
            }
        }
        const Scene changed = document.scene();
        QVERIFY(changed != start);

        while (document.undoStack()->canUndo())
            action(*window, "undo")->trigger();
        QVERIFY2(document.scene() == start, qPrintable(QString("seed %1").arg(seed)));
        QVERIFY(document.pendingVertices().empty());
        QVERIFY(!window->isWindowModified());
        while (document.undoStack()->canRedo())
            action(*window, "redo")->trigger();
        QVERIFY(document.scene() == changed);
    }

    void theBoxesChangeTheSceneAndFollowIt()
    {
        const auto window = openedWindow();
        auto *arithmetic = named<QComboBox>(*window, "arithmeticBox");
        QTest::keyClick(arithmetic, Qt::Key_Down);
        QCOMPARE(window->parts().document->scene().settings.arithmetic, Arithmetic::Float32);
        QCOMPARE(window->parts().playhead->traced()->trace->settings().arithmetic,
                 Arithmetic::Float32);

        action(*window, "undo")->trigger();
        QCOMPARE(arithmetic->currentText(), "exact");
    }

    void whatTheMethodRefusesCannotBeChosenAndSaysWhy()
    {
        const auto window = openedWindow();
        const auto *rule = named<QComboBox>(*window, "fillRuleBox");
        const int topLeft = rule->findText("top-left");
        QVERIFY(
            !rule->model()->flags(rule->model()->index(topLeft, 0)).testFlag(Qt::ItemIsEnabled));
        const QString why = rule->itemData(topLeft, Qt::ToolTipRole).toString();
        QVERIFY2(why.contains("a column ends at its two bounds"), qPrintable(why));
    }

    void layersLieOverTheFrameFromTheMenuAndLast()
    {
        const auto window = openedWindow();
        Canvas &canvas = *window->parts().canvas;
        const auto isShown
            = [&canvas](const QImage &before) { return canvas.grab().toImage() != before; };

        for (const char *layer : {"layer-box", "layer-half-planes"}) {
            const QImage before = canvas.grab().toImage();
            QAction *toggle = action(*window, layer);
            QVERIFY(!toggle->isChecked());
            QVERIFY(toggle->toolTip().length() > 40);
            toggle->trigger();
            QVERIFY(toggle->isChecked());
            QVERIFY(isShown(before));
            toggle->trigger();
            QVERIFY(!isShown(before));
            toggle->trigger();
        }
        window->close();

        const auto next = openedWindow();
        QCOMPARE(next->parts().options->layers(), QStringList({"box", "half-planes"}));
        QVERIFY(action(*next, "layer-box")->isChecked());
        action(*next, "hideLayers")->trigger();
        QVERIFY(!action(*next, "layer-box")->isChecked());
    }

    void aLayerWithNothingToShowIsGreyAndSaysWhy()
    {
        const auto window = openedWindow();
        QAction *edgeTable = action(*window, "layer-edge-table");

        QVERIFY(!edgeTable->isEnabled());
        QCOMPARE(edgeTable->statusTip(),
                 "Nothing to show: “Column scan” has no such numbers, unlike “Polygon by parity”, "
                 "“Bézier path: filled”, “Text as outlines”.");
        QVERIFY(action(*window, "layer-weights")->isEnabled());
    }

    void theFirstAffineMapComesBackFromTheMenuAndWithAnotherScene()
    {
        const auto window = openedWindow();
        DisplayOptions &options = *window->parts().options;
        QAction *first = action(*window, "firstAffineMap");
        const AffineImage other{0, {latticePixel(1, 1), latticePixel(9, 1), latticePixel(1, 9)}};

        QVERIFY(!first->isEnabled());
        options.setAffineImage(other);
        first->trigger();
        QVERIFY(!options.affineImage());

        options.setAffineImage(other);
        window->parts().document->reset(Scene());
        QVERIFY(!options.affineImage());
        QVERIFY(!first->isEnabled());
    }

    void theStatusFieldsKeepTheirPlacesWhileStepping()
    {
        const auto window = openedWindow();
        QCoreApplication::processEvents();
        const auto places = [&] {
            QList<int> lefts;
            for (const char *name : {"statusColumn", "statusStep", "statusSettings"})
                lefts += named<QLabel>(*window, name)->x();
            return lefts;
        };
        const QList<int> before = places();
        for (const std::size_t position : {std::size_t(3), std::size_t(99), std::size_t(1039)}) {
            window->parts().playhead->seek(position);
            QCoreApplication::processEvents();
            QCOMPARE(places(), before);
        }
    }

private:
    IsolatedSettings m_settings;
};

PIXELPLUMB_TEST(TestMainWindow)

} // namespace tst_mainwindow

#include "tst_mainwindow.moc"
