// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/tracedscene.h"
#include "core/scene/scenefile.h"
#include "tests/support/formularange.h"
#include "tests/support/testprogram.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>

namespace tst_shadedformulas {

using namespace pixelplumb;

namespace {

Scene sceneOf(QByteArray text)
{
    const auto read = readScene(text.replace('\'', '"'));
    if (!read)
        qFatal("%s", qPrintable(read.error().message()));
    return read->scene;
}

/// The formulas of a run with their numbers; the test fails if one does not give the number next to
/// it.
QSet<QString> formulasOf(const TracedScene &traced)
{
    const Arithmetic arithmetic = traced.scene.settings.arithmetic;
    QSet<QString> shown;
    for (std::size_t step = 0; step < traced.trace->stepCount(); ++step) {
        for (const FormulaLine &line : explainStep(traced, step).lines) {
            if (line.substituted.isEmpty())
                continue;
            shown.insert(line.symbols);
            const QString fault
                = formulaFault(line, FormulaRange::of(line.substituted, arithmetic), arithmetic);
            if (!fault.isEmpty())
                QTest::qFail(qPrintable(u"step %1: %2: %3 %4, not %5"_s.arg(step).arg(
                                 line.symbols, line.substituted, fault, toText(line.used))),
                             __FILE__, __LINE__);
        }
    }
    return shown;
}

/// The tool tips that still hold a place for a value ("%1").
QStringList unfilledTipsOf(const TraceNumbers &numbers)
{
    QStringList unfilled;
    for (const auto *table : {&numbers.setUp, &numbers.span, &numbers.sample})
        for (const NumberDescription &number : *table)
            if (number.toolTip.contains(QRegularExpression(u"%\\d"_s)))
                unfilled += number.toolTip;
    return unfilled;
}

} // namespace

/// Formulas of triangles with effects, and of the column scan in float64.
class TestShadedFormulas : public QObject {
    Q_OBJECT

private slots:
    /// Texels beyond the texture, levels beyond a byte, planes and weights of triangles and
    /// segments, and primitives with and without w in one scene.
    void everyNumberOfAShadedTriangleHasAFormulaThatComesOut_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<Arithmetic>("arithmetic");
        for (const char *method : {"column-scan", "interpolate-bilinear", "interpolate-plane",
                                   "interpolate-barycentric"})
            for (const Arithmetic arithmetic :
                 {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64})
                QTest::addRow("%s, %s", method, nameOf(arithmetic).data())
                    << QString::fromLatin1(method) << arithmetic;
    }
    void everyNumberOfAShadedTriangleHasAFormulaThatComesOut()
    {
        QFETCH(QString, method);
        QFETCH(Arithmetic, arithmetic);
        QByteArray text
            = "{ 'pixelplumb': 1, 'frame': { 'width': 12, 'height': 12 }, 'materials': { "
              "'a': { 'texture': 'checker', 'filter': 'bilinear', 'wrap': 'repeat' }, "
              "'b': { 'texture': 'checker', 'filter': 'nearest', 'wrap': 'clamp' }, "
              "'c': { 'texture': 'checker', 'filter': 'nearest', 'wrap': 'repeat' }, "
              "'d': { 'texture': 'checker', 'filter': 'bilinear', 'wrap': 'clamp' } }, "
              "'primitives': [ ";
        const QByteArray triangle
            = "{ 'triangle': [[1, 1], [9, 2], [3, 10]], 'colors': ['#ff0000', '#00ff00', "
              "'#0000ff'], 'uv': [[-1.5, -0.75], [2.25, 0.5], [0.125, 1.75]], 'w': [%1], "
              "'material': '%2' }";
        const QByteArray segment
            = "{ 'triangle': [%1], 'colors': ['#ff0000', '#00ff00', '#0000ff'], 'uv': [[-1, -1], "
              "[2, 0.5], [0, 1]], 'material': 'a' }";
        QByteArrayList primitives;
        for (const char *material : {"a", "b", "c", "d"}) {
            for (const char *w : {"1, 2, 3", "2, 2, 2"})
                primitives += QByteArray(triangle).replace("%1", w).replace("%2", material);
        }
        for (const char *points : {"[1, 1], [5, 5], [9, 9]", "[3, 9], [3, 1], [3, 4]",
                                   "[4, 4], [4, 4], [4, 4]", "[9, 6], [5, 6], [1, 6]"})
            primitives += QByteArray(segment).replace("%1", points);
        text += primitives.join(", ") + " ] }";
        Scene scene = sceneOf(text);
        scene.method = method.toStdString();
        scene.settings.arithmetic = arithmetic;
        const auto traced = traceScene(scene);
        const QSet<QString> shown = formulasOf(*traced);
        QCOMPARE(unfilledTipsOf(traced->trace->numbers()), QStringList());
        QStringList expected = {u"i = ⌊8·u − ½⌋ − 8·⌊⌊8·u − ½⌋/8⌋"_s,
                                u"j = min(max(⌊8·v⌋, 0), 7)"_s,
                                u"j = ⌊8·v⌋ − 8·⌊⌊8·v⌋/8⌋"_s,
                                u"i = min(max(⌊8·u − ½⌋, 0), 7)"_s,
                                u"f_u = 8·u − ½ − ⌊8·u − ½⌋"_s,
                                u"f_u = 8·u − ½ − i"_s,
                                u"R_w₁ = R₁/w₁"_s,
                                u"R_w₁ = R₁"_s,
                                u"R = R_w/q"_s,
                                u"R = R_w"_s};
        if (method.endsWith(u"plane"_s))
            expected += {u"c_Rw = R_w₀ − a_Rw·x₀ − b_Rw·y₀"_s, u"a_Rw = (R_w₂ − R_w₀)/(x₂ − x₀)"_s,
                         u"b_Rw = (R_w₀ − R_w₁)/(y₀ − y₁)"_s};
        else if (method.endsWith(u"barycentric"_s))
            expected += {u"a_α = (y₂ − y₁)/((y₂ − y₁)·(x₀ − x₁) + (x₁ − x₂)·(y₀ − y₁))"_s,
                         u"c_γ = −a_γ·x₀"_s, u"c_α = 1 − a_α·x₀"_s};
        else
            expected += {u"ΔR_w = 0"_s};
        for (const QString &formula : expected)
            QVERIFY2(shown.contains(formula),
                     qPrintable(formula + u'\n' + QStringList(shown.values()).join(u'\n')));
    }

