// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/tracerows.h"
#include "core/number/wideinteger.h"
#include "core/runs/explain/formulaexplanation.h"
#include "core/runs/explain/pixelhistory.h"
#include "tests/support/casestorun.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes/effectscenes.h"
#include "tests/support/testprogram.h"
#include "widgets/look/numberformat.h"
#include "widgets/model/pixelhistorymodel.h"

#include <QTest>

#include <algorithm>

namespace tst_exactlevels {

using namespace pixelplumb;

namespace {

Scene sceneOf(const EffectScene &made, const QString &method, Arithmetic arithmetic)
{
    Scene scene;
    scene.frame = made.frame;
    scene.method = method.toStdString();
    scene.settings.arithmetic = arithmetic;
    scene.triangles = made.primitives.triangles;
    scene.attributes = made.primitives.attributes;
    scene.appearance = made.primitives.appearance;
    return scene;
}

/// The areas opposite the vertices at a sample; without an area, how far its segment continues to
/// either end, along x or, if it is vertical, along y.
std::array<BigInteger, 3> partsAt(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    const LatticePoint sample = latticePixel(x, y);
    std::array<BigInteger, 3> parts = {0, 0, 0};
    const auto at = [&](std::size_t i) { return triangle.vertices[i % 3].position; };
    if (doubledArea(triangle) != 0) {
        const int turn = doubledArea(triangle) < 0 ? -1 : 1;
        for (std::size_t i = 0; i < 3; ++i)
            parts[i] = turn * BigInteger(doubledArea(sample, at(i + 1), at(i + 2)));
        return parts;
    }
    const std::array<int, 3> order = sortedByColumn(triangle);
    const auto first = std::size_t(order[0]), last = std::size_t(order[2]);
    const bool isUpright = at(first).x == at(last).x;
    const auto along = [&](const LatticePoint &point) { return isUpright ? point.y : point.x; };
    parts[first] = along(at(last)) - along(sample);
    parts[last] = along(sample) - along(at(first));
    if (at(first) == at(last))
        parts[first] = 1;
    return parts;
}

/// The levels at a sample, from the vertices: Σ λ·c/w ÷ Σ λ/w, where λ are the areas opposite the
/// vertices; all w are 1 without perspective, all c the first one if colours are not smooth. If Σ
/// λ/w is not above 0 there are none, except in a single colour, which no w changes.
std::optional<std::array<BigRational, 3>> levelsAt(const Primitives &primitives, std::size_t index,
                                                   std::int64_t x, std::int64_t y)
{
    const auto isOff
        = [&](Effect effect) { return primitives.appearance.forced[effect] == Forcing::Off; };
    const auto &vertices = primitives.triangles[index].vertices;
    const TriangleAttributes *attributes = primitives.attributesOf(index);
    const std::array<BigInteger, 3> parts = partsAt(primitives.triangles[index], x, y);
    const auto &first = vertices[0].colour;
    if (std::ranges::all_of(vertices, [&](const Vertex &each) { return each.colour == first; }))
        return std::array<BigRational, 3>{int(first.channels[0]), int(first.channels[1]),
                                          int(first.channels[2])};
    BigRational below = 0;
    std::array<BigRational, 3> above = {0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        const BigRational w = isOff(Effect::Perspective) || !attributes
            ? BigRational(1)
            : BigRational(attributes->vertices[i].w);
        const BigRational weight = BigRational(parts[i]) / w;
        const Vertex &owner = vertices[isOff(Effect::SmoothColour) ? 0 : i];
        below += weight;
        for (std::size_t channel = 0; channel < 3; ++channel)
            above[channel] += weight * int(owner.colour.channels[channel]);
    }
    if (below <= 0)
        return std::nullopt;
    for (BigRational &level : above)
        level /= below;
    return above;
}

bool isSame(const Quantity &shown, const BigRational &expected)
{
    if (!shown.isRational()) // more than 128 bits can hold
        return !shown.isNone() && shown.toDouble() == expected.convert_to<double>();
    return BigRational(BigInteger(shown.numerator()), BigInteger(shown.denominator())) == expected;
}

/// The Formula panel's line for R, G or B; null if it has no such line.
const FormulaLine *lineOf(const Explanation &explanation, QChar letter)
{
    const auto found = std::ranges::find_if(explanation.lines, [letter](const FormulaLine &line) {
        return line.symbols.startsWith(letter + u" = "_s)
            || line.symbols.startsWith(letter + u" ← "_s);
    });
    return found == explanation.lines.end() ? nullptr : &*found;
}

} // namespace

/// All views that show a level as exact show the same one, and it fits the run: with perspective if
/// the run divides by w, in one colour if colours are not smooth.
class TestExactLevels : public QObject {
    Q_OBJECT

private slots:
    void everyViewShowsThatOfTheRunsPlan_data()
    {
        QTest::addColumn<EffectHardship>("hardship");
        QTest::addColumn<QString>("method");
        QTest::addColumn<Arithmetic>("arithmetic");
        for (const EffectHardship hardship : allEffectHardships) {
            for (const char *method : {"column-scan", "interpolate-bilinear", "interpolate-plane",
                                       "interpolate-barycentric"}) {
                for (const Arithmetic arithmetic : {Arithmetic::Exact, Arithmetic::Float32})
                    QTest::addRow("%s, %s, %s", qPrintable(nameOf(hardship)), method,
                                  arithmetic == Arithmetic::Exact ? "exact" : "float32")
                        << hardship << QString::fromLatin1(method) << arithmetic;
            }
        }
    }
    void everyViewShowsThatOfTheRunsPlan()
    {
        QFETCH(EffectHardship, hardship);
        QFETCH(QString, method);
        QFETCH(Arithmetic, arithmetic);
        for (std::uint64_t seed = 0; seed < (isSanitized ? 1 : 4); ++seed) {
            Scene scene = sceneOf(randomEffectScene(seed, hardship), method, arithmetic);
            if (seed == 2)
                scene.appearance.forced[Effect::Perspective] = Forcing::Off;
            if (seed == 3)
                scene.appearance.forced[Effect::SmoothColour] = Forcing::Off;
            const auto traced = traceScene(scene);
            for (std::size_t span = 0; span < traced->trace->spanCount(); ++span)
                compareViews(traced, span);
        }
    }

private:
    static void compareViews(const std::shared_ptr<const TracedScene> &traced, std::size_t span)
    {
        PixelHistoryModel model;
        const std::vector<SampleRow> rows = sampleRows(*traced, span);
        const std::size_t stride = areAllCasesRun() ? 3 : 12;
        for (std::size_t i = span % stride; i < rows.size(); i += stride) {
            const SampleRow &row = rows[i];
            const SampleRecord &sample = row.record;
            if (sample.colour[0].isNone()) {
                QVERIFY(row.exact.colour[0].isNone());
                continue;
            }
            const auto expected = levelsAt(traced->primitives, row.primitive, sample.x, sample.y);
            QVERIFY(expected.has_value());
            const std::vector<PixelAttempt> attempts = pixelHistory(*traced, sample.x, sample.y);
            const auto attempt = std::ranges::find_if(attempts, [&](const PixelAttempt &each) {
                return each.sample && each.step == row.step;
            });
            QVERIFY(attempt != attempts.end());
            model.setPixel(traced, QPoint(int(sample.x), int(sample.y)));
            const QModelIndex inPanel = model.index(int(attempt - attempts.begin()), 0);
            const Explanation explanation = explainStep(*traced, row.step);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const Quantity &exact = row.exact.colour[channel];
                QVERIFY2(isSame(exact, (*expected)[channel]), qPrintable(toText(exact)));
                QCOMPARE(toText(attempt->exactColour[channel]), toText(exact));
                if (attempt->written)
                    compareInPanel(
                        model.index(int(channel), PixelHistoryModel::ExactColumn, inPanel),
                        sample.colour[channel], exact);
                if (const FormulaLine *line = lineOf(explanation, channelLetters[channel]))
                    QCOMPARE(toText(line->exact), toText(exact));
            }
        }
    }

    /// Beside a colour stands the truth, which the panel omits where it equals the number used.
    static void compareInPanel(const QModelIndex &beside, const Quantity &used,
                               const Quantity &exact)
    {
        const QString shown = beside.data().toString();
        if (shown.contains(u"error"_s))
            QCOMPARE(shown,
                     u"truth %1, error %2"_s.arg(displayText(exact), displayError(used, exact)));
        else
            QVERIFY2(used == exact, qPrintable(shown));
    }
};

PIXELPLUMB_TEST(TestExactLevels)

} // namespace tst_exactlevels

#include "tst_exactlevels.moc"
