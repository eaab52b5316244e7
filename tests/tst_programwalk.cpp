// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seededrandom.h"
#include "core/grade/programwalk.h"
#include "core/methods/method.h"

#include <QTest>

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

} // namespace

/// The walk that programs' mistakes are put into is the kernels', where nothing is put into it.
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
            QCOMPARE(redrawn(scene, {walking({})}), pictureOf(scene));
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
                    QCOMPARE(redrawn(scene, {walking({.order = order})}), right);
            }
        }
    }
};

QTEST_GUILESS_MAIN(TestProgramWalk)
#include "tst_programwalk.moc"
