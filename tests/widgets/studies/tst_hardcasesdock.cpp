// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/bounderrors.h"
#include "core/scene/files/fileaccess.h"
#include "tests/support/isolatedsettings.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"
#include "tests/support/window/openwindow.h"
#include "widgets/canvas/canvas.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenedocument.h"
#include "widgets/studies/accuracy/precisionpanel.h"
#include "widgets/studies/cases/hardcasesdetails.h"
#include "widgets/studies/cases/hardcasespanel.h"
#include "widgets/studies/compare/comparepanel.h"

#include <QTest>
#include <QtWidgets>

namespace tst_hardcasesdock {

using namespace pixelplumb;

class TestHardCasesDock : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_settings.clear();
        m_window = openedWindow();
        m_panel = named<HardCasesPanel>(*m_window, "hardCases");
        m_details = named<HardCasesDetails>(*m_window, "hardCasesDetails");
        m_playhead = m_window->parts().playhead;
    }
    void cleanup() { m_window.reset(); }

    void holdsEveryCaseThatHasAPictureWithWordsOfItsFamily()
    {
        open();

        // For each file, the cases with rejected coordinates are counted separately.
        for (const char *name :
             {"hard_cases.json", "more_cases.json", "shape_cases.json", "effect_cases.json"}) {
            const QString path = testData(name);
            const auto cases = readHardCases(*readFile(path));
            QVERIFY(cases.isOk() && cases->size() >= 26);
            for (const HardCase &each : *cases)
                QVERIFY2(m_panel->choose(each.id) || each.kind == HardCaseKind::Invalid,
                         qPrintable(each.id));
        }
        const QString fallback = whyOf(u"no such family"_s);
        for (const GalleryCase &each : m_panel->cases()) {
            QVERIFY2(each.why != fallback, qPrintable(each.family));
            QVERIFY2(!each.family.isEmpty() && !each.hardCase.stresses.isEmpty(),
                     qPrintable(each.hardCase.id));
            // At least two sentences.
            QVERIFY2(each.why.count(u'.') >= 2, qPrintable(each.hardCase.id));
        }
    }

    void drawsTheChosenCaseByTheCurrentMethodAndByTheTruth()
    {
        setArithmetic(Arithmetic::Float32);
        open();

        QVERIFY(m_panel->choose(u"tie_tenths"_s));

        auto *caption = named<QLabel>(*m_window, "hardCaseCaption");
        QTRY_VERIFY2_WITH_TIMEOUT(caption->text().contains(u"64 missing"_s),
                                  qPrintable(caption->text()), 20000);
        QVERIFY(caption->text().contains(u"Column scan, float32, closed"_s));
        const auto words = named<QLabel>(*m_window, "hardCaseWords")->text();
        QVERIFY2(words.contains(u"the sign of the error decides, not its size"_s),
                 qPrintable(words));
    }

    void theChosenCasesPictureKeepsItsColours()
    {
        open();
        QVERIFY(m_panel->choose(u"tie_tenths"_s));
        const auto picture = [this](QIcon::Mode mode) {
            const auto *tree = named<QTreeWidget>(*m_window, "hardCasesTree");
            return tree->currentItem()->icon(0).pixmap(tree->iconSize(), mode).toImage();
        };
        QTRY_VERIFY_WITH_TIMEOUT(!picture(QIcon::Normal).isNull(), 20000);
        QCOMPARE(picture(QIcon::Selected), picture(QIcon::Normal));
    }

    void opensACaseAtTheFirstPixelThatDiffers()
    {
        setArithmetic(Arithmetic::Float32);
        open();
        m_panel->choose(u"tie_tenths"_s);

        QTest::mouseClick(named<QPushButton>(*m_window, "hardCaseOpen"), Qt::LeftButton);

        QTRY_VERIFY_WITH_TIMEOUT(
            m_playhead->traced() && m_playhead->traced()->scene.frame.width == 1001, 20000);
        QTRY_COMPARE_WITH_TIMEOUT(m_playhead->pickedPixel(), std::optional(QPoint(10, 1)), 5000);
        QCOMPARE(m_playhead->traced()->differences.at(10, 1), Difference::Missing);
        QCOMPARE(m_playhead->currentColumnX(), std::optional<std::int64_t>(10));
    }

    void tellsWithinThreeClicksWhyFloat64LosesMoreAtTenthsThanFloat32()
    {
        open();
        m_panel->choose(u"tie_tenths"_s); // the first click
        auto *compare = named<ComparePanel>(*m_window, "compare");

        QTest::mouseClick(named<QPushButton>(*m_window, "hardCaseCompare"),
                          Qt::LeftButton); // the second click

        QTRY_VERIFY_WITH_TIMEOUT(compare->contest() && !compare->isRunning()
                                     && compare->contest()->scene.frame.width == 1001,
                                 30000);
        const auto missing = [&](std::size_t run) {
            return compare->contest()->runs[run].tally.againstTruth.count(Difference::Missing);
        };
        QCOMPARE(compare->contenders()[1].settings.arithmetic, Arithmetic::Float32);
        QCOMPARE(missing(1), 64);
        QCOMPARE(missing(2), 127);
        m_playhead->pick({20, 2}); // the third click, on a pixel that both lose
        const QString html = named<QLabel>(*compare, "compareReason")->text();
        QVERIFY2(html.contains(u"y<sub>B</sub>"_s), qPrintable(html)); // as everywhere else
        const QString reason = QTextDocumentFragment::fromHtml(html).toPlainText();
        QVERIFY2(reason.contains(u"yB = 2.0000000000000004 instead of 2"_s), qPrintable(reason));
    }

    void putsEveryMethodToTheTestOneByOne()
    {
        open();
        m_panel->choose(u"tip_left_0_0"_s);

        QTRY_VERIFY_WITH_TIMEOUT(!m_details->verdicts().empty() && !m_details->isChecking(), 60000);

        for (const ContenderVerdict &verdict : m_details->verdicts()) {
            if (verdict.contender.method->isStableIn(verdict.contender.settings.arithmetic))
                QVERIFY2(verdict.outcome != CaseOutcome::FellShort,
                         qPrintable(verdict.contender.name()));
        }
    }

    void saysTheDriftedNumberOfLostTiesIsAsTold()
    {
        // The words about tie_tenths: at 64 and 127 ties the error is on the losing side.
        Scene scene;
        for (const char *path : {":/cases/more_cases.json", ":/cases/hard_cases.json"}) {
            for (const GalleryCase &each : galleryOf(QLatin1String(path))) {
                if (each.hardCase.id == "tie_tenths")
                    scene = sceneOf(each.hardCase, methods().front(), {});
            }
        }
        const auto all = boundErrorsOf(scene, 0);
        QVERIFY(all);
        for (const auto &[arithmetic, expected] :
             {std::pair(Arithmetic::Float32, 64), std::pair(Arithmetic::Float64, 127)}) {
            const auto errors = std::ranges::find(*all, arithmetic, &BoundErrors::arithmetic);
            int losing = 0;
            for (const BoundError &error : errors->spans) {
                if (error.place.coordinate % 10 == 0)
                    losing += int(error.lower > 0) + int(error.upper < 0);
            }
            QCOMPARE(losing, expected);
        }
    }

    void looksRightInBothPalettes_data() { addPalettes(); }
    void looksRightInBothPalettes()
    {
        QFETCH(QPalette, palette);
        qApp->setPalette(palette);
        setArithmetic(Arithmetic::Float32);
        open();
        m_panel->choose(u"overshoot_sliver"_s);
        QTRY_VERIFY_WITH_TIMEOUT(m_panel->picturesLeft() < int(m_panel->cases().size()) - 12,
                                 30000);

        grabbed(*m_window, u"hardcases"_s);
        // Not hardCasesTree: most of it is pictures of the cases, on backgrounds of their own.
        QTRY_COMPARE(readingFault(*named<QWidget>(*m_window, "hardCaseWords")), QString());
    }

private:
    void open()
    {
        action(*m_window, "hardCasesDockToggle")->trigger();
        QCoreApplication::processEvents();
    }
    void setArithmetic(Arithmetic arithmetic)
    {
        ScanSettings settings = m_window->parts().document->scene().settings;
        settings.arithmetic = arithmetic;
        m_window->parts().document->setSettings(settings);
        QTRY_COMPARE(m_playhead->traced()->scene.settings.arithmetic, arithmetic);
        m_window->parts().document->undoStack()->setClean(); // so that it does not ask about
                                                             // changes
    }
    static std::vector<GalleryCase> galleryOf(const QString &path)
    {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return {};
        const auto gallery = readGallery(file.readAll());
        return gallery ? *gallery : std::vector<GalleryCase>();
    }

    IsolatedSettings m_settings;
    std::unique_ptr<MainWindow> m_window;
    HardCasesPanel *m_panel = nullptr;
    HardCasesDetails *m_details = nullptr;
    Playhead *m_playhead = nullptr;
};

PIXELPLUMB_TEST(TestHardCasesDock)

} // namespace tst_hardcasesdock

#include "tst_hardcasesdock.moc"
