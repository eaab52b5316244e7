// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/effectchanges.h"
#include "tests/support/testprogram.h"

#include <QtTest>

namespace tst_effectmutations {

using namespace pixelplumb;

/// Verdicts are minimal: a change flips its own verdict and no other.
class TestEffectMutations : public QObject {
    Q_OBJECT

private slots:
    void aMutationTurnsExactlyItsVerdictBothWays_data()
    {
        QTest::addColumn<Change>("before");
        QTest::addColumn<Change>("after");
        QTest::addColumn<QList<Effect>>("turned");
        const auto add
            = [](const char *name, const Change &before, const Change &after,
                 const QList<Effect> &turned) { QTest::newRow(name) << before << after << turned; };
        const Change rich = [](Primitives &p) {
            setLight(p, 0);
            setTexture(p, 0);
            setAlpha(p, 0, 255);
            setDepths(p, 0, {2, 2, 2});
            setDepths(p, 1, {2, 2, 2});
        };
        const auto with = [](const Change &first, const Change &second) -> Change {
            return [=](Primitives &p) {
                first(p);
                second(p);
            };
        };
        const Change none = [](Primitives &) {};
        const QList<Effect> blending = {Effect::Blending};
        add(
            "alpha from 255 to 254", none, [](Primitives &p) { setAlpha(p, 0, 254); }, blending);
        add("alpha from 255 to 254 of a lit board", rich,
            with(rich, [](Primitives &p) { attributesAt(p, 0).vertices[1].alpha = 254; }),
            blending);
        add("one channel of one colour by 1", none, [](Primitives &p) { setColour(p, 0); },
            {Effect::SmoothColour});
        const Change apart = [](Primitives &p) {
            setDepths(p, 0, {2, 2, 2});
            setDepths(p, 1, {3, 3, 3});
        };
        add("the farther one moved over the nearer", apart, with(apart, overlap), {Effect::Depth});
        const Change coplanar = with(overlap, [](Primitives &p) {
            setDepths(p, 0, {2, 2, 2});
            setDepths(p, 1, {2, 2, 2});
        });
        add("one of two tilted backward", coplanar,
            with(coplanar,
                 [](Primitives &p) {
                     setDepths(p, 1, {2, 2, 3});
                 }),
            {Effect::Depth});
        const Change smooth = [](Primitives &p) { setColour(p, 0); };
        add("one w by 2^-24", smooth,
            with(smooth, [](Primitives &p) { setW(p, 0, attributeOne + 1); }),
            {Effect::Perspective});
        const Change textured = [](Primitives &p) { setTexture(p, 0); };
        add("the material's texture away", textured,
            with(textured, [](Primitives &p) { p.appearance.materials[0].texture = nullptr; }),
            {Effect::Texture});
        const Change lit = [](Primitives &p) { setLight(p, 0); };
        add("the light switched off", lit,
            with(lit, [](Primitives &p) { p.appearance.lights.clear(); }), {Effect::Light});
        add(
            "a vertex moved by 1/256 px beyond the border",
            [](Primitives &p) { p.triangles[0].vertices[0].position.x = -unitsPerPixel + 1; },
            [](Primitives &p) { p.triangles[0].vertices[0].position.x = -unitsPerPixel; },
            {Effect::Clipping});
        add("four samples", none,
            [](Primitives &p) { p.appearance.antialiasing = Antialiasing::Samples4; },
            {Effect::Antialiasing});
    }
    void aMutationTurnsExactlyItsVerdictBothWays()
    {
        QFETCH(Change, before);
        QFETCH(Change, after);
        QFETCH(QList<Effect>, turned);

        const EffectPlan first = planOf(changed(before));
        const EffectPlan second = planOf(changed(after));

        for (const Effect effect : allEffects) {
            const QByteArray name(nameOf(effect).data(), qsizetype(nameOf(effect).size()));
            QVERIFY2((first.verdicts[effect].verdict != second.verdicts[effect].verdict)
                         == turned.contains(effect),
                     name);
            QVERIFY2((first.runs(effect) != second.runs(effect)) == turned.contains(effect), name);
        }
    }
};

PIXELPLUMB_TEST(TestEffectMutations)

} // namespace tst_effectmutations

#include "tst_effectmutations.moc"
