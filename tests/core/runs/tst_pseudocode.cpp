// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/frame/framenames.h"
#include "core/methods/words/listedlines.h"
#include "core/runs/explain/stepmoment.h"
#include "core/runs/scenerun.h"
#include "core/scan/choicenames.h"
#include "core/scene/scenefile.h"
#include "tests/support/scenes/scenesformethods.h"
#include "tests/support/scenes/shapes.h"
#include "tests/support/sourcetree.h"
#include "tests/support/testprogram.h"

#include <QDir>
#include <QtTest>

#include <algorithm>
#include <map>
#include <set>

namespace tst_pseudocode {

using namespace pixelplumb;

namespace {

std::vector<NamedScene> scenesWithEffects()
{
    std::vector<NamedScene> scenes;
    const QDir folder(resource(u"/scenes"_s));
    for (const QString &name : folder.entryList({u"*.json"_s})) {
        Scene scene = readSceneFile(folder.filePath(name))->scene;
        if (planOf(SceneRun(scene)).isPlain())
            continue;
        scene.frame.width = std::min(scene.frame.width, 60);
        scene.frame.height = std::min(scene.frame.height, 60);
        scenes.push_back({name, scene});
    }
    // Each kind of antialiasing, with everything that the first scenes have.
    for (std::size_t i = 0; i < 3; ++i) {
        for (const Antialiasing antialiasing :
             {Antialiasing::Samples4, Antialiasing::Samples16, Antialiasing::Area}) {
            Scene scene = scenes[i].second;
            scene.appearance.antialiasing = antialiasing;
            scenes.push_back({scenes[i].first, scene});
        }
    }
    return scenes;
}

bool isOn(const PseudocodeLine &line, Moment moment)
{
    return std::ranges::find(line.moments, moment) != line.moments.end();
}

/// Adds the texts of the lines that a run does. A step that no line lists is reported.
void collectLines(const TracedScene &traced, const QString &scene, std::set<QString> &done)
{
    const ScanTrace &trace = *traced.trace;
    std::map<std::size_t, Pseudocode> codes;
    for (std::size_t index = 0; index < trace.stepCount(); ++index) {
        const std::size_t primitive = trace.stepAt(index).primitive;
        const Pseudocode &code
            = codes.try_emplace(primitive, pseudocodeOf(traced, primitive)).first->second;
        const Moment moment = momentOf(trace, index);
        bool isListed = false;
        for (const PseudocodeLine &line : code) {
            if (isOn(line, moment)) {
                isListed = true;
                done.insert(line.text);
            }
        }
        QVERIFY2(isListed,
                 qPrintable(u"%1: moment %2 of step %3 in %4"_s.arg(traced.method->id)
                                .arg(int(moment))
                                .arg(index)
                                .arg(scene)));
    }
}

QStringList linesNotIn(const Pseudocode &code, const std::set<QString> &done)
{
    QStringList missing;
    for (const PseudocodeLine &line : code) {
        // Segments are drawn under one rule only: tst_effectlistings runs their lines.
        if (line.of != LineOf::Segment && !done.contains(line.text))
            missing += line.text;
    }
    return missing;
}

/// Whether a listed line stands under a rule in a frame of an origin.
bool standsUnder(const ListedLine &listed, FillRule rule, FrameOrigin origin)
{
    const QString ruled = nameText(nameOf(rule));
    const QString turned = u"origin "_s + nameText(nameOf(origin));
    const QStringList places = listed.where.split(u", "_s);
    return listed.where.isEmpty() || places.contains(ruled) || places.contains(turned)
        || places.contains(ruled + u" with "_s + turned);
}

/// The formulas of a span's bounds.
QStringList boundFormulas(const StepWords &words)
{
    QStringList formulas;
    for (const NumberDescription &number : words.numbers) {
        const bool isBound = number.subject == NumberSubject::LowerEdge
            || number.subject == NumberSubject::UpperEdge
            || number.subject == NumberSubject::LeftEdge
            || number.subject == NumberSubject::RightEdge;
        if (isBound && number.formula.contains(u'←'))
            formulas += number.formula;
    }
    return formulas;
}

} // namespace

/// The pseudocode of every method describes its kernel; tst_everyrun checks that each step does a
/// line of it and that each line is done.
class TestPseudocode : public QObject {
    Q_OBJECT

private slots:
    /// What is printed of a method says of each line under which rules and in which frames it
    /// holds.
    void theListingOfAMethodHoldsUnderEveryRuleAndOrigin()
    {
        for (const Method &method : methods()) {
            const auto listed = underRules(method.pseudocode, method.fillRules);
            for (const FillRule rule : method.fillRules) {
                for (const FrameOrigin origin : allFrameOrigins) {
                    QStringList read;
                    for (const ListedLine &each : listed) {
                        if (standsUnder(each, rule, origin))
                            read.append(each.line.text);
                    }
                    QStringList lines;
                    for (const PseudocodeLine &line : underRule(method.pseudocode, rule, origin))
                        lines.append(line.text);
                    QCOMPARE(method.id + read.join(u'\n'), method.id + lines.join(u'\n'));
                }
            }
        }
    }

