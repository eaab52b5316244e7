// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/hunt/invariants.h"
#include "core/methods/method.h"
#include "tests/support/casestorun.h"
#include "tests/support/programs/defectgroups.h"
#include "tests/support/scenes/probescenes.h"
#include "tests/support/testprogram.h"

#include <QTest>

#include <algorithm>
#include <numeric>

namespace tst_invariants {

using namespace pixelplumb;

/// What holds of every right picture, without one at hand. What is printed of it is in
/// tests/data/transcripts/invariants.txt.
class TestInvariants : public QObject {
    Q_OBJECT

private slots:
    void invariantsFindMostDefectsAndNothingElse_data()
    {
        QTest::addColumn<std::size_t>("missed"); // at most
        QTest::newRow("column-scan") << std::size_t(16);
        QTest::newRow("row-walk") << std::size_t(28);
        QTest::newRow("edge-equations") << std::size_t(9);
        QTest::newRow("barycentric-rectangle") << std::size_t(9);
    }
    void invariantsFindMostDefectsAndNothingElse()
    {
        QFETCH(std::size_t, missed);
        const QByteArray name = QTest::currentDataTag();
        Scene conventions;
        conventions.method = name.toStdString();
        const Contender method{methodNamed(QString::fromLatin1(name)), {}};
        constexpr int pairs = 60;
        QVERIFY(checkInvariants(sourceOf(method), conventions, 1, pairs).broken.empty());
        std::vector<Defect> defects = defectsFor(probeScenes(name.constData()).back());
        std::erase_if(defects, [](const Defect &defect) {
            return defect.standsAlone || defect.isRightAlone;
        });
        const std::vector<Defect> run = casesToRun(defects, groupOf);
        QStringList unseen;
        for (const Defect &defect : run) {
            if (checkInvariants(sourceOf(defect.id, method), conventions, 1, pairs).broken.empty())
                unseen += defect.id;
        }
        // By chance a few hold more of these: three times the share is allowed for.
        const std::size_t most
            = areAllCasesRun() ? missed : 3 * missed * run.size() / defects.size() + 1;
        QVERIFY2(std::size_t(unseen.size()) <= most, qPrintable(unseen.join(u' ')));
    }

    void aRasterHasNoColoursThatCouldBeWrong()
    {
        const PictureSource raster{u"raster"_s, [](const Scene &scene) {
                                       Picture picture = pictureOf(scene);
                                       picture.hasColours = false;
                                       std::ranges::fill(picture.colours, Colour{{1, 2, 3}});
                                       return Result<Picture>(picture);
                                   }};
        const auto report = checkInvariants(raster, Scene(), 1, 60);
        QVERIFY(report.checked > 0);
        QVERIFY(report.broken.empty());
    }

    void theTruthKeepsEveryInvariantUnderEveryRule_data()
    {
        QTest::addColumn<FillRule>("rule");
        QTest::addColumn<FrameOrigin>("origin");
        for (const FillRule rule : allFillRules) {
            QTest::addRow("%s, y up", nameOf(rule).data()) << rule << FrameOrigin::BottomLeft;
            QTest::addRow("%s, y down", nameOf(rule).data()) << rule << FrameOrigin::TopLeft;
        }
    }
    void theTruthKeepsEveryInvariantUnderEveryRule()
    {
        QFETCH(FillRule, rule);
        QFETCH(FrameOrigin, origin);
        Scene conventions;
        conventions.frame.origin = origin;
        conventions.settings.fillRule = rule;
        const ScanSettings settings{.fillRule = rule};
        std::vector<std::uint64_t> seeds(20);
        std::iota(seeds.begin(), seeds.end(), 1U);
        for (const char *method : {"edge-equations", "truth"}) {
            for (const std::uint64_t seed : casesToRun(seeds)) {
                const Contender drawer{methodNamed(QString::fromLatin1(method)), settings};
                const auto report = checkInvariants(sourceOf(drawer), conventions, seed, 60);
                QVERIFY(report.checked > 0 && report.undrawn == 0);
                for (const BrokenInvariant &each : report.broken)
                    QFAIL(qPrintable(u"%1, seed %2: %3"_s.arg(QString::fromLatin1(method))
                                         .arg(seed)
                                         .arg(nameOf(each.invariant))));
            }
        }
    }
};

PIXELPLUMB_TEST(TestInvariants)

} // namespace tst_invariants

#include "tst_invariants.moc"