    /// 2^16 − 1 levels of depth, a depth beyond 1, and pixels of several samples.
    void depthLevelsAndMeansHaveFormulas()
    {
        const QSet<QString> shown = formulasOf(*traceScene(
            sceneOf("{ 'pixelplumb': 1, 'frame': { 'width': 12, 'height': 12 }, 'depth': 'on', "
                    "'depthBits': 16, 'antialiasing': 4, 'primitives': [ { 'triangle': [[1, 1], "
                    "[10, 2], [3, 10]], 'colors': ['#ff0000', '#00ff00', '#0000ff'], "
                    "'z': [0.1, 1.5, 0.25] } ] }")));
        for (const char *formula : {"z_level = ⌊z·65535 + ½⌋", "mean_R = ⌊sum_R/4 + ½⌋",
                                    "z_level = ⌊min(1, max(0, z))·65535 + ½⌋"})
            QVERIFY2(shown.contains(QString::fromUtf8(formula)), formula);
    }

    /// At (2, 2) the hypotenuse x + y = 4 passes through the centre; of the samples (−1/8, −3/8),
    /// (3/8, −1/8), (−3/8, 1/8) and (1/8, 3/8) the first and the third lie below it.
    void theSumOfAPixelsSamplesIsWorkedOutFromThem()
    {
        for (const char *primitive :
             {"'triangle': [[0, 0], [4, 0], [0, 4]], 'colors': ['#ffffff', '#ffffff', '#ffffff']",
              "'line': [[0, 4], [4, 0]], 'colors': ['#ffffff', '#ffffff']"}) {
            const QSet<QString> shown = formulasOf(
                *traceScene(sceneOf("{ 'pixelplumb': 1, 'frame': { 'width': 6, 'height': 6 }, "
                                    "'antialiasing': 4, 'primitives': [ { "
                                    + QByteArray(primitive) + " } ] }")));
            // A stroke one pixel wide covers all four samples there.
            const bool isTriangle = QByteArray(primitive).contains("triangle");
            const QString sum = u"sum_R = 255 + %1 + 255 + %1"_s.arg(isTriangle ? 0 : 255);
            QVERIFY2(shown.contains(sum), qPrintable(QStringList(shown.values()).join(u'\n')));
        }
    }

    /// By hand: exactly 118 1/2, which float64 computes as 118.49999999999999; A = −132, and β is
    /// 1/(4·132·256²) = 2.88992…·10⁻⁸.
    void whatIsAddedToLevelsInFloat64IsShown()
    {
        const auto traced = traceScene(
            sceneOf("{ 'pixelplumb': 1, 'frame': { 'width': 50, 'height': 50 }, 'method': "
                    "'column-scan-bias', 'arithmetic': 'float64', 'primitives': [ { 'triangle': "
                    "[[32, 39], [23, 9], [21, 17]], 'colors': ['#2f243c', '#9ff97e', '#a2339b'] "
                    "} ] }"));
        formulasOf(*traced);
        QStringList bytes;
        for (std::size_t step = 0; step < traced->trace->stepCount(); ++step) {
            const TraceStep at = traced->trace->stepAt(step);
            if (at.kind != StepKind::Sample)
                continue;
            const PixelChange &change = traced->trace->changes()[at.sample];
            if (change.x != 25 || change.y != 23)
                continue;
            for (const FormulaLine &line : explainStep(*traced, step).lines) {
                if (line.symbols.startsWith(u"byte"))
                    bytes.append(line.symbols + u": "_s + line.substituted);
            }
        }
        QCOMPARE(bytes.size(), 3);
        QVERIFY2(bytes[2].startsWith(u"byte = ⌊B + (½ + β_C)⌋: ⌊118.49999999999999 + (½ + 2.88992"),
                 qPrintable(bytes[2]));
    }

    void beyondTheHorizonTheHorizonRefuses()
    {
        const auto traced = traceScene(
            sceneOf("{ 'pixelplumb': 1, 'frame': { 'width': 12, 'height': 12 }, 'depth': 'on', "
                    "'antialiasing': 'area', 'method': 'interpolate-plane', 'primitives': [ { "
                    "'triangle': [[2, 8], [6.5, 10], [4.5, 7]], 'colors': ['#ff0000', '#00ff00', "
                    "'#ff0000'], 'z': [0.5, 0.25, 0.5], 'w': [1, 1, 16] } ] }"));
        int refused = 0;
        for (std::size_t step = 0; step < traced->trace->stepCount(); ++step) {
            const TraceStep at = traced->trace->stepAt(step);
            if (at.kind != StepKind::Sample || traced->trace->changes()[at.sample].isWritten())
                continue;
            ++refused;
            const QString sentence = explainStep(*traced, step).sentence;
            QVERIFY2(sentence.contains(u"horizon"), qPrintable(sentence));
        }
        QVERIFY(refused > 0);
    }
};

PIXELPLUMB_TEST(TestShadedFormulas)

} // namespace tst_shadedformulas

#include "tst_shadedformulas.moc"