    void everyEffectThatRunsHasItsLines_data()
    {
        QTest::addColumn<const Method *>("method");
        for (const Method &method : methods()) {
            QCOMPARE(method.shadedPseudocode.empty(), !method.supports(Effect::Depth));
            if (method.supports(Effect::Depth))
                QTest::newRow(qPrintable(method.id)) << &method;
        }
    }
    void everyEffectThatRunsHasItsLines()
    {
        QFETCH(const Method *, method);
        std::set<QString> done;
        for (const auto &[name, scene] : scenesWithEffects()) {
            const auto traced = tracedBy(*method, Arithmetic::Exact, scene);
            collectLines(*traced, name, done);
            if (QTest::currentTestFailed())
                return;
            for (const PseudocodeLine &line : pseudocodeOf(*traced, 0))
                QVERIFY2(!line.effect || traced->shading()->runs(*line.effect),
                         qPrintable(line.text));
        }
        QStringList missing = linesNotIn(method->shadedPseudocode, done);
        missing.removeAll(u"if no sample is to be drawn: done"_s);
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(u'\n')));
    }

    /// The line "else: y_B ← y_B + m" is marked where the formula says so.
    void edgesBeginAndGoOnWhereTheFormulasSaySo_data()
    {
        QTest::addColumn<QString>("id");
        for (const char *id : {"column-scan", "row-walk", "column-scan-constant-rate"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }
    void edgesBeginAndGoOnWhereTheFormulasSaySo()
    {
        QFETCH(QString, id);
        int begun = 0;
        int added = 0;
        for (const auto &[name, scene] : scenesForEveryMethod()) {
            const auto traced = tracedBy(*methodNamed(id), Arithmetic::Exact, scene);
            for (std::size_t span = 0; span < traced->trace->spanCount(); ++span) {
                const QStringList formulas = boundFormulas(traced->trace->spanWords(span));
                if (formulas.isEmpty())
                    continue;
                const bool isAdded = std::ranges::all_of(
                    formulas, [](const QString &formula) { return formula.contains(u'′'); });
                const Moment moment = momentOf(*traced->trace, traced->trace->indexOfSpan(span));
                QVERIFY2((moment == Moment::Span) == isAdded,
                         qPrintable(name + u' ' + formulas.join(u' ')));
                (isAdded ? added : begun) += 1;
            }
        }
        QVERIFY(begun > 10);
        QVERIFY(added > 100);
    }

    /// Between successive pixels, a step that crosses changes both coordinates, one that stays
    /// changes one.
    void decisionsGoWhereTheirLineSays_data()
    {
        QTest::addColumn<QString>("id");
        for (const char *id : {"line-bresenham", "line-bresenham-symmetric", "circle-midpoint"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }
    void decisionsGoWhereTheirLineSays()
    {
        QFETCH(QString, id);
        std::map<Moment, int> seen;
        Scene lines;
        lines.frame.width = lines.frame.height = 40;
        lines.shapes = {lineAt(1, 1, 30, 12),  lineAt(2, 30, 35, 8), lineAt(5, 2, 12, 38),
                        lineAt(38, 39, 20, 1), circleAt(20, 20, 17), circleAt(20, 20, 11)};
        const auto traced = tracedBy(*methodNamed(id), Arithmetic::Exact, lines);
        const ScanTrace &trace = *traced->trace;
        for (std::size_t span = 1; span < trace.spanCount(); ++span) {
            const Moment moment = momentOf(trace, trace.indexOfSpan(span));
            if (moment != Moment::Stay && moment != Moment::Cross)
                continue;
            const PixelChange &now = trace.changes()[trace.firstSampleOf(span)];
            const PixelChange &before = trace.changes()[trace.firstSampleOf(span - 1)];
            const int changed = int(now.x != before.x) + int(now.y != before.y);
            QCOMPARE(changed, moment == Moment::Cross ? 2 : 1);
            ++seen[moment];
        }
        QVERIFY(seen[Moment::Stay] > 5);
        QVERIFY(seen[Moment::Cross] > 5);
    }
};

PIXELPLUMB_TEST(TestPseudocode)

} // namespace tst_pseudocode

#include "tst_pseudocode.moc"
