// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seededrandom.h"
#include "core/grade/bugs/defectivescene.h"
#include "core/grade/scan/programwalk.h"
#include "core/methods/method.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/tracedscene.h"
#include "tests/support/testprogram.h"
#include "tests/support/tracereplay.h"

#include <QTest>

#include <set>

namespace tst_programwalk {

using namespace pixelplumb;

namespace {

Scene randomScene(SeededRandom &random, const QString &method, FillRule rule)
{
    Scene scene;
    scene.frame.width = 40;
    scene.frame.height = 40;
    scene.method = method.toStdString();
    scene.settings.fillRule = rule;
    constexpr std::array<Lattice, 3> units = {1, 64, 256};
    const Lattice unit = units[std::size_t(random.between(0, 2))];
    Triangle triangle;
    for (Vertex &vertex : triangle.vertices)
        vertex = {{random.between(-2, 42) * 256 / unit * unit + random.between(0, 3) * unit,
                   random.between(-2, 42) * 256 / unit * unit + random.between(0, 3) * unit},
                  random.colour()};
    scene.triangles = {triangle};
    return scene;
}

/// The run's steps paint that picture.
void verifyReplay(const TracedScene &run, const Picture &picture, const QString &id)
{
    const QImage image = replayed(*run.trace, run.scene.frame);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const auto &[red, green, blue] = picture.colours[picture.placeOf(x, y)].channels;
            QVERIFY2(image.pixel(x, y) == qRgb(red, green, blue), qPrintable(id));
        }
    }
}

} // namespace

/// Without mistakes, the walk that simulates programs draws exactly what the kernels draw.
class TestProgramWalk : public QObject {
    Q_OBJECT

private slots:
    void aWalkWithoutMistakesDrawsWhatTheKernelsDraw_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<ScanSettings>("settings");
        for (const Method *method : {methodNamed(u"column-scan"), methodNamed(u"row-walk")}) {
            std::vector<VariantSet> variants = {{}};
            for (const Variant variant : method->variants)
                variants.push_back(VariantSet().with(variant));
            for (const FillRule rule : method->fillRules) {
                for (const Arithmetic arithmetic : method->arithmetics) {
                    for (const VariantSet &set : variants)
                        QTest::addRow("%s, %s, %s, %s", qPrintable(method->id), nameOf(rule).data(),
                                      nameOf(arithmetic).data(),
                                      set.isEmpty() ? "right"
                                                    : nameOf(variantsIn(set).front()).data())
                            << method->id
                            << ScanSettings{arithmetic, rule, ByteRounding::Nearest, set};
                }
            }
        }
    }
    void aWalkWithoutMistakesDrawsWhatTheKernelsDraw()
    {
        QFETCH(QString, method);
        QFETCH(ScanSettings, settings);
        SeededRandom random(7);
        for (int i = 0; i < 20; ++i) {
            Scene scene = randomScene(random, method, settings.fillRule);
            scene.settings = settings;
            if (doubledArea(scene.triangles.front()) == 0)
                continue;
            QCOMPARE(redrawn(scene, redrawingBy({})), pictureOf(scene));
        }
    }

    void fromTheOtherEndItIsTheSame()
    {
        SeededRandom random(8);
        for (const char *method : {"column-scan", "row-walk"}) {
            for (int i = 0; i < 60; ++i) {
                const Scene scene
                    = randomScene(random, QString::fromLatin1(method), FillRule::Closed);
                const Picture right = pictureOf(scene);
                for (const WalkOrder order : {WalkOrder::Ascending, WalkOrder::Descending})
                    QCOMPARE(redrawn(scene, redrawingBy({.order = order})), right);
            }
        }
    }

    /// The run that is stepped, the picture that is drawn and the one that is searched for are one.
    void everyMistakeOfAWalkCanBeStepped_data()
    {
        QTest::addColumn<QString>("method");
        QTest::newRow("columns") << u"column-scan"_s;
        QTest::newRow("rows") << u"row-walk"_s;
    }
    void everyMistakeOfAWalkCanBeStepped()
    {
        QFETCH(QString, method);
        SeededRandom random(10);
        Scene scene = randomScene(random, method, FillRule::Closed);
        std::size_t walks = 0;
        for (const Defect &defect : defectsFor(scene)) {
            if (!defect.redrawing || !defect.redrawing->walk)
                continue;
            ++walks;
            for (const Arithmetic arithmetic : {Arithmetic::Exact, Arithmetic::Float32}) {
                scene.settings.arithmetic = arithmetic;
                const std::span only(&defect, 1);
                const Scene stepped = steppedWithDefects(scene, only);
                const Picture picture = pictureWith(scene, only);
                QVERIFY2(!stepped.settings.bugs.isRight(), qPrintable(defect.id));
                QVERIFY2(pictureOf(stepped) == picture, qPrintable(defect.id));
                const auto run = traceScene(stepped);
                verifyReplay(*run, picture, defect.id);
                for (std::size_t i = 0; i < run->trace->stepCount(); i += 7)
                    QVERIFY(!explainStep(*run, i).heading.isEmpty());
            }
        }
        QVERIFY(walks > 150);
    }

    void everyMistakenEdgeTestCanBeStepped_data()
    {
        QTest::addColumn<QString>("method");
        for (const Method &method : methods()) {
            if (method.testsEdges)
                QTest::newRow(qPrintable(method.id)) << method.id;
        }
    }
    void everyMistakenEdgeTestCanBeStepped()
    {
        QFETCH(QString, method);
        SeededRandom random(11);
        Scene scene = randomScene(random, method, methodNamed(method)->fillRules.front());
        int tests = 0;
        for (const Defect &defect : defectsFor(scene)) {
            if (!defect.redrawing || !defect.redrawing->edgeTest)
                continue;
            ++tests;
            const std::span only(&defect, 1);
            const Scene stepped = steppedWithDefects(scene, only);
            QVERIFY2(!stepped.settings.testBugs.isRight(), qPrintable(defect.id));
            const Picture picture = pictureWith(scene, only);
            QVERIFY2(pictureOf(stepped) == picture, qPrintable(defect.id));
            const auto run = traceScene(stepped);
            verifyReplay(*run, picture, defect.id);
            for (std::size_t i = 0; i < run->trace->stepCount(); i += 29)
                QVERIFY(!explainStep(*run, i).heading.isEmpty());
        }
        QVERIFY(tests > 50);
    }

    void everySettingHasAByteOfItsOwn()
    {
        std::set<std::string_view> ids;
        std::set<std::size_t> places;
        for (const ScanSetting &setting : scanSettings()) {
            QVERIFY(ids.insert(setting.id).second && places.insert(setting.place).second);
            ScanBugs bugs;
            setValue(setting, 1, bugs);
            QVERIFY(!bugs.isRight() && valueOf(setting, bugs) == 1);
            QCOMPARE(together(bugs, bugs).has_value(), setting.id == "order");
            QCOMPARE(*together(bugs, {}), bugs);
        }
    }

    void aChannelOfTheVerticesIsOneOfThePicture()
    {
        SeededRandom random(9);
        const Scene scene = randomScene(random, u"column-scan"_s, FillRule::Closed);
        const Picture right = pictureOf(scene);
        const std::array<QString, 3> names = {u"red"_s, u"green"_s, u"blue"_s};
        const std::vector<Defect> defects = defectsFor(scene);
        const auto channelWith = [&](const QString &id, std::size_t place, std::size_t channel) {
            const auto defect = std::ranges::find(defects, id, &Defect::id);
            return pictureWith(scene, std::span(&*defect, 1)).colours[place].channels[channel];
        };
        const auto place = std::size_t(std::ranges::find(right.covered, std::uint8_t(1))
                                       - right.covered.begin());
        for (std::size_t to = 0; to < 3; ++to) {
            QCOMPARE(channelWith(names[to] + u"-not-set"_s, place, to), 0);
            for (std::size_t from = 0; from < 3; ++from) {
                const QString id = names[to] + u"-from-"_s + names[from];
                if (from != to)
                    QCOMPARE(channelWith(id, place, to), right.colours[place].channels[from]);
            }
        }
    }
};

PIXELPLUMB_TEST(TestProgramWalk)

} // namespace tst_programwalk

#include "tst_programwalk.moc"
